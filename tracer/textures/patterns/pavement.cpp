// Pavements: what each lattice cell shows is data (pavement_flags.inc, measured by tools/measure_pavements), the value
// is a formula (spec 05 9.2).
#include "tracer/textures/patterns/pavement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

struct Measured {
  int sides, tiles, pattern, columns, rows;
  const char* cells;
};

constexpr std::uint16_t kWords[] = {
#define VERISIM_PAVEMENT_WORDS
#include "tracer/textures/patterns/pavement_flags.inc"
#undef VERISIM_PAVEMENT_WORDS
};
constexpr Measured kMeasured[] = {
#include "tracer/textures/patterns/pavement_flags.inc"
};

struct Flags {
  int columns, rows;
  std::vector<std::uint16_t> cells;
};

// The alphabet of the data: printable characters from '#' on, without the backslash.
std::size_t letter(char c) { return static_cast<std::size_t>(c - 35 - (c > '\\' ? 1 : 0)); }
constexpr std::size_t kLetters = 91;

Flags decode(const Measured& m) {
  Flags flags{m.columns, m.rows, {}};
  const std::size_t count = static_cast<std::size_t>(m.columns) * m.rows;
  const bool two = std::strlen(m.cells) == 2 * count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t word = two ? letter(m.cells[2 * i]) * kLetters + letter(m.cells[2 * i + 1]) : letter(m.cells[i]);
    flags.cells.push_back(kWords[word]);
  }
  return flags;
}

const Flags& flags_of(int sides, int tiles, int pattern) {
  static const std::map<std::tuple<int, int, int>, Flags> all = [] {
    std::map<std::tuple<int, int, int>, Flags> result;
    for (const Measured& m : kMeasured) result[{m.sides, m.tiles, m.pattern}] = decode(m);
    return result;
  }();
  const auto found = all.find({sides, tiles, pattern});
  if (found == all.end()) throw std::invalid_argument("no such pavement");
  return found->second;
}

int remainder(double v, int n) {
  const double r = v - std::floor(v / n) * n;
  return std::clamp(static_cast<int>(r), 0, n - 1);
}

