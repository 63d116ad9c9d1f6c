// Eight rays on their way through the nodes of a Bvh (node_rays-inl.h).
#pragma once

#include "tracer/bvh/box_node.h"
#include "tracer/math/ray_batch.h"

namespace verisim::accel {

// Eight rays as the nodes of a tree see them: in single precision, from where they enter the tree.
struct alignas(64) NodeRays {
  using Lane = float[RayPacket::kCount];
  Lane origin[3], inverse[3];       // origins relative to the tree's centre, inverse directions
  double start[RayPacket::kCount];  // where they enter the tree; infinite: they miss it
  double slack;
};

// Which children of a node eight rays meet.
struct alignas(64) ChildrenMet {
  float near[4][RayPacket::kCount];  // where they are entered, counted from where the ray enters the tree
  unsigned lanes[4];
};

}  // namespace verisim::accel
