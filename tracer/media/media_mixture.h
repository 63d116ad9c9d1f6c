// What media of one interval of a ray are together, and the intervals that they are sampled in (spec 07 sections 4.4
// and 4.5).
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "tracer/media/media.h"
#include "tracer/media/media_kernels.h"

namespace verisim::global {

// All media of an interval. At least one.
struct MediaMixture {
  explicit MediaMixture(std::span<const CompiledMedia* const> media);
  // Mean phase for the cosine between the directions to the light and of the view ray, over all media, also those
  // without scattering (isotropic).
  double mean_phase(double cosine) const;
  // Sets what is scattered of what arrives in the lanes.
  void scatter(int count, MediaPacket& packet) const;

  std::span<const CompiledMedia* const> media;
  const scene::Media* control;  // that asks for most intervals
  double aa_threshold;
  bool scatters = false, isotropic = true, has_density = false, varies = false;
  bool constant_shadow = true;  // POV-Ray believes so of every medium (spec 07 4.6)
  // Method 3 looks at q sub-intervals on a grid of step 1 / (q + 1).
  int subintervals() const { return std::max(2, control->samples_min / 2 + 1); }
  // How often a sub-interval may be halved: no more than a double can be, or an aa_level of a billion never ended where
  // no threshold is met.
  int halvings() const { return std::min(control->aa_level, 1100) - 1; }
};

struct MediaInterval {
  double start, length;
  bool lit;  // lights are looked at only in lit pieces
};

// Where a light shines on a ray.
struct LitRange {
  std::size_t light;
  double first, last;
};

class MediaIntervals {
 public:
  // Keeps the lights that shine on ray.at(0) .. ray.at(length).
  void look_for_lights(std::span<const scene::LightSource* const> lights, const Ray& ray, double length);
  void divide(const MediaMixture& mixture, double length);

  std::span<const LitRange> lit() const { return {lit_.data(), static_cast<std::size_t>(lit_count_)}; }
  std::span<const MediaInterval> all() const { return {intervals_.data(), static_cast<std::size_t>(count_)}; }

 private:
  static constexpr int kMaxIntervals = 256;  // POV-Ray stops the render beyond
  static constexpr int kMaxLights = 256;
  static constexpr int kMax = kMaxIntervals + 2 * kMaxLights + 1;  // one more by rounding

  // `last`: of the ray's pieces.
  void push(double start, double end, bool lit, int count, bool last);

  int lit_count_ = 0, count_ = 0;
  std::array<LitRange, kMaxLights> lit_;
  std::array<MediaInterval, kMax> intervals_;
};

}  // namespace verisim::global
