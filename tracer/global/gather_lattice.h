// Directions in which a radiosity sample looks in the default mode: cosine-weighted about +y like POV-Ray's (spec 07 2.7), but each sample has a lattice of its
// own, shifted against those of the others, instead of the next stretch of one sequence. Noise hangs on samples of few rays and time on those of many: these
// take fewer rays than in POV-Ray, those of few take more. Those of very few, at deep levels, are left as they are: how far they are used hangs on a harmonic
// mean, and a better one would change the look.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "tracer/math/vec.h"

namespace verisim::global {

class GatherLattice {
 public:
  static bool worthwhile(int rays) { return rays > kFew; }
  // Rays in place of `rays` of POV-Ray's.
  static int enough(int rays) { return rays > kEven ? rays - (rays - kEven) * 2 / 7 : std::min(2 * rays, rays + (kEven - rays) * 9 / 20); }

  // From one direction to the next, so that few of them are spread evenly, too: their places are much like those of the sequence of shifts.
  static int step(int count) {
    constexpr int kTried = 250;  // on either side of what suits one of the coordinates
    int best = 1;
    double least = 1.0;
    for (const auto& [ku, kv] : {std::pair(kU, kV), std::pair(kV, kU)}) {
      const int center = static_cast<int>(ku * count);
      for (int s = std::max(1, center - kTried); s < std::min(count, center + kTried); ++s) {
        const double angle = s * kGolden;
        const double off = std::max(apart(static_cast<double>(s) / count, ku), std::min(apart(angle, kv), apart(angle, -kv)));
        if (off < least && std::gcd(s, count) == 1) least = off, best = s;
      }
    }
    return best;
  }

  // Lattices of successive numbers complement each other, and begin everywhere: what only their beginnings look at is seen by all directions alike.
  GatherLattice(int count, int step, std::size_t number)
      : count_(count), step_(step), first_(static_cast<int>(part(kFirst * static_cast<double>(number)) * count)), u_(part(kU * static_cast<double>(number))), v_(part(kV * static_cast<double>(number))) {}

  // The first `count` are the lattice, in an order whose beginnings are spread evenly, too; then come others, shifted again.
  Vec3 next() {
    if (drawn_ == count_) drawn_ = 0, u_ = part(u_ + kU), v_ = part(v_ + kV);
    const auto place = static_cast<double>((static_cast<long long>(drawn_++) * step_ + first_) % count_);
    const double u = (place + u_) / count_, angle = 2.0 * 3.14159265358979323846 * (place * kGolden + v_), r = std::sqrt(u);
    return {r * std::cos(angle), std::sqrt(1.0 - u), r * std::sin(angle)};
  }

 private:
  static constexpr int kFew = 16, kEven = 60;  // kEven: as many as in POV-Ray
  static constexpr double kGolden = 0.61803398874989485;
  static constexpr double kU = 0.75487766624669276, kV = 0.56984029099805327;  // powers of the inverse plastic number: shifts that fill the square evenly
  static constexpr double kFirst = 0.81917251339616443;  // inverse of the root of x^4 = x + 1
  static double part(double x) { return x - std::floor(x); }
  static double apart(double a, double b) { return std::fabs(a - b - std::round(a - b)); }

  int count_, step_, first_, drawn_ = 0;
  double u_, v_;
};

}  // namespace verisim::global
