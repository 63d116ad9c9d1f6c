// Stored photons and the density estimate from them (spec 07 sections 3.9 and 3.10).
#pragma once

#include <filesystem>
#include <vector>

#include "tracer/math/c_random.h"
#include "tracer/photons/nearby_radii.h"
#include "tracer/photons/photon_search.h"

namespace verisim::global {

class PhotonMap {
 public:
  void add(const PhotonPosition& position, const Photon& photon) { index_.photons.add(position, photon); }
  void append(const PhotonMap& other) { index_.photons.append(other.list()); }
  std::size_t size() const { return index_.photons.size(); }
  bool empty() const { return index_.photons.empty(); }
  std::span<const Photon> photons() const { return list().photons; }
  std::span<const PhotonPosition> positions() const { return list().positions; }
  void reserve(std::size_t count) { index_.photons.reserve(count); }

  // Sorts the photons into a balanced tree (node of [a,b] at (a+b)/2). Call once, before any search.
  void build();
  void build_sorted();  // the same for photons that are in the order of a file
  // The gather radius: `user` if positive, else estimated from the density around photons that `random` picks; times
  // multiplier (and 2 for media).
  void set_gather_radius(double user, double multiplier, int gather_max, bool media, CLibraryRandom& random);

  // Photons around a point of this map, found by `gather`.
  struct Gathered {
    SomePhotons photons;
    double radius = 0;  // of the disc or sphere that holds them
    // What is kept for the next one.
    std::vector<std::uint32_t> numbers;
    PhotonSearch search;
    NearbyRadii nearby;
    std::vector<std::uint32_t> wider_numbers;  // of the second search
  };
  struct GatherSettings {
    int minimum = 20, maximum = 100;
    double expand_increase = 0.2;
    int expand_minimum = 35;
  };
  // Surface estimate: distances flattened along `normal` (null: media, a sphere). One expansion at most (spec 07 3.10).
  void gather(const Vec3& point, const Vec3* normal, const GatherSettings& settings, Gathered& out) const;

 private:
  const PhotonList& list() const { return index_.photons; }
  double typical_radius(int count) const;
  void find(const PhotonCenter& center, const GatherSettings& settings, Gathered& out) const;

  PhotonIndex index_;
  double radius_ = 0;
};

// POV-Ray's map file (spec 07 3.9): surface map first, media map second. Throw std::runtime_error; a map is used in the
// order of its file, which need not be a tree.
void save_photons(const std::filesystem::path& path, const PhotonMap& surface, const PhotonMap& media);
void load_photons(const std::filesystem::path& path, PhotonMap& surface, PhotonMap& media);

}  // namespace verisim::global
