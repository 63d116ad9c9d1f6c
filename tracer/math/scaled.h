// Colours times numbers of double precision, rounded to single precision before anything else happens to them, as in
// POV-Ray: what fog adds, a diffuse share of a pigment, a highlight of a light, textures of a map with their weights.
#pragma once

#include "tracer/math/color.h"

namespace verisim {

inline Rgb scaled(const Rgb& c, double by) {
  return {static_cast<float>(by * c.r), static_cast<float>(by * c.g), static_cast<float>(by * c.b)};
}
inline Color scaled(const Color& c, double by) {
  return {scaled(c.rgb(), by), static_cast<float>(by * c.f), static_cast<float>(by * c.t)};
}

}  // namespace verisim
