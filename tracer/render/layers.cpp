#include "tracer/render/layers.h"

#include "tracer/shading/finish.h"

namespace verisim::render {
namespace {

using textures::CompiledTexture;
using textures::WeightedTexture;

struct Look {
  Vec3 normal{0, 0, 0};
  Rgb albedo;
};

class FirstSurface {
 public:
  explicit FirstSurface(const shading::SceneData& scene) : scene_(scene) {}

  // False: nothing is hit.
  bool hit(const Ray& ray, double t_max, shapes::Hit& hit) const {
    return scene_.world.intersect(ray, shapes::RayKind::camera, 1e-4, t_max, hit);
  }

  Look look(const Ray& ray, const shapes::Hit& hit) {
    shading::SurfaceHit at(hit, ray.direction, 0, 0);
    const Vec3 p = at.pattern_point();
    Look result;
    scene_.world.weighted_textures(hit, at.inside_hit, weighted_);
    if (weighted_.empty()) {
      if (const auto* texture = at.surface.texture_within(at.inside_hit)) add(at, *texture, p, nullptr, 1, result);
    } else {
      for (const WeightedTexture& entry : weighted_) add(at, *entry.texture, p, nullptr, entry.weight, result);
    }
    const double size = length(result.normal);
    result.normal = size > kEpsilon ? result.normal / size : at.geometric_normal;
    return result;
  }

 private:
  void add(shading::SurfaceHit& at, const CompiledTexture& texture, const Vec3& p, shading::TextureFrames* frames,
           float weight, Look& out) {
    if (texture.patterned()) {
      const shading::TextureParts parts(selection_, texture, p, at.texture_point, frames);
      for (std::size_t i = 0; i < parts.size(); ++i)
        if (const WeightedTexture entry = parts[i]; entry.weight != 0)
          add(at, *entry.texture, parts.point, &parts.frames, weight * entry.weight, out);
      return;
    }
    Rgb filter(1);
    bool top = true;
    for (const textures::CompiledLayer& layer : texture.layers) {
      const Vec3 normal =
          layer.normal ? shading::perturb_in_frames(*layer.normal, p, at.geometric_normal, at.texture_point, frames)
                       : at.geometric_normal;
      if (top) out.normal += normal * static_cast<double>(weight);
      top = false;
      Color c;
      const bool colored = textures::evaluate(*layer.pigment, p, &at.texture_point, c);
      out.albedo +=
          filter * c.rgb() * (weight * std::max(0.0f, rounded_opacity(shading::surface_opacity(c, scene_.version))));
      if (colored) filter *= c.transmission();
    }
  }

  const shading::SceneData& scene_;
  std::vector<WeightedTexture> weighted_, selection_;
};

}  // namespace

void resize_layers(Layers& layers, int width, int height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (layers.depth) layers.depths.assign(pixels, kFarDepth);
  if (layers.normal) layers.normals.assign(pixels, Vec3(0, 0, 0));
  if (layers.albedo) layers.albedos.assign(pixels, Rgb());
  if (layers.id) layers.ids.assign(pixels, 0);
}

void fill_layers(Layers& layers, const shading::SceneData& scene, const CameraModel& camera, int width,
                 const Block& block, bool antialias) {
  constexpr int kGrid = 4;
  FirstSurface surface(scene);
  shapes::Hit hit;
  const double limit = camera.limit();
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      Look look;
      if (const std::optional<Ray> ray = camera.ray(x, y); ray && surface.hit(*ray, limit, hit)) {
        if (layers.depth) layers.depths[i] = static_cast<float>(hit.t);
        if (layers.id) layers.ids[i] = static_cast<std::uint32_t>(hit.shape->surface->frame_object) + 1;
        look = surface.look(*ray, hit);
      }
      if (antialias && (layers.normal || layers.albedo)) {
        look = {};
        for (int k = 0; k < kGrid * kGrid; ++k) {
          const double dx = (k % kGrid + 0.5) / kGrid - 0.5, dy = (k / kGrid + 0.5) / kGrid - 0.5;
          const std::optional<Ray> ray = camera.ray(x + dx, y + dy);
          if (!ray || !surface.hit(*ray, limit, hit)) continue;
          const Look part = surface.look(*ray, hit);
          look.normal += part.normal / static_cast<double>(kGrid * kGrid);
          look.albedo += part.albedo * (1.0f / (kGrid * kGrid));
        }
      }
      if (layers.normal) layers.normals[i] = look.normal;
      if (layers.albedo) layers.albedos[i] = look.albedo;
    }
  }
}

}  // namespace verisim::render
