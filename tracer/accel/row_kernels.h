// What eight rays meet first, computed for all of them at once: boxes and planes. Compiled for several instruction sets; every lane does the operations of
// the scalar code in the same order.
#pragma once

#include "tracer/accel/box_node.h"
#include "tracer/math/ray_row.h"

namespace verisim::accel {

// Which of the boxes of an entry eight rays meet; place 4 n + k is child k of node n.
struct alignas(64) BoxesMet {
  std::int64_t places[RayLanes::kCount];              // as bits
  double near[EntryPoints::kMost][RayLanes::kCount];  // where a ray enters a box that it meets
};

// Eight rays as the nodes of a tree see them.
struct alignas(64) NodeRays {
  using Lane = double[RayLanes::kCount];
  Lane ox, oy, oz, ix, iy, iz;  // origins relative to the tree's centre, inverse directions
};

// Which children of a node eight rays meet.
struct alignas(64) ChildrenMet {
  double near[4][RayLanes::kCount];  // where they are entered
  unsigned lanes[4];
};

struct RowKernels {
  // Eight rays from `first` against boxes relative to `center`, at distances above t_min.
  void (*boxes)(const EntryPoints& entry, const Vec3& center, const RayRow& rays, int first, double t_min, BoxesMet& met);
  NodeRays (*node_rays)(const Vec3& center, const RayRow& rays, int first);
  // The children of a node that they meet above t_min and before their limits.
  void (*children)(const BoxNode& node, const NodeRays& rays, double t_min, const double* limit, ChildrenMet& met);
  // The distances at which they meet a plane (shapes/plane.h); -1 where they do not.
  void (*plane)(const Vec3& normal, double distance, const RayRow& rays, int first, double* t);
};

// Those of the best instruction set of this machine.
const RowKernels& row_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const RowKernels* row_kernels(int instruction_set);

}  // namespace verisim::accel
