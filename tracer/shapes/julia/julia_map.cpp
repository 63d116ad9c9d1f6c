#include "tracer/shapes/julia/julia_map.h"

#include <algorithm>
#include <cmath>

namespace verisim::shapes::julia {

namespace {

constexpr int kSide = Grid::kSide;
constexpr double kMargin = 1e-6;  // relative; far above rounding

double norm(const Number& h) { return std::sqrt(norm2<Kind::quaternion_square>(h)); }
double size(double re, double im) { return std::sqrt(re * re + im * im); }

// The radius beyond which every point escapes in time: |h^n + c| >= |h|^n - |c|, for hypercomplex squares, too.
double escape_radius(const Field& f) {
  const double c = norm(f.parameter);
  const auto escapes = [&](double r) {
    for (int i = 1; i <= f.iterations; ++i) {
      if (r * r > f.escape) return true;
      r = (f.kind == Kind::quaternion_cube ? r * r * r : r * r) - c;
      if (r <= 0) return false;
    }
    return false;
  };
  double low = 0, high = std::sqrt(f.escape) * (1 + kMargin);
  for (int i = 0; i < 30; ++i) {
    const double middle = (low + high) / 2;
    (escapes(middle) ? high : low) = middle;
  }
  return high * (1 + kMargin);
}

}  // namespace

Map::Map(const Field& field) {
  const double radius = escape_radius(field);
  grid_.low = -radius;
  grid_.cell = 2 * radius / kSide;
  fill(field, 0, 0, 0, kSide);
}

bool Map::may_hold(const Field& f, const Vec3& p, double half) const {
  Number h{p.x, p.y, p.z, (f.slice_distance - dot(f.slice, p)) / f.slice_w};
  const double escape = f.escape * (1 + kMargin);
  // In four dimensions.
  double stray = half * std::sqrt(3.0) * std::sqrt(1 + dot(f.slice, f.slice) / (f.slice_w * f.slice_w)) * (1 + kMargin);
  const auto next_stray = [&](double size, double by) {
    return (f.kind == Kind::quaternion_cube ? (3 * size * (size + by) + by * by) * by : (2 * size + by) * by) *
           (1 + kMargin);
  };
  if (is_quaternion(f.kind)) {
    for (int i = 1; i <= f.iterations; ++i) {
      const double size = norm(h), least = size - stray;
      if (least > 0 && least * least > escape) return false;
      if (stray > 2 * size + 4) return true;
      h = plus(f.kind == Kind::quaternion_cube ? image<Kind::quaternion_cube>(h) : image<Kind::quaternion_square>(h),
               f.parameter);
      stray = next_stray(size, stray);
    }
    return true;
  }
  // A hypercomplex number is a pair of complex numbers a, b with |h|^2 = (|a|^2 + |b|^2) / 2, and each is squared by
  // itself.
  double stray_a = stray * std::sqrt(2.0), stray_b = stray_a;
  for (int i = 1; i <= f.iterations; ++i) {
    const double a = size(h.x - h.w, h.y + h.z), b = size(h.x + h.w, h.y - h.z);
    const double least_a = std::max(0.0, a - stray_a), least_b = std::max(0.0, b - stray_b);
    if ((least_a * least_a + least_b * least_b) / 2 > escape) return false;
    if (stray_a > 2 * a + 4 && stray_b > 2 * b + 4) return true;
    h = plus(image<Kind::hypercomplex_square>(h), f.parameter);
    stray_a = next_stray(a, stray_a), stray_b = next_stray(b, stray_b);
  }
  return true;
}

void Map::fill(const Field& field, int i, int j, int k, int size) {
  const double half = grid_.cell * size / 2;
  const auto at = [&](int n) { return grid_.low + grid_.cell * n + half; };
  if (!may_hold(field, {at(i), at(j), at(k)}, half * 1.001)) return;
  if (size > 1) {
    const int s = size / 2;
    for (int c = 0; c < 8; ++c) fill(field, i + (c & 1 ? s : 0), j + (c & 2 ? s : 0), k + (c & 4 ? s : 0), s);
    return;
  }
  grid_.add(i, j, k);
  grid_.box.extendBy(Vec3(at(i) - half, at(j) - half, at(k) - half));
  grid_.box.extendBy(Vec3(at(i) + half, at(j) + half, at(k) + half));
}

// A walk through the grid from the far end.
double Map::last(const Vec3& o, const Vec3& d, double begin, double end) const {
  if (grid_.box.isEmpty()) return -1;
  for (int k = 0; k < 3; ++k) {
    if (d[k] == 0) {
      if (o[k] < grid_.box.min[k] || o[k] > grid_.box.max[k]) return -1;
      continue;
    }
    const double a = (grid_.box.min[k] - o[k]) / d[k], b = (grid_.box.max[k] - o[k]) / d[k];
    begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
  }
  if (!(begin <= end)) return -1;
  int cell[3], step[3];
  double next[3], delta[3];  // where the ray, seen from its end, leaves the cell; the length of a cell along it
  for (int k = 0; k < 3; ++k) {
    const double place = (o[k] + end * d[k] - grid_.low) / grid_.cell;
    cell[k] = std::clamp(static_cast<int>(place), 0, kSide - 1);
    step[k] = d[k] > 0 ? -1 : 1;
    const double wall = grid_.low + grid_.cell * (cell[k] + (step[k] > 0 ? 1 : 0));
    next[k] = d[k] == 0 ? -1e300 : (wall - o[k]) / d[k];
    delta[k] = d[k] == 0 ? 0 : grid_.cell / std::fabs(d[k]);
  }
  double t = end;
  for (;;) {
    if (grid_.has(cell[0], cell[1], cell[2])) return t;
    const int k = next[0] > next[1] ? (next[0] > next[2] ? 0 : 2) : (next[1] > next[2] ? 1 : 2);
    t = next[k];
    if (!(t > begin)) return -1;
    cell[k] += step[k];
    if (cell[k] < 0 || cell[k] >= kSide) return -1;
    next[k] -= delta[k];
  }
}

}  // namespace verisim::shapes::julia
