// What rounding does to values in units of 8 bits.
#pragma once

namespace verisim::compare {

// 16-bit and float values are not whole numbers of those units: a limit that is passed by no more is kept.
inline constexpr double kRounding = 1e-3;
// The variance of rounding to whole values.
inline constexpr double kRoundingVariance = 1.0 / 12;

}  // namespace verisim::compare
