// Polynomials along eight rays: the same bits with every instruction set.
#include "tracer/shapes/algebraic/poly_packet.h"
#include "tracer/shapes/packet_test_support.h"
#include "tracer/shapes/swept/sphere_sweep_packet.h"

namespace verisim::shapes::testing {
namespace {

class PolynomialKernel : public EachInstructionSet {};

TEST_P(PolynomialKernel, MakesTheSamePolynomialsAlongRays) {
  const PacketKernels* kernels = packet_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  const Transform moved = Transform::scaling({0.7, -1.2, 0.9}).then(Transform::rotation({20, 70, -40}));
  const scene::Poly surface =
      poly(6, {{6, 0, 0, 1}, {1, 2, 3, -0.7}, {0, 4, 1, 2}, {0, 0, 5, 0.3}, {2, 1, 0, 1}, {0, 0, 0, -1}});
  std::vector<unsigned char> used(28, 1);
  const SweepCubic cubic{{{0.1, -0.3, 0.2, 0.4}, {1, 0.5, -0.2, 0.1}, {-0.3, 0.8, 0.5, -0.2}, {0.2, -0.7, 0.3, 0.1}},
                         {0.55, 0.06, 0.26}};
  Rays rays;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, round % 9);
    const RayPacket packet{*rays.batches, round % 9, 255};
    LocalPacket local, plain_local;
    kernels->local(round % 2 ? &moved : nullptr, packet, local);
    packet_kernels(simd::kBaseline)->local(round % 2 ? &moved : nullptr, packet, plain_local);
    PolyPacket a, b;
    (*poly_along(GetParam()))(6, surface.coefficients.data(), used.data(), local, a);
    (*poly_along(simd::kBaseline))(6, surface.coefficients.data(), used.data(), plain_local, b);
    ASSERT_EQ(a.size, 7);
    ASSERT_EQ(b.size, 7);
    SweepSidePacket c, d;
    (*sweep_follow(GetParam()))(cubic, local, c);
    (*sweep_follow(simd::kBaseline))(cubic, plain_local, d);
    for (int k = 0; k < kLanes; ++k) {
      for (int i = 0; i < 7; ++i) ASSERT_TRUE(same(a.c[i][k], b.c[i][k]));
      for (int i = 0; i < 11; ++i) ASSERT_TRUE(same(c.power[i][k], d.power[i][k]));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, PolynomialKernel, all_instruction_sets());

}  // namespace
}  // namespace verisim::shapes::testing
