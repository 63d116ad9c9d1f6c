// Where photons start: rings of directions around the line from a light to a target (spec 07 sections 3.3 to 3.5).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tracer/scene/scene.h"

namespace verisim::global {

// MT19937 with the standard seed, tabulated and read cyclically; the index is advanced before each read (spec 07
// section 1).
class RandomTable {
 public:
  RandomTable();
  double next() {
    index_ = (index_ + 1) % numbers_.size();
    return numbers_[index_];
  }

 private:
  std::span<const double> numbers_;
  std::size_t index_ = 0;
};

// One light and one target object, with what is allowed to happen to the photons.
struct PhotonPair {
  const scene::LightSource* light = nullptr;
  const scene::Object* target = nullptr;
  Vec3 center;  // bounding sphere of the target
  double radius = 0;
  double density = 1;  // the number after `target`
  bool reflection = false, refraction = false;
};
// All pairs that are used, in POV-Ray's order: lights, then targets in the order of the world's objects.
std::vector<PhotonPair> photon_pairs(const scene::Scene& scene, std::span<const scene::Object* const> objects);
// The spacing in force: that of the settings, or computed from `count` (spec 07 3.4).
double photon_spacing(const scene::Photons& settings, std::span<const PhotonPair> pairs);

struct PhotonStart {
  Ray ray;
  float energy = 1;  // share of the light's colour (area lights divide it)
};
// Calls trace(starts, sigma, done) for every ring of starts, in batches, sigma being the spacing per unit of distance
// (parallel lights: per se) and `done` the fraction shot so far. `trace` returns whether any photon of the batch hit
// the target; rings end by autostop or at the target's edge. Throws render::LimitExceeded for a spacing so fine that it
// would not end.
void shoot(const PhotonPair& pair, double spacing, const scene::Photons& settings, RandomTable& random,
           const std::function<bool(std::span<const PhotonStart>, double, double)>& trace);

}  // namespace verisim::global
