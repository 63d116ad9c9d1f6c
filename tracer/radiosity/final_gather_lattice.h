// Directions in which a radiosity sample looks in the default mode: cosine-weighted about +y like POV-Ray's (spec
// 07 2.7), but each sample has a lattice of its own, shifted against those of the others, instead of the next stretch
// of one sequence. Noise hangs on samples of few rays and time on those of many: these take fewer rays than in POV-Ray,
// those of few take more. Those of very few, at deep levels, are left as they are: how far they are used hangs on a
// harmonic mean, and a better one would change the look.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "tracer/math/constants.h"
#include "tracer/math/vec.h"

namespace verisim::global {

class FinalGatherLattice {
 public:
  static bool worthwhile(int rays) { return rays > kFew; }
  // Rays in place of `rays` of POV-Ray's.
  static int enough(int rays) {
    return rays > kEven ? rays - (rays - kEven) * 2 / 7 : std::min(2 * rays, rays + (kEven - rays) * 9 / 20);
  }

  // From one direction to the next, so that few of them are spread evenly, too: their places are much like those of the
  // sequence of shifts.
  static int step(int count) {
    constexpr int kTried = 250;  // on either side of what suits one of the coordinates
    int best = 1;
    double least = 1.0;
    for (const auto& [ku, kv] : {std::pair(kU, kV), std::pair(kV, kU)}) {
      const int center = static_cast<int>(ku * count);
      for (int s = std::max(1, center - kTried); s < std::min(count, center + kTried); ++s) {
        const double angle = s * kGolden;
        const double off =
            std::max(apart(static_cast<double>(s) / count, ku), std::min(apart(angle, kv), apart(angle, -kv)));
        if (off < least && std::gcd(s, count) == 1) least = off, best = s;
      }
    }
    return best;
  }

  // What all lattices of as many rays share.
  struct Plan {
    Plan() = default;
    explicit Plan(int n) : count(n), step(FinalGatherLattice::step(n)), turns(static_cast<std::size_t>(n)) {
      for (int place = 0; place < n; ++place) turns[static_cast<std::size_t>(place)] = turn(place * kGolden);
    }
    int count = 0, step = 0;
    std::vector<Vec2> turns;  // cosines and sines of the angles that places are at
  };

  // Lattices of successive numbers complement each other, and begin everywhere: what only their beginnings look at is
  // seen by all directions alike.
  FinalGatherLattice(const Plan& plan, std::size_t number)
      : plan_(plan),
        first_(static_cast<int>(part(kFirst * static_cast<double>(number)) * plan.count)),
        u_(part(kU * static_cast<double>(number))),
        v_(part(kV * static_cast<double>(number))),
        turn_(turn(v_)) {}

  // The first `count` are the lattice, in an order whose beginnings are spread evenly, too; then come others, shifted
  // again.
  Vec3 next() {
    if (drawn_ == plan_.count) drawn_ = 0, u_ = part(u_ + kU), v_ = part(v_ + kV), turn_ = turn(v_);
    const auto place = static_cast<std::size_t>((static_cast<long long>(drawn_++) * plan_.step + first_) % plan_.count);
    const double u = (static_cast<double>(place) + u_) / plan_.count, r = std::sqrt(u);
    const Vec2& own = plan_.turns[place];
    return {r * (own.x * turn_.x - own.y * turn_.y), std::sqrt(1.0 - u), r * (own.x * turn_.y + own.y * turn_.x)};
  }

 private:
  static constexpr int kFew = 16, kEven = 60;  // kEven: as many as in POV-Ray
  static constexpr double kGolden = 0.61803398874989485;
  static constexpr double
      kU = 0.75487766624669276,
      kV = 0.56984029099805327;  // powers of the inverse plastic number: shifts that fill the square evenly
  static constexpr double kFirst = 0.81917251339616443;  // inverse of the root of x^4 = x + 1
  static double part(double x) { return x - std::floor(x); }
  static double apart(double a, double b) { return std::fabs(a - b - std::round(a - b)); }

  static Vec2 turn(double whole) {
    const double angle = 2.0 * kPi * whole;
    return {std::cos(angle), std::sin(angle)};
  }

  const Plan& plan_;
  int first_, drawn_ = 0;
  double u_, v_;
  Vec2 turn_;
};

}  // namespace verisim::global
