#include "tracer/render/path_pixels.h"

namespace verisim::render {
namespace {

// A camera ray of a pixel position: lens and mesh cameras take their rays in turn.
std::optional<Ray> camera_ray(const CameraModel& camera, double x, double y, int n) {
  if (!camera.blur) return camera.ray(x, y, n % camera.rays_per_sample());
  const auto count = static_cast<int>(camera.blur->positions().size());
  const std::optional<PrimaryRay> primary = camera.blur->ray(camera.rays, x, y, n % count);
  if (!primary) return std::nullopt;
  return camera.bent({primary->ray.origin, normalize(primary->ray.direction)}, primary->image);
}

}  // namespace

void render_paths(const Block& block, const CameraModel& camera, const path::PathScene& scene, shading::Tracer& tracer,
                  const Options& options, const BlockPixels& out) {
  path::PathTracer paths(scene, tracer);
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x) {
      path::Sequence sequence(options.seed, x, y);
      double sum[4] = {};
      for (int s = 0; s < options.path_samples; ++s) {
        sequence.begin(static_cast<std::uint32_t>(s));
        tracer.random().begin_sample(x, y, static_cast<std::uint32_t>(s));
        ++tracer.statistics().samples;
        const Vec2 place = sequence.next2();
        const std::optional<Ray> ray = camera_ray(camera, x + place.x - 0.5, y + place.y - 0.5, s);
        if (!ray) {
          sum[3] += 1;
          continue;
        }
        const Color c = paths.radiance(*ray, sequence);
        sum[0] += c.r, sum[1] += c.g, sum[2] += c.b, sum[3] += c.t;
      }
      const double n = options.path_samples;
      out.at(x, y) = Color{static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n),
                           static_cast<float>(sum[2] / n), 0, static_cast<float>(sum[3] / n)};
    }
  }
}

}  // namespace verisim::render
