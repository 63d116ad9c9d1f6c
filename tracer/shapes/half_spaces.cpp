#include "tracer/shapes/half_spaces.h"

#include <cmath>
#include <vector>

namespace verisim::shapes {
namespace {

// Hits are at most this far away (spec 03 4.5).
constexpr double kFarthest = 1e7;
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
  Vec3 normal() const {
    Vec3 n(0);
    n[axis] = sign;
    return n;
  }
};
constexpr Side kSides[] = {{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}};

bool along_axis(const Vec3& n) { return (n.x != 0) + (n.y != 0) + (n.z != 0) == 1; }

// If e is the sum of weight[i] * half_spaces[i].normal with weights above 0, e . p is at most the same sum of the
// distances: duality of linear programs.
void lower_by(Box3& box, const Side& side, std::span<const HalfSpace* const> planes, const double* weights) {
  Vec3 rest = side.normal();
  double bound = 0, size = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!(weights[i] >= kLeastWeight && weights[i] < kSteepest)) return;
    const double w = std::fmax(weights[i], 0);
    if (w == 0) continue;
    rest -= w * planes[i]->normal;
    bound += w * planes[i]->distance;
    size += std::fabs(w * planes[i]->distance);
  }
  const double error = (std::fabs(rest.x) + std::fabs(rest.y) + std::fabs(rest.z)) * 2 * kFarthest;
  if (error < 1e-3) side.lower(box, bound + error + 1e-9 * (1 + size));
}

// The largest coordinate of a polytope by the dual simplex method: a corner of a box around it moves along edges of
// the planes met so far until no plane cuts it off. Each corner's three planes give a bound, so it may stop anywhere.
class Corner {
 public:
  // The planes, then the six sides of a box; what is infinite of it is `kNowhere` away and bounds nothing.
  Corner(std::span<const HalfSpace> planes, const Side& side) : planes_(planes), side_(side) {
    const std::size_t first = planes.size() - std::size(kSides);
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t towards = first + 2 * static_cast<std::size_t>(axis);
      basis_[axis] = &planes_[axis == side.axis && side.sign < 0 ? towards + 1 : towards];
      weights_[axis] = axis == side.axis ? 1 : 0;
    }
  }

  void lower(Box3& box) {
    for (int step = 0; step < kMaxSteps && move(); ++step)
      if (bounded()) lower_by(box, side_, basis_, weights_);
  }

  static constexpr double kNowhere = 1e8;

 private:
  static constexpr int kMaxSteps = 40;

  bool bounded() const {
    for (int i = 0; i < 3; ++i)
      if (basis_[i]->distance == kNowhere && weights_[i] > 0) return false;
    return true;
  }

  // To the corner behind the plane that cuts most off; false: none does, or all is cut off.
  bool move() {
    const Vec3 &a = basis_[0]->normal, &b = basis_[1]->normal, &c = basis_[2]->normal;
    const Vec3 bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double det = dot(a, bc);
    if (!(std::fabs(det) > 1e-12)) return false;
    const Vec3 corner = (basis_[0]->distance * bc + basis_[1]->distance * ca + basis_[2]->distance * ab) / det;
    const HalfSpace* worst = nullptr;
    double most = 1e-14 * (1 + length(corner));
    for (const HalfSpace& plane : planes_)
      if (const double over = dot(plane.normal, corner) - plane.distance; over > most) most = over, worst = &plane;
    if (!worst) return false;
    // It takes the place of the plane whose weight is first used up.
    const double shares[] = {dot(worst->normal, bc) / det, dot(worst->normal, ca) / det, dot(worst->normal, ab) / det};
    int leaving = -1;
    for (int i = 0; i < 3; ++i) {
      if (!(shares[i] > 1e-9)) continue;
      const double sooner = leaving < 0 ? 1 : weights_[leaving] * shares[i] - weights_[i] * shares[leaving];
      if (sooner > 0 || (sooner == 0 && shares[i] > shares[leaving])) leaving = i;
    }
    if (leaving < 0) return false;
    const double weight = weights_[leaving] / shares[leaving];
    for (int i = 0; i < 3; ++i) weights_[i] = std::fmax(weights_[i] - weight * shares[i], 0);
    weights_[leaving] = weight;
    basis_[leaving] = worst;
    return true;
  }

  std::span<const HalfSpace> planes_;
  const Side& side_;
  const HalfSpace* basis_[3];
  double weights_[3];
};

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
  if (planes.empty()) return box;
  for (const Side& side : kSides)
    planes.push_back({side.normal(), std::isfinite(side.bound(box)) ? side.bound(box) : Corner::kNowhere});
  for (const Side& side : kSides) Corner(planes, side).lower(box);
  return box;
}

}  // namespace verisim::shapes
