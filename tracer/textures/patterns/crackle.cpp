// Crackle and facets: distances to random points, one in each unit cell (spec 05 section 7).
#include <algorithm>
#include <bit>
#include <limits>

#include "tracer/noise/noise.h"
#include "tracer/textures/patterns/crackle_kernels.h"
#include "tracer/textures/patterns/crackle_offsets.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

const CrackleKernels& best_kernels = crackle_kernels();

const CrackleCell& cell_of(CrackleMetric metric, const Vec3& p) {
  return crackle_cell(metric, floor_to_int(p.x - kEpsilon), floor_to_int(p.y - kEpsilon), floor_to_int(p.z - kEpsilon));
}

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

struct MetricAny {
  double exponent;
  double operator()(double d) const { return std::pow(std::fabs(d), exponent); }
  // Above this sum of squares no point is among the nearest three. With q = sum d^2, the sum of |d|^m lies between
  // q^(m/2) and 3^(1 - m/2) q^(m/2); so no point counts whose q is above that of the third by q times 3^|1 - 2/m|.
  double largest_square(const CrackleCell& cell, const Vec3& p) const {
    constexpr double kMargin = 1e-9;  // far above the rounding of powers, as long as these are usual
    if (!(exponent >= 0.01 && exponent <= 64)) return kNoLimit;
    return best_kernels.squares(cell, p).s[2] * std::pow(3.0, std::fabs(1 - 2 / exponent)) * (1 + kMargin);
  }
};
// Of metric 1, as facets have it: differences keep their signs.
struct SignedSums {
  double operator()(double d) const { return d; }
  double largest_square(const CrackleCell&, const Vec3&) const { return kNoLimit; }
};

struct Nearest {
  double s[3];
  Vec3 point;  // the nearest one
};

// The three smallest sums over the axes of metric(difference), for metrics that are seldom used.
template <class Metric>
Nearest nearest_three(const Vec3& p, Metric metric) {
  const CrackleCell& cell = cell_of(CrackleMetric::any, p);
  alignas(64) double squares[CrackleCell::kMax];
  for (int i = 0; i < CrackleCell::kMax; ++i) {
    const double x = cell.x[i] - p.x, y = cell.y[i] - p.y, z = cell.z[i] - p.z;
    squares[i] = x * x + y * y + z * z;
  }
  const double largest = metric.largest_square(cell, p);
  Nearest best{{kNoLimit, kNoLimit, kNoLimit}, p};
  for (std::size_t i = 0; i < kCrackleOffsets.size(); ++i) {
    if (squares[i] > largest) continue;
    const double s = metric(cell.x[i] - p.x) + metric(cell.y[i] - p.y) + metric(cell.z[i] - p.z);
    if (s < best.s[0]) {
      best.s[2] = best.s[1];
      best.s[1] = best.s[0];
      best.s[0] = s;
      best.point = Vec3(cell.x[i], cell.y[i], cell.z[i]);
    } else if (s < best.s[1]) {
      best.s[2] = best.s[1];
      best.s[1] = s;
    } else if (s < best.s[2]) {
      best.s[2] = s;
    }
  }
  return best;
}

// The nearest of the random points by sums of squares.
Vec3 nearest_point(const Vec3& p) {
  const CrackleCell& cell = cell_of(CrackleMetric::squares, p);
  double least = std::numeric_limits<double>::infinity();
  int nearest = 0;
  for (int i = 0; i < cell.count; ++i) {
    const double x = cell.x[i] - p.x, y = cell.y[i] - p.y, z = cell.z[i] - p.z, s = x * x + y * y + z * z;
    if (s < least) least = s, nearest = i;
  }
  return Vec3(cell.x[nearest], cell.y[nearest], cell.z[nearest]);
}

// The pattern's value from the three smallest distances.
double in_form(const CrackleData& data, double s0, double s1, double s2) {
  const scene::CrackleParams& c = data.p;
  const double distances[3] = {s0, s1, s2};
  double sum = 0;
  const bool finite_roots = std::fabs(c.metric) >= 1;
  for (int k = 0; k < 3; ++k) {
    const double s = distances[k] + data.offset_power;
    if (c.form[k] == 0 && finite_roots && std::isfinite(s)) continue;  // nothing times an infinite root is no number
    sum += c.form[k] * (c.metric == 2 ? std::sqrt(s) : c.metric == 1 ? s : std::pow(s, 1 / c.metric));
  }
  return clamp01(sum);
}

// The cells of a batch's points, and the points.
struct CrackleBatch {
  alignas(64) double cell[3][PointBatch::kMax], point[3][PointBatch::kMax];
  bool together(int i, int k) const {
    return cell[0][i] == cell[0][k] && cell[1][i] == cell[1][k] && cell[2][i] == cell[2][k];
  }
};

class CrackleValues {
 public:
  CrackleValues(const CrackleData& data, double* values)
      : data_(data),
        squares_(data.p.metric == 2),
        form_{data.p.form[0], data.p.form[1], data.p.form[2]},
        values_(values) {}

