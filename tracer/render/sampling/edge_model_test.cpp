// The half-planes that samples allow, against brute force.
#include "tracer/render/sampling/edge_model.h"

#include <gtest/gtest.h>

#include <random>

namespace verisim::render {
namespace {

double brute_force_coverage(double nx, double ny, double d) {
  constexpr int kSide = 400;
  int inside = 0;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) inside += nx * ((i + 0.5) / kSide - 0.5) + ny * ((j + 0.5) / kSide - 0.5) < d;
  return static_cast<double>(inside) / (kSide * kSide);
}

float coverage(float nx, float ny, float d) {
  const float x[4] = {nx, -ny, 1, 0.6f}, y[4] = {ny, nx, 0, 0.8f};
  alignas(16) float lanes[4];
  HalfPlanes(x, y).coverage(Float4(d)).store(lanes);
  return lanes[0];
}

TEST(EdgeModel, CoverageIsExact) {
  for (int turn = 0; turn < 16; ++turn) {
    const double angle = turn * std::numbers::pi / 8;  // straight ones and diagonals among them
    const double nx = std::cos(angle), ny = std::sin(angle);
    for (double d = -0.8; d < 0.81; d += 0.0973)
      EXPECT_NEAR(coverage(static_cast<float>(nx), static_cast<float>(ny), static_cast<float>(d)),
                  brute_force_coverage(nx, ny, d), 0.004)
          << angle << ' ' << d;
  }
}

struct Truth {
  float nx, ny, d;
  bool second(float x, float y) const { return nx * x + ny * y > d; }
};

TEST(EdgeModel, SamplesInTheMiddleOfWhatIsPossibleFindTheEdge) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  double squares[5] = {};
  int edges = 0, beyond = 0;
  for (; edges < 500; ++edges) {
    const float angle = 6.2832f * unit(random);
    const Truth truth{std::cos(angle), std::sin(angle), unit(random) - 0.5f};
    unsigned bits = 0;
    for (int k = 0; k < 9; ++k)
      bits |= static_cast<unsigned>(truth.second(static_cast<float>(k % 3 - 1), static_cast<float>(k / 3 - 1))) << k;
    EdgeModel model = EdgeModel::of_centres(bits).model;
    const float covered = 1 - coverage(truth.nx, truth.ny, truth.d);
    for (int taken = 0; taken < 5; ++taken) {
      const EdgeModel::Estimate e = model.estimate();
      ASSERT_TRUE(e.possible) << angle << ' ' << truth.d << " after " << taken;
      const double error = e.coverage - covered;
      squares[taken] += error * error;
      beyond += std::fabs(error) > 3 * e.deviation + 0.02;
      const float along = unit(random) - 0.5f;
      const float x = std::clamp(e.nx * e.d - e.ny * along, -0.5f, 0.5f),
                  y = std::clamp(e.ny * e.d + e.nx * along, -0.5f, 0.5f);
      model.add(x, y, truth.second(x, y));
    }
  }
  for (double& s : squares) s = std::sqrt(s / edges);
  EXPECT_LT(squares[0], 0.16);
  EXPECT_LT(squares[2], 0.07);
  EXPECT_LT(squares[4], 0.04);
  EXPECT_LT(beyond, 5 * edges / 50) << "the deviation is honest";
}

TEST(EdgeModel, NoEdgePartsALineADotOrAChequer) {
  EXPECT_FALSE(EdgeModel::of_centres(0b000'111'000).estimate.possible);
  EXPECT_FALSE(EdgeModel::of_centres(0b000'010'000).estimate.possible);
  EXPECT_FALSE(EdgeModel::of_centres(0b101'010'101).estimate.possible);
  EXPECT_FALSE(EdgeModel::of_centres(0b001'000'100).estimate.possible);
  EXPECT_TRUE(EdgeModel::of_centres(0b000'000'111).estimate.possible);
  EXPECT_TRUE(EdgeModel::of_centres(0b000'000'001).estimate.possible);
  EdgeModel model = EdgeModel::of_centres(0b000'000'111).model;
  model.add(0.1f, 0.3f, true);  // a dark speck beyond the edge
  EXPECT_FALSE(model.estimate().possible);
}

}  // namespace
}  // namespace verisim::render
