// Which photons of a map are near a point, eight at a time. Compiled for several instruction sets; every lane does the
// operations of the scalar code in the same order.
//
// Floats say which may be near; those are measured in doubles. What is found is compared by distances rounded to
// floats, and measured again where these are equal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/photons/photon.h"
#include "tracer/math/vec.h"

namespace verisim::global {

class PhotonTree;
class WrongPlanes;

// Sixteen photons side by side; those that are left over are infinitely far away.
struct alignas(64) PhotonLeaf {
  static constexpr std::size_t kAtOnce = 16;
  std::array<float, kAtOnce> x, y, z;
};

// Sixteen boxes around photons; those that are left over are empty.
struct alignas(64) PhotonBoxes {
  std::array<float, PhotonLeaf::kAtOnce> low[3], high[3];
};

// Where a search is made: distances are flattened along the normal, unless it is zero. Squared distances off the plane
// through the point are larger by a factor 1 + 16 |normal . delta|.
struct PhotonCenter {
  Vec3 point, normal;
  double squared_distance(const Photon& photon) const {
    const Vec3 d = Vec3(photon.position[0], photon.position[1], photon.position[2]) - point;
    return dot(d, d) * (1.0 + 16.0 * std::fabs(dot(normal, d)));
  }
};

// Photons of a map, measured from a center.
struct PhotonMeasure {
  const Photon* photons;
  PhotonCenter center;
  double squared(std::uint32_t number) const { return center.squared_distance(photons[number]); }
};

// Photons by number, with their flattened distances, squared and rounded.
class PhotonDistances {
 public:
  // What is not smaller is not smaller when rounded; all are finite.
  static float rounded(double squared) { return static_cast<float>(std::min(squared, 3e38)); }

  std::size_t size() const { return size_; }
  std::span<const float> squared() const { return {squared_.data(), size_}; }
  std::span<const std::uint32_t> index() const { return {index_.data(), size_}; }
  void clear() { size_ = 0; }
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
    if (size + PhotonLeaf::kAtOnce > index_.size()) grow(size);
  }
  float* squared_data() { return squared_.data(); }
  std::uint32_t* index_data() { return index_.data(); }
  void set_size(std::size_t size) { size_ = size; }

 private:
  void grow(std::size_t size);

  std::vector<float> squared_;  // these are longer
  std::vector<std::uint32_t> index_;
  std::size_t size_ = 0;
};

struct PhotonQuery {
  const PhotonMeasure& measure;
  std::size_t maximum;   // so many nearest are wanted
  std::size_t too_many;  // more are not
  // Photons that a search within `radius` overlooks in any case are left out; null: there are none so near.
  const WrongPlanes* planes;
  double radius;
};

enum class Collected { all, nearest, too_many };

struct PhotonKernels {
  // Bit i: box i is nearer to the point than the square root of `squared`, or as near.
  unsigned (*boxes)(const PhotonBoxes& boxes, const std::array<float, 3>& point, float squared);
  // Finds the photons whose squared distance is below `limit`, in the order of the map. `nearest`: there are many more
  // than the maximum, and only those below a lower `limit`, or at it, were found, at least the maximum. Gives up when
  // it knows that there are `too_many` or more.
  Collected (*collect)(const PhotonTree& tree, const PhotonQuery& query, double& limit, PhotonDistances& found);
  // Copies the `maximum` nearest of more than that to `to` (which may be `from`), in their order; of equally far ones
  // the first. `limit`: none is farther; then the squared distance of the last one kept.
  void (*keep_nearest)(PhotonDistances& from, const PhotonMeasure& measure, std::size_t maximum, double& limit,
                       PhotonDistances& to);
  // Copies those with squared distances of at most `limit`.
  void (*keep_within)(PhotonDistances& from, const PhotonMeasure& measure, double limit, PhotonDistances& to);
  // Writes the places in the list of those that are as far as `radius - overhang[index]`, and perhaps of some that are
  // hardly nearer; returns how many there are. Behind the list stand sixteen numbers, of any size, and there is room
  // for sixteen places more than it has.
  std::size_t (*reaching)(PhotonDistances& list, const float* overhang, double radius, std::uint32_t* places);
};

const PhotonKernels& photon_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const PhotonKernels* photon_kernels(int instruction_set);

}  // namespace verisim::global