// Bits of a square cell: borders left, right, lower, upper; marks in the corners lower left, lower right, upper left,
// upper right.
double square_pavement(const Pavement& pv, double x, double z) {
  const double i = std::floor(x), j = std::floor(z);
  const unsigned flags = pv.flags[remainder(j, pv.rows) * pv.columns + remainder(i, pv.columns)];
  const double u = x - i, w = z - j;
  const bool border[4] = {(flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0, (flags & 8) != 0};
  double v = 0;
  const double gap[4] = {u, 1 - u, w, 1 - w};
  for (int e = 0; e < 4; ++e)
    if (border[e]) v = std::max(v, 1 - 2 * gap[e]);
  for (int c = 0; c < 4; ++c) {
    const bool right = c & 1, up = c & 2;
    const double s = 2 * (right ? 1 - u : u), q = 2 * (up ? 1 - w : w);
    if (flags >> (4 + c) & 1) {
      if (pv.form != 3 && border[right ? 0 : 1] && border[up ? 2 : 3]) {  // a bend
        if (pv.form == 2) return std::min(1.0, std::fabs(std::sqrt(s * s + q * q) - 1));
        if (pv.form == 1) return std::min(1.0, std::fabs(s + q - 1));
        return std::max({s - 1, q - 1, std::min(1 - s, 1 - q)});
      }
      const double mark = pv.interior == 0   ? std::min(1 - s, 1 - q)
                          : pv.interior == 1 ? 1 - (s + q)
                                             : 1 - std::sqrt(s * s + q * q);
      v = std::max(v, mark);
    }
    if (border[right ? 1 : 0] && border[up ? 3 : 2]) {
      if (pv.exterior == 1)
        v = std::max(v, std::min(1.0, 2 - s - q));
      else if (pv.exterior == 2 && s <= 1 && q <= 1)
        v = std::max(v, std::min(1.0, std::sqrt((1 - s) * (1 - s) + (1 - q) * (1 - q))));
    }
  }
  return v;
}

// A position in a unit triangle by its barycentric coordinates; vertices 0 left, 1 right, 2 top, edge k opposite to
// vertex k.
struct InTriangle {
  std::array<double, 3> b;
  // Projection from vertex k along the edge to vertex `to`, 0 .. 1.
  double along(int k, int to) const { return b[to] + b[3 - k - to] / 2; }
  bool in_sector(int k) const { return along(k, (k + 1) % 3) < 0.5 && along(k, (k + 2) % 3) < 0.5; }
  double distance_to_vertex(int k) const {
    const double p = b[(k + 1) % 3], q = b[(k + 2) % 3];
    return std::sqrt(p * p + q * q + p * q);
  }
  double distance_to_centroid() const {
    const double p = b[1] - 1.0 / 3, q = b[2] - 1.0 / 3;
    return std::sqrt(std::max(0.0, p * p + q * q + p * q));
  }
};

// Bits of a triangular cell: 0..2 borders (edge k opposite to vertex k), 3..5 marks at the vertices, then two bits per
// vertex: the sweep in its sector, 0 none, 1 towards vertex k+1, 2 towards vertex k+2.
double triangle_pavement(const Pavement& pv, double x, double z) {
  const double height = std::sqrt(3.0) / 2, root3 = std::sqrt(3.0);
  const double row = std::floor(z / height), up = z / height - row;
  const double skewed = x - z / (2 * height), column = std::floor(skewed), right = skewed - column;
  const bool inverted = right + up >= 1;
  const unsigned flags =
      pv.flags[remainder(row, pv.rows) * pv.columns + remainder(2 * column + row + (inverted ? 1 : 0), pv.columns)];
  const InTriangle p{inverted ? std::array<double, 3>{right + up - 1, 1 - right, 1 - up}
                              : std::array<double, 3>{1 - right - up, right, up}};

  if (pv.form != 0)
    for (int k = 0; k < 3; ++k) {
      const unsigned sweep = flags >> (6 + 2 * k) & 3;
      if (sweep == 0 || !p.in_sector(k)) continue;
      const int end = (k + static_cast<int>(sweep)) % 3;
      if (pv.form == 1) return std::min(1.0, 2 * std::fabs(2 * p.along(k, end) - 1));
      return clamp01(2 * root3 * (p.distance_to_vertex(end) - root3 / 3));
    }

  const bool border[3] = {(flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0};
  double v = 0;
  for (int k = 0; k < 3; ++k) {
    if (border[k]) v = std::max(v, 1 - 3 * p.b[k]);
    if (!(flags >> (3 + k) & 1)) continue;
    if (pv.interior == 0)
      v = std::max(v, 1 - 3 * (1 - p.b[k]));
    else if (pv.interior == 2)
      v = std::max(v, 1 - 3 * p.distance_to_vertex(k));
    else if (p.in_sector(k))
      v = std::max(v, 1 - 3 * std::max(p.along(k, (k + 1) % 3), p.along(k, (k + 2) % 3)));
  }
  if (pv.sides != 3 || pv.exterior == 0) return v;
  for (const int k : {2, 1, 0}) {
    const int e1 = (k + 1) % 3, e2 = (k + 2) % 3;  // the edges that meet in vertex k
    if (!border[e1] || !border[e2]) continue;
    if (pv.exterior == 2 && p.in_sector(k)) v = std::min(1.0, 2 * root3 * p.distance_to_centroid());
    if (pv.exterior == 1 && 3 * p.b[e1] <= 1 && 3 * p.b[e2] <= 1) v = std::min(1.0, 3 * std::fabs(p.b[k] - 1.0 / 3));
  }
  return v;
}

}  // namespace

Pavement compile_pavement(const scene::PavementParams& d) {
  const Flags& flags = flags_of(d.sides, d.tiles, d.pattern);
  const auto byte = [](int v) { return v & 255; };
  return {d.sides,       byte(d.exterior) % 3, byte(d.interior) % 3, byte(d.form) % (d.sides == 4 ? 4 : 3),
          flags.columns, flags.rows,           flags.cells.data()};
}

double evaluate_pavement(const Pavement& pavement, double x, double z) {
  if (!std::isfinite(x) || !std::isfinite(z)) return 0;
  return pavement.sides == 4 ? square_pavement(pavement, x, z) : triangle_pavement(pavement, x, z);
}

double formulas::pavement(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return evaluate_pavement(c.as<PavementData>().pavement, p.x, p.z);
}

}  // namespace verisim::textures
