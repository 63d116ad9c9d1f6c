#include "tracer/query.h"

#include <memory>
#include <mutex>

#include "tracer/bvh/slab_test.h"
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
  if (!has_no_box_test(object) && !accel::slab_test(object.bounds).passes(ray)) return std::nullopt;
  shapes::Hit hit;
  if (!impl_->ready().intersect(ray, shapes::RayKind::query, kSmallestDistance, kLargestDistance, hit))
    return std::nullopt;
  return TraceHit{hit.point, hit.shape->normal(hit)};
}

bool Target::inside(const Vec3& p) const { return impl_->ready().inside(p); }

}  // namespace verisim::query
