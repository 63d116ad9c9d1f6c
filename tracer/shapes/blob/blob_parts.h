// What a blob is made of.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tracer/bvh/bvh.h"
#include "tracer/shapes/blob/blob_packet.h"

namespace verisim::shapes::blob {

// Where a part adds to the field, in the blob's space: only looked at while a blob is prepared.
struct PartReach {
  Vec3 center;  // of a sphere around it
  double radius = 0;
  Box3 box;      // around it
  Box3 pov_box;  // POV-Ray's, which is wider
};
struct PartList {
  std::vector<BlobPart> parts;
  std::vector<PartReach> reaches;  // one for each part
};
// In the order of the description.
PartList parts_of(const scene::Blob& blob);

// Parts, and what finds those that a ray or a point is near to. One for all copies of a blob.
struct BlobParts {
  explicit BlobParts(const scene::Blob& blob);
  static std::shared_ptr<const BlobParts> of(const std::shared_ptr<const scene::Blob>& blob);

  std::vector<BlobPart> parts;       // in the order of POV-Ray's hierarchy, which decides the last digits of sums
  std::vector<PartSpheres> spheres;  // around their reach, if the parts are not too many
  accel::Bvh tree;
  bool capsules = false;     // whether there are any
  std::uint64_t halves = 0;  // the half spheres among the first 64, as bits
  Box3 box, positive_box;    // around the reach of all parts, and of those that add to the field

  static constexpr std::size_t kMaxInSpheres = 64;  // parts; of more, a tree finds the few that rays meet
};

}  // namespace verisim::shapes::blob
