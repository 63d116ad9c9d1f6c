// density_file: a block of samples over the unit cube (spec 05 section 8).
#pragma once

#include "tracer/scene/pattern.h"

namespace verisim::textures {

double density_file(const scene::DensityFileParams& d, const Vec3& p);

}  // namespace verisim::textures
