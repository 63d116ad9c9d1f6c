// What a blob is made of.
#pragma once

#include <memory>
#include <vector>

#include "tracer/bvh/bvh.h"
#include "tracer/shapes/blob/blob_packet.h"

namespace verisim::shapes::blob {

// `pov_boxes`: null, or where to add each part's box as POV-Ray has it, in the blob's space.
std::vector<BlobPart> parts_of(const scene::Blob& blob, std::vector<Box3>* pov_boxes = nullptr);
// Around the reach of each part.
std::vector<PartSpheres> spheres_around(const std::vector<BlobPart>& parts);
// Where the surface can be: with a positive threshold (not `all`), within reach of a positive part.
Box3 box_of(const std::vector<BlobPart>& parts, bool all);

// Parts, and what finds those that a ray or a point is near to. One for all copies of a blob.
struct BlobParts {
  explicit BlobParts(const scene::Blob& blob);
  static std::shared_ptr<const BlobParts> of(const std::shared_ptr<const scene::Blob>& blob);

  std::vector<BlobPart> parts;       // in the order of POV-Ray's hierarchy, which decides the last digits of sums
  std::vector<PartSpheres> spheres;  // if the parts are not too many
  accel::Bvh tree;

  static constexpr std::size_t kMaxForPacket = 64;  // parts; of more, a tree finds the few that a ray meets
};

}  // namespace verisim::shapes::blob
