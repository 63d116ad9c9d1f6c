// The formulas of light sources (spec 06 sections 7 and 8): for one point (light.cpp) and, in plain loops that become
// wide instructions, for many (light_falloff_kernels.cpp). Without branches.
#pragma once

#include "tracer/math/vec.h"

namespace verisim::shading {

struct LightDirection {
  Vec3 towards;     // unit, from the point to the light
  double distance;  // along it; negative behind a parallel light
};

// Of light that spreads from a point; `to`: from the lit point to there.
inline LightDirection radial_direction(const Vec3& to) {
  const double d = length(to);
  return {to * (1 / d), d};  // not to / d: POV-Ray's rounding, on which the intervals of media along shadow rays hang
}

// 0 below low, 1 above high, a cubic between.
inline double smooth_step(double low, double high, double x) {
  const double u = (x - low) / (high - low), between = u * u * (3 - 2 * u);
  return x < low ? 0 : x >= high ? 1 : between;
}

// What a spotlight sends in a direction whose cosine with its axis is m; `raised`: m to the power of its tightness.
// Below the cosine `soft` it is less and less; minus infinity: nowhere.
inline double spot_profile(double m, double raised, double cos_falloff, double cos_radius, double soft) {
  const double dimmed = raised * smooth_step(cos_falloff, cos_radius, m), bright = m < soft ? dimmed : raised;
  return m <= 0 ? 0 : bright;
}

// `raised`: the distance, in fade_distances, to the power of fade_power.
inline double faded(double raised) { return 2 / (1 + raised); }

// The displacement of (a, b), from -1/2 to 1/2 along both axes of an area light, within a circular one. Both are moved
// by 0.001, in this order of sums (spec 06 8.1), so that the middle is not 0/0.
inline Vec3 disc_offset(const Vec3& a1, const Vec3& a2, double a, double b) {
  a += 0.001, b += 0.001;
  const double wide = std::fabs(a), high = std::fabs(b), s = (wide < high ? high : wide) / std::sqrt(a * a + b * b);
  return a1 * (a * s) + a2 * (b * s);
}

}  // namespace verisim::shading
