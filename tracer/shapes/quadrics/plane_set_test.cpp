// Planes eight at a time, and the boxes of what planes and quadrics enclose.
#include "tracer/shapes/quadrics/plane_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "tracer/bvh/bvh.h"
#include "tracer/shapes/half_spaces.h"
#include "tracer/shapes/quadrics/plane.h"
#include "tracer/shapes/quadrics/quadric_box.h"
#include "tracer/shapes/shape.h"

namespace verisim::shapes {
namespace {

std::mt19937 random_numbers(11);

Vec3 random_vector(double size) {
  std::normal_distribution<double> d(0, size);
  return {d(random_numbers), d(random_numbers), d(random_numbers)};
}

scene::Quadric quadric(const Vec3& square, const Vec3& linear, double constant) {
  scene::Quadric q;
  q.square = square, q.mixed = Vec3(0), q.linear = linear, q.constant = constant;
  return q;
}

TEST(PlaneSet, KnowsOutsideOfManyPlanesBothWaysRound) {
  PlaneSet set;
  std::vector<std::pair<scene::Plane, bool>> planes;
  while (!set.full()) {
    planes.push_back({{normalize(random_vector(1)), random_vector(1).x}, planes.size() % 3 == 0});
    set.add(planes.back().first.normal, planes.back().first.distance, planes.back().second);
  }
  ASSERT_EQ(planes.size(), static_cast<std::size_t>(PlaneSet::kMax));
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random_vector(2);
    const std::uint64_t outside = set.outside(p);
    for (std::size_t k = 0; k < planes.size(); ++k)
      ASSERT_EQ(outside >> k & 1,
                (dot(p, planes[k].first.normal) - planes[k].first.distance < kEpsilon) == planes[k].second)
          << k;
  }
}

TEST(PlaneSet, PointsInsideAllPlanesLieWhereTheRayMayBeInside) {
  int inside = 0;
  for (int round = 0; round < 300; ++round) {
    PlaneSet set;
    for (int k = 0; k < 11; ++k) set.add(normalize(random_vector(1)), std::fabs(random_vector(1).x), false);
    const Ray ray{random_vector(1), normalize(random_vector(1))};
    alignas(64) double t[PlaneSet::kMax];
    double enter = -10, leave = 10;
    set.meet(ray, t, enter, leave);
    for (double s = -10; s < 10; s += 0.05) {
      const bool in = set.outside(ray.at(s)) == 0;
      inside += in;
      if (in) {
        ASSERT_TRUE(enter <= s && s <= leave);
      } else {
        ASSERT_FALSE(enter + 1e-3 < s && s < leave - 1e-3) << "as tight as the planes are";
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(HalfSpaces, BoxHoldsThePolytopeAndIsTight) {
  // A prism with a triangle of 45 degrees as its section: no plane but two is along an axis, and the box is finite.
  const double s = std::sqrt(0.5);
  const HalfSpace prism[] = {{{0, 1, 0}, -0.25}, {{0, -1, 0}, 3}, {{0, 0, -1}, 35}, {{-s, 0, s}, 0}, {{s, 0, s}, 0}};
  const Box3 box = narrowed(everywhere(), prism);
  const Vec3 low(-35, -3, -35), high(35, -0.25, 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(box.min[i], low[i], 1e-5);
    EXPECT_NEAR(box.max[i], high[i], 1e-5);
    EXPECT_LE(box.min[i], low[i]);
    EXPECT_GE(box.max[i], high[i]);
  }
}

TEST(HalfSpaces, OpenSidesStayInfinite) {
  const HalfSpace wedge[] = {{{0, 1, 0}, 2}, {normalize(Vec3(1, -1, 0)), 1}, {normalize(Vec3(-1, -1, 0)), 1}};
  const Box3 box = narrowed(everywhere(), wedge);
  EXPECT_TRUE(std::isinf(box.min.z) && std::isinf(box.max.z));
  EXPECT_NEAR(box.min.y, -std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(box.max.x, 2 + std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(box.min.x, -2 - std::sqrt(2.0), 1e-5);
}

TEST(HalfSpaces, RandomPolytopesLieInTheirBoxes) {
  int inside = 0, finite = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<HalfSpace> planes;
    for (int k = 0; k < 3 + round % 7; ++k)
      planes.push_back({normalize(random_vector(1)), 0.3 + std::fabs(random_vector(1).x)});
    Box3 known = everywhere();
    if (round % 2) known.max.y = 1.5;
    const Box3 box = narrowed(known, planes);
    finite += std::isfinite(box.min.x) && std::isfinite(box.max.z);
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = random_vector(2);
      bool in = p.y <= known.max.y;
      for (const HalfSpace& h : planes) in = in && dot(h.normal, p) <= h.distance;
      inside += in;
      if (in) {
        ASSERT_TRUE(box.intersects(p)) << round;
      }
    }
  }
  EXPECT_GT(inside, 3000);
  EXPECT_GT(finite, 50);
}

// The coordinates of the corners: where three planes meet and no other cuts off what lies there.
Box3 box_of_corners(const std::vector<HalfSpace>& planes) {
  Box3 box;
  const auto inside = [&](const Vec3& p) {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const HalfSpace& h) { return dot(h.normal, p) <= h.distance + 1e-9; });
  };
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Vec3 &a = planes[i].normal, &b = planes[j].normal, &c = planes[k].normal;
        const double det = dot(a, cross(b, c));
        if (std::fabs(det) < 1e-6) continue;
        const Vec3 p =
            (planes[i].distance * cross(b, c) + planes[j].distance * cross(c, a) + planes[k].distance * cross(a, b)) /
            det;
        if (inside(p)) box.extendBy(p);
      }
    }
  }
  return box;
}

