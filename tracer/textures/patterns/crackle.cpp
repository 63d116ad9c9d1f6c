// Crackle and facets: distances to random points, one in each unit cell (spec 05 section 7).
#include <array>
#include <limits>

#include "tracer/textures/noise.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

struct CellOffset { std::int8_t x, y, z; };

// The 81 cells that POV-Ray looks at, nearest rings first: all of {-2..2}^3 with at most one component of magnitude 2.
constexpr std::array<CellOffset, 81> make_offsets() {
  std::array<CellOffset, 81> result{};
  int n = 0;
  for (int ring = 0; ring <= 6; ++ring)
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y)
        for (int z = -2; z <= 2; ++z) {
          const int twos = (x * x == 4) + (y * y == 4) + (z * z == 4);
          if (twos <= 1 && x * x + y * y + z * z == ring)
            result[n++] = {static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), static_cast<std::int8_t>(z)};
        }
  return result;
}
constexpr std::array<CellOffset, 81> kOffsets = make_offsets();
static_assert(kOffsets[0].x == 0 && kOffsets[0].y == 0 && kOffsets[0].z == 0 && (kOffsets[80].x != 0 || kOffsets[80].y != 0));

struct Metric2 {
  double operator()(double d) const { return d * d; }
};
struct Metric1 {
  double operator()(double d) const { return std::fabs(d); }
};
struct MetricAny {
  double exponent;
  double operator()(double d) const { return std::pow(std::fabs(d), exponent); }
};

struct Nearest {
  double s[3];
  Vec3 point;  // the nearest one
};

// The three smallest sums over the axes of metric(difference). `bounded`: the metric grows with the distance, so cells can be skipped.
template <class Metric>
Nearest nearest_three(const Vec3& p, Metric metric, bool bounded) {
  const NoiseTables& t = noise_tables();
  const std::int64_t cell[3] = {floor_to_int(p.x - kEpsilon), floor_to_int(p.y - kEpsilon), floor_to_int(p.z - kEpsilon)};
  const Vec3 f(p.x - static_cast<double>(cell[0]), p.y - static_cast<double>(cell[1]), p.z - static_cast<double>(cell[2]));
  // What the gap to the cells at offset -2 .. 2 alone contributes, and the first step of the hash.
  double gap[3][5];
  for (int k = 0; k < 3; ++k) {
    gap[k][0] = bounded ? metric(f[k] + 1) : 0;
    gap[k][1] = bounded ? metric(f[k]) : 0;
    gap[k][2] = 0;
    gap[k][3] = bounded ? metric(1 - f[k]) : 0;
    gap[k][4] = bounded ? metric(2 - f[k]) : 0;
  }
  int first_hash[5];
  for (int i = 0; i < 5; ++i) first_hash[i] = t.hash[(cell[0] + i - 2) & 4095];

  constexpr double kFar = std::numeric_limits<double>::infinity();
  Nearest best{{kFar, kFar, kFar}, p};
  for (const CellOffset& o : kOffsets) {
    if (bounded && gap[0][o.x + 2] + gap[1][o.y + 2] + gap[2][o.z + 2] > best.s[2]) continue;
    const int h = t.hash[t.hash[first_hash[o.x + 2] ^ ((cell[1] + o.y) & 4095)] ^ ((cell[2] + o.z) & 4095)];
    const double x = o.x + random_value(t, h), y = o.y + random_value(t, h + 1), z = o.z + random_value(t, h + 2);
    const double s = metric(x - f.x) + metric(y - f.y) + metric(z - f.z);
    if (s < best.s[0]) {
      best.s[2] = best.s[1];
      best.s[1] = best.s[0];
      best.s[0] = s;
      best.point = Vec3(x, y, z);
    } else if (s < best.s[1]) {
      best.s[2] = best.s[1];
      best.s[1] = s;
    } else if (s < best.s[2]) {
      best.s[2] = s;
    }
  }
  best.point += Vec3(static_cast<double>(cell[0]), static_cast<double>(cell[1]), static_cast<double>(cell[2]));
  return best;
}

}  // namespace

double crackle(const CrackleData& data, int noise_generator, const Vec3& p) {
  const scene::CrackleParams& c = data.p;
  Nearest n;
  if (c.metric == 2) n = nearest_three(p, Metric2{}, true);
  else if (c.metric == 1) n = nearest_three(p, Metric1{}, true);
  else n = nearest_three(p, MetricAny{c.metric}, c.metric > 0);
  if (c.solid) return clamp01(noise(n.point, noise_generator));
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    if (c.form[k] == 0) continue;
    const double s = n.s[k] + data.offset_power;
    sum += c.form[k] * (c.metric == 2 ? std::sqrt(s) : c.metric == 1 ? s : std::pow(s, 1 / c.metric));
  }
  return clamp01(sum);
}

Vec3 nearest_facet_point(const Vec3& p, double metric) {
  if (metric == 2) return nearest_three(p, Metric2{}, true).point;
  if (metric == 1) return nearest_three(p, [](double d) { return d; }, false).point;
  return nearest_three(p, MetricAny{metric}, metric > 0).point;
}

}  // namespace verisim::textures
