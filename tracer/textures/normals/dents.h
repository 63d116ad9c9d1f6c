// The noise of dents, which normals take to the third power: with POV-Ray's bits, which the fast noise has not always.
#pragma once

#include "tracer/noise/noise.h"

namespace verisim::textures {

inline double dents_noise(const Vec3& p, int generator) {
  return generator == 3 ? noise(p, generator) : reference::noise(p, generator);
}

}  // namespace verisim::textures
