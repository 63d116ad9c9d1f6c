#include "compare/causes/moved_light.h"

#include <algorithm>
#include <cmath>

namespace verisim::compare {
namespace {

constexpr double kGrazing = 0.05;  // least cosine from which the light of other directions is told

Vec3 vector(const Pixel& p) { return {p[0], p[1], p[2]}; }

double cosine(const Vec3& light, const Vec3& point, const Vec3& normal) {
  const Vec3 to = light - point;
  const double far = verisim::length(to);
  return far > 0 ? verisim::dot(to, normal) / far : 0;
}

// The pixels that show a surface, each with what the light would make of it straight from above.
class LitSurfaces {
 public:
  LitSurfaces(const Vec3& from, const Pixels& light, const Pixels& wanted, const SeenSurfaces& seen) {
    const std::array<double, 3> strength = strength_of(from, light, seen);
    for (std::size_t i = 0; i < light.size(); ++i) {
      if (seen.normal[i] == Pixel{}) continue;
      One& one = all_.emplace_back();
      one.at = i, one.point = vector(seen.point[i]), one.normal = vector(seen.normal[i]), one.light = light[i],
      one.wanted = wanted[i];
      const double facing = cosine(from, one.point, one.normal);
      for (std::size_t k = 0; k < 3; ++k)
        one.from_above[k] = facing > kGrazing && light[i] != Pixel{}
                                ? light[i][k] / static_cast<float>(facing)
                                : seen.diffuse[i][k] * static_cast<float>(strength[k]);
    }
  }

  // Of the points, by each coordinate: the far end of a plane does not count for more than what stands on it.
  Vec3 middle() const {
    Vec3 out(0.0);
    std::vector<double> values(all_.size());
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < all_.size(); ++i) values[i] = all_[i].point[axis];
      std::nth_element(values.begin(), half, values.end());
      out[axis] = *half;
    }
    return out;
  }

  // What a light there leaves of the wanted light, squared, over every `step`-th pixel.
  double left(const Vec3& at, std::size_t step) const {
    double sum = 0;
    for (std::size_t i = 0; i < all_.size(); i += step) sum += squared_distance(shown(all_[i], at), all_[i].wanted);
    return sum;
  }

  // The same for the light as it was, with its shadows.
  double changed(std::size_t step) const {
    double sum = 0;
    for (std::size_t i = 0; i < all_.size(); i += step) sum += squared_distance(all_[i].light, all_[i].wanted);
    return sum;
  }

  Pixels light_from(const Vec3& at, std::size_t pixels) const {
    Pixels out(pixels);
    for (const One& one : all_) out[one.at] = shown(one, at);
    return out;
  }

  std::size_t size() const { return all_.size(); }

 private:
  struct One {
    std::size_t at = 0;
    Vec3 point, normal;
    Pixel light{}, wanted{}, from_above{};
  };

  // So much more than white light from straight above, where it shines.
  static std::array<double, 3> strength_of(const Vec3& from, const Pixels& light, const SeenSurfaces& seen) {
    std::array<double, 3> is{}, would_be{}, out{};
    for (std::size_t i = 0; i < light.size(); ++i) {
      const double facing = cosine(from, vector(seen.point[i]), vector(seen.normal[i]));
      if (light[i] == Pixel{} || facing < kGrazing) continue;
      for (std::size_t k = 0; k < 3; ++k) is[k] += light[i][k], would_be[k] += seen.diffuse[i][k] * facing;
    }
    for (std::size_t k = 0; k < 3; ++k) out[k] = would_be[k] > 0 ? is[k] / would_be[k] : 0;
    return out;
  }

  // Lit, or in a shadow: whichever is nearer to what is wanted.
  static Pixel shown(const One& one, const Vec3& at) {
    const auto facing = static_cast<float>(std::max(0.0, cosine(at, one.point, one.normal)));
    const Pixel lit{one.from_above[0] * facing, one.from_above[1] * facing, one.from_above[2] * facing};
    return squared_distance(lit, one.wanted) < squared_distance({}, one.wanted) ? lit : Pixel{};
  }

  std::vector<One> all_;
};

}  // namespace

std::optional<MovedLight> moved_light(const Vec3& from, const Pixels& light, const Pixels& wanted,
                                      const SeenSurfaces& surfaces) {
  constexpr std::size_t kLeast = 100, kJudged = 3000;
  constexpr int kMaxSteps = 200;
  constexpr double kClearly = 0.6, kFirstStep = 0.25, kLastStep = 1e-3, kLeastAngle = 0.01, kOfShadows = 0.02;
  const LitSurfaces lit(from, light, wanted, surfaces);
  if (lit.size() < kLeast) return std::nullopt;
  const std::size_t step = 1 + lit.size() / kJudged;
  const Vec3 middle = lit.middle();
  const double start = lit.left(from, step), far = verisim::length(from - middle);
  if (start <= kOfShadows * lit.changed(step)) return std::nullopt;
  Vec3 best = from;
  double least = start;
  int steps = 0;
  for (double stride = kFirstStep; stride > kLastStep && steps < kMaxSteps; ++steps) {
    Vec3 better = best;
    for (int axis = 0; axis < 3; ++axis)
      for (const double way : {-1.0, 1.0}) {
        Vec3 to = best;
        to[axis] += way * stride * far;
        if (const double left = lit.left(to, step); left < least) least = left, better = to;
      }
    if (better == best) stride /= 2;
    best = better;
  }
  const Vec3 before = verisim::normalize(from - middle), after = verisim::normalize(best - middle);
  if (least > kClearly * start || verisim::length(after - before) < kLeastAngle) return std::nullopt;
  return MovedLight{best, lit.light_from(best, light.size())};
}

}  // namespace verisim::compare
