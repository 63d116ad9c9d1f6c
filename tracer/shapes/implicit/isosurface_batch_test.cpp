// Rays in step against single rays, and the instruction sets against each other.
#include "tracer/shapes/implicit/isosurface_batch.h"

#include <cmath>

#include "tracer/functions/expression.h"
#include "tracer/shapes/trace_test_support.h"
#include "tracer/simd/instruction_sets.h"

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

TEST(IsosurfaceBatch, FindsWhatSingleRaysFind) {
  std::mt19937 random(5);
  int found = 0;
  for (int n = 0; n < 48; ++n) {
    scene::Isosurface s;
    s.function = wavy_ball(n % 5 == 0 ? 0.9 : 0.2);
    s.max_gradient = n % 3 == 0 ? 1.1 : 5;  // too small, then pruned nodes matter
    s.accuracy = n % 4 == 0 ? 0.05 : 0.002;
    s.max_trace = n % 6;
    s.open = n % 7 == 0;
    s.threshold = n % 2 ? 0.1 : 0;
    if (n % 8 == 1) s.container = {true, Vec3(0), Vec3(0), {0, 0, 0}, 0.9};
    scene::Object o = object(s);
    if (n % 3) o.transform = Transform::rotation({30, 40, 50}).then(Transform::scaling({0.9, 1.2, 0.8}));
    const auto shape = compile(o);
    for (int i = 0; i < 40 && !HasFatalFailure(); ++i) expect_rows_as_single_rays(*shape, random, found);
  }
  EXPECT_GT(found, 2000);
}

// Lanes that begin behind the surface leave the others alone, also where a function is computed only for the lanes that
// are asked for.
TEST(IsosurfaceBatch, SomeRaysBeginAtTheSurface) {
  scene::Isosurface s;
  s.function = functions::compile(sum({product({axis(0), axis(0)}),
                                       product({axis(1), axis(1)}),
                                       {functions::BuiltinCall{functions::Builtin::tanh_, {axis(2)}}},
                                       number(-0.5)}),
                                  3, 3);
  s.max_gradient = 3, s.accuracy = 0.05;  // what is near the surface: 4 x 3 x 0.05
  std::mt19937 random(9);
  int found = 0;
  const auto shape = compile(object(s));
  for (int i = 0; i < 2000 && !HasFatalFailure(); ++i) expect_rows_as_single_rays(*shape, random, found);
  EXPECT_GT(found, 2000);
}

// Distances that are not for lanes are left to the single ray.
TEST(IsosurfaceBatch, FarAndFineSearchesAreSingle) {
  scene::Isosurface s;
  s.function = wavy_ball(0.2);
  s.max_gradient = 5;
  s.accuracy = 1e-300;
  std::mt19937 random(6);
  int found = 0;
  for (int i = 0; i < 5 && !HasFatalFailure(); ++i) expect_rows_as_single_rays(*compile(object(s)), random, found);
  EXPECT_GT(found, 0);
}

void set_up(SearchPacket& packet, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  packet.accuracy = 0.001 * (1.5 + unit(random)), packet.threshold = 0.1 * unit(random);
  for (int k = 0; k < SearchPacket::kCount; ++k) {
    for (int i = 0; i < 3; ++i) packet.origin[i][k] = unit(random), packet.direction[i][k] = unit(random);
    packet.begin[k] = unit(random), packet.width[k] = 3 + unit(random);
    packet.end[k] = packet.begin[k] + packet.width[k];
    packet.value0[k] = 0.5 + unit(random), packet.value1[k] = unit(random);
    packet.slope[k] = 2 + unit(random), packet.sign[k] = unit(random) < 0 ? -1 : 1;
  }
}
unsigned search(const IsosurfaceKernels& kernels, SearchPacket& packet) {
  alignas(64) double points[3 * SearchPacket::kCount], values[SearchPacket::kCount];
  for (unsigned active = kernels.start(packet, 0xed); active != 0; active = kernels.advance(packet, values)) {
    kernels.middles(packet, points);
    for (int k = 0; k < SearchPacket::kCount; ++k) values[k] = std::sin(7 * points[k]) + points[8 + k] * points[16 + k];
  }
  unsigned found = 0;
  for (int k = 0; k < SearchPacket::kCount; ++k) found |= packet.found[k] != 0 ? 1u << k : 0;
  return found;
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
    const bool nearly = n % 8 == 7;  // when the steepest slope is known
    if (nearly) with.doubt = 2 * map.error_bound() + 1e-16;
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
        ++(nearly ? doubtful : lost);
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

TEST(IsosurfaceBatch, InstructionSetsGiveTheSameBits) {
  std::mt19937 random(7);
  int hits = 0;
  for (int n = 0; n < 300; ++n) {
    SearchPacket start{};
    set_up(start, random);
    SearchPacket plain = start;
    const unsigned found = search(*isosurface_kernels(simd::kBaseline), plain);
    EXPECT_EQ(found & ~0xedu, 0u);
    hits += std::popcount(found);
    for (int set = simd::kAvx2; set < simd::kInstructionSets; ++set) {
      const IsosurfaceKernels* const kernels = isosurface_kernels(set);
      if (!kernels) continue;
      SearchPacket other = start;
      ASSERT_EQ(search(*kernels, other), found);
      each_lane(0xed, [&](int k) {
        ASSERT_EQ(other.hit[k], plain.hit[k]);
        ASSERT_EQ(other.steepest[k], plain.steepest[k]);
      });
    }
  }
  EXPECT_GT(hits, 300);
}

}  // namespace
}  // namespace verisim::shapes
