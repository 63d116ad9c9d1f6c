// Numbers of mathematics.
#pragma once

#include <numbers>

namespace verisim {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2 * kPi;
inline constexpr double kDegree = kPi / 180.0;

}  // namespace verisim
