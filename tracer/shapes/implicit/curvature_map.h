// How much the function of an isosurface bends, place by place: with two values of it, that tells much of what is
// between them (isosurface_kernels.cpp).
#pragma once

#include <array>
#include <vector>

#include "tracer/functions/bounds/curvature.h"
#include "tracer/math/vec.h"

namespace verisim::shapes {

class CurvatureMap {
 public:
  CurvatureMap(const functions::Program& program, const Box3& container);

  // False: nothing is known anywhere.
  bool useful() const { return useful_; }
  // How far values of ProgramKernels::approximate may be from exact ones; infinity: not known.
  double error_bound() const { return error_bound_; }
  // Of computed values, even those of ProgramKernels::approximate, for points whose coordinates are sums of numbers up
  // to `farthest`.
  double error() const { return error_; }
  double farthest() const { return farthest_; }

  // Entry (i, j, k) is for what lies within cell (i, j, k) and the next one along each axis: first index slowest.
  const double* bends() const { return bends_.data(); }
  // For all of the container, as Curvature::parts.
  const std::array<double, 6>& parts() const { return parts_; }
  const Vec3& low() const { return low_; }
  double edge() const { return edge_; }  // of a cell
  int count(int axis) const { return count_[static_cast<std::size_t>(axis)]; }

 private:
  std::size_t at(int i, int j, int k) const { return static_cast<std::size_t>((i * count_[1] + j) * count_[2] + k); }
  bool fill(functions::CurvatureBounds& bounds, const Vec3& size, double cells);
  void join_neighbours();

  Vec3 low_;
  double edge_ = 0, error_ = 0, farthest_ = 0, error_bound_ = 0;
  std::array<int, 3> count_{1, 1, 1};
  std::array<double, 6> parts_{};
  std::vector<double> bends_;
  bool useful_ = false;
};

}  // namespace verisim::shapes
