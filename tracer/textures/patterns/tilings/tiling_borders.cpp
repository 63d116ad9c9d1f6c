#include "tracer/textures/patterns/tilings/tiling_borders.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verisim::textures {
namespace {

// In units of 1 / classes, what POV-Ray leaves in tilings of squares and oblongs where folding takes what lies hardly
// below 0 to the whole period (measured, spec 05 9.1); `z`: where x alone lies there.
std::optional<double> value_past_fold(const Tiling& t, double x, double z) {
  const auto past = [&](double v) { return v < 0 && v + t.fold == t.fold; };
  const bool along_z = past(z);
  if (!along_z && !past(x)) return std::nullopt;
  const double place = z - std::floor(z / t.fold) * t.fold;
  const auto within = [&](double from, double to) { return !along_z && place >= from && place < to; };
  switch (t.number) {
    case 6:
      return (within(1, 2) ? 7 : within(2, 3) ? 5 : 8) / 2.0;
    case 11:
      return (within(1, 2) ? 4 : 7) / 3.0;
    case 15:
      return (within(0, 2) ? 8 : 10) / 2.0;
    default:
      return (within(1, 3) ? 5 : 8) / 2.0;
  }
}

// Hardly below z = 0 tilings 19 and 20 have neither what is there nor what is below, but in the hexagon; hardly above
// it they have what is there (measured, spec 05 9.1).
std::optional<double> value_beside_level_line(const Tiling& t, double x, double z) {
  const bool is19 = t.level_line == 19;
  if (z > 0 && z <= (is19 ? 0x1p-54 : 0x1p-53)) return evaluate_tiling(t, x, 0);
  if (!(z < 0 && z >= -0x1p-52)) return std::nullopt;
  const double place = x - std::floor(x / 7) * 7, hexagon = is19 ? 5 : 2;
  if (place > hexagon && place < hexagon + 2) return std::nullopt;
  const bool lower = place == std::floor(place) ? false
                                                : (is19 ? place < 0.5 || (place > 2.5 && place < 5)
                                                        : (place > 1.5 && place < 2) || (place > 4 && place < 6.5));
  return (lower ? 1 : 2) / 3.0;
}

}  // namespace

Vec2 lean_on_level_line(const Tiling& t, double x) {
  constexpr double kLean = 1e-12;
  const double place = x - std::floor(x / 7) * 7;
  if (t.level_line == 19) return {0, (place > 2.5 && place < 3) || (place >= 4 && place <= 5) ? -kLean : kLean};
  if (place == 4) return {-kLean, 0};
  return {0, place > 4 ? -kLean : kLean};
}

bool on_seam(const Tiling& t, double fraction, double folded) {
  return t.mirrored ? folded == 3 : fraction <= 0x1p-55 || fraction == 1;
}

double value_on_seam(const Tiling& t, bool along_z, double v, double z) {
  if (t.mirrored) return (along_z && z >= 1 && z <= 2 ? 4 : 7) / 3.0;
  if (!along_z) return 0;
  const double q = std::sqrt(0.5), r = std::numbers::sqrt2 / 4, place = v * t.lattice[1][1],
               within = std::min(place - q, 3 * q - place) / r;
  if (!(within > 0)) return 0;
  const bool five = t.seams == 14;
  return ((five ? place < 2 * q ? 3 : 4 : 2) + within) / (five ? 5 : 3);
}

double beside_border(double v) {
  constexpr double kFar = 1e-12;
  const double line = std::round(2 * v) / 2, beside = v - line;
  return beside != 0 && std::fabs(beside) < kFar ? line + std::copysign(kFar, beside) : v;
}

std::optional<double> value_beside_zero(const Tiling& t, double x, double z) {
  constexpr double kFar = 1e-12;
  if (t.fold > 0) return value_past_fold(t, x, z);
  if (t.exchanged && x == std::floor(x) && std::fabs(z) < kHardlyBeside)
    return evaluate_tiling(t, x, std::copysign(kFar, z));
  if (t.sided && z < 0 && z > -kHardlyBeside) return evaluate_tiling(t, x, -kFar);
  if (t.level_line != 0) return value_beside_level_line(t, x, z);
  return std::nullopt;
}

}  // namespace verisim::textures
