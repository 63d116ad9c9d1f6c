// The camera's normal{} bends primary rays as it would bend a surface normal (spec 02 section 1.6).
#include "tracer/render/cameras/camera_rays.h"

namespace verisim::render {

Vec3 perturb_direction(const textures::CompiledNormal& normal, const Vec3& unit_direction, const Vec2& image) {
  const Vec3 p{image.x, image.y, 0};
  textures::SurfacePoint point{p, unit_direction, unit_direction};
  point.is_hit = false;
  textures::perturb(normal, p, unit_direction, point);
  return normalize(point.normal);
}

}  // namespace verisim::render
