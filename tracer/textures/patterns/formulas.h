// The formulas of the scalar patterns (spec 05 section 8), one function each; `p` is the warped point, `surface` null
// where there is none. Grouped into files by kinship.
#pragma once

#include <numbers>
#include <algorithm>
#include <cmath>

#include "tracer/noise/noise_tables.h"
#include "tracer/textures/patterns/pattern.h"
#include "tracer/textures/point_batch.h"

namespace verisim::textures {

inline double clamp01(double v) { return v < 0 ? 0 : v > 1 ? 1 : v; }
// One period of a sine over [0, 1].
// sin(2 pi v), of the fraction of |v| as POV-Ray scales it: normals show the last bit.
double sine_cycle(double v);
inline double sine_angle(double v) {
  const double size = std::fabs(v);
  return std::copysign((size - std::floor(size)) * 50000 / 50000 * (2 * std::numbers::pi), v);
}
inline double triangle(double v) {
  const double t = v - std::floor(v);
  return t >= 0.5 ? 2 * (1 - t) : 2 * t;
}
// fmod(v, 1.00001), exactly, without the slow general remainder for ordinary values.
inline double wrap_period(double v) {
  constexpr double kPeriod = 1.00001;
  const double magnitude = std::fabs(v);
  if (magnitude < kPeriod) return v;
  if (!(magnitude < 0x1p25)) return std::fmod(v, kPeriod);
  // The period in two parts of 26 bits, so that products with the whole number of periods, and the differences, are
  // exact.
  constexpr double kHigh = static_cast<double>(static_cast<long long>(kPeriod * 0x1p26)) * 0x1p-26,
                   kLow = kPeriod - kHigh;
  const double n = static_cast<double>(static_cast<int>(magnitude * (1 / kPeriod)));
  double r = (magnitude - n * kHigh) - n * kLow;
  if (r < 0)
    r += kPeriod;
  else if (r >= kPeriod)
    r -= kPeriod;
  return v < 0 ? -r : r;
}
// The remainder in [0, modulus).
inline double positive_remainder(double v, double modulus) {
  const double r = v - std::floor(v / modulus) * modulus;
  return r >= modulus || r < 0 ? 0 : r;
}

namespace formulas {
// One a pattern that is asked for a value; those of traits kFormulaWithNoise are in evaluation/evaluation.inc.
#define VERISIM_PATTERN(name, params, list, traits) \
  double name(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface);
VERISIM_PATTERNS(VERISIM_PATTERN)
#undef VERISIM_PATTERN
}  // namespace formulas

// quilted.cpp
// The displacement of a quilted normal, which its pattern is the mean of (spec 05 section 8).
Vec3 quilt(const QuiltedData& data, const Vec3& p);

// crackle.cpp
double crackle(const CrackleData& data, int noise_generator, const Vec3& p);
// The same at the points of a batch, which is filled up.
void crackle_batch(const CrackleData& data, int noise_generator, int count, const PointBatch& points, double* v);
// The nearest random cell point by the metric of facets: metric 1 takes the signed sum of the differences (spec
// 05 10.6).
Vec3 nearest_facet_point(const Vec3& p, double metric);

// water.cpp: ripples and waves
std::shared_ptr<const std::vector<WaveSource>> wave_sources(int count);
// A distance of zero counts as 1, so that directions stay finite.
inline double wave_distance(const WaveSource& source, const Vec3& p) {
  const double d = length(p - source.position);
  return d == 0 ? 1 : d;
}
// One source's part of a normal of ripples or waves.
struct SourceWave {
  SourceWave(const CompiledPattern& c, double bump, const WaveSource& source)
      : amount(bump),
        frequency(c.frequency),
        own_frequency(c.kind == scene::PatternKind::waves ? source.frequency : 1),
        phase(c.phase),
        count(static_cast<double>(c.as<WaveData>().sources->size())) {}
  double cycles(double distance) const { return distance * frequency * own_frequency + phase; }
  double slope(double sine, double distance) const { return amount * sine / own_frequency / (distance * count); }

  double amount, frequency, own_frequency, phase, count;
};
Vec3 waves_bump(const CompiledPattern& c, double amount, const Vec3& p, Vec3 n);

// fractal.cpp
double fractal(const scene::FractalParams& f, scene::PatternKind kind, const Vec3& p);

}  // namespace verisim::textures
