// Lanes do what the plain code does, for every kind, function and instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tracer/shapes/julia/julia_march.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes::julia {
namespace {

std::vector<scene::JuliaFractal> fractals() {
  std::vector<scene::JuliaFractal> all;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 20 * 6; ++k) {
    scene::JuliaFractal f;
    f.hypercomplex = k % 20 < 18;
    f.function = static_cast<scene::JuliaFunction>(f.hypercomplex ? k % 20 : k % 2);
    f.parameter = {unit(random) * 0.6, unit(random) * 0.6, unit(random) * 0.6, unit(random) * 0.6};
    if (k % 3 != 0) {
      f.slice = {unit(random) * 0.5, unit(random) * 0.5, unit(random) * 0.5, 0.7};
      f.slice_distance = unit(random);
    }
    f.exponent = {1.5 + unit(random), k % 2 == 0 ? 0 : unit(random)};
    f.max_iteration = k < 20 ? 1 : 2 + k / 20 * 2;
    f.precision = 5 + 5 * (k / 20);
    all.push_back(f);
  }
  return all;
}

const char* name(int set) {
  static constexpr const char* kNames[simd::kInstructionSets] = {"baseline", "sse4", "avx2", "avx512"};
  return kNames[set];
}

struct Scattered {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> unit{-1, 1};
  Vec3 point() { return {unit(random), unit(random), unit(random)}; }
  Ray ray() {
    const Vec3 d = normalize(point());
    return {point() * 2.5 - 4.0 * d, d};
  }
};

TEST(JuliaKernels, PointsAndEstimatesAreThoseOfThePlainCode) {
  for (const scene::JuliaFractal& fractal : fractals()) {
    const Iteration iteration(fractal);
    const Field& f = iteration.field();
    if (is_quaternion(f.kind)) continue;  // their estimates hang on logarithms that the plain code spares, too
    Scattered scattered;
    for (int n = 0; n < 40; ++n) {
      const Vec3 d = scattered.ray().direction;
      Points points;
      for (int k = 0; k < kLanes; ++k) points.set(k, scattered.point() * (n % 2 == 0 ? 2.5 : 1));
      if (n % 5 == 0)
        for (int k = 0; k < kLanes; ++k) points.at[2][k] = points.at[1][k] * (k % 2 == 0 ? 1 : -1);  // real numbers
      for (int set = 0; set < simd::kInstructionSets; ++set) {
        if (!kernels(set)) continue;
        double estimates[kLanes];
        const unsigned inside = kernels(set)->march(f, points, d, estimates);
        for (int k = 0; k < kLanes; ++k) {
          Orbit orbit(f.iterations + 1);
          const int escaped = iteration.iterate(orbit, iteration.start(points[k]));
          ASSERT_EQ(inside >> k & 1, escaped == 0 ? 1u : 0u) << name(set) << ", " << static_cast<int>(f.function);
          if (escaped == 0) continue;
          const Number& h = orbit[escaped - 1];
          const double q = f.kind == Kind::hypercomplex_square ? norm2<Kind::hypercomplex_square>(h)
                                                               : norm2<Kind::function>(h),
                       slope = dot(iteration.hypercomplex_normal(orbit, escaped - 1), d);
          const double expected = slope_tells(slope, q, f.precision) ? q / (-2 * slope) : f.precision;
          if (expected > f.precision)
            ASSERT_EQ(estimates[k], expected) << name(set) << ", " << static_cast<int>(f.function);
          else
            ASSERT_LE(estimates[k], f.precision);
        }
      }
    }
  }
}

// What a march of one ray finds first, as JuliaFractal asks it.
struct Found {
  bool hit = false, escapes = false;
  double depth = 0;
  Vec3 point, normal;
};
Found march_alone(const Iteration& iteration, const Ray& ray, double begin, double end) {
  Found found;
  Orbit orbit(iteration.field().iterations + 1);
  March(iteration).walk(orbit, ray, begin, end, end, [&](double depth, const Vec3& point) {
    found.hit = true, found.depth = depth, found.point = point;
    if (is_power(iteration.field().kind) || iteration.iterate(orbit, iteration.start_of_inside(point)) == 0)
      return true;
    found.escapes = true;
    iteration.complete(orbit);
    found.normal = iteration.hypercomplex_normal(orbit, iteration.field().iterations);
    return true;
  });
  return found;
}

TEST(JuliaKernels, RaysInStepFindWhatEachFindsAlone) {
  int crossed = 0, kept = 0;
  for (const scene::JuliaFractal& fractal : fractals()) {
    const Iteration iteration(fractal);
    const Field& f = iteration.field();
    Scattered scattered;
    for (int n = 0; n < 12; ++n) {
      Rays rays;
      Interval interval;
      Found expected[kLanes];
      const unsigned active = n % 3 == 0 ? 0xffu : 0xb6u;
      for (int k = 0; k < kLanes; ++k) {
        const Ray ray = scattered.ray();
        rays.set(k, ray.origin, ray.direction);
        interval.begin[k] = 0.5, interval.end[k] = interval.last[k] = 6, interval.limit[k] = 1e300;
        expected[k] = march_alone(iteration, ray, 0.5, 6);
      }
      for (int set = 0; set < simd::kInstructionSets; ++set) {
        if (!kernels(set)) continue;
        double depths[kLanes];
        Points points;
        NormalsOfSearch normals;
        const unsigned hits = kernels(set)->first_intersections(f, rays, interval, active, depths, points, &normals);
        for (int k = 0; k < kLanes; ++k) {
          if ((active >> k & 1) == 0) continue;
          ASSERT_EQ(hits >> k & 1, expected[k].hit ? 1u : 0u) << name(set) << ", " << static_cast<int>(f.function);
          if (!expected[k].hit) continue;
          ++crossed;
          ASSERT_EQ(depths[k], expected[k].depth);
          ASSERT_EQ(points[k], expected[k].point);
          ASSERT_EQ(normals.lanes >> k & 1, expected[k].escapes ? 1u : 0u);
          if (!expected[k].escapes) continue;
          ++kept;
          for (int i = 0; i < 3; ++i) {
            if (std::isnan(expected[k].normal[i])) continue;
            ASSERT_EQ(normals.normals[k][i], expected[k].normal[i])
                << name(set) << ", " << static_cast<int>(f.function);
          }
        }
      }
    }
  }
  EXPECT_GT(crossed, 1000);
  EXPECT_GT(kept, 100);
}

}  // namespace
}  // namespace verisim::shapes::julia
