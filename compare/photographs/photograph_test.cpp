// Photographs with known answers, made by ImageMagick: perspective, lens distortion, vignetting, noise, JPEG.
#include "compare/photographs/photograph.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/metrics/test_pictures.h"
#include "compare/metrics/values.h"
#include "compare/oracle/process.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace fs = std::filesystem;
namespace {

constexpr int kPhotographWidth = 160, kPhotographHeight = 120;
// Where the picture's corners are in a photograph of 640x480.
constexpr Corners kCorners{{{90, 60}, {560, 100}, {520, 420}, {120, 390}}};

// Boxes and discs of several greys and colours on a slope.
Picture render() {
  Picture p;
  p.width = kPhotographWidth, p.height = kPhotographHeight, p.channels = 3, p.bits = 8;
  for (int y = 0; y < kPhotographHeight; ++y)
    for (int x = 0; x < kPhotographWidth; ++x) {
      const double slope = 0.3 + 0.3 * x / kPhotographWidth;
      Rgb v{slope, slope * 0.9, slope * 0.8};
      if (x > 30 && x < 70 && y > 25 && y < 80) v = {0.7, 0.2, 0.15};
      if (std::hypot(x - 110, y - 70) < 25) v = {0.2, 0.6, 0.3};
      // Something near every corner, which otherwise nothing would hold.
      if (x > 6 && x < 24 && y > 90 && y < 112) v = {0.75, 0.75, 0.7};
      if (x > 130 && x < 152 && y > 5 && y < 22) v = {0.1, 0.15, 0.4};
      if (x > 6 && x < 20 && y > 6 && y < 18) v = {0.65, 0.6, 0.2};
      if (x > 136 && x < 154 && y > 98 && y < 114) v = {0.15, 0.12, 0.1};
      for (const double c : v) p.samples.push_back(static_cast<float>(std::round(255 * c) / 255));
    }
  return p;
}

class Photographs : public testing::Test {
 protected:
  void SetUp() override {
    program_ = find_program("convert");
    if (!is_image_magick()) GTEST_SKIP() << "ImageMagick is not installed";
    image::write_picture(render(), path("render.png"));
  }
  fs::path path(const char* name) const { return folder_.path() / name; }
  // Other programs have that name, too.
  bool is_image_magick() const {
    if (program_.empty()) return false;
    const ProcessResult run =
        run_process({{program_.string(), "-version"}, folder_.path(), {{"PATH", "/usr/bin:/bin"}}, 60, nullptr});
    return run.succeeded() && run.out.find("Version: ImageMagick") != std::string::npos;
  }

  // The render, drawn with its corners at kCorners on grey, and what else is asked for.
  Picture photograph(const std::vector<std::string>& rest, const char* name = "photo.png") {
    std::vector<std::string> words{program_.string(),
                                   path("render.png").string(),
                                   "-set",
                                   "colorspace",
                                   "sRGB",
                                   "-scale",
                                   "800%",
                                   "-virtual-pixel",
                                   "gray",
                                   "-define",
                                   "distort:viewport=640x480+0+0",
                                   "-distort",
                                   "Perspective"};
    const double from[4][2] = {
        {0, 0}, {8 * kPhotographWidth, 0}, {8 * kPhotographWidth, 8 * kPhotographHeight}, {0, 8 * kPhotographHeight}};
    std::string points;
    for (std::size_t i = 0; i < 4; ++i)
      points += fmt::format("{},{} {},{} ", from[i][0], from[i][1], kCorners[i].x, kCorners[i].y);
    words.push_back(points);
    words.insert(words.end(), rest.begin(), rest.end());
    words.push_back(path(name).string());
    const ProcessResult run = run_process({words, folder_.path(), {{"PATH", "/usr/bin:/bin"}}, 60, nullptr});
    EXPECT_TRUE(run.succeeded()) << run.err;
    return image::read_picture(path(name));
  }
  static Corners about() {
    Corners c = kCorners;
    for (std::size_t i = 0; i < 4; ++i) c[i].x += i % 2 ? 4 : -3, c[i].y += i < 2 ? 3 : -4;
    return c;
  }
  static double worst_corner(const Alignment& a) {
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i)
      worst = std::max(worst, std::hypot(a.corners[i].x - kCorners[i].x, a.corners[i].y - kCorners[i].y));
    return worst;
  }

  TemporaryFolder folder_;
  fs::path program_;
};

TEST_F(Photographs, CornersAreRefined) {
  const Alignment a = align(photograph({}), render(), about(), false);
  EXPECT_LT(worst_corner(a), 0.6);
  EXPECT_LT(a.corner_errors[0].x, 0.5);
}

