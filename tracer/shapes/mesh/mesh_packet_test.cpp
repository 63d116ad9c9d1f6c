// Triangles met by eight rays: the same bits with every instruction set, and for one ray.
#include "tracer/shapes/mesh/mesh_packet.h"
#include "tracer/shapes/packet_test_support.h"

namespace verisim::shapes::testing {
namespace {

class MeshKernel : public EachInstructionSet {};

TEST_P(MeshKernel, MeetsTheSameTrianglesOfAMesh) {
  const MeshKernels *kernels = mesh_kernels(GetParam()), &plain = *mesh_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::vector<ObjectRef> objects;
  add_meshes({}, objects);
  const auto mesh = MeshGeometry::of(objects[0]->as<scene::Mesh>()->data);
  Rays rays;
  int met = 0, passed_over = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    MeshPacket a, b;
    packet_kernels(simd::kBaseline)->local(nullptr, {*rays.batches, 0, rays.active}, a.rays);
    b.rays = a.rays;
    const double t_min = round % 2 ? 1e-4 : 1;
    kernels->meet(*mesh, nullptr, rays.active, t_min, rays.limit, false, a);
    plain.meet(*mesh, nullptr, rays.active, t_min, rays.limit, false, b);
    for (int k = 0; k < kLanes; ++k) {
      ASSERT_EQ(a.triangle[k], b.triangle[k]);
      ASSERT_TRUE(same(a.t[k], b.t[k]));
      met += a.triangle[k] >= 0;
    }
    ASSERT_EQ(a.passed_over, b.passed_over);
    passed_over += std::popcount(a.passed_over);
  }
  EXPECT_GT(met, 3000);
  EXPECT_GT(passed_over, 1000);
}

TEST_P(MeshKernel, MeetsATriangleAlike) {
  const MeshKernels *kernels = mesh_kernels(GetParam()), &plain = *mesh_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  const Vec3 normal = normalize(Vec3(0.4, -0.9, 0.3));
  const FlatTriangle<double> slanted{{normal.x, normal.y, normal.z}, 0.1, {{-1.5, -1.2}, {1.3, -1}, {0.1, 1.7}}};
  const PlaneAxes axes = axes_beside(1);
  Rays rays;
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, round % 9);
    const RayPacket packet{*rays.batches, round % 9, 255};
    PacketHits a, b;
    kernels->triangle(slanted, axes, packet, 1e-4, rays.limit, a);
    plain.triangle(slanted, axes, packet, 1e-4, rays.limit, b);
    for (int k = 0; k < kLanes; ++k) {
      ASSERT_EQ(a.part[k], b.part[k]);
      const Ray ray = packet.at(k);
      double alone;
      const bool hit =
          TriangleHit::meets(slanted, axes, RayOfTriangle{ray.origin, ray.direction}, 1e-4, kTriangleFarthest, alone) &&
          alone < rays.limit[k];
      ASSERT_EQ(a.part[k] >= 0, hit);
      if (!hit) continue;
      ASSERT_TRUE(same(a.t[k], b.t[k]) && same(a.t[k], alone));
      ++met;
    }
  }
  EXPECT_GT(met, 3000);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, MeshKernel, all_instruction_sets());

}  // namespace
}  // namespace verisim::shapes::testing
