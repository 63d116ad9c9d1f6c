// Many rays against boxes and planes: what one ray meets alone.
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <memory>
#include <random>

#include "tracer/bvh/bvh.h"
#include "tracer/world/batch_kernels.h"
#include "tracer/shapes/quadrics/plane.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::accel {
namespace {

class BatchKernel : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    kernels = batch_kernels(GetParam());
    if (!kernels) GTEST_SKIP() << "this machine cannot run it";
    std::normal_distribution<double> d;
    for (int i = 0; i < RayBatch::kMax; ++i) {
      rays->origin.set(i, Vec3(d(random), d(random), d(random)) * 6.0);
      Vec3 direction = normalize(Vec3(d(random), d(random), d(random)));
      if (i % 9 == 0) direction[i % 3] = 0;  // along a face
      rays->direction.set(i, direction);
    }
  }
  const BatchKernels* kernels = nullptr;
  std::mt19937 random{3};
  std::unique_ptr<RayBatch> rays = std::make_unique<RayBatch>();
};

TEST_P(BatchKernel, PlanesAreMetAsByOneRay) {
  const Vec3 normal = normalize(Vec3(1, 2, -0.5));
  int met = 0;
  unsigned reached = 0;
  for (int first = 3; first < 33; first += RayPacket::kCount) {
    alignas(64) double t[RayPacket::kCount], limit[RayPacket::kCount];
    for (int k = 0; k < RayPacket::kCount; ++k) limit[k] = 0.5 + k;
    const unsigned within = kernels->plane(normal, 0.7, *rays, first, 0.3, limit, t);
    for (int k = 0; k < RayPacket::kCount; ++k) {
      const double slope = dot(normal, rays->direction.at(first + k)),
                   along = (0.7 - dot(normal, rays->origin.at(first + k))) / slope;
      EXPECT_EQ(t[k], shapes::meets_plane(slope, along) ? along : -1) << first + k;
      EXPECT_EQ(within >> k & 1, t[k] >= 0.3 && t[k] < limit[k] ? 1u : 0u) << first + k;
      met += t[k] > 0, reached += within >> k & 1;
    }
  }
  EXPECT_GT(met, 5);
  EXPECT_GT(reached, 2);
  EXPECT_LT(reached, static_cast<unsigned>(met));
}

TEST_P(BatchKernel, BoxesAreMetByThoseRaysThatMeetThem) {
  std::uniform_real_distribution<double> u(-4, 4);
  int count = 0, misses = 0, beyond = 0, outside = 0;
  for (int round = 0; round < 200; ++round) {
    Box3 boxes[8], bounds;
    for (int b = 0; b < 7; ++b) {
      for (int corner = 0; corner < 2; ++corner) boxes[b].extendBy(Vec3(u(random), u(random), u(random)));
      bounds.extendBy(boxes[b]);
    }
    const Vec3 center = bounds.center();
    const double slack = 1e-5;
    BoxNode nodes[2];
    for (int b = 0; b < 8; ++b) {
      BoxNode& node = nodes[b / 4];
      if (b % 4 == 0) node.clear();
      if (b == 7) break;  // there is no eighth box
      for (int i = 0; i < 3; ++i) {
        node.planes[i][b % 4] = static_cast<float>(boxes[b].min[i] - center[i] - slack);
        node.planes[3 + i][b % 4] = static_cast<float>(boxes[b].max[i] - center[i] + slack);
      }
      node.child[b % 4] = BoxNode::leaf(0, 1);
    }
    for (int first = 0; first < RayBatch::kMax; first += RayPacket::kCount) {
      NodeRays there;
      kernels->node_rays({bounds.min - Vec3(slack), bounds.max + Vec3(slack)}, center, slack, *rays, first, 1e-4,
                         there);
      double limit[RayPacket::kCount];
      for (int k = 0; k < RayPacket::kCount; ++k)
        limit[k] = k % 3 == 0 ? 5 : k % 3 == 1 ? 1e20 : std::numeric_limits<double>::infinity();
      for (int k = 0; k < RayPacket::kCount; ++k) outside += there.start[k] == std::numeric_limits<double>::infinity();
      for (int b = 0; b < 8; ++b) {
        ChildrenMet met;
        kernels->children(nodes[b / 4], there, limit, met);
        if (b == 7) {
          EXPECT_EQ(met.lanes[3], 0u) << "there is no eighth box";
          break;
        }
        double nothing[RayPacket::kCount] = {};
        EXPECT_EQ(kernels->before(met.near[b % 4], there, limit) & met.lanes[b % 4], met.lanes[b % 4]);
        beyond += std::popcount(met.lanes[b % 4] & ~kernels->before(met.near[b % 4], there, nothing));
        for (int k = 0; k < RayPacket::kCount; ++k) {
          double near = 1e-4, far = limit[k];
          const bool expected = clip_to_box(rays->at(first + k), boxes[b], near, far),
                     is_met = met.lanes[b % 4] >> k & 1;
          if (expected) {
            ++count;
            EXPECT_TRUE(is_met) << first + k << ' ' << b;
            EXPECT_LE(there.start[k] + met.near[b % 4][k], near + 1e-6);
            EXPECT_GE(there.start[k] + met.near[b % 4][k], near - 1e-3 * (1 + near)) << "nor far before it";
          } else {
            misses += is_met;
          }
        }
      }
    }
  }
  EXPECT_GT(count, 1000);
  EXPECT_GT(beyond, 500) << "limits may shrink";
  EXPECT_GT(outside, 100) << "rays that miss all boxes";
  EXPECT_LT(misses, 20) << "boxes are not much larger than they are";
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, BatchKernel, testing::Range(0, static_cast<int>(simd::kInstructionSets)));

}  // namespace
}  // namespace verisim::accel
