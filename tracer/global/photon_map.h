// Stored photons and the density estimate from them (spec 07 sections 3.9 and 3.10).
#pragma once

#include <bit>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "tracer/global/c_random.h"
#include "tracer/global/photon_order.h"
#include "tracer/global/photon_search.h"

namespace verisim::global {

// Photons by number, with their flattened distances, squared.
class PhotonDistances {
 public:
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }
  std::span<const double> squared() const { return {squared_.data(), size_}; }
  std::span<const std::uint32_t> index() const { return {index_.data(), size_}; }
  void add(std::uint32_t index, double squared) { add(index, 1, &squared); }
  // Of sixteen photons from number `first` on those whose bits are set.
  void add(std::uint32_t first, unsigned bits, const double* squared);
  // Keeps the `maximum` nearest, in their order; of equally far ones the first. `limit`: none is farther; then the distance of the last one kept.
  void keep_nearest(std::size_t maximum, double& limit);

 private:
  std::vector<double> squared_;  // these are longer
  std::vector<std::uint32_t> index_;
  std::vector<double> between_;
  std::size_t size_ = 0;
};

inline void PhotonDistances::add(std::uint32_t first, unsigned bits, const double* squared) {
  if (size_ + PhotonPositions::kAtOnce > index_.size()) squared_.resize(2 * size_ + 64), index_.resize(2 * size_ + 64);
  double* const to = squared_.data();
  std::uint32_t* const to_index = index_.data();
  std::size_t n = size_;
  for (; bits != 0; bits &= bits - 1, ++n) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(bits));
    to[n] = squared[i], to_index[n] = first + i;
  }
  size_ = n;
}

class PhotonMap {
 public:
  void add(const Photon& photon) { photons_.push_back(photon); }
  void append(const PhotonMap& other) { photons_.insert(photons_.end(), other.photons_.begin(), other.photons_.end()); }
  std::size_t size() const { return photons_.size(); }
  bool empty() const { return photons_.empty(); }
  const std::vector<Photon>& photons() const { return photons_; }
  std::vector<Photon>& photons() { return photons_; }

  // Sorts the photons into a balanced tree (node of [a,b] at (a+b)/2). Call once, before any search.
  void build();
  void build_sorted();  // the same for photons that are in the order of a file
  // The gather radius: `user` if positive, else estimated from the density around photons that `random` picks; times multiplier (and 2 for media).
  void set_gather_radius(double user, double multiplier, int gather_max, bool media, CLibraryRandom& random);
  double gather_radius() const { return radius_; }

  // Scratch of searches in one map, and what helps the next one.
  struct Search {
    PhotonDistances found;
    PhotonDistances around, doubts;  // of `depends_on_order`; doubts: planes and their nodes
    std::vector<std::uint32_t> nearer;
    NearbyRadii nearby;
  };
  // Photons around a point of this map, found by `gather`.
  struct Gathered {
    std::vector<const Photon*> photons;
    double radius = 0;  // of the disc or sphere that holds them
    Search search;
    // The second, wider search.
    std::vector<const Photon*> wider_photons;
    Search wider_search;
  };
  struct GatherSettings {
    int minimum = 20, maximum = 100;
    double expand_increase = 0.2;
    int expand_minimum = 35;
  };
  // Surface estimate: distances flattened along `normal` (null: media, a sphere). One expansion at most (spec 07 3.10).
  void gather(const Vec3& point, const Vec3* normal, const GatherSettings& settings, Gathered& out) const;

 private:
  // Where a search is made: distances are flattened along the normal, unless it is zero.
  struct Center {
    Vec3 point, normal;
  };
  // The nearest photons within `radius` that are at most `maximum`; returns the radius of what holds them, or 0 if there are `too_many`.
  // `guess`: a radius that may be enough; 0: none.
  double search(const Center& center, double radius, int maximum, std::size_t too_many, double guess, Search& scratch, std::vector<const Photon*>& out) const;
  enum class Collected { all, nearest, too_many };
  Collected collect(const Center& center, double within, double radius, std::size_t maximum, std::size_t too_many, Search& search, double& farthest) const;
  bool depends_on_order(const Center& center, double radius, std::size_t maximum, double farthest, Search& search) const;
  void collect_in_order(const Center& center, double radius, std::size_t maximum, Search& search, double& farthest) const;
  // Bit i: photon first + i is nearer than the limit; of at most sixteen.
  unsigned near(const Center& center, double limit, std::uint32_t first, std::uint32_t count, double* squared) const {
    return kernels_.near(tree_.positions(), first, center.point, center.normal, limit, squared) & ((1u << count) - 1);
  }

  double typical_radius(int count) const;

  const PhotonKernels& kernels_ = photon_kernels();
  std::vector<Photon> photons_;
  WrongPlanes planes_;
  PhotonTree tree_;
  double radius_ = 0;
};

// POV-Ray's map file (spec 07 3.9): surface map first, media map second. Throw std::runtime_error; a map is used in the order of its file, which need not be a tree.
void save_photons(const std::filesystem::path& path, const PhotonMap& surface, const PhotonMap& media);
void load_photons(const std::filesystem::path& path, PhotonMap& surface, PhotonMap& media);

}  // namespace verisim::global
