#include "tracer/shapes/implicit/curvature_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tracer/functions/bounds/error_bound.h"

namespace verisim::shapes {

namespace {

constexpr double kFewCells = 150,
                 kManyCells = 1500;        // about: where all is smooth, and to keep what is not to little space
constexpr std::size_t kLongProgram = 200;  // instructions: not worth the time
constexpr int kMaxAlongAnAxis = 64;

}  // namespace

CurvatureMap::CurvatureMap(const functions::Program& program, const Box3& container) : low_(container.min) {
  const Vec3 size = container.max - container.min;
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, std::fabs(container.min[axis]), std::fabs(container.max[axis])});
  const double longest = std::max({size.x, size.y, size.z});
  if (!(longest > 0 && largest < 1e9) || program.size() > kLongProgram) return;
  farthest_ = 256 * largest;
  functions::CurvatureBounds bounds(program, farthest_ * 0x1p-50);
  if (!fill(bounds, size, kFewCells)) fill(bounds, size, kManyCells);
  join_neighbours();
  const Vec3 margin(edge_ * 1e-6 + largest * 1e-9);
  error_bound_ = functions::error_bound(program, {container.min - margin, container.max + margin});
}

// True: something is known of every cell.
bool CurvatureMap::fill(functions::CurvatureBounds& bounds, const Vec3& size, double cells) {
  // Cubes, as far as the shortest side allows.
  edge_ = std::max({size.x, size.y, size.z}) / kMaxAlongAnAxis;
  const auto count = [&](int axis) { return std::max(1.0, std::ceil(size[axis] / edge_)); };
  while (count(0) * count(1) * count(2) > cells) edge_ *= 1.05;
  for (int axis = 0; axis < 3; ++axis) count_[static_cast<std::size_t>(axis)] = static_cast<int>(count(axis));

  const double margin = edge_ * 1e-6;
  bool complete = true;
  parts_ = {}, error_ = 0;
  bends_.resize(at(count_[0] - 1, count_[1] - 1, count_[2] - 1) + 1);
  for (int i = 0; i < count_[0]; ++i)
    for (int j = 0; j < count_[1]; ++j)
      for (int k = 0; k < count_[2]; ++k) {
        const Vec3 corner = low_ + Vec3(i, j, k) * edge_;
        const functions::Curvature c = bounds.within({corner - Vec3(margin), corner + Vec3(edge_ + margin)});
        bends_[at(i, j, k)] = c.bend;
        for (std::size_t n = 0; n < 6; ++n) parts_[n] = std::max(parts_[n], c.parts[n]);
        if (std::isfinite(c.bend))
          useful_ = true, error_ = std::max(error_, c.error);
        else
          complete = false;
      }
  return complete;
}

void CurvatureMap::join_neighbours() {
  for (int i = 0; i < count_[0]; ++i)
    for (int j = 0; j < count_[1]; ++j)
      for (int k = 0; k < count_[2]; ++k) {
        const int i1 = std::min(i + 1, count_[0] - 1), j1 = std::min(j + 1, count_[1] - 1),
                  k1 = std::min(k + 1, count_[2] - 1);
        double& here = bends_[at(i, j, k)];  // entries behind it are still those of single cells
        here = std::max({here, bends_[at(i1, j, k)], bends_[at(i, j1, k)], bends_[at(i, j, k1)], bends_[at(i1, j1, k)],
                         bends_[at(i1, j, k1)], bends_[at(i, j1, k1)], bends_[at(i1, j1, k1)]});
      }
}

}  // namespace verisim::shapes
