// On and beside the borders of tilings POV-Ray's rounding decides, along whole lines where a surface lies in them
// (measured, spec 05 section 9.1).
#pragma once

#include <optional>

#include "tracer/textures/patterns/tilings/tiling.h"

namespace verisim::textures {

// How near to x = 0 or z = 0 tilings have other values (value_beside_zero).
inline constexpr double kHardlyBeside = 1e-15;

// Where tilings 19 and 20 lean on the line z = 0, where all of a surface with uv coordinates may lie (measured, spec 05
// 9.1).
Vec2 lean_on_level_line(const Tiling& t, double x);
// Whether a point is on a line between cells, along one axis: `fraction` of the cell, or folded, where it is mirrored.
bool on_seam(const Tiling& t, double fraction, double folded);
// There POV-Ray has, instead of a tile's value, what its tests of tiles leave (measured, spec 05 9.1): above 1, too.
double value_on_seam(const Tiling& t, bool along_z, double v, double z);
// What lies hardly beside a multiple of 1/2, where borders are, goes so far from it that the way into the cell does not
// hide on which side it is.
double beside_border(double v);
// The value at a point that lies hardly beside x = 0 or z = 0, where tilings have other ones there.
std::optional<double> value_beside_zero(const Tiling& t, double x, double z);

}  // namespace verisim::textures
