// What object patterns ask of an object. Textures are compiled before shapes are known to them: the shape answers
// behind this.
#pragma once

#include <memory>

#include "tracer/scene/object.h"

namespace verisim::scene {

class Solid {
 public:
  virtual ~Solid() = default;
  virtual bool inside(const Vec3& p) const = 0;
};

// The compiled object; defined where shapes are compiled (tracer/shapes/compile.cpp).
std::shared_ptr<const Solid> compile_solid(const Object& object);

}  // namespace verisim::scene
