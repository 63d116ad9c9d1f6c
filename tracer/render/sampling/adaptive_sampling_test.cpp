// Adaptive sampling: points that are stratified, errors for the samples taken, details that are found.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tracer/render/sampling/adaptive_sampling.h"
#include "tracer/render/sampling/antialias.h"

namespace verisim::render {
namespace {

TEST(LowDiscrepancy, EveryPowerOfTwoIsStratifiedInAllElementaryIntervals) {
  for (const std::uint64_t seed : {0u, 1u, 77u}) {
    const LowDiscrepancy points(3, -5, seed);
    for (int k = 1; k <= 8; ++k) {
      const int n = 1 << k;
      for (int a = 0; a <= k; ++a) {  // 2^a columns, 2^(k-a) rows: one point in each
        std::vector<int> count(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) {
          const Vec2 p = points(static_cast<std::uint32_t>(i));
          ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1);
          ++count[static_cast<std::size_t>(static_cast<int>(p.x * (1 << a)) +
                                           (static_cast<int>(p.y * (1 << (k - a))) << a))];
        }
        for (const int c : count) ASSERT_EQ(c, 1) << "k " << k << " a " << a;
      }
    }
  }
}

// A half plane of white in front of black, whose coverage of every pixel is known by brute force.
struct HalfPlane {
  double nx, ny, d;
  std::size_t samples = 0;
  Color operator()(double x, double y) {
    ++samples;
    const float v = nx * x + ny * y > d ? 1.0f : 0.0f;
    return {v, v, v, 0, 0};
  }
};

struct Sampled {
  double rms = 0;
  std::size_t samples = 0;
};
template <class Method>
Sampled edge_error(Method method) {
  constexpr int kSize = 32;
  Sampled result;
  double squares = 0;
  int pixels = 0;
  for (int turn = 0; turn < 12; ++turn) {
    const double angle = 0.13 + turn * 0.5;
    HalfPlane edge{std::cos(angle), std::sin(angle), 16 * std::cos(angle) + 16 * std::sin(angle) + 0.07 * turn};
    Framebuffer frame;
    frame.width = frame.height = kSize;
    frame.pixels.assign(kSize * kSize, Color());
    method(edge, frame);
    result.samples += edge.samples;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        HalfPlane exact = edge;
        double coverage = 0;
        for (int j = 0; j < 32; ++j)
          for (int i = 0; i < 32; ++i) coverage += exact(x + (i + 0.5) / 32 - 0.5, y + (j + 0.5) / 32 - 0.5).r / 1024;
        const double error = frame.at(x, y).r - coverage;
        if (coverage > 0 && coverage < 1) squares += error * error, ++pixels;
      }
    }
  }
  result.rms = std::sqrt(squares / pixels);
  return result;
}

Sampled adaptive_edge(float tolerance) {
  return edge_error([&](HalfPlane& edge, Framebuffer& frame) {
    AdaptiveSettings settings;
    settings.tolerance = tolerance;
    settings.encoded = true;
    AdaptiveSampling<HalfPlane>(settings, frame.width, frame.height, edge)
        .render({0, 0, frame.width, frame.height}, frame);
  });
}

TEST(AdaptiveSampling, TheErrorOfEdgesFollowsTheTolerance) {
  const Sampled coarse = adaptive_edge(0.05f), fine = adaptive_edge(0.02f);
  EXPECT_LT(coarse.rms, 1.6 * 0.05);
  EXPECT_LT(fine.rms, 1.6 * 0.02);
  EXPECT_LT(fine.rms, coarse.rms);
  EXPECT_GT(fine.samples, coarse.samples);
}

// A floor of squares up to the horizon: edges of moderate contrast, then detail finer than a pixel.
struct Floor {
  double scale = 1;
  std::size_t samples = 0;
  Color operator()(double x, double y) {
    ++samples;
    x /= scale, y /= scale;
    if (y < 6) return {0.3f, 0.4f, 0.6f, 0, 0};
    const double distance = 30 / (y - 5.9), u = (x - 15.3) * distance / 20;
    const float v = (static_cast<int>(std::floor(u)) + static_cast<int>(std::floor(distance))) % 2 ? 0.55f : 0.15f;
    return {v, v, 0.8f * v, 0, 0};
  }
};