TEST_F(Photographs, NoiseAndJpegDoNotMoveThem) {
  const Alignment a = align(photograph({"-attenuate", "0.4", "+noise", "Gaussian", "-quality", "85"}, "photo.jpg"),
                            render(), about(), false);
  EXPECT_LT(worst_corner(a), 0.8);
}

// ImageMagick's barrel takes a pixel's colour from r (1 + b r^2), r in units of half the shorter side; the same curve
// the other way round begins with 1 - b r^2.
TEST_F(Photographs, RadialDistortionIsFound) {
  const Picture photo = photograph({"-distort", "Barrel", "0 0.03 0 1"});
  const double half_diagonal = std::hypot(320, 240), unit = 240;
  const Alignment a = align(photo, render(), about(), true);
  const double expected = -0.03 * (half_diagonal / unit) * (half_diagonal / unit);
  EXPECT_NEAR(a.distortion, expected, 0.25 * -expected);
  const FittedPair fitted = fit_to_reference(photo, render(),
                                             {.crop = {},
                                              .corners = about(),
                                              .distortion = true,
                                              .vignetting = false,
                                              .exposure = true,
                                              .white_balance = false});
  const FittedPair plain = fit_to_reference(photo, render(),
                                            {.crop = {},
                                             .corners = about(),
                                             .distortion = false,
                                             .vignetting = false,
                                             .exposure = true,
                                             .white_balance = false});
  EXPECT_LT(measure(fitted.reference, fitted.test).rmse, 0.6 * measure(plain.reference, plain.test).rmse);
  EXPECT_NEAR(fitted.fit.stops, 0, 0.02);
  EXPECT_THAT(fitted.fit.text(), testing::HasSubstr("radial distortion"));
}

TEST_F(Photographs, FallOffExposureAndWhiteBalanceAreFoundTogether) {
  // 1 - 0.4 r^2 of the light, r in half diagonals, and 0.7, 0.6 and 0.5 of it: in linear light.
  const Picture photo =
      photograph({"-colorspace", "RGB",      "-fx",       "u*(1-0.4*((i+0.5-320)^2+(j+0.5-240)^2)/160000)",
                  "-channel",    "R",        "-evaluate", "multiply",
                  "0.7",         "-channel", "G",         "-evaluate",
                  "multiply",    "0.6",      "-channel",  "B",
                  "-evaluate",   "multiply", "0.5",       "+channel",
                  "-colorspace", "sRGB"});
  const FittedPair pair = fit_to_reference(photo, render(),
                                           {.crop = {},
                                            .corners = about(),
                                            .distortion = false,
                                            .vignetting = true,
                                            .exposure = true,
                                            .white_balance = true});
  ASSERT_TRUE(pair.fit.vignetting);
  const auto fall = [&](double r2) { return 1 + pair.fit.vignetting->a * r2 + pair.fit.vignetting->b * r2 * r2; };
  EXPECT_NEAR(fall(0.25), 0.9, 0.02);
  EXPECT_NEAR(fall(0.6), 0.76, 0.03);
  EXPECT_NEAR(pair.fit.stops, std::log2(std::cbrt(0.7 * 0.6 * 0.5)), 0.05);
  EXPECT_NEAR(pair.fit.balance[0] / pair.fit.balance[1], 0.7 / 0.6, 0.02);
  EXPECT_NEAR(pair.fit.balance[2] / pair.fit.balance[1], 0.5 / 0.6, 0.02);
  EXPECT_LT(measure(pair.reference, pair.test).rmse, 6);
}

TEST(Photograph, NoiseIsEstimatedBesideEdges) {
  Picture p = render();
  EXPECT_LT(estimate_noise(p), 1.2);
  unsigned state = 1;
  for (float& v : p.samples) {
    double sum = 0;  // of twelve uniform numbers: about normal
    for (int i = 0; i < 12; ++i) state = state * 1664525u + 1013904223u, sum += state / 4294967296.0;
    v = std::clamp(v + static_cast<float>(4 * (sum - 6) / 255), 0.0f, 1.0f);
  }
  p.bits = 16;
  // The luma of three channels with 4 code values each: 4 sqrt(0.299^2 + 0.587^2 + 0.114^2) = 2.68.
  EXPECT_NEAR(estimate_noise(p), 2.68, 0.9);
}

TEST(Photograph, CornersInAnotherOrderAreRefused) {
  EXPECT_THROW(Homography({{{0, 0}, {0, 10}, {10, 10}, {10, 0}}}), PictureMismatch);
  const Homography h(kCorners);
  EXPECT_NEAR(h(1, 1).x, 520, 1e-9);
  EXPECT_NEAR(h(0, 1).y, 390, 1e-9);
}

}  // namespace
}  // namespace verisim::compare
