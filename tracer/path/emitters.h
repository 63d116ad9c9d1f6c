// Emitting surfaces that paths aim at: spheres, boxes, discs and triangles whose finish has emission
// (docs/path-tracing.md).
//
// Whatever else emits is found by paths that happen to meet it: the result is the same, with more noise.
#pragma once

#include <unordered_map>
#include <vector>

#include "tracer/scene/scene.h"

namespace verisim::path {

class Emitters {
 public:
  explicit Emitters(const scene::Scene& scene);
  bool empty() const { return parts_.empty(); }

  struct Point {
    Vec3 point;
    const scene::Object* object = nullptr;
  };
  // A point of the emitting surfaces, chosen with density() per area. u, v in [0, 1).
  Point sample(double which, const Vec2& uv) const;
  // Probability per area of choosing a point of this object; 0: it is none of the emitters.
  double density(const scene::Object* object) const;

 private:
  // A sphere, a disc, a triangle or a parallelogram.
  struct Part {
    enum class Kind : unsigned char { sphere, disc, triangle, parallelogram } kind;
    Vec3 a, b, c;  // centre; or corner and two edges; disc: centre and two perpendicular radii
    double radius = 0, hole = 0;
    const scene::Object* object = nullptr;
    double area = 0, power = 0;
  };
  void add(const scene::Object& object);
  void add_part(const scene::Object& object, Part part, double strength);

  std::vector<Part> parts_;
  std::vector<double> cumulative_;
  std::unordered_map<const scene::Object*, double> per_area_;
};

}  // namespace verisim::path