struct AgainstMethodTwo {
  int depth;
  float threshold, tolerance;
  int size;  // of the picture, which shows the same
};
class AgainstQuads : public testing::TestWithParam<AgainstMethodTwo> {};

TEST_P(AgainstQuads, HalfTheSamplesForLessError) {
  const int size = GetParam().size;
  const auto error = [&](auto method) {
    Floor floor{size / 32.0};
    Framebuffer frame;
    frame.width = frame.height = size;
    frame.pixels.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), Color());
    method(floor, frame);
    Sampled result{0, floor.samples};
    double squares = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        double exact = 0;
        for (int j = 0; j < 32; ++j)
          for (int i = 0; i < 32; ++i) exact += floor(x + (i + 0.5) / 32 - 0.5, y + (j + 0.5) / 32 - 0.5).r / 1024;
        squares += (frame.at(x, y).r - exact) * (frame.at(x, y).r - exact);
      }
    }
    result.rms = std::sqrt(squares / (size * size));
    return result;
  };
  AntialiasSettings settings;
  settings.method = 2, settings.depth = GetParam().depth, settings.threshold = GetParam().threshold;
  const Sampled quads = error([&](Floor& floor, Framebuffer& frame) {
    RecursiveQuads<Floor>(settings, floor).render({0, 0, size, size}, frame);
  });
  const Sampled adaptive = error([&](Floor& floor, Framebuffer& frame) {
    AdaptiveSettings how;
    how.encoded = true;
    how.tolerance = GetParam().tolerance;
    AdaptiveSampling<Floor>(how, size, size, floor).render({0, 0, size, size}, frame);
  });
  EXPECT_LT(adaptive.rms, quads.rms) << adaptive.samples << " and " << quads.samples << " samples";
  EXPECT_LT(2 * adaptive.samples, quads.samples) << adaptive.rms << " and " << quads.rms;
}
INSTANTIATE_TEST_SUITE_P(AdaptiveSampling, AgainstQuads,
                         testing::Values(AgainstMethodTwo{3, 0.3f, 0.05f, 128}, AgainstMethodTwo{4, 0.1f, 0.025f, 32}),
                         [](const auto& i) { return i.param.depth == 3 ? "defaults" : "fine"; });

// A picture of `size` pixels a side in blocks, the last one first if `backwards`.
template <class Picture>
Framebuffer sampled(Picture& picture, int size, float tolerance, int block_size = 64, bool backwards = false) {
  Framebuffer frame;
  frame.width = frame.height = size;
  frame.pixels.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), Color());
  AdaptiveSettings settings;
  settings.encoded = true;
  settings.tolerance = tolerance;
  std::vector<Block> blocks;
  for (int y = 0; y < size; y += block_size)
    for (int x = 0; x < size; x += block_size)
      blocks.push_back({x, y, std::min(block_size, size - x), std::min(block_size, size - y)});
  if (backwards) std::reverse(blocks.begin(), blocks.end());
  AdaptiveSampling<Picture> sampling(settings, size, size, picture);
  for (const Block& block : blocks) sampling.render(block, frame);
  return frame;
}

TEST(AdaptiveSampling, RampsAndFlatsTakeHalfASampleAPixel) {
  std::size_t samples = 0;
  auto ramp = [&](double x, double y) {
    ++samples;
    const float v = static_cast<float>(0.2 + 0.01 * x + 0.005 * y);
    return Color(v, v, 0.3f, 0, 0);
  };
  const Framebuffer frame = sampled(ramp, 32, 0.015f);
  EXPECT_LE(samples, 32u * 32u / 2 + 4);
  for (int y = 1; y < 31; ++y)
    for (int x = 1; x < 31; ++x) EXPECT_NEAR(frame.at(x, y).r, 0.2 + 0.01 * x + 0.005 * y, 1e-5);
  samples = 0;
  sampled(ramp, 32, 0.005f);
  EXPECT_EQ(samples, 32u * 32u) << "a fine tolerance traces every centre";
}

