// What a ray sees that hits nothing: background and sky_sphere (spec 06 sections 11.1 and 11.2).
#pragma once

#include <vector>

#include "tracer/scene/scene.h"
#include "tracer/textures/point_batch.h"

namespace verisim::shading {

class Sky {
 public:
  Sky(const scene::Scene& scene, textures::Compiler& compiler, bool output_alpha);
  // False: the same in every direction.
  bool varies() const { return !pigments_.empty(); }
  // Colour with t = see-through. `opaque`: this ray ignores alpha output (a reflection lies in its path, or radiosity
  // asks).
  Color seen(const Vec3& direction, bool opaque) const;
  // The same in many directions.
  void seen(int count, const textures::PointBatch& directions, bool opaque, Color* colors) const;

 private:
  // What stands behind the pigments.
  Color background(bool opaque) const;

  int version_;
  bool output_alpha_;
  Color background_;
  std::vector<const textures::CompiledPigment*> pigments_;  // top first
  Rgb emission_{1};
  Transform transform_;
};

}  // namespace verisim::shading
