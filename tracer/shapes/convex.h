// Solids that a ray crosses in one interval, for the objects that are cut out of them: outside that interval nothing of
// what else the object is made of shows.
#pragma once

#include <limits>

#include "tracer/math/ray_batch.h"

namespace verisim::shapes {

struct Intersections {
  // Where points of the ray may be inside; what lies at other distances, the solid's inside test refuses, even where
  // points are off the ray by PlaneSet::doubt_at.
  double near = -std::numeric_limits<double>::infinity(), far = std::numeric_limits<double>::infinity();
  // What intersect_all adds, in its order: hits without parts at points of the ray.
  double t[2];
  int count = 0;

  void add(double distance) { t[count++] = distance; }
};

class Convex {
 public:
  // False: a ray may cross it in several intervals, or only parts of it are left.
  virtual bool crossed_once() const = 0;
  virtual Intersections cross(const Ray& ray) const = 0;
  // The same of the rays of `active`.
  virtual void cross_packet(const RayPacket& rays, Intersections* intersections) const = 0;

 protected:
  ~Convex() = default;
};

}  // namespace verisim::shapes
