// The order of photons in POV-Ray's map, and what its searches overlook because of it.
//
// The photon in the middle of a range divides the others by one coordinate, and so on within. But ranges of two stay as
// they are, and selecting the middle may leave two photons behind in the wrong order: some 2 % of the relations do not
// hold. A search that takes them for granted overlooks photons on the wrong side of a plane. This shows in pictures,
// and the radius that is found automatically hangs on the order. Measured with the map files of 3.7.0.10.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/photons/photon.h"
#include "tracer/photons/photon_kernels.h"

namespace verisim::global {

// The node of a range [a, b] at (a + b) / 2, with its axis.
void sort_photons(PhotonList& photons);

// The planes on whose wrong side photons lie.
class WrongPlanes {
 public:
  void build(const PhotonList& sorted);
  // Whether there are any that can hide photons within a distance from the point of a search that looks at all planes
  // nearer than `radius`.
  bool hide(double distance, double radius) const {
    return (distance + largest_overhang_) * (1.0 + kRounding) >= radius;
  }
  // Removes photons from number `from` of the list on that a search around p for photons nearer than `radius` does not
  // come upon.
  void drop_hidden(const PhotonList& sorted, const Vec3& p, double radius, std::size_t from,
                   PhotonDistances& list) const;
  const PhotonOverhangs& overhangs() const { return overhangs_; }
  static constexpr double kRounding = 1e-9;  // of distances

  // Calls visit(node, squared distance of its plane) for the planes that hide photon i from such a search, as long as
  // visit returns true; then returns that.
  template <class Visit>
  bool for_each_hiding(const PhotonList& sorted, std::size_t i, const Vec3& p, double squared, Visit&& visit) const {
    std::size_t k = first_[i / kBlock];
    while (k < planes_.size() && planes_[k].photon < i) ++k;
    for (; k < planes_.size() && planes_[k].photon == i; ++k) {
      const std::uint32_t node = planes_[k].node;
      const std::uint8_t axis = sorted.photons[node].axis;
      const double d = p[axis] - sorted.positions[node][axis];
      // Behind the node are the photons above its plane, for those who search from below.
      if ((d < 0.0) == (i > node) && d * d >= squared && !visit(node, d * d)) return false;
    }
    return true;
  }

 private:
  // That of a node, where it hides a photon on its wrong side.
  struct Plane {
    std::uint32_t photon, node;
  };
  void note_overhangs(const PhotonList& sorted);

  PhotonOverhangs overhangs_;
  double largest_overhang_ = 0;
  static constexpr std::size_t kBlock = 16;
  ReallocVector<Plane> planes_;       // by photons, of each from the root on; few photons have any
  std::vector<std::uint32_t> first_;  // where those of a block of photons begin
};

// The first of ascending numbers that is not smaller than `least`; `end` if there is none. Without branches that cannot
// be foretold, but for those that find all on one side, as in large ranges.
inline const std::uint32_t* first_from(const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t least) {
  if (begin == end || *begin >= least) return begin;
  if (end[-1] < least) return end;
  for (std::ptrdiff_t n = end - begin; n > 1;) {
    const std::ptrdiff_t half = n / 2;
    begin += begin[half] < least ? half : 0;
    n -= half;
  }
  return begin + 1;  // it is smaller
}

// What visit_in_order comes upon before it looks behind the plane of `node`, if nothing is too far for it.
struct VisitedBefore {
  std::size_t count = 0;       // of some photons, by number and in ascending order
  bool after_another = false;  // a photon for which `is_other` comes before the last one counted; not all are looked at
};
template <class IsOther>
VisitedBefore visited_before(const PhotonList& sorted, const Vec3& p, std::uint32_t node,
                             std::span<const std::uint32_t> photons, IsOther&& is_other) {
  // `inside`: those of the photons that are in the range of a node, which gets smaller.
  std::uint32_t first = 0, last = static_cast<std::uint32_t>(sorted.size()) - 1;
  const std::uint32_t *inside = photons.data(), *inside_end = inside + photons.size();
  VisitedBefore result;
  bool another = false;
  const auto add = [&](std::ptrdiff_t n) {
    result.count += static_cast<std::size_t>(n), result.after_another |= n > 0 && another;
  };
  while (inside != inside_end) {
    const std::uint32_t middle = (first + last) / 2;
    const std::uint32_t* const above = first_from(inside, inside_end, middle);
    const std::uint32_t* const beyond = above + (above != inside_end && *above == middle);
    const std::uint8_t axis = sorted.photons[middle].axis;
    const bool near_below = p[axis] - sorted.positions[middle][axis] < 0.0;
    add(beyond - above);
    another = another || is_other(middle);
    if (node == middle || (node < middle) != near_below) add(near_below ? above - inside : inside_end - beyond);
    if (node == middle) break;
    if (node < middle) {
      last = middle - 1, inside_end = above;
    } else {
      first = middle + 1, inside = beyond;
    }
  }
  return result;
}

// Calls visit(index) for photons in the order of POV-Ray's search: a node, then the side of its plane where p lies,
// then the other if it is nearer than the square root of `limit`, which visit may lower.
template <class Visit>
void visit_in_order(const PhotonList& sorted, const Vec3& p, const double& limit, Visit&& visit) {
  struct Part {
    std::uint32_t first, end;
    double squared;  // how far behind a plane
  };
  std::array<Part, 2 * 64> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, static_cast<std::uint32_t>(sorted.size()), -1.0};
  while (depth > 0) {
    const Part part = stack[--depth];
    if (part.first == part.end || !(part.squared < limit)) continue;
    const std::uint32_t middle = part.first + (part.end - part.first - 1) / 2;
    visit(middle);
    const std::uint8_t axis = sorted.photons[middle].axis;
    const double d = p[axis] - sorted.positions[middle][axis];
    const Part below{part.first, middle, d < 0.0 ? -1.0 : d * d}, above{middle + 1, part.end, d < 0.0 ? d * d : -1.0};
    stack[depth++] = d < 0.0 ? above : below;
    stack[depth++] = d < 0.0 ? below : above;
  }
}

}  // namespace verisim::global
