#include "tracer/render/explain.h"

#include "tracer/render/sampling/pixel_sampler.h"
#include "tracer/render/prepasses.h"
#include "tracer/render/requirements.h"

namespace verisim::render {
namespace {

const scene::Scene& supported(const scene::Scene& scene, const Options& options) {
  check_supported(scene, options);
  return scene;
}

}  // namespace

struct Explainer::Prepared {
  Prepared(const scene::Scene& scene, const Options& options)
      : compiler({supported(scene, options).settings.noise_generator, scene.settings.number_of_waves, scene.version,
                  options.quality <= 5}),
        world(scene, compiler, {options.split_unions, options.remove_bounds, options.bounding_threshold}),
        data(scene, world, compiler, options.quality, options.output_alpha),
        effects(scene, compiler, options.quality),
        camera(scene.camera, options.width, options.height, compiler) {
    if (effects.any()) data.effects = &effects;
    if (effects.photons) photon_pass(effects, data, options, 1);
    if (effects.radiosity) radiosity_pretrace(effects, data, camera, options, 1);
    tracer =
        std::make_unique<shading::Tracer>(data, shading::RandomSource(options.replay, options.seed), options.cancel);
    begin_block(effects, *tracer, options, 0);
  }

  textures::Compiler compiler;
  accel::World world;
  shading::SceneData data;
  global::SceneEffects effects;
  CameraModel camera;
  std::unique_ptr<shading::Tracer> tracer;
};

Explainer::Explainer(const scene::Scene& scene, const Options& options)
    : prepared_(std::make_unique<Prepared>(scene, options)) {}
Explainer::~Explainer() = default;

Color Explainer::pixel(int x, int y, shading::Observer& observer) {
  observer.scene(prepared_->data);
  prepared_->tracer->set_observer(&observer);
  PixelSampler sampler(prepared_->camera, *prepared_->tracer);
  return sampler(x, y);
}

Color explain(const scene::Scene& scene, const Options& options, int x, int y, shading::Observer& observer) {
  return Explainer(scene, options).pixel(x, y, observer);
}

}  // namespace verisim::render
