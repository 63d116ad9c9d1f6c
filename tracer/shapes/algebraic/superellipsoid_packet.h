// Superellipsoids for eight rays at once: Newton's method from outside a convex one, and POV-Ray's values. Compiled for
// several instruction sets; all give the same bits, and what one lane finds does not depend on the others.
#pragma once

#include <algorithm>
#include <cmath>

#include "tracer/math/ray_batch.h"

namespace verisim::shapes {

// |(a, b)|_p, p = 2 / e, as POV-Ray has it, bit by bit: powers by multiplication where p is a small integer.
struct EllipsoidNorm {
  double exponent, inverse;
  double negligible;  // 1 + x^p is 1 below it
  int integer = 0;    // the exponent; 0: it is none, or large

  explicit EllipsoidNorm(double e) : exponent(2 / e), inverse(1 / exponent), negligible(std::pow(2, -54 / exponent)) {
    if (exponent >= 1 && exponent <= 6 && exponent == std::floor(exponent)) integer = static_cast<int>(exponent);
  }
  double operator()(double a, double b) const {
    if (a < b) std::swap(a, b);
    if (!(a > 0)) return 0;
    const double ratio = b / a;
    if (ratio < negligible) return a;
    const double sum = 1 + raise(ratio);
    return sum == 1 ? a : a * std::pow(sum, inverse);  // most of a body with sharp edges
  }
  // x^p
  double raise(double x) const {
    if (integer == 0) return std::pow(x, exponent);
    double result = 1;
    for (int n = integer; n != 0; n >>= 1, x *= x)
      if (n & 1) result *= x;
    return result;
  }
};

// Points in the shape's own space.
struct alignas(64) EllipsoidPoints {
  static constexpr int kCount = RayPacket::kCount;
  double x[kCount], y[kCount], z[kCount];
};

// Rays in the shape's own space, and how far each may go.
struct alignas(64) ConvexPacket {
  static constexpr int kCount = RayPacket::kCount;
  double ox[kCount], oy[kCount], oz[kCount], dx[kCount], dy[kCount], dz[kCount];
  double t[kCount];      // where the search begins, outside; then the root
  double end[kCount];    // it goes no further than this
  double side[kCount];   // 1: forward, -1: backward
  double value[kCount];  // |(|(x, y)|_p, z)|_q - 1 at t, as an answer
  double slope[kCount];  // of the value
};

struct SuperellipsoidKernels {
  // From t towards `end`. The lanes of `active` that find the surface.
  unsigned (*approach)(double p, double q, unsigned active, ConvexPacket& packet);
  // The same for the first two lanes.
  unsigned (*approach_pair)(double p, double q, unsigned active, ConvexPacket& packet);
  // |(|(x, y)|, z)| at the points of `active`, with the bits of EllipsoidNorm; other points are any.
  void (*norms)(const EllipsoidNorm& across, const EllipsoidNorm& all, unsigned active, const EllipsoidPoints& points,
                double* norms);
};

// Those of the best instruction set of this machine.
const SuperellipsoidKernels& superellipsoid_kernels();
// Those of any set, for tests; null: this machine cannot run it.
const SuperellipsoidKernels* superellipsoid_kernels(int instruction_set);

}  // namespace verisim::shapes
