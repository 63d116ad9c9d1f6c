#include "tracer/render/pixel_sampler.h"

namespace verisim::render {

CameraModel::CameraModel(const scene::Camera& description, int width, int height, textures::Compiler& compiler)
    : camera(description), rays(description, width, height) {
  origin_varies = rays.origin_varies();
  if (description.kind == scene::CameraKind::mesh_camera) {
    mesh.emplace(description, width, height);
    origin_varies = true;
  } else if (description.aperture != 0 && description.blur_samples > 0) {
    FocalBlur::Weight weight;
    if (description.bokeh) {
      weight = [pigment = compiler.pigment(description.bokeh)](const Vec3& p) {
        Color c;
        textures::evaluate(*pigment, p, nullptr, c);
        return static_cast<double>(c.grey());
      };
    }
    blur.emplace(description, weight);
    origin_varies = true;
  }
  if (description.normal) normal = compiler.normal(description.normal);
}

Color PixelSampler::operator()(double x, double y) {
  ++tracer_.statistics().samples;
  if (camera_.mesh) return mesh_sample(x, y);
  if (camera_.blur) {
    return camera_.blur->sample(camera_.rays, x, y, [&](const PrimaryRay& primary, int n) {
      tracer_.random().begin_sample(x, y, static_cast<std::uint32_t>(n));
      return trace(primary.ray, primary.image);
    });
  }
  tracer_.random().begin_sample(x, y, 0);
  const std::optional<PrimaryRay> primary = camera_.rays.at(x, y);
  if (!primary) return {0, 0, 0, 0, 1};
  return trace({primary->ray.origin, normalize(primary->ray.direction)}, primary->image);
}

Color PixelSampler::trace(Ray ray, const Vec2& image) {
  if (camera_.normal) ray.direction = perturb_direction(*camera_.normal, ray.direction, image);
  return tracer_.trace_camera(ray, camera_.origin_varies);
}

Color PixelSampler::mesh_sample(double x, double y) {
  const double limit = camera_.camera.max_distance >= kEpsilon ? camera_.camera.max_distance : std::numeric_limits<double>::infinity();
  Color sum;
  int shot = 0;
  for (int k = 0; k < camera_.mesh->rays_per_pixel(); ++k) {
    std::optional<Ray> ray = camera_.mesh->ray(x, y, k);
    if (!ray) continue;
    tracer_.random().begin_sample(x, y, static_cast<std::uint32_t>(k));
    if (camera_.normal) ray->direction = perturb_direction(*camera_.normal, ray->direction, {0, 0});
    sum += tracer_.trace_camera(*ray, true, limit);
    ++shot;
  }
  if (shot == 0) return {0, 0, 0, 0, 1};
  return sum * (1.0f / static_cast<float>(shot));
}

}  // namespace verisim::render
