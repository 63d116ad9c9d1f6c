#include "tracer/shapes/half_spaces.h"

#include <cmath>
#include <vector>

namespace verisim::shapes {
namespace {

// Hits are at most this far away (spec 03 4.5).
constexpr double kFarthest = 1e7;
// Of more half spaces only the axis-parallel ones count: there are too many triples.
constexpr std::size_t kMax = 24;
constexpr double kSteepest = 1e6, kLeastWeight = -1e-12;

// One direction of one axis, as a bound from above.
struct Side {
  int axis;
  double sign;
  double bound(const Box3& box) const { return sign > 0 ? box.max[axis] : -box.min[axis]; }
  void lower(Box3& box, double to) const {
    if (!(to < bound(box))) return;
    if (sign > 0)
      box.max[axis] = to;
    else
      box.min[axis] = -to;
  }
};
constexpr Side kSides[] = {{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}};

bool along_axis(const Vec3& n) { return (n.x != 0) + (n.y != 0) + (n.z != 0) == 1; }

// If e is the sum of weight[i] * half_spaces[i].normal with weights above 0, e . p is at most the same sum of the
// distances: duality of linear programs.
void lower_by(Box3& box, const Side& side, std::span<const HalfSpace* const> planes, const double* weights) {
  Vec3 rest(0);
  rest[side.axis] = side.sign;
  double bound = 0, size = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!(weights[i] >= kLeastWeight && weights[i] < kSteepest)) return;
    const double w = std::fmax(weights[i], 0);
    rest -= w * planes[i]->normal;
    bound += w * planes[i]->distance;
    size += std::fabs(w * planes[i]->distance);
  }
  const double error = (std::fabs(rest.x) + std::fabs(rest.y) + std::fabs(rest.z)) * 2 * kFarthest;
  if (error < 1e-3) side.lower(box, bound + error + 1e-9 * (1 + size));
}

}  // namespace

Box3 narrowed(const Box3& known, std::span<const HalfSpace> half_spaces) {
  Box3 box = known;
  std::vector<HalfSpace> planes;
  for (const HalfSpace& h : half_spaces) {
    if (along_axis(h.normal)) {
      const HalfSpace* one[] = {&h};
      for (const Side& side : kSides) {
        const double weight = side.sign / h.normal[side.axis];
        if (weight > 0 && std::isfinite(weight)) lower_by(box, side, one, &weight);
      }
    } else {
      planes.push_back(h);
    }
  }
  const std::size_t oblique = planes.size();
  if (oblique == 0 || oblique + 6 > kMax) return box;
  for (const Side& side : kSides) {
    if (!std::isfinite(side.bound(box))) continue;
    Vec3 normal(0);
    normal[side.axis] = side.sign;
    planes.push_back({normal, side.bound(box)});
  }
  const auto try_sides = [&](std::span<const HalfSpace* const> chosen, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double det = dot(a, bc);
    if (!(std::fabs(det) > 1e-9)) return;
    const double inverse = 1 / det;
    for (const Side& side : kSides) {
      const double scale = side.sign * inverse;
      const double weights[] = {bc[side.axis] * scale, ca[side.axis] * scale, ab[side.axis] * scale};
      if (weights[0] >= kLeastWeight && weights[1] >= kLeastWeight) lower_by(box, side, chosen, weights);
    }
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    // Without an oblique plane, of which the first ones are, nothing is learnt.
    for (std::size_t j = 0; j < i && j < oblique; ++j) {
      // Two planes alone: the weight of the direction along both must be none.
      const HalfSpace* two[] = {&planes[i], &planes[j]};
      try_sides(two, planes[i].normal, planes[j].normal, cross(planes[i].normal, planes[j].normal));
    }
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j && k < oblique; ++k) {
        const HalfSpace* three[] = {&planes[i], &planes[j], &planes[k]};
        try_sides(three, planes[i].normal, planes[j].normal, planes[k].normal);
      }
    }
  }
  return box;
}

}  // namespace verisim::shapes
