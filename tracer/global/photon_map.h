// Stored photons and the density estimate from them (spec 07 sections 3.9 and 3.10).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tracer/global/c_random.h"
#include "tracer/global/photon_order.h"
#include "tracer/global/photon_search.h"

namespace verisim::global {

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
    struct Found {
      double squared;
      std::uint32_t index;
    };
    std::vector<Found> found;
    std::vector<Found> around, doubts;  // of `depends_on_order`; doubts: planes and their nodes
    std::vector<double> distances;
    PhotonNeighbourhoods nearby;
    void keep_nearest(std::size_t maximum, double& limit);
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
  // The nearest photons within `radius` that are at most `maximum`; returns the radius of what holds them, or 0 if there are `too_many`.
  // `guess`: a radius that may be enough, 0: none; the one that was.
  double search(const Vec3& point, const Vec3* normal, double radius, int maximum, std::size_t too_many, double& guess, Search& scratch,
                std::vector<const Photon*>& out) const;
  enum class Collected { all, nearest, too_many };
  template <class Candidates>
  Collected collect(const Candidates& candidates, const Vec3& point, const Vec3* normal, double within, double radius, std::size_t maximum,
                    std::size_t too_many, Search& search, double& farthest) const;
  bool depends_on_order(const Vec3& point, const Vec3* normal, double radius, std::size_t maximum, double farthest, Search& search) const;
  void collect_in_order(const Vec3& point, const Vec3* normal, double radius, std::size_t maximum, Search& search, double& farthest) const;
  bool fill(PhotonNeighbourhoods::Cell& cell, std::size_t most) const;

  double typical_radius(int count) const;

  std::vector<Photon> photons_;
  WrongPlanes planes_;
  PhotonTree tree_;
  double radius_ = 0;
};

// POV-Ray's map file (spec 07 3.9): surface map first, media map second. Throw std::runtime_error; a map is used in the order of its file, which need not be a tree.
void save_photons(const std::filesystem::path& path, const PhotonMap& surface, const PhotonMap& media);
void load_photons(const std::filesystem::path& path, PhotonMap& surface, PhotonMap& media);

}  // namespace verisim::global
