#include "tracer/textures/warp.h"

#include <algorithm>
#include <numbers>

#include "tracer/math/constants.h"
#include "tracer/noise/noise_tables.h"

namespace verisim::textures {
namespace {

// The number of the tile is single, as POV-Ray's is: far away it names every second one only, and then none.
Vec3 repeat(const RepeatStep& w, Vec3 p) {
  const double width = w.width;
  const double n = static_cast<float>(std::floor(p[w.axis] / width));
  p[w.axis] -= static_cast<double>(static_cast<float>(n * width));
  if (std::fmod(n, 2) != 0) {
    for (int k = 0; k < 3; ++k)
      if (w.flip[k] != 0) p[k] = -p[k];
    if (w.flip[w.axis] != 0) p[w.axis] += width;
  }
  return p + n * w.offset;
}

Vec3 black_hole(const BlackHoleStep& w, const Vec3& p) {
  Vec3 center = w.center;
  if (w.repeats) {
    double block[3];
    for (int k = 0; k < 3; ++k) {
      block[k] = w.repeat[k] < kEpsilon ? 0 : std::floor(p[k] / w.repeat[k]);
      center[k] += w.repeat[k] * block[k];
    }
    if (w.turbulent) {
      const NoiseTables& t = noise_tables();
      const int h = lattice_hash(t, floor_to_int(block[0]), floor_to_int(block[1]), floor_to_int(block[2]));
      for (int k = 0; k < 3; ++k) center[k] += random_value(t, h + k) * w.turbulence[k];
    }
  }
  const Vec3 d = p - center;
  const double distance = length(d);
  if (distance >= w.radius || w.type != 0) return p;
  const double strength = std::min(1.0, std::pow((w.radius - distance) / w.radius, w.falloff) * w.strength);
  return p + (w.inverse ? -strength : strength) * d;
}

// Turns the unrolled coordinates so that `o` is the axis of depth; a linear mixture when o is not a coordinate axis, as
// in POV-Ray.
Vec3 orient(const Vec3& o, double a, double b, double c) {
  if (o.x == 0 && o.y == 0 && o.z == 1) return {a, b, c};
  return {o.x * c + o.y * a + o.z * a, o.x * b - o.y * c + o.z * b, -o.x * a + o.y * b + o.z * c};
}

// Angle of (x, z) from +x towards +z over a full turn, in [0, 1); `radius` = length of (x, z), 0 and infinity give 0.
double turn(double x, double z, double radius) {
  if (radius == 0 || std::isinf(radius)) return 0;
  const double angle = std::acos(std::clamp(x / radius, -1.0, 1.0));
  return (z < 0 ? kTwoPi - angle : angle) / kTwoPi;
}

Vec3 project(const ProjectionStep& w, const Vec3& p) {
  using enum scene::ProjectionWarpKind;
  if (w.kind == planar) return orient(w.orientation, p.x, p.y, w.offset);
  const double radius = std::sqrt(p.x * p.x + p.z * p.z);
  const double q = w.distance_exponent;
  const auto interval = [q](double distance) {
    if (q == 0) return 1.0;
    return q == 1 ? distance : std::pow(distance, q);
  };
  switch (w.kind) {
    case cylindrical: {
      if (radius == 0) return p;
      return orient(w.orientation, turn(p.x, p.z, radius) * interval(radius), p.y, radius);
    }
    case spherical: {
      const double distance = length(p);
      if (distance == 0) return p;
      const Vec3 d(p.x / distance, p.y / distance, p.z / distance);
      const double phi = 0.5 + std::asin(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi;
      const double theta = turn(d.x, d.z, std::sqrt(d.x * d.x + d.z * d.z));
      return orient(w.orientation, theta * interval(distance), phi * interval(distance), distance);
    }
    default: {
      if (radius == 0) return p;
      const double x = radius - w.major_radius;
      const double rho = std::sqrt(x * x + p.y * p.y);
      double phi = std::acos(std::clamp(-x / rho, -1.0, 1.0));  // on the ring itself no number
      if (p.y > 0) phi = kTwoPi - phi;
      return orient(w.orientation, turn(p.x, p.z, radius) * interval(rho), phi / kTwoPi * interval(rho), rho);
    }
  }
}

// Unfolds a cube: each face gets its place in a cross of a 4 x 3 grid. Sixths are multiplied, not divided, as POV-Ray
// has them. The origin comes to no place at all: 0 / 0.
Vec3 unfold_cube(const Vec3& p) {
  const double ax = std::fabs(p.x), ay = std::fabs(p.y), az = std::fabs(p.z);
  const double largest = std::max({ax, ay, az});
  constexpr double kThird = 1.0 / 3, kSixth = 1.0 / 6;
  if (p.x == largest) return {0.75 - (p.z / p.x + 1) / 8, kThird + (p.y / p.x + 1) * kSixth, p.x};
  if (p.y == largest) return {0.25 + (p.x / p.y + 1) / 8, 1 - (p.z / p.y + 1) * kSixth, p.y};
  if (p.z == largest) return {0.25 + (p.x / p.z + 1) / 8, kThird + (p.y / p.z + 1) * kSixth, p.z};
  if (ax == largest) return {(p.z / ax + 1) / 8, kThird + (p.y / ax + 1) * kSixth, ax};
  if (ay == largest) return {0.25 + (p.x / ay + 1) / 8, (p.z / ay + 1) * kSixth, ay};
  return {1 - (p.x / az + 1) / 8, kThird + (p.y / az + 1) * kSixth, az};
}

struct Walk {
  Vec3 p;
  void operator()(const AffineStep& s) {
    const auto to = [&](int k) { return p.x * s.rows[0][k] + p.y * s.rows[1][k] + p.z * s.rows[2][k] + s.rows[3][k]; };
    p = Vec3(to(0), to(1), to(2));
  }
  void operator()(const TurbulenceStep*) {}
  void operator()(const RepeatStep& s) { p = repeat(s, p); }
  void operator()(const BlackHoleStep& s) { p = black_hole(s, p); }
  void operator()(const ProjectionStep& s) { p = project(s, p); }
  void operator()(const CubicStep&) { p = unfold_cube(p); }
};

struct Append {
  WarpChain& chain;
  TurbulenceTable& table;
  void operator()(const Transform& t) const {
    if (t.is_identity()) return;
    AffineStep step{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j) step.rows[i][j] = t.inv[i][j];
    if (!chain.transforms && chain.rest.empty()) {
      chain.transforms = true;
      chain.first = step;
    } else {
      chain.rest.emplace_back(step);
    }
  }
  void operator()(const scene::TurbulenceWarp& w) const {
    if (w.amount != Vec3(0, 0, 0)) chain.rest.emplace_back(table.get(w));
  }
  void operator()(const scene::ProjectionWarp& w) const {
    ProjectionStep step = w;
    if (const double n = length(step.orientation); n > 0) step.orientation /= n;
    chain.rest.emplace_back(step);
  }
  void operator()(const scene::RepeatWarp& w) const { chain.rest.emplace_back(w); }
  void operator()(const scene::BlackHoleWarp& w) const {
    if (w.type == 0) chain.rest.emplace_back(w);
  }
  void operator()(const scene::CubicWarp& w) const { chain.rest.emplace_back(w); }
};

}  // namespace

const TurbulenceStep* TurbulenceTable::get(const scene::Turbulence& t) {
  const Key key(t.amount.x, t.amount.y, t.amount.z, t.octaves, t.lambda, t.omega);
  return &known_.try_emplace(key, TurbulenceStep{t.amount, Octaves(t.octaves, t.lambda, t.omega)}).first->second;
}

const TurbulenceStep& no_turbulence() {
  static const TurbulenceStep none{{0, 0, 0}, Octaves(6, 2, 0.5)};
  return none;
}

WarpChain compile_warps(const scene::List<scene::Warp>& warps, const TurbulenceStep* classic, TurbulenceTable& table) {
  WarpChain chain;
  for (const scene::Warp& warp : warps) std::visit(Append{chain, table}, warp);
  if (classic && classic->amount != Vec3(0, 0, 0)) chain.rest.emplace_back(classic);
  return chain;
}

Vec3 walk_step(const WarpStep& step, const Vec3& p) {
  Walk walk{p};
  std::visit(walk, step);
  return walk.p;
}

}  // namespace verisim::textures
