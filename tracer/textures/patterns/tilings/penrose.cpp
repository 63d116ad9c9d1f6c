// Tilings 25 .. 27: Penrose's pentagons, kites and darts, and rhombs, by recursive subdivision (spec 05 section 9.1).
//
// A state machine: each state is a kind of tile (or half of one); a step decides in which smaller tile of the
// subdivision the point lies, moves the point into that tile's own position and enlarges it by the golden ratio. After
// the last step the leaf's formula gives the value.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/textures/patterns/tilings/tiling.h"

namespace verisim::textures {
namespace {

const double kGolden = (1 + std::sqrt(5.0)) / 2;
const double kInverseGolden = 1 / kGolden;
constexpr double eta = 1e-6;
constexpr int kMaxSteps = 400;  // |p| <= 1e17 needs less than 200

double radians(double degrees) { return degrees * std::numbers::pi / 180; }
double cosine(double degrees) { return std::cos(radians(degrees)); }
double sine(double degrees) { return std::sin(radians(degrees)); }

struct P {
  double x, z;
};
P operator+(const P& a, const P& b) { return {a.x + b.x, a.z + b.z}; }
P operator-(const P& a, const P& b) { return {a.x - b.x, a.z - b.z}; }
P operator*(double s, const P& a) { return {s * a.x, s * a.z}; }

// Rotations by the multiples of 36 degrees that occur.
P rotate(double degrees, const P& p) {
  static const double c[10] = {1,  cosine(36),  cosine(72),  cosine(108), cosine(144),
                               -1, cosine(216), cosine(252), cosine(288), cosine(324)};
  static const double s[10] = {0, sine(36),  sine(72),  sine(108), sine(144),
                               0, sine(216), sine(252), sine(288), sine(324)};
  const int k = (static_cast<int>(degrees) / 36 + 10) % 10;
  return {p.x * c[k] - p.z * s[k], p.z * c[k] + p.x * s[k]};
}

// Distance from the line through (x0, 0) with direction `degrees`.
double line_distance(const P& p, double x0, double degrees) {
  return std::fabs(sine(degrees) * (p.x - x0) - cosine(degrees) * p.z);
}
bool below(const P& p, double x0, double degrees) { return p.z < (p.x - x0) * std::tan(radians(degrees)); }

// Folds the plane into the wedge of 36 degrees above the x axis.
P fold(P p) {
  const double r = std::sqrt(p.x * p.x + p.z * p.z);
  p.z = std::fabs(p.z);
  static const double c36 = cosine(36), c108 = cosine(108);
  if (p.x < r * c36) p = rotate(p.x < r * c108 ? -144 : -72, p);
  p.z = std::fabs(p.z);
  return p;
}

double falling(double a, double b) { return std::min(std::max({0.5 - a / 2, 0.5 - b / 2, 0.0}), 0.5 - eta); }
double rising(double a, double b) { return std::max({1 - a / 2, 1 - b / 2, 0.5 + eta}); }

double kite_and_dart(bool rhombs, P p) {
  static const double c36 = cosine(36), s36 = sine(36), c18 = cosine(18);
  p = fold(p);
  if (rhombs) p = kInverseGolden * p;
  const double delta = line_distance(p, 0, 108) / c18;
  const int n = delta > 0 ? std::max(0, static_cast<int>(std::ceil(std::log(delta) / std::log(kGolden * kGolden)))) : 0;
  p = std::pow(kGolden, -2 * n) * p;
  if (n % 2 == 1) {
    p = rotate(-36, p);
    p.z = std::fabs(p.z);
  }
  bool kite = true;
  for (int m = std::min(2 * n, kMaxSteps); m > 0; --m) {
    p.z = std::fabs(p.z);
    if (kite) {
      if (below(p, kInverseGolden, 144))
        kite = false;
      else
        p = rotate(108, p - P{c36, s36});
    } else if (below(p, kInverseGolden, 108)) {
      kite = true;
      p = rotate(-36, p);
    } else {
      p = rotate(-144, p - P{1, 0});
    }
    p = kGolden * p;
  }
  p.z = std::fabs(p.z);
  if (!rhombs) {
    if (kite) return falling(4.46 * line_distance(p, 0, 36), 4.46 * line_distance(p, 1, 108));
    return rising(4.46 * p.z, 4.46 * line_distance(p, 1, 144));
  }
  if (!kite) return falling(5.55 * line_distance(p, 0, 36), 5.55 * line_distance(p, 1, 144));
  if (below(p, kInverseGolden, 72))
    return rising(5.55 * line_distance(p, kInverseGolden, 72), 5.55 * line_distance(p, 1, 108));
  return falling(5.55 * p.z, 5.55 * line_distance(p, kInverseGolden, 72));
}

enum class Piece {
  pentagon1,
  pentagon2a,
  pentagon2b,
  pentagon3a,
  pentagon3b,
  star,
  boat_a,
  boat_b,
  diamond_a,
  diamond_b
};  // a: "+", b: "-" in the specification

const double kA = 0.5 / sine(36), kI = 0.5 / std::tan(radians(36)), kF = 5.55 * kInverseGolden;
const double kC72 = cosine(72), kS72 = sine(72);

// One subdivision step, without the enlargement.
Piece subdivide(Piece piece, P& p) {
  using enum Piece;
  switch (piece) {
    case pentagon1:
      p = fold(p);
      if (p.z < (p.x - kI) * std::tan(radians(54)) + 0.5) {
        p = {p.x - kI - kInverseGolden * kA * kC72, p.z};
        return pentagon2b;
      }
      p = rotate(-36, p);
      return star;
    case pentagon2a:
      if (below(p, kInverseGolden * kInverseGolden * kA, 54)) {
        p = {p.x - kA, p.z};
        return pentagon1;
      }
      if (below(p, kInverseGolden * kInverseGolden * kA, 162)) {
        p.x = -p.x;
        return diamond_a;
      }
      p = rotate(108, p) + P{kInverseGolden * kA, 0};
      return pentagon2a;
    case pentagon2b:
      if (below(p, -kA, 18)) {
        p = {p.x + kA - kInverseGolden * kInverseGolden * kA, p.z};
        return diamond_b;
      }
      p = rotate(-36, p);
      p = {-p.x - kA * kC72, p.z - kA * kS72};
      return pentagon3b;
    case pentagon3a:
      if (p.x > kInverseGolden * kInverseGolden * kA * kC72) {
        p = {-p.x + kInverseGolden * kInverseGolden * kA * kC72 + kInverseGolden * kI, p.z};
        return pentagon2a;
      }
      return boat_a;
    case pentagon3b:
      if (p.x < kA * cosine(108)) {
        p = rotate(-144, p) - P{kA, 0};
        return pentagon2b;
      }
      if (p.z > (p.x - kInverseGolden * kInverseGolden * kA) * std::tan(radians(126))) {
        p = rotate(36, p);
        p = {-p.x - kA * kC72, p.z - kA * kS72};
        return pentagon3b;
      }
      return boat_b;
    case star:
      if (p.x < kInverseGolden * kI) return pentagon1;
      p = {2 * kInverseGolden * kI - p.x, p.z};
      return pentagon3a;
    case boat_a:
      if (p.x > kGolden * kA * cosine(108)) {
        p.x = -p.x;
        return pentagon1;
      }
      p = p + P{kA, 0};
      return pentagon3a;
    case boat_b:
      p = rotate(72, p) + P{kA, 0};
      return pentagon3a;
    case diamond_a:
      return pentagon1;
    case diamond_b:
      return pentagon3a;
  }
  return piece;
}

double leaf(Piece piece, P p) {
  using enum Piece;
  switch (piece) {
    case pentagon1:
      p = fold(p);
      return std::clamp((1 - kF * std::fabs(p.x - kI)) / 6, 0.0, 1.0 / 6 - eta);
    case pentagon2a:
    case pentagon2b:
      p = fold(p);
      return std::clamp((2 - kF * std::fabs(p.x - kI)) / 6, 1.0 / 6 + eta, 2.0 / 6 - eta);
    case pentagon3a:
    case pentagon3b:
      p = fold(p);
      return std::clamp((3 - kF * std::fabs(p.x - kI)) / 6, 2.0 / 6 + eta, 3.0 / 6 - eta);
    case star:
      return std::clamp((4 - kF * line_distance(p, kGolden * kA, 162)) / 6, 3.0 / 6 + eta, 4.0 / 6 - eta);
    case boat_a:
    case boat_b: {
      const double a = kF * std::fabs(p.x - kInverseGolden * kA * kC72);
      p = fold({-p.x, p.z});
      const double b = kF * line_distance(p, kGolden * kA, 162);
      return std::min(std::max({(5 - a) / 6, (5 - b) / 6, 4.0 / 6 + eta}), 5.0 / 6 - eta);
    }
    default:
      return std::clamp(1 - kF * line_distance(p, -kInverseGolden * kA, 18) / 6, 5.0 / 6 + eta, 1 - eta);
  }
}

double pentagons(P p) {
  p = fold(p);
  const double ratio = p.x / kI;
  const int n = ratio > 0 ? std::max(0, static_cast<int>(std::ceil(std::log(ratio) / (4 * std::log(kGolden))))) : 0;
  p = std::pow(kGolden, -4 * n) * p;
  Piece piece = Piece::pentagon1;
  for (int m = std::min(4 * n, kMaxSteps); m > 0; --m) {
    p.z = std::fabs(p.z);
    piece = subdivide(piece, p);
    p = kGolden * p;
  }
  p.z = std::fabs(p.z);
  return leaf(piece, p);
}

}  // namespace

double penrose_tiling(int number, double x, double z) {
  if (!(std::fabs(x) < 1e18 && std::fabs(z) < 1e18)) return 0;
  if (std::sqrt(x * x + z * z) <= kEpsilon) return 1;
  return number == 25 ? pentagons({x, z}) : kite_and_dart(number == 27, {x, z});
}

}  // namespace verisim::textures
