#include "tracer/render/explain.h"

#include "tracer/render/prepared_scene.h"
#include "tracer/render/sampling/pixel_sampler.h"

namespace verisim::render {
struct Explainer::Watched {
  Watched(PreparedScene& prepared, const Options& options, const Window& window)
      : camera(prepared.camera(options, window)) {
    prepared.run_prepasses(camera, options, 1);
    tracer = std::make_unique<shading::Tracer>(prepared.data(), shading::RandomSource(options.replay, options.seed),
                                               options.cancel);
    begin_block(prepared.effects(), *tracer, options, 0);
  }

  CameraModel camera;
  std::unique_ptr<shading::Tracer> tracer;
};

Explainer::Explainer(const scene::Scene& scene, const Options& options)
    : own_(std::make_unique<PreparedScene>(scene, options)),
      watched_(std::make_unique<Watched>(*own_, options, Window())) {}
Explainer::Explainer(PreparedScene& prepared, const Options& options, const Window& window)
    : watched_(std::make_unique<Watched>(prepared, options, window)) {}
Explainer::~Explainer() = default;

Color Explainer::pixel(double x, double y, shading::Observer& observer) {
  observer.scene(watched_->tracer->scene());
  watched_->tracer->set_observer(&observer);
  PixelSampler sampler(watched_->camera, *watched_->tracer);
  return sampler(x, y);
}

Color explain(const scene::Scene& scene, const Options& options, double x, double y, shading::Observer& observer) {
  return Explainer(scene, options).pixel(x, y, observer);
}

}  // namespace verisim::render
