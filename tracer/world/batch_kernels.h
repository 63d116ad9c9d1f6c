// What eight rays meet first, computed for all of them at once: boxes and planes. Compiled for several instruction
// sets; every lane does the operations of the scalar code in the same order.
#pragma once

#include "tracer/bvh/node_rays.h"

namespace verisim::accel {

struct BatchKernels {
  // Eight rays from `first` in a tree with this centre, bounds and slack (bvh.h), at distances above t_min.
  void (*node_rays)(const Box3& bounds, const Vec3& center, double slack, const RayBatch& rays, int first, double t_min,
                    NodeRays& there);
  // The children of a node that they meet before their limits, and perhaps some that they narrowly miss.
  void (*children)(const BoxNode& node, const NodeRays& rays, const double* limit, ChildrenMet& met);
  // The lanes whose limits lie behind these places.
  unsigned (*before)(const float* near, const NodeRays& rays, const double* limit);
  // The distances at which they meet a plane (shapes/plane.h), -1 where they do not; the lanes where that is from t_min
  // on and before their limits.
  unsigned (*plane)(const Vec3& normal, double distance, const RayBatch& rays, int first, double t_min,
                    const double* limit, double* t);
};

// Those of the best instruction set of this machine.
const BatchKernels& batch_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const BatchKernels* batch_kernels(int instruction_set);

}  // namespace verisim::accel
