// Many rays against boxes and planes: what one ray meets alone.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "tracer/accel/box_tree.h"
#include "tracer/accel/row_kernels.h"
#include "tracer/shapes/plane.h"
#include "tracer/textures/instruction_sets.h"

namespace verisim::accel {
namespace {

class RowKernel : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    kernels = row_kernels(GetParam());
    if (!kernels) GTEST_SKIP() << "this machine cannot run it";
    std::normal_distribution<double> d;
    for (int i = 0; i < RayRow::kMost; ++i) {
      rays->origin.set(i, Vec3(d(random), d(random), d(random)) * 6.0);
      Vec3 direction = normalize(Vec3(d(random), d(random), d(random)));
      if (i % 9 == 0) direction[i % 3] = 0;  // along a face
      rays->direction.set(i, direction);
    }
  }
  const RowKernels* kernels = nullptr;
  std::mt19937 random{3};
  std::unique_ptr<RayRow> rays = std::make_unique<RayRow>();
};

TEST_P(RowKernel, PlanesAreMetAsByOneRay) {
  const Vec3 normal = normalize(Vec3(1, 2, -0.5));
  int met = 0;
  for (int first = 3; first < 33; first += RayLanes::kCount) {
    alignas(64) double t[RayLanes::kCount];
    kernels->plane(normal, 0.7, *rays, first, t);
    for (int k = 0; k < RayLanes::kCount; ++k) {
      const double slope = dot(normal, rays->direction.at(first + k)), along = (0.7 - dot(normal, rays->origin.at(first + k))) / slope;
      EXPECT_EQ(t[k], shapes::meets_plane(slope, along) ? along : -1) << first + k;
      met += t[k] > 0;
    }
  }
  EXPECT_GT(met, 5);
}

TEST_P(RowKernel, BoxesAreMetByThoseRaysThatMeetThem) {
  std::uniform_real_distribution<double> u(-4, 4);
  const auto met = std::make_unique<BoxesMet>();
  int count = 0, misses = 0;
  for (int round = 0; round < 200; ++round) {
    const Vec3 center(u(random), u(random), u(random));
    EntryPoints entry;
    entry.count = 2;
    Box3 boxes[8];
    for (int n = 0; n < 2; ++n) {
      entry.nodes[n].clear();
      for (int k = 0; k < (n == 0 ? 4 : 3); ++k) {
        Box3& box = boxes[4 * n + k];
        box.makeEmpty();
        box.extendBy(Vec3(u(random), u(random), u(random)));
        box.extendBy(Vec3(u(random), u(random), u(random)));
        for (int i = 0; i < 3; ++i) {
          entry.nodes[n].planes[i][k] = static_cast<float>(box.min[i] - center[i] - 1e-5);
          entry.nodes[n].planes[3 + i][k] = static_cast<float>(box.max[i] - center[i] + 1e-5);
        }
        entry.nodes[n].child[k] = BoxNode::leaf(0, 1);
      }
    }
    for (int first = 0; first < RayRow::kMost; first += RayLanes::kCount) {
      kernels->boxes(entry, center, *rays, first, 1e-4, *met);
      const NodeRays there = kernels->node_rays(center, *rays, first);
      double limit[RayLanes::kCount];
      for (int k = 0; k < RayLanes::kCount; ++k) limit[k] = k % 3 == 0 ? 5 : 1e20;
      for (int n = 0; n < 2; ++n) {
        ChildrenMet children;
        kernels->children(entry.nodes[n], there, 1e-4, limit, children);
        for (int k = 0; k < RayLanes::kCount; ++k)
          for (int b = 0; b < 4; ++b) {
            const bool is_met = met->places[k] >> (4 * n + b) & 1 && met->near[4 * n + b][k] < limit[k];
            EXPECT_EQ(children.lanes[b] >> k & 1, is_met) << n << b << ' ' << first + k;
            if (is_met) {
              EXPECT_EQ(children.near[b][k], met->near[4 * n + b][k]);
            }
          }
      }
      for (int k = 0; k < RayLanes::kCount; ++k) {
        EXPECT_EQ(met->places[k] >> 7, 0) << "there is no eighth box";
        for (int b = 0; b < 7; ++b) {
          double near = 1e-4, far = 1e20;
          const bool expected = clip_to_box(rays->at(first + k), boxes[b], near, far);
          const bool is_met = met->places[k] >> b & 1;
          if (expected) {
            ++count;
            EXPECT_TRUE(is_met) << first + k << ' ' << b;
            EXPECT_LE(met->near[b][k], near);
          } else {
            misses += is_met;
          }
        }
      }
    }
  }
  EXPECT_GT(count, 1000);
  EXPECT_LT(misses, 20) << "boxes are not much larger than they are";
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, RowKernel, testing::Range(0, static_cast<int>(textures::kInstructionSets)));

}  // namespace
}  // namespace verisim::accel
