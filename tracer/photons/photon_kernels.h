// Which photons of a map are near a point, eight at a time. Compiled for several instruction sets; every lane does the
// operations of the scalar code in the same order.
//
// Floats say which may be near; those are measured in doubles. What is found is compared by distances rounded to
// floats, and measured again where these are equal.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tracer/photons/photon_distances.h"

namespace verisim::global {

class PhotonTree;
struct PhotonIndex;

inline constexpr std::size_t kPhotonsAtOnce = 16;

// Sixteen boxes around photons; those that are left over are empty.
struct alignas(64) PhotonBoxes {
  std::array<float, kPhotonsAtOnce> low[3], high[3];
};

inline constexpr auto kAnyNumber = std::numeric_limits<std::size_t>::max();

struct PhotonQuery {
  const PhotonMeasure& measure;
  std::size_t maximum;   // so many nearest are wanted
  std::size_t too_many;  // more are not
  // Photons that a search within `radius` overlooks in any case are left out; null: there are none so near.
  const PhotonIndex* hiding;
  double radius;
};

// By photon: planes that hide it are at most so much farther away than it is from the one who searches.
struct PhotonOverhangs {
  // Level and base are the upper bits of a float; 0: no plane hides it. Behind the last level stand three bytes more,
  // which kernels read.
  std::vector<std::uint8_t> levels;
  std::uint32_t base = 0;
  static constexpr int kShift = 20;
  float largest() const { return std::bit_cast<float>((base + 255u) << kShift); }
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
  // Writes the places in the list of those that are as far as `radius` without their overhang, and perhaps of some that
  // are hardly nearer; returns how many there are. Behind the list stand sixteen numbers, of any size, and there is
  // room for sixteen places more than it has.
  std::size_t (*reaching)(PhotonDistances& list, const PhotonOverhangs& overhangs, double radius,
                          std::uint32_t* places);
};

const PhotonKernels& photon_kernels();
// Those of any instruction set, for tests; null: this machine cannot run it.
const PhotonKernels* photon_kernels(int instruction_set);

}  // namespace verisim::global
