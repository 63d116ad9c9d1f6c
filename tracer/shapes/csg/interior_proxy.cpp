#include "tracer/shapes/csg/interior_proxy.h"

#include <algorithm>

#include "tracer/shapes/quadrics/cone.h"
#include "tracer/shapes/factories.h"

namespace verisim::shapes {
namespace {

// How much smaller the proxy is than its shape: far more than rounding.
constexpr double kMargin = 1e-6;

}  // namespace

std::optional<InteriorProxy> InteriorProxy::of(const scene::Object& object) {
  if (!object.bounded_by.empty() || !object.clipped_by.empty()) return std::nullopt;
  if (const auto* sphere = object.as<scene::Sphere>()) {
    InteriorProxy proxy(object, Form::ball);
    proxy.center_ = sphere->center;
    proxy.radius2_ = sphere->radius * sphere->radius * (1 - kMargin);
    return proxy;
  }
  if (const auto* box = object.as<scene::Box>()) {
    InteriorProxy proxy(object, Form::box);
    proxy.center_ = 0.5 * (box->low + box->high);
    for (int i = 0; i < 3; ++i) proxy.half_[i] = 0.5 * std::fabs(box->high[i] - box->low[i]) * (1 - kMargin);
    return proxy;
  }
  if (const auto* cone = object.as<scene::Cone>()) {
    InteriorProxy proxy(object, Form::cone);
    if (!object.transform) proxy.to_local_ = cone_frame(*cone);
    const Box3 box = cone_box(*cone);  // a cylinder's radius is 1; a cone's is its height above the tip
    const bool cylinder = cone_is_cylinder(*cone);
    proxy.radius2_ = cylinder ? 1 - kMargin : 0, proxy.widening_ = cylinder ? 0 : 1 - kMargin;
    proxy.low_ = std::max(box.min.z, 0.0) + kMargin, proxy.high_ = box.max.z - kMargin;
    return proxy;
  }
  return std::nullopt;
}

bool InteriorProxy::holds(const Box3& box) const {
  for (int corner = 0; corner < 8; ++corner)
    if (!holds(Vec3(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                    corner & 4 ? box.max.z : box.min.z)))
      return false;
  return true;
}

}  // namespace verisim::shapes
