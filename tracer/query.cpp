#include "tracer/query.h"

#include <memory>
#include <mutex>

#include "tracer/scene/bounds.h"
#include "tracer/scene/solid_parts.h"
#include "tracer/shapes/shape.h"

namespace verisim::query {
namespace {

constexpr double kSmallestDistance = 1e-4, kLargestDistance = 2e10;

// Kinds whose box POV-Ray never asks: spec 03 2.1.
bool has_no_box_test(const scene::Object& o) {
  return o.as<scene::Sphere>() || o.as<scene::Box>() || o.as<scene::Plane>() || o.as<scene::Triangle>() ||
         o.as<scene::SmoothTriangle>() || o.as<scene::Poly>();
}

// POV-Ray's slab test, in binary32.
bool meets_box(const Ray& ray, const scene::Bounds& b) {
  float near = 0, far = static_cast<float>(kLargestDistance);
  for (std::size_t i = 0; i < 3; ++i) {
    const float o = static_cast<float>(ray.origin[static_cast<int>(i)]),
                inverse = static_cast<float>(1.0 / ray.direction[static_cast<int>(i)]);
    float enter = (b.low[i] - o) * inverse, leave = (b.low[i] + b.size[i] - o) * inverse;
    if (inverse < 0) std::swap(enter, leave);
    if (enter > near) near = enter;
    if (leave < far) far = leave;
  }
  // A breadth of one rounding: grazing rays are decided by the shape.
  return near <= far * 1.000001f + 1e-6f && far > static_cast<float>(kSmallestDistance);
}

}  // namespace

struct Target::Impl {
  scene::ObjectPtr object;
  std::once_flag once;
  std::unique_ptr<shapes::Shape> shape;
  const shapes::Shape& ready() {
    std::call_once(once, [this] { shape = shapes::compile(*object); });
    return *shape;
  }
};

Target::Target(scene::ObjectPtr object)
    : impl_(std::make_unique<Impl>()), has_inside_(scene::has_only_solid_parts(*object)) {
  impl_->object = std::move(object);
}
Target::~Target() = default;

std::optional<TraceHit> Target::trace(const Vec3& origin, const Vec3& direction) const {
  const double len = length(direction);
  if (!(len > 0) || !std::isfinite(len)) return std::nullopt;
  const Ray ray{origin, direction * (1.0 / len)};
  const scene::Object& object = *impl_->object;
  if (!has_no_box_test(object) && !meets_box(ray, object.bounds)) return std::nullopt;
  shapes::Hit hit;
  if (!impl_->ready().intersect(ray, shapes::RayKind::query, kSmallestDistance, kLargestDistance, hit))
    return std::nullopt;
  return TraceHit{hit.point, hit.shape->normal(hit)};
}

bool Target::inside(const Vec3& p) const { return impl_->ready().inside(p); }

}  // namespace verisim::query
