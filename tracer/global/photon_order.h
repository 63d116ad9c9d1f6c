// The order of photons in POV-Ray's map, and what its searches overlook because of it.
//
// The photon in the middle of a range divides the others by one coordinate, and so on within. But ranges of two stay as they are, and selecting the middle
// may leave two photons behind in the wrong order: some 2 % of the relations do not hold. A search that takes them for granted overlooks photons on the
// wrong side of a plane. This shows in pictures, and the radius that is found automatically hangs on the order. Measured with the map files of 3.7.0.10.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tracer/global/photon.h"

namespace verisim::global {

// The node of a range [a, b] at (a + b) / 2, with its axis.
void sort_photons(std::vector<Photon>& photons);

// The planes on whose wrong side photons lie.
class WrongPlanes {
 public:
  void build(std::span<const Photon> sorted);
  // Whether a search around p for photons nearer than the square root of `squared` comes upon photon i.
  bool looks_behind(std::size_t i, const Vec3& p, double squared) const {
    return for_each_hiding(i, p, squared, [](std::uint32_t, double) { return false; });
  }
  // Calls visit(node, squared distance of its plane) for the planes that hide photon i from such a search, as long as visit returns true; then returns that.
  template <class Visit>
  bool for_each_hiding(std::size_t i, const Vec3& p, double squared, Visit&& visit) const {
    for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
      const Plane& plane = planes_[k];
      const double d = p[plane.axis] - plane.at;
      if ((d < 0.0) == plane.from_below && d * d >= squared && !visit(plane.node, d * d)) return false;
    }
    return true;
  }

 private:
  struct Plane {
    float at;
    std::uint32_t node;
    std::uint8_t axis;
    bool from_below;  // overlooked from there, not from above
  };
  std::vector<std::uint32_t> first_;
  std::vector<Plane> planes_;  // those of photon i from first_[i] on
};

// Whether visit_in_order, if nothing is too far for it, comes upon photon i before it looks behind the plane of `node`.
bool visited_before(std::span<const Photon> sorted, const Vec3& p, std::uint32_t i, std::uint32_t node);

// Calls visit(index) in the order of POV-Ray's search: a node, then the side of its plane where p lies, then the other if it is nearer than the square root of
// `limit`, which visit may lower.
template <class Visit>
void visit_in_order(std::span<const Photon> sorted, const Vec3& p, const double& limit, Visit&& visit) {
  struct Part {
    std::ptrdiff_t first, last;
    double squared;  // how far behind a plane
  };
  std::array<Part, 2 * 64> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, static_cast<std::ptrdiff_t>(sorted.size()) - 1, -1.0};
  while (depth > 0) {
    const Part part = stack[--depth];
    if (part.first > part.last || !(part.squared < limit)) continue;
    const std::ptrdiff_t middle = (part.first + part.last) / 2;
    const Photon& node = sorted[static_cast<std::size_t>(middle)];
    const double d = p[node.axis] - node.position[node.axis];
    visit(static_cast<std::uint32_t>(middle));
    const Part below{part.first, middle - 1, d < 0.0 ? -1.0 : d * d}, above{middle + 1, part.last, d < 0.0 ? d * d : -1.0};
    stack[depth++] = d < 0.0 ? above : below;
    stack[depth++] = d < 0.0 ? below : above;
  }
}

}  // namespace verisim::global
