// Patterns of regular cells.
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

double fraction(double v) { return v - std::floor(v); }
bool odd(double integer) { return fraction(0.5 * integer) > 0; }  // what is no number is even

}  // namespace

namespace formulas {

double brick(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const BrickData& data = c.as<BrickData>();
  const double m = data.mortar;
  const Vec3 q((p.x + m + kEpsilon) / data.size.x, (p.y + m + kEpsilon) / data.size.y,
               (p.z + m + kEpsilon) / data.size.z);
  const Vec3 joint(m / data.size.x, m / data.size.y, m / data.size.z);
  if (fraction(q.y) <= joint.y) return 0;
  const bool even_row = fraction(q.y / 2) <= 0.5;
  if (fraction(even_row ? q.x : q.x + 0.5) <= joint.x) return 0;
  if (fraction(even_row ? q.z + 0.5 : q.z) <= joint.z) return 0;
  return 1;
}

double cells(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  const NoiseTables& t = noise_tables();
  return random_value(
      t, lattice_hash(t, floor_to_int(p.x + kEpsilon), floor_to_int(p.y + kEpsilon), floor_to_int(p.z + kEpsilon)));
}

double checker(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  const double sum = std::floor(p.x + kEpsilon) + std::floor(p.y + kEpsilon) + std::floor(p.z + kEpsilon);
  return odd(sum) ? 1 : 0;
}

double cubic(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
  const double largest = std::max({ax, ay, az});
  if (p.x == largest) return 0;
  if (p.y == largest) return 1;
  if (p.z == largest) return 2;
  return ax == largest ? 3 : ay == largest ? 4 : 5;
}

double square(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  const bool x = odd(std::floor(p.x)), z = odd(std::floor(p.z));
  return x ? (z ? 2 : 3) : (z ? 1 : 0);
}

double hexagon(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  constexpr double kWidth = 0.5, kHeight = 0.866025404, kPeriod = 5.196152424;
  const double x = positive_remainder(std::fabs(p.x) / kWidth, 6);
  const double z = positive_remainder((p.z < 0 ? kPeriod - std::fabs(p.z) : p.z) / kHeight, 6);
  if (!(x < 6) || !(z < 6)) return 0;  // no numbers
  const int column = static_cast<int>(x), row = static_cast<int>(z);
  static constexpr int kOuter[6] = {0, 1, 1, 2, 2, 0}, kInner[6] = {2, 2, 0, 0, 1, 1};
  static constexpr int kBelow[6] = {0, 2, 1, 0, 2, 1}, kAbove[6] = {2, 1, 0, 2, 1, 0};
  if (column == 0 || column == 5) return kOuter[row];
  if (column == 2 || column == 3) return kInner[row];
  double u = x - column;
  const double w = z - row;
  if ((column + row) % 2 == 1) u = 1 - u;
  if (u == 0) u = 1e-4;
  return w / u < 1 ? kBelow[row] : kAbove[row];
}

double triangular(const CompiledPattern&, const Vec3& p, const SurfacePoint*) {
  if (!std::isfinite(p.x) || !std::isfinite(p.z)) return 4;
  const double root3 = std::sqrt(3.0);
  const double x = positive_remainder(p.x, 3);
  // Hardly below a row's edge it is the whole of root3, not 0: the last row, turned over.
  double z = p.z - std::floor(p.z / root3) * root3;
  const int a = static_cast<int>(x);
  const double u = x - a;
  const bool upper = z >= root3 / 2;
  if (upper) z = root3 - z;
  int c;
  if (u != 0 && z < root3 * u && z < root3 * (1 - u))
    c = 0;
  else if (z >= root3 * u || u == 0)
    c = 1;
  else
    c = 3;
  const int v = c == 0 ? (6 - 2 * a) % 6 : (c + 2 * a) % 6;
  return upper ? 5 - v : v;
}

}  // namespace formulas
}  // namespace verisim::textures
