// Anti-aliasing against the numbers of spec 02.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tracer/image/gamma.h"
#include "tracer/image/output.h"
#include "tracer/render/cameras/camera_rays.h"
#include "tracer/render/sampling/antialias.h"
#include "tracer/render/sampling/jitter.h"

namespace verisim::render {
namespace {

// Spec 02 probe P4: a sky whose colour is a function of the direction; 24x20, row 6, red, linear 8 bits.
struct AntialiasCase {
  const char* name;
  bool antialias;
  float threshold;
  int depth, method, block;
  bool jitter;
  std::vector<int> row;
};
class AntialiasProbe : public testing::TestWithParam<AntialiasCase> {};

TEST_P(AntialiasProbe, RowOfTheTable) {
  const AntialiasCase& p = GetParam();
  scene::Camera camera;
  camera.right = {1.5, 0, 0};
  const CameraRays rays(camera, 24, 20);
  auto sample = [&](double x, double y) -> Color {
    const Vec3 d = normalize(rays.at(x, y)->ray.direction);
    const double s = d.x * d.x + d.y * d.y - 0.1 * d.z * d.z;
    const auto v = static_cast<float>((s < 0 ? 0.9 : 0.0) + (s < 0    ? 0.0
                                                             : s == 0 ? 0.0
                                                                      : 0.25 + 0.5 * (d.x / d.z) * (d.x / d.z)));
    return {v, v * 0.8f, v * 0.6f};
  };
  Options options;
  options.antialias = p.antialias, options.antialias_threshold = p.threshold, options.antialias_depth = p.depth,
  options.sampling_method = p.method;
  options.jitter = p.jitter;
  const AntialiasSettings settings = antialias_settings(options, scene::Gamma::power, 1);
  Framebuffer frame{24, 20, std::vector<Color>(24 * 20), {}};
  AdaptiveGrid grid(settings, sample);
  RecursiveQuads quads(settings, sample);
  for (int y = 0; y < 20; y += p.block) {
    for (int x = 0; x < 24; x += p.block) {
      const Block block{x, y, std::min(p.block, 24 - x), std::min(p.block, 20 - y)};
      if (!p.antialias) {
        render_plain(block, sample, frame);
      } else if (p.method == 1) {
        grid.render(block, frame);
      } else {
        quads.render(block, frame);
      }
    }
  }
  image::OutputOptions linear;
  linear.file_srgb = false;
  const image::Quantised q = image::quantise(frame, linear);
  for (int x = 0; x < 24; ++x) EXPECT_EQ(q.samples[3 * (6 * 24 + x)], p.row[x]) << "column " << x;
}
using Row = std::vector<int>;
INSTANTIATE_TEST_SUITE_P(P4, AntialiasProbe,
                         testing::Values(AntialiasCase{"off", false, .3f, 3, 1, 24, true,
                                                       Row{130, 119, 109, 100, 92, 85, 79, 74, 230, 230, 230, 230,
                                                           230, 230, 230, 230, 74, 79, 85, 92, 100, 109, 119, 130}},
                                         AntialiasCase{"method1", true, .3f, 3, 1, 24, true,
                                                       Row{130, 119, 109, 100, 92,  85, 79, 90, 230, 230, 230, 230,
                                                           230, 230, 230, 230, 121, 79, 85, 92, 100, 109, 119, 130}},
                                         AntialiasCase{"no_jitter", true, .3f, 3, 1, 24, false,
                                                       Row{130, 119, 109, 100, 92,  85, 79, 105, 230, 230, 230, 230,
                                                           230, 230, 230, 230, 105, 79, 85, 92,  100, 109, 119, 130}},
                                         AntialiasCase{"depth4", true, .1f, 4, 1, 24, true,
                                                       Row{130, 119, 109, 100, 92,  85, 79, 111, 229, 230, 230, 230,
                                                           230, 230, 230, 229, 111, 79, 85, 92,  100, 109, 119, 130}},
                                         AntialiasCase{"blocks8", true, .05f, 3, 1, 8, true,
                                                       Row{130, 118, 109, 100, 92,  85, 79, 90, 230, 230, 230, 230,
                                                           230, 230, 230, 230, 121, 79, 85, 92, 100, 108, 119, 129}},
                                         AntialiasCase{"method2", true, .3f, 3, 2, 24, true,
                                                       Row{130, 119, 109, 100, 92,  85, 79, 106, 227, 230, 230, 230,
                                                           230, 230, 230, 227, 106, 79, 85, 92,  100, 109, 119, 130}},
                                         AntialiasCase{"method2_depth1", true, .1f, 1, 2, 24, true,
                                                       Row{130, 119, 109, 100, 92,  85, 79, 113, 190, 230, 230, 230,
                                                           230, 230, 230, 190, 113, 79, 85, 92,  100, 109, 119, 130}}),
                         [](const auto& i) { return std::string(i.param.name); });

TEST(Antialias, ThresholdZeroSupersamplesEverything) {
  Options options;
  options.antialias_threshold = 0;
  int calls = 0;
  auto sample = [&](double, double) -> Color {
    ++calls;
    return {1, 1, 1};
  };
  AdaptiveGrid grid(antialias_settings(options, scene::Gamma::power, 1), sample);
  Framebuffer frame{4, 4, std::vector<Color>(16), {}};
  grid.render({0, 0, 4, 4}, frame);
  EXPECT_EQ(calls, 24 + 16 * 9);
}

// A picture of edges and noise, whose samples are taken one by one or many at a time.
struct Speckled {
  bool together;
  std::vector<std::pair<double, double>> asked{};
  bool any_order() const { return together; }
  Color operator()(double x, double y) {
    asked.emplace_back(x, y);
    const double v =
        0.5 + 0.2 * std::sin(0.3 * x) + 0.2 * std::sin(0.4 * y) + (std::sin(12.9898 * x + 78.233 * y) > 0.95 ? 0.3 : 0);
    return {static_cast<float>(v), static_cast<float>(v * v), 0.5f};
  }
};

TEST(AdaptiveGrid, PixelsThatDoNotWaitForEachOtherAreSupersampledTogether) {
  Options options;
  options.antialias_threshold = 0.25f;
  for (const Block& block : {Block{0, 0, 24, 20}, Block{5, 7, 1, 9}, Block{0, 0, 13, 1}, Block{2, 1, 3, 17}}) {
    Speckled one_by_one{false}, together{true};
    Framebuffer expected{24, 20, std::vector<Color>(24 * 20), {}}, frame = expected;
    const AntialiasSettings settings = antialias_settings(options, scene::Gamma::power, 1);
    AdaptiveGrid(settings, one_by_one).render(block, expected);
    AdaptiveGrid(settings, together).render(block, frame);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 24; ++x) ASSERT_EQ(frame.at(x, y), expected.at(x, y)) << x << ' ' << y;
    std::sort(one_by_one.asked.begin(), one_by_one.asked.end()),
        std::sort(together.asked.begin(), together.asked.end());
    EXPECT_EQ(together.asked, one_by_one.asked);
    const auto plain = static_cast<std::size_t>((block.width + 1) * (block.height + 1) - 1),
               all = plain + static_cast<std::size_t>(9 * block.width * block.height);
    EXPECT_GT(together.asked.size(), plain);
    EXPECT_LT(together.asked.size(), all);
  }
}

// The sum of differences between encoded channels, as spec 02 3.3 has it.
bool differ_by_definition(const Color& a, const Color& b, const AntialiasSettings& s) {
  const auto encode = [&s](float v) {
    if (s.identity) return v;
    return std::pow(std::fmax(s.decode_srgb ? image::srgb_decode(v) : v, 0.0f), s.exponent);
  };
  return std::fabs(encode(a.r) - encode(b.r)) + std::fabs(encode(a.g) - encode(b.g)) +
             std::fabs(encode(a.b) - encode(b.b)) + std::fabs(a.t - b.t) >=
         s.threshold;
}

TEST(SampleComparison, DecidesByTheEncodedColours) {
  std::mt19937 random(7);
  const float odd[] = {0, -0.0f, -1, 1e-6f, 2, 1e30f, std::numeric_limits<float>::infinity(), std::nanf("")};
  const auto channel = [&] {
    std::uniform_real_distribution<float> exponent(-18, 3);
    return random() % 16 == 0 ? odd[random() % std::size(odd)] : std::exp2(exponent(random));
  };
  for (const auto& [gamma, working, threshold] : {std::tuple(0.0f, scene::Gamma::power, 0.3f),
                                                  {2.5f, scene::Gamma::power, 0.3f},
                                                  {2.5f, scene::Gamma::srgb, 0.1f},
                                                  {0.2f, scene::Gamma::power, 0.02f},
                                                  {9.0f, scene::Gamma::power, 0.0f}}) {
    Options options;
    options.antialias_gamma = gamma, options.antialias_threshold = threshold;
    const AntialiasSettings settings = antialias_settings(options, working, 1);
    const SampleComparison comparison(settings);
    int differ = 0;
    for (int i = 0; i < 20000; ++i) {
      const Color a(channel(), channel(), channel(), 0, 0.1f);
      Color b = a;
      // As far from it in one channel as the threshold is, to the last bits.
      const float encoded = settings.identity ? a.g : std::pow(std::fmax(a.g, 0.0f), settings.exponent) + threshold;
      b.g = settings.identity ? a.g + threshold : std::pow(encoded, 1 / settings.exponent);
      for (int k = static_cast<int>(random() % 9); k > 0; --k) b.g = std::nextafter(b.g, random() % 2 ? 9.0f : 0.0f);
      if (i % 4 == 0) b = {channel(), channel(), channel(), 0, 0.3f};
      const bool expected = differ_by_definition(a, b, settings);
      ASSERT_EQ(comparison.differ(comparison.sample(a), comparison.sample(b)), expected)
          << a.r << ' ' << a.g << ' ' << a.b << ", " << b.r << ' ' << b.g << ' ' << b.b << ", gamma " << gamma;
      differ += expected;
    }
    EXPECT_GT(differ, 2000);
    EXPECT_LT(differ, threshold > 0 ? 18000 : 20001);
  }
}

}  // namespace
}  // namespace verisim::render
