// POV-Ray's sample displacement: pure functions of position, built from a fixed permutation and a table of offsets
// (spec 02 section 3.2).
#pragma once

#include <array>
#include <cstdint>

#include "tracer/math/vec.h"

namespace verisim::render {

// The permutation P of 0..4095.
const std::array<std::uint16_t, 4096>& permutation();

// J2: displacement in [-0.5, 0.496094] per axis for a sample at (x, y).
Vec2 jitter2(double x, double y);

// Radical inverse of n in base `base`: the Halton sequence.
double radical_inverse(int base, std::uint32_t n);

}  // namespace verisim::render