  // Eight neighbours in one cell.
  void of_eight(CrackleEight& at, double* values) const {
    (squares_ ? best_kernels.squares_of_eight : best_kernels.sums_of_eight)(
        cell_at(at.cell[0][0], at.cell[1][0], at.cell[2][0]), at);
    best_kernels.in_form(at, form_, data_.offset_power, squares_, values);
  }
  // Points of a row wherever they are, cell by cell.
  void of_all(const CrackleBatch& batch, std::uint64_t open) const {
    while (open != 0) {
      const int first = std::countr_zero(open);
      int found[8], n = 0;
      for (std::uint64_t rest = open; rest != 0 && n < 8; rest &= rest - 1)
        if (const int i = std::countr_zero(rest); batch.together(i, first))
          found[n++] = i, open &= ~(std::uint64_t{1} << i);
      of_some(batch, found, n);
    }
  }

 private:
  static constexpr int kAlone = 3;  // points of a cell that are found one by one: then its random points are the lanes

  const CrackleCell& cell_at(double a, double b, double c) const {
    return crackle_cell(squares_ ? CrackleMetric::squares : CrackleMetric::sums, static_cast<std::int64_t>(a),
                        static_cast<std::int64_t>(b), static_cast<std::int64_t>(c));
  }
  void of_some(const CrackleBatch& batch, const int* found, int n) const {
    const CrackleCell& cell = cell_at(batch.cell[0][found[0]], batch.cell[1][found[0]], batch.cell[2][found[0]]);
    if (n <= kAlone) {
      for (int k = 0; k < n; ++k) {
        const NearestThree nearest = (squares_ ? best_kernels.squares : best_kernels.sums)(
            cell, {batch.point[0][found[k]], batch.point[1][found[k]], batch.point[2][found[k]]});
        values_[found[k]] = in_form(data_, nearest.s[0], nearest.s[1], nearest.s[2]);
      }
      return;
    }
    CrackleEight at;
    for (int k = 0; k < 8; ++k)
      for (int axis = 0; axis < 3; ++axis) at.point[axis][k] = batch.point[axis][found[std::min(k, n - 1)]];
    (squares_ ? best_kernels.squares_of_eight : best_kernels.sums_of_eight)(cell, at);
    alignas(64) double values[8];
    best_kernels.in_form(at, form_, data_.offset_power, squares_, values);
    for (int k = 0; k < n; ++k) values_[found[k]] = values[k];
  }

  const CrackleData& data_;
  const bool squares_;
  const double form_[3];
  double* const values_;
};

// Whether the cells of points can be found in lanes: the form needs no more than distances, and coordinates are not too
// large.
bool in_packet(const CrackleData& data, int count, const PointBatch& p) {
  if (data.p.solid || (data.p.metric != 2 && data.p.metric != 1)) return false;
  constexpr double kFar = 1e9;
  bool near = true;
  for (int i = 0; i < count; ++i)
    near = near && std::fabs(p.x[i]) < kFar && std::fabs(p.y[i]) < kFar && std::fabs(p.z[i]) < kFar;
  return near;
}

}  // namespace

void crackle_batch(const CrackleData& data, int noise_generator, int count, const PointBatch& p, double* v) {
  if (!in_packet(data, count, p)) {
    for (int i = 0; i < count; ++i) v[i] = crackle(data, noise_generator, p.at(i));
    return;
  }
  const CrackleValues values(data, v);
  CrackleBatch batch;
  std::uint64_t open = 0;
  for (int first = 0; first < count; first += 8) {
    CrackleEight at;
    if (best_kernels.locate(p.x + first, p.y + first, p.z + first, at)) {
      values.of_eight(at, v + first);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      std::copy_n(at.cell[axis], 8, batch.cell[axis] + first);
      std::copy_n(at.point[axis], 8, batch.point[axis] + first);
    }
    open |= ((std::uint64_t{1} << std::min(count - first, 8)) - 1) << first;
  }
  values.of_all(batch, open);
}

double crackle(const CrackleData& data, int noise_generator, const Vec3& p) {
  const scene::CrackleParams& c = data.p;
  if (c.solid) {
    const Vec3 nearest = c.metric == 2 ? nearest_point(p) : nearest_three(p, MetricAny{c.metric}).point;
    return clamp01(noise(nearest, noise_generator));
  }
  NearestThree n;
  if (c.metric == 2 || c.metric == 1) {
    const CrackleCell& cell = cell_of(c.metric == 2 ? CrackleMetric::squares : CrackleMetric::sums, p);
    n = c.metric == 2 ? best_kernels.squares(cell, p) : best_kernels.sums(cell, p);
  } else {
    const Nearest nearest = nearest_three(p, MetricAny{c.metric});
    n = {{nearest.s[0], nearest.s[1], nearest.s[2]}};
  }
  return in_form(data, n.s[0], n.s[1], n.s[2]);
}

Vec3 nearest_facet_point(const Vec3& p, double metric) {
  if (metric == 2) return nearest_point(p);
  if (metric == 1) return nearest_three(p, SignedSums{}).point;
  return nearest_three(p, MetricAny{metric}).point;
}

double formulas::crackle(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return textures::crackle(c.as<CrackleData>(), c.noise_generator, p);
}

}  // namespace verisim::textures