TEST(HalfSpaces, BoxesOfPolytopesEndAtTheirCorners) {
  for (int round = 0; round < 300; ++round) {
    std::vector<HalfSpace> oblique;
    for (int k = 0; k < 1 + round % 30; ++k) oblique.push_back({random_vector(1), 0.1 + std::fabs(random_vector(1).x)});
    const Box3 known(Vec3(-3, -2, -1.5), Vec3(2, 3, 2.5));
    std::vector<HalfSpace> all = oblique;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 n(0);
      n[axis] = 1;
      all.push_back({n, known.max[axis]}), all.push_back({-n, -known.min[axis]});
    }
    const Box3 box = narrowed(known, oblique), exact = box_of_corners(all);
    for (int i = 0; i < 3; ++i) {
      ASSERT_GE(box.max[i], exact.max[i] - 1e-9) << round;
      ASSERT_LE(box.min[i], exact.min[i] + 1e-9) << round;
      ASSERT_NEAR(box.max[i], exact.max[i], 1e-3) << round;
      ASSERT_NEAR(box.min[i], exact.min[i], 1e-3) << round;
    }
  }
}

TEST(QuadricBox, HoldsWhatIsSolidAndIsTightWherePlanesCutIt) {
  Box3 known = everywhere();
  known.max.y = 4;
  const Box3 cup = narrowed(known, quadric({1, 0, 1}, {0, -1, 0}, 0));
  EXPECT_NEAR(cup.max.x, 2, 1e-4);
  EXPECT_NEAR(cup.min.z, -2, 1e-4);
  EXPECT_NEAR(cup.min.y, 0, 1e-4);
  const Box3 tube = narrowed(everywhere(), quadric({4, 0, 1}, {-8, 0, 0}, 3));
  EXPECT_TRUE(std::isinf(tube.max.y));
  EXPECT_NEAR(tube.max.x, 1.5, 1e-4);
  EXPECT_NEAR(tube.min.z, -1, 1e-4);
}

TEST(QuadricBox, RandomQuadricsLieInTheirBoxes) {
  int inside = 0, narrower = 0;
  for (int round = 0; round < 400; ++round) {
    scene::Quadric q = quadric(random_vector(1), random_vector(1), random_vector(1).x);
    if (round % 3 == 0) q.square[round % 2] = 0;
    if (round % 5 == 0) q.linear = Vec3(0);
    Box3 known = everywhere();
    if (round % 2) known.min.y = -1, known.max.y = 1.2;
    const Box3 box = narrowed(known, q);
    narrower += box.max.x < known.max.x;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = random_vector(1.5);
      double value = q.constant;
      for (int k = 0; k < 3; ++k) value += p[k] * (q.square[k] * p[k] + q.linear[k]);
      if (value > 0 || !known.intersects(p)) continue;
      ++inside;
      ASSERT_TRUE(box.intersects(p)) << round;
    }
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(narrower, 40);
}

}  // namespace
}  // namespace verisim::shapes
