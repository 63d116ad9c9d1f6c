// Delta tracking and ratio tracking in participating media: unbiased, whatever the densities are (Woodcock et al. 1965;
// Novak et al. 2014).
#pragma once

#include <span>

#include "tracer/media/media.h"
#include "tracer/path/sequence.h"

namespace verisim::path {

struct VolumeWalk {
  bool scattered = false;
  double distance = 0;                            // of the place of scattering
  const global::CompiledMedia* medium = nullptr;  // what scattered there
};

// Follows light backwards along [0, length]: adds what the media emit, times `weight`, to `sum`; either it arrives at
// the end or it is scattered on the way, and `weight` is changed to what it then carries (scattering coefficient over
// probability).
VolumeWalk delta_track(std::span<const global::CompiledMedia* const> media, const Ray& ray, double length,
                       Sequence& sequence, Rgb& weight, Rgb& sum);

// An unbiased estimate of the share that passes.
Rgb transmittance(std::span<const global::CompiledMedia* const> media, const Ray& ray, double length,
                  Sequence& sequence);

// Normalised phase function (its integral over the sphere is 1): the mean over the sphere of POV-Ray's value for this
// medium makes it so.
double normalised_phase(const scene::Media& media, double cosine);

}  // namespace verisim::path
