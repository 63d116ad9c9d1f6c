// The eight lanes against single points, and the map against the set itself.
#include "tracer/shapes/julia/julia_map.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes::julia {
namespace {

std::vector<Field> fields() {
  std::vector<Field> all;
  for (const Kind kind : {Kind::quaternion_square, Kind::quaternion_cube, Kind::hypercomplex_square}) {
    Field f;
    f.kind = kind;
    f.parameter = {-0.162, 0.163, -0.56, 0.1};
    f.slice = Vec3(0.1, 0.2, -0.1), f.slice_w = 0.97, f.slice_distance = 0.05;
    f.escape = kind == Kind::hypercomplex_square ? 16 : 2.6;
    f.iterations = 7;
    all.push_back(f);
  }
  return all;
}

// One point at a time, by the formulas of spec 04 section 8.
bool survives(const Field& f, const Vec3& p) {
  Number h{p.x, p.y, p.z, (f.slice_distance - f.slice.x * p.x - f.slice.y * p.y - f.slice.z * p.z) / f.slice_w};
  for (int i = 1; i <= f.iterations; ++i) {
    if (h.norm2() > f.escape) return false;
    h = (f.kind == Kind::quaternion_square ? quaternion_square(h)
         : f.kind == Kind::quaternion_cube ? quaternion_cube(h)
                                           : product(h, h)) +
        f.parameter;
  }
  return true;
}

TEST(JuliaPacket, AgreeWithSinglePoints) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.6, 1.6);
  for (const Field& f : fields()) {
    int inside_seen = 0;
    for (int n = 0; n < 2000; ++n) {
      const Vec3 o(coordinate(random), coordinate(random), coordinate(random)),
          d(coordinate(random), coordinate(random), coordinate(random));
      double estimate[kLanes];
      Points points;
      for (int k = 0; k < kLanes; ++k) points.set(k, o + 0.05 * k * d);
      const unsigned inside = kernels().march(f, points, d, estimate);
      for (int k = 0; k < kLanes; ++k) {
        ASSERT_EQ(inside >> k & 1, static_cast<unsigned>(survives(f, points[k])));
        inside_seen += inside >> k & 1;
      }
    }
    EXPECT_GT(inside_seen, 100);
  }
}

TEST(JuliaPacket, FourHalvingsAskForTheMiddlesThatASearchComesTo) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-1.6, 1.6);
  for (const Field& f : fields()) {
    int inside_seen = 0;
    for (int n = 0; n < 1000; ++n) {
      const Vec3 from(coordinate(random), coordinate(random), coordinate(random)),
          d = 0.1 * Vec3(coordinate(random), coordinate(random), coordinate(random));
      const unsigned inside = kernels().halvings(f, from, d, 1);
      for (unsigned way = 0; way < 16; ++way) {  // bit i: after halving i the farther half
        Vec3 low = from;
        double width = 1;
        unsigned node = 0;
        for (int i = 0; i < 4; ++i) {
          width /= 2;
          const Vec3 middle = low + width * d;
          const bool survived = survives(f, middle);
          ASSERT_EQ(inside >> node & 1, static_cast<unsigned>(survived)) << node;
          inside_seen += survived;
          const bool farther = way >> i & 1;
          if (farther) low = middle;
          node = 2 * node + (farther ? 2 : 1);
        }
      }
    }
    EXPECT_GT(inside_seen, 1000);
  }
}

// Random rays at a fractal and what the kernels make of them.
struct Intersections {
  RaysInGrid within;
  unsigned entered = 0, crossed = 0;
  double depth[kLanes] = {};
  Points points = {};
};
Intersections intersections(const Kernels& kernels, const Field& f, const Map& map, const Transform* matrix,
                            const RayBatch& row) {
  const double t_max[kLanes] = {9, 9, 9, 9, 9, 9, 2, 3};
  const RayPacket rays{row, 0, 0xf7};
  LocalPacket local;
  packet_kernels().local(matrix, rays, local);
  Intersections c;
  c.entered = kernels.enter(map.grid(), std::sqrt(f.escape), local, rays.active, t_max, c.within);
  c.crossed = kernels.first_intersections(f, c.within.rays, c.within.interval, c.entered, c.depth, c.points);
  return c;
}

TEST(JuliaPacket, InstructionSetsGiveTheSameBits) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const Transform turned = Transform::rotation({30, 40, 50}).then(Transform::scaling({0.9, 1.2, 0.8}));
  for (const Field& f : fields()) {
    const Map map(f);
    int entered = 0, crossed = 0;
    for (int n = 0; n < 500; ++n) {
      RayBatch rays{};
      for (int k = 0; k < kLanes; ++k) {
        const Vec3 d = normalize(Vec3(coordinate(random), coordinate(random), n % 5 == 0 ? 0 : coordinate(random)));
        rays.direction.set(k, d);
        rays.origin.set(
            k, Vec3(coordinate(random), coordinate(random), coordinate(random)) - static_cast<double>(n % 3) * d);
      }
      const Transform* const matrix = n % 2 ? &turned : nullptr;
      const Intersections plain = intersections(*kernels(simd::kBaseline), f, map, matrix, rays);
      entered += std::popcount(plain.entered), crossed += std::popcount(plain.crossed);
      each_lane(plain.entered, [&](int k) {
        const Vec3 o(plain.within.rays.origin[0][k], plain.within.rays.origin[1][k], plain.within.rays.origin[2][k]);
        const Vec3 d(plain.within.rays.direction[0][k], plain.within.rays.direction[1][k],
                     plain.within.rays.direction[2][k]);
        ASSERT_EQ(plain.within.interval.last[k],
                  map.last(o, d, plain.within.interval.begin[k], plain.within.interval.end[k]));
      });
      for (int set = simd::kAvx2; set < simd::kInstructionSets; ++set) {
        if (!kernels(set)) continue;
        const Intersections other = intersections(*kernels(set), f, map, matrix, rays);
        ASSERT_EQ(other.entered, plain.entered);
        ASSERT_EQ(other.crossed, plain.crossed);
        each_lane(plain.entered,
                  [&](int k) { ASSERT_EQ(other.within.interval.last[k], plain.within.interval.last[k]); });
        each_lane(plain.crossed, [&](int k) {
          ASSERT_EQ(other.depth[k], plain.depth[k]);
          ASSERT_EQ(other.points[k], plain.points[k]);
        });
      }
    }
    EXPECT_GT(entered, 1000);
    EXPECT_GT(crossed, 200);
  }
}

TEST(JuliaMap, NothingOfTheSetLiesBehindTheLastCell) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const Field& f : fields()) {
    const Map map(f);
    int inside_seen = 0, missed = 0;
    for (int n = 0; n < 3000; ++n) {
      const Vec3 d = normalize(Vec3(coordinate(random), coordinate(random), coordinate(random)));
      const Vec3 o = Vec3(coordinate(random), coordinate(random), coordinate(random)) * 1.2 - 3.0 * d;
      const double last = map.last(o, d, 0, 6);
      missed += last < 0;
      for (double t = 0.01; t < 6; t += 0.03) {
        if (!survives(f, o + t * d)) continue;
        ++inside_seen;
        ASSERT_LE(t, last + 1e-9);
        ASSERT_TRUE(map.grid().box.intersects(o + t * d));
      }
    }
    EXPECT_GT(inside_seen, 1000);
    EXPECT_GT(missed, 100);
  }
}

}  // namespace
}  // namespace verisim::shapes::julia
