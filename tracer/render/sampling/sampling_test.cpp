// Jitter, lens positions, cameras and anti-aliasing against the numbers of spec 02.
#include <gtest/gtest.h>

#include <numbers>

#include "tracer/image/output.h"
#include "tracer/render/sampling/adaptive_sampling.h"
#include "tracer/render/sampling/antialias.h"
#include "tracer/render/cameras/camera_rays.h"
#include "tracer/render/sampling/focal_blur.h"
#include "tracer/render/sampling/jitter.h"

namespace verisim::render {
namespace {

TEST(Jitter, PermutationStartsAsInTheSpecification) {
  const int expected[] = {2291, 2574, 3654, 1557, 1196, 3388, 2637, 1820};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(permutation()[i], expected[i]);
}

TEST(Jitter, CheckValues) {
  const auto near = [](double x, double y, double a, double b) {
    const Vec2 j = jitter2(x, y);
    EXPECT_EQ(j.x, static_cast<float>(a))
        << x << ' ' << y;  // the table is of single precision: seen in the far checks of lens rays
    EXPECT_EQ(j.y, static_cast<float>(b)) << x << ' ' << y;
  };
  near(0, 0, 0.084015, 0.084015);
  near(1.5, 2.25, -0.306641, -0.197235);
  near(100.25, 60.75, 0.394562, 0.246124);
  near(-1.0 / 3, 5, -0.417938, -0.173798);
}

TEST(FocalBlur, LensPositionsLieOnTheLensAndDiffer) {
  for (int n : {1, 4, 7, 8, 19, 30, 37, 50, 200}) {
    scene::Camera camera;
    camera.aperture = 1, camera.blur_samples = n;
    const FocalBlur blur(camera, nullptr);
    ASSERT_EQ(blur.positions().size(), static_cast<std::size_t>(n));
    for (const Vec2& p : blur.positions()) EXPECT_LE(p.x * p.x + p.y * p.y, 0.2501);
    EXPECT_NEAR(blur.lens_jitter(),
                n == 7    ? 0.144338
                : n == 19 ? 0.096225
                : n == 37 ? 0.0721688
                          : 0.5 / std::sqrt(n),
                1e-12);
  }
}

// Rays that are made together are those that are made alone, bit by bit: in a window of a picture, for any number.
TEST(FocalBlur, RaysTogetherAreThoseAlone) {
  scene::Camera camera;
  camera.location = {1.3, -0.7, 2.9}, camera.direction = {0.3, 0.1, 1.1};
  camera.right = {1.2, 0.05, -0.3}, camera.up = {-0.1, 0.9, 0.02};
  camera.aperture = 0.8, camera.focal_distance = 7.3, camera.blur_samples = 50;
  const FocalBlur blur(camera, nullptr);
  for (const WindowPlace window : {WindowPlace{}, WindowPlace{31, 17}}) {
    for (const scene::CameraKind kind : {scene::CameraKind::perspective, scene::CameraKind::orthographic}) {
      camera.kind = kind;
      const CameraRays rays(camera, 160, 120, window);
      for (int count : {1, 7, 8, 61, RayBatch::kMax}) {
        std::vector<Vec2> places;
        std::vector<std::uint32_t> numbers;
        for (int i = 0; i < count; ++i)
          places.emplace_back(3.25 * i + 0.1, 2 * i + 1), numbers.push_back(static_cast<std::uint32_t>(i * 7 % 50));
        const auto together = std::make_unique<RayBatch>();
        blur.rays(rays, places.data(), numbers.data(), count, *together);
        for (int i = 0; i < count; ++i) {
          const Ray alone = blur.ray(rays, places[i].x, places[i].y, static_cast<int>(numbers[i]))->ray;
          EXPECT_EQ(together->at(i).origin, alone.origin) << i;
          EXPECT_EQ(together->at(i).direction, alone.direction) << i;
        }
      }
    }
  }
}

// Spec 02 probe P1: the sky maps direction component c to 3 * (c + 1.1) / 2.2 / 3, written linear in 8 bits.
struct CameraCase {
  const char* name;
  scene::Camera camera;
  std::array<std::array<int, 3>, 4> expected;  // pixels (0,0) (11,2) (5,5) (15,11) of 16x12
};
class CameraProbe : public testing::TestWithParam<CameraCase> {};

TEST_P(CameraProbe, DirectionsOfTheTable) {
  const int pixels[4][2] = {{0, 0}, {11, 2}, {5, 5}, {15, 11}};
  const CameraRays camera(GetParam().camera, 16, 12);
  for (int i = 0; i < 4; ++i) {
    const auto ray = camera.at(pixels[i][0], pixels[i][1]);
    std::array<int, 3> got{0, 0, 0};
    if (ray) {
      const Vec3 d = normalize(ray->ray.direction);
      for (int c = 0; c < 3; ++c) got[c] = static_cast<int>(std::floor((d[c] + 1.1) / 2.2 * 255 + 0.5));
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], GetParam().expected[i][c], 0) << "pixel " << i << " channel " << c;
  }
}

scene::Camera of(scene::CameraKind kind) {
  scene::Camera c;
  c.kind = kind;
  return c;
}
scene::Camera small_fisheye() {
  scene::Camera c = of(scene::CameraKind::fisheye);
  c.right = {.5, 0, 0}, c.up = {0, .5, 0}, c.angle = 180;
  return c;
}
scene::Camera narrow_spherical() {
  scene::Camera c = of(scene::CameraKind::spherical);
  c.horizontal_angle = 200, c.vertical_angle = 100;
  return c;
}
using K = scene::CameraKind;
INSTANTIATE_TEST_SUITE_P(
    P1, CameraProbe,
    testing::Values(
        CameraCase{"perspective", {}, {{{70, 170, 219}, {159, 159, 235}, {104, 132, 241}, {185, 85, 219}}}},
        CameraCase{"fisheye", of(K::fisheye), {{{0, 0, 0}, {177, 177, 220}, {90, 135, 237}, {0, 0, 0}}}},
        CameraCase{
            "small_fisheye", small_fisheye(), {{{56, 197, 187}, {165, 178, 225}, {99, 135, 240}, {199, 58, 187}}}},
        CameraCase{
            "ultra_wide", of(K::ultra_wide_angle), {{{54, 184, 197}, {166, 166, 230}, {99, 133, 240}, {201, 71, 197}}}},
        CameraCase{"omnimax", of(K::omnimax), {{{0, 0, 0}, {187, 217, 171}, {78, 171, 223}, {0, 0, 0}}}},
        CameraCase{"panoramic", of(K::panoramic), {{{108, 242, 129}, {184, 215, 179}, {61, 141, 221}, {147, 13, 129}}}},
        CameraCase{"cylinder1", of(K::cylinder1), {{{57, 176, 206}, {165, 160, 232}, {99, 132, 240}, {198, 79, 206}}}},
        CameraCase{"cylinder2", of(K::cylinder2), {{{66, 192, 201}, {160, 177, 227}, {104, 135, 241}, {189, 63, 201}}}},
        CameraCase{"cylinder3", of(K::cylinder3), {{{50, 128, 213}, {167, 128, 237}, {99, 128, 240}, {205, 128, 213}}}},
        CameraCase{
            "cylinder4", of(K::cylinder4), {{{128, 204, 215}, {128, 179, 231}, {128, 135, 243}, {128, 51, 215}}}},
        CameraCase{"spherical", of(K::spherical), {{{125, 242, 113}, {197, 219, 141}, {32, 143, 191}, {130, 13, 113}}}},
        CameraCase{"narrow_spherical",
                   narrow_spherical(),
                   {{{47, 211, 122}, {197, 184, 201}, {68, 136, 226}, {208, 44, 122}}}}),
    [](const auto& i) { return std::string(i.param.name); });

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
  for (const Color& c : frame.pixels) sum += (c.r - 0.1) / 0.8;
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
