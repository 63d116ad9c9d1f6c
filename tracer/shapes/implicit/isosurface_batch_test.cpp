// Searches of eight rays in step.
#include "tracer/shapes/implicit/isosurface_batch.h"

#include <cmath>

#include "tracer/functions/expression.h"
#include "tracer/shapes/trace_test_support.h"

namespace verisim::shapes {
namespace {

using namespace test;
using functions::Node;

Node number(double v) { return {functions::Constant{v}}; }
Node axis(int i) { return {functions::Parameter{i}}; }
Node chain(std::vector<Node> operands, functions::Op op) {
  std::vector<functions::Op> operators(operands.size() - 1, op);
  return {functions::Chain{std::move(operands), std::move(operators)}};
}
Node sum(std::vector<Node> operands) { return chain(std::move(operands), functions::Op::add); }
Node product(std::vector<Node> operands) { return chain(std::move(operands), functions::Op::multiply); }
Node sine(int i, double frequency) {
  return {functions::BuiltinCall{functions::Builtin::sin_, {product({axis(i), number(frequency)})}}};
}

// x^2 + y^2 + z^2 - 0.8 + size sin 6x sin 6y sin 6z
FunctionPtr wavy_ball(double size) {
  const Node waves = product({number(size), sine(0, 6), sine(1, 6), sine(2, 6)});
  return functions::compile(
      sum({product({axis(0), axis(0)}), product({axis(1), axis(1)}), product({axis(2), axis(2)}), number(-0.8), waves}),
      3, 3);
}

// Searches with a map of curvature end where those without it do, with the same steepest slope, after fewer steps.
TEST(IsosurfaceBatch, AMapChangesOnlyTheSteps) {
  const FunctionPtr function = wavy_ball(0.25);
  const auto& program = *FieldPacket::suitable(function.get());
  const CurvatureMap map(program, {Vec3(-1.3), Vec3(1.3)});
  ASSERT_TRUE(map.useful());
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  int hits = 0, steps[2] = {}, lost = 0, doubtful = 0;
  for (int n = 0; n < 3000; ++n) {
    FieldPacket field(program);
    SearchPacket packet{};
    packet.accuracy = n % 3 == 0 ? 0.05 : 0.001, packet.threshold = n % 2 ? 0.05 : 0;
    for (int k = 0; k < SearchPacket::kCount; ++k) {
      const Vec3 from = Vec3(unit(random), unit(random), unit(random)) * 1.3,
                 to = Vec3(unit(random), unit(random), unit(random)) * 1.3;
      const double speed = length(to - from);
      for (int i = 0; i < 3; ++i) {
        packet.origin[i][k] = from[i], packet.direction[i][k] = to[i] - from[i];
        packet.cell_origin[i][k] = (from[i] - map.low()[i]) / map.edge(),
        packet.cell_step[i][k] = (to[i] - from[i]) / map.edge();
        packet.reach[k] = std::max(packet.reach[k], std::fabs(packet.cell_step[i][k]));
      }
      packet.bend_anywhere[k] = std::numeric_limits<double>::infinity();
      packet.speed2[k] = speed * speed * (1 + 1e-12);
      packet.end[k] = packet.width[k] = 1;
      packet.value0[k] = (*function)(from.x, from.y, from.z) - packet.threshold,
      packet.value1[k] = (*function)(to.x, to.y, to.z) - packet.threshold;
      packet.slope[k] = (n % 5 == 0 ? 2.0 : 5.0) * speed;  // too small, or large enough
      packet.steepest[k] = (n % 4) * 1.5 * speed, packet.sign[k] = packet.value0[k] < 0 ? -1 : 1;
      packet.value0[k] *= packet.sign[k], packet.value1[k] *= packet.sign[k];
    }
    SearchPacket with = packet;
    with.map = &map;
    const bool approximate = n % 8 == 7;  // when the steepest slope is known
    if (approximate) with.doubt = 2 * map.error_bound() + 1e-16;
    const auto search_in = [&](SearchPacket& s, int& count) {
      const IsosurfaceKernels& kernels = isosurface_kernels();
      for (unsigned active = kernels.start(s, 255); active != 0;
           active = kernels.advance(s, field.evaluate(active, s.doubt > 0)))
        kernels.middles(s, field.points()), count += std::popcount(active);
    };
    search_in(packet, steps[0]);
    search_in(with, steps[1]);
    for (int k = 0; k < SearchPacket::kCount; ++k) {
      if (with.lost[k] != 0) {
        ++(approximate ? doubtful : lost);
        continue;
      }
      ASSERT_EQ(with.found[k], packet.found[k]);
      ASSERT_EQ(with.steepest[k], packet.steepest[k]);
      if (packet.found[k] == 0) continue;
      ++hits;
      ASSERT_EQ(with.hit[k], packet.hit[k]);
    }
  }
  EXPECT_GT(hits, 5000);
  EXPECT_LT(lost, 3);
  EXPECT_LT(doubtful, 100);  // of 3000
  EXPECT_LT(4 * steps[1], 3 * steps[0]);
}

}  // namespace
}  // namespace verisim::shapes
