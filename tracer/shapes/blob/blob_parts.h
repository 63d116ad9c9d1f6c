// What a blob is made of.
#pragma once

#include <vector>

#include "tracer/shapes/blob/blob_lanes.h"

namespace verisim::shapes::blob {

std::vector<BlobPart> parts_of(const scene::Blob& blob);
// Around the reach of each part.
std::vector<PartSpheres> spheres_around(const std::vector<BlobPart>& parts);
// Where the surface can be: with a positive threshold (not `all`), within reach of a positive part.
Box3 box_of(const std::vector<BlobPart>& parts, bool all);

}  // namespace verisim::shapes::blob
