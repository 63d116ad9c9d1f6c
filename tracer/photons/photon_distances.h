// Photons near a point with their distances: what searches of a map find.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/math/vec.h"
#include "tracer/photons/photon.h"

namespace verisim::global {

// Where a search is made: distances are flattened along the normal, unless it is zero. Squared distances off the plane
// through the point are larger by a factor 1 + 16 |normal . delta|.
struct PhotonCenter {
  Vec3 point, normal;
  double squared_distance(const PhotonPosition& photon) const {
    const Vec3 d = Vec3(photon[0], photon[1], photon[2]) - point;
    return dot(d, d) * (1.0 + 16.0 * std::fabs(dot(normal, d)));
  }
};

// Photons of a map, measured from a center.
struct PhotonMeasure {
  const PhotonPosition* positions;
  PhotonCenter center;
  double squared(std::uint32_t number) const { return center.squared_distance(positions[number]); }
};

// Photons by number, with their flattened distances, squared and rounded.
class PhotonDistances {
 public:
  static constexpr std::size_t kRoom = 16;  // behind the last one, for kernels to write
  // What is not smaller is not smaller when rounded; all are finite.
  static float rounded(double squared) { return static_cast<float>(std::min(squared, 3e38)); }

  std::size_t size() const { return size_; }
  std::span<const float> squared() const { return {squared_.data(), size_}; }
  std::span<const std::uint32_t> index() const { return {index_.data(), size_}; }
  void clear() { size_ = 0, split_ = -1; }
  // The squared distance of photons that are equally far, of which only some are left in the list; negative: none.
  double split() const { return split_; }
  void set_split(double squared) { split_ = squared; }
  void add(std::uint32_t index, double squared) {
    make_room(size_ + 1);
    squared_[size_] = rounded(squared), index_[size_++] = index;
  }
  // Takes one out; the others stay in their order.
  void erase(std::size_t i);
  // Copies those of [from, end) to places before them.
  void move(std::size_t from, std::size_t end, std::size_t to);

  // For kernels: room for `size`, and sixteen more that may be written behind the last.
  void make_room(std::size_t size) {
    if (size + kRoom > index_.size()) grow(size);
  }
  float* squared_data() { return squared_.data(); }
  std::uint32_t* index_data() { return index_.data(); }
  void set_size(std::size_t size) { size_ = size; }

 private:
  void grow(std::size_t size);

  std::vector<float> squared_;  // these are longer
  std::vector<std::uint32_t> index_;
  std::size_t size_ = 0;
  double split_ = -1;
};

// Of those that are as far as `limit` when rounded, removes those that are farther.
void drop_farther(PhotonDistances& list, const PhotonMeasure& measure, double limit);
// Of those that are as far as the last one when rounded, keeps the nearest, until there are `wanted` in all; returns
// the squared distance of the last one. Notes it if others that are as far are dropped.
double drop_farthest(PhotonDistances& list, float last, const PhotonMeasure& measure, std::size_t wanted);

}  // namespace verisim::global
