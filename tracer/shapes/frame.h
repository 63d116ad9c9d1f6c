// Shapes that are modelled in a frame of their own: along the z axis (cone, cylinder, disc), in a plane (polygon).
#pragma once

#include <memory>

#include "tracer/math/transform.h"
#include "tracer/scene/object.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {

// Takes z = 0 .. 1, radius 1 to `length` along `axis` (unit) from `origin`, by the smallest rotation from z to the
// axis.
Transform frame_along(const Vec3& origin, const Vec3& axis, double radius, double length);

// A shape that is modelled in a frame of its own: compiled as an object that is moved there, if it is not moved
// already.
template <class Compiled, class Described, class Frame>
std::unique_ptr<Shape> compile_in_frame(const scene::Object& object, const Described& described, Frame&& frame) {
  if (object.transform) return std::make_unique<Compiled>(object, described);
  scene::Object framed = object;
  framed.transform = frame(described);
  auto shape = std::make_unique<Compiled>(framed, described);
  shape->object = &object;
  return shape;
}

}  // namespace verisim::shapes
