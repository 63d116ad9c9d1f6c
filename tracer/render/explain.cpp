#include "tracer/render/explain.h"

#include "tracer/render/pixel_sampler.h"
#include "tracer/render/prepasses.h"
#include "tracer/render/requirements.h"

namespace verisim::render {

Color explain(const scene::Scene& scene, const Options& options, int x, int y, shading::Observer& observer) {
  check_supported(scene, options);
  textures::Compiler compiler({scene.settings.noise_generator, scene.settings.number_of_waves, scene.version, options.quality <= 5});
  const accel::World world(scene, compiler, options.split_unions, options.remove_bounds);
  shading::SceneData data(scene, world, compiler, options.quality, options.output_alpha);
  global::SceneEffects effects(scene, compiler, options.quality);
  if (effects.any()) data.effects = &effects;
  const CameraModel camera(scene.camera, options.width, options.height, compiler);
  if (effects.photons) photon_pass(effects, data, options, 1);
  if (effects.radiosity) radiosity_pretrace(effects, data, camera, options, 1);
  shading::Tracer tracer(data, shading::RandomSource(options.replay, options.seed), options.cancel);
  begin_block(effects, tracer, options, 0);
  observer.scene(data);
  tracer.set_observer(&observer);
  PixelSampler sampler(camera, tracer);
  return sampler(x, y);
}

}  // namespace verisim::render
