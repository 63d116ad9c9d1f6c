// Simple solids in numbers: for what asks several of them, or several rays, at once.
#pragma once

#include <cstdint>

#include "tracer/math/transform.h"
#include "tracer/scene/object.h"

namespace verisim::shapes {

struct SimpleSolid {
  enum class Form : std::uint8_t { other, plane, sphere, box, cone, quadric };
  Form form = Form::other;
  bool inverted = false, cylinder = false, open = false;
  bool turned = false;                // of equally near hits the first wins, not the last
  const Transform* matrix = nullptr;  // from the shape's own space; null: none
  Vec3 a{0, 0, 0}, b{0, 0, 0};        // plane: its normal; sphere: its centre; box: its corners
  double c = 0;                       // plane: its distance; sphere: its squared radius; cone: where its narrow end is
  const scene::Quadric* quadric = nullptr;
};

}  // namespace verisim::shapes
