#include "tracer/path/volume.h"

#include <algorithm>
#include <cmath>

#include "tracer/math/constants.h"

namespace verisim::path {
namespace {

constexpr int kMaxSteps = 1 << 20;  // a path through 1e6 mean free paths carries nothing

struct Coefficients {
  Rgb extinction, emission, scattering;
};

Coefficients at(std::span<const global::CompiledMedia* const> media, const Vec3& p) {
  Coefficients c;
  for (const global::CompiledMedia* m : media) {
    const Rgb density = global::media_density(*m, p);
    c.extinction += density * m->extinction;
    c.emission += density * m->description->emission;
    if (m->scatters) c.scattering += density * m->description->scattering;
  }
  return c;
}

double majorant_of(std::span<const global::CompiledMedia* const> media, double length) {
  double sum = 0;
  for (const global::CompiledMedia* m : media) sum += m->extinction.max() * m->density_bound;
  // At least a few looks at what the media emit.
  return std::max(sum, 4.0 / length);
}

float largest(const Rgb& c) { return c.max_abs(); }

}  // namespace

VolumeWalk delta_track(std::span<const global::CompiledMedia* const> media, const Ray& ray, double length,
                       Sequence& sequence, Rgb& weight, Rgb& sum) {
  const double majorant = majorant_of(media, length);
  const auto inverse = static_cast<float>(1.0 / majorant);
  double t = 0;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Vec2 u = sequence.next2();
    t -= std::log(1.0 - u.x) / majorant;
    if (!(t < length)) return {};
    const Coefficients c = at(media, ray.at(t));
    sum += weight * c.emission * inverse;
    // Scattered, or nothing happened; absorption is in the weight. Where the bound was too low the null part is
    // negative, which is as unbiased.
    const Rgb scattered = weight * c.scattering, null = weight * (Rgb(static_cast<float>(majorant)) - c.extinction);
    const float s = largest(scattered), n = largest(null);
    if (!(s + n > 0)) {
      weight = {};
      return {};
    }
    const float chance = s / (s + n);
    if (u.y >= chance) {
      weight = null * (inverse / (1 - chance));
      continue;
    }
    weight = scattered * (inverse / chance);
    VolumeWalk result{true, t, nullptr};
    double left = 0;
    const auto strength = [&](const global::CompiledMedia& m) {
      return m.scatters ? static_cast<double>(largest(global::media_density(m, ray.at(t)) * m.description->scattering))
                        : 0.0;
    };
    for (const global::CompiledMedia* m : media) left += strength(*m);
    left *= sequence.next();
    for (const global::CompiledMedia* m : media) {
      if (!m->scatters) continue;
      result.medium = m;
      if ((left -= strength(*m)) <= 0) break;
    }
    return result;
  }
  weight = {};
  return {};
}

Rgb transmittance(std::span<const global::CompiledMedia* const> media, const Ray& ray, double length,
                  Sequence& sequence) {
  double majorant = 0;
  for (const global::CompiledMedia* m : media) majorant += m->extinction.max() * m->density_bound;
  Rgb passed(1);
  if (!(majorant > 0)) return passed;
  const auto inverse = static_cast<float>(1.0 / majorant);
  double t = 0;
  for (int step = 0; step < kMaxSteps; ++step) {
    t -= std::log(1.0 - sequence.next()) / majorant;
    if (!(t < length)) return passed;
    passed *= Rgb(1) - at(media, ray.at(t)).extinction * inverse;
    // What hardly passes is decided by chance.
    if (const float left = largest(passed); left < 0.1f) {
      if (sequence.next() >= left / 0.1) return {};
      passed *= 0.1f / left;
    }
  }
  return {};
}

double normalised_phase(const scene::Media& media, double cosine) {
  // Means over the sphere of the functions of spec 07 4.4.
  constexpr double kMeans[6] = {1, 1, 0.576655375 * 2.0, 0.495714547 * (1.0 + 50.0 / 33.0), 0.799372013 * 4.0 / 3.0, 1};
  const int type = std::clamp(media.scattering_type, 1, 5);
  return global::phase(media, cosine) / (4 * kPi * kMeans[type]);
}

}  // namespace verisim::path
