// The nearest photons of a map, as POV-Ray's search finds them: a few are overlooked (photon_order.h).
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/photons/photon.h"
#include "tracer/photons/photon_kernels.h"
#include "tracer/photons/photon_order.h"
#include "tracer/photons/photon_tree.h"

namespace verisim::global {

// Photons in the order of their map, and what finds them.
struct PhotonIndex {
  PhotonList photons;
  WrongPlanes planes;
  PhotonTree tree;

  void build() {
    photons.fit();
    planes.build(photons);
    tree.build(photons.positions);
  }
};

// Searches of one thread, one after the other.
class PhotonSearch {
 public:
  // Writes the numbers of the nearest photons within `radius` that are at most `maximum`; returns the radius of what
  // holds them, or 0 if there are `too_many`. `guess`: a radius that may be enough; 0: none.
  double nearest(const PhotonIndex& index, const PhotonCenter& center, double radius, int maximum, std::size_t too_many,
                 double guess, std::vector<std::uint32_t>& out);

 private:
  struct Doubt {
    std::uint32_t photon, node;
    double squared;  // distance of the node's plane
  };
  struct Found {
    double squared;
    std::uint32_t index;
  };
  enum class Verdict { found, overlooked, unknown };

  Collected collect(double within, std::size_t most, std::size_t too_many);
  void keep_nearest();
  bool drop_overlooked();
  bool another_was_early();
  void find_doubts(double judged);
  Verdict judge(const Doubt& doubt);
  Verdict judge_by_found(const Doubt& doubt);
  void look_around(double squared);
  void forget(std::uint32_t photon);
  void collect_in_order();
  void add_to_heap(const Found& found);
  void replace_farthest(const Found& found);

  const PhotonKernels& kernels_ = photon_kernels();
  // What is looked for.
  const PhotonIndex* index_ = nullptr;
  PhotonMeasure measure_{nullptr, {Vec3(0.0), Vec3(0.0)}};
  double radius_ = 0;
  std::size_t maximum_ = 0;
  // All photons whose squared distance is below `limit_` are in `found_`, but for those that no search finds; the
  // nearest of them are in `kept_`, none beyond `farthest_`.
  PhotonDistances found_, kept_;
  double limit_ = 0, farthest_ = 0;
  // Photons that were found and may be overlooked, and why; those that are.
  std::vector<Doubt> doubts_;
  std::vector<std::uint32_t> overlooked_;
  // Scratch.
  PhotonDistances nearer_;
  std::vector<std::uint32_t> places_;
  std::vector<Found> heap_;  // the farthest first, once it is full
};

}  // namespace verisim::global