struct Dot {
  double x, y, radius;
  Color operator()(double at_x, double at_y) const {
    const float v = std::hypot(at_x - x, at_y - y) < radius ? 0.9f : 0.1f;
    return {v, v, v, 0, 0};
  }
};
double light(const Framebuffer& frame) {
  double sum = 0;
  for (const PixelColor& c : frame.pixels) sum += (c.r - 0.1) / 0.8;
  return sum;
}

TEST(AdaptiveSampling, DotsTwoPixelsWideAreFoundAndFollowedWhereverTheyAre) {
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      Dot dot{15 + i / 8.0 + 0.06, 16 + j / 8.0 + 0.03, 1.05};
      EXPECT_NEAR(light(sampled(dot, 32, 0.015f)), std::numbers::pi * 1.05 * 1.05, 0.7) << i << ' ' << j;
    }
  }
}

TEST(AdaptiveSampling, SmallerDotsMayHideBetweenTheFirstCentres) {
  Dot between{16, 17, 0.9}, on{16, 16, 0.9};
  EXPECT_NEAR(light(sampled(between, 32, 0.015f)), 0, 1e-4);
  EXPECT_NEAR(light(sampled(on, 32, 0.015f)), std::numbers::pi * 0.81, 0.7);
  EXPECT_NEAR(light(sampled(between, 32, 0.005f)), std::numbers::pi * 0.81, 0.5) << "not with a fine tolerance";
}

TEST(AdaptiveSampling, StraightLinesOfOnePixelDoNotHide) {
  for (int i = 0; i < 16; ++i) {
    auto line = [&](double x, double) {
      const float v = std::fabs(x - 15 - i / 8.0) < 0.52 ? 0.9f : 0.1f;
      return Color(v, v, v, 0, 0);
    };
    EXPECT_NEAR(light(sampled(line, 32, 0.015f)) / 32, 1.04, 0.15) << i;
  }
}

// Discs of many sizes on a ramp: smooth regions, curved edges and where they meet.
struct Discs {
  std::size_t samples = 0;
  Color operator()(double x, double y) {
    ++samples;
    float v = static_cast<float>(0.15 + 0.002 * x + 0.001 * y);
    for (int i = 0; i < 12; ++i)
      if (std::hypot(x - (i * 37 % 96), y - (i * 59 % 96)) < 10 + 2 * i) v = 0.3f + 0.05f * static_cast<float>(i);
    return {v, 0.8f * v, 0.5f, 0, 0};
  }
};

TEST(AdaptiveSampling, BlocksDoNotDependOnWhatWasRenderedBefore) {
  Discs discs;
  const Framebuffer forwards = sampled(discs, 96, 0.02f, 32), backwards = sampled(discs, 96, 0.02f, 32, true);
  for (std::size_t i = 0; i < forwards.pixels.size(); ++i) ASSERT_EQ(forwards.pixels[i], backwards.pixels[i]) << i;
}

TEST(AdaptiveSampling, FollowsAThinLineBeyondWhereCentresShowIt) {
  // Centres meet it in the first 15 columns only.
  auto line = [](double x, double y) {
    const float v = std::fabs(y - 8 - 0.02 * x) < 0.3 ? 1.0f : 0.0f;
    return Color(v, v, v, 0, 0);
  };
  Framebuffer frame;
  frame.width = 25, frame.height = 16;
  frame.pixels.assign(25 * 16, Color());
  AdaptiveSettings settings;
  settings.encoded = true;
  AdaptiveSampling<decltype(line)>(settings, 25, 16, line).render({0, 0, 25, 16}, frame);
  for (int x = 0; x < 25; ++x) {
    float column = 0;
    for (int y = 0; y < 16; ++y) column += frame.at(x, y).r;
    EXPECT_NEAR(column, 0.6, 0.2) << x;
  }
}

}  // namespace
}  // namespace verisim::render
