#include "compare/photographs/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/metrics/test_pictures.h"
#include "compare/verdict/truth.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

// A photograph of the scene: darker, warmer, larger, with a frame around it.
struct Photograph {
  Picture render = changed(scene_like_picture(48, 36), [](double v) { return 0.8 * v; }), photo;
  static constexpr std::array<double, 3> kGain = {0.5 * 1.3, 0.5, 0.5 * 0.7};
  Photograph(int scale, int frame) {
    photo.width = 48 * scale + 2 * frame, photo.height = 36 * scale + 2 * frame;
    for (int y = 0; y < photo.height; ++y)
      for (int x = 0; x < photo.width; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const int u = (x - frame) / scale, v = (y - frame) / scale;
          const bool inside = x >= frame && y >= frame && u < 48 && v < 36;
          const double value =
              inside ? linear_to_srgb(
                           kGain[c] *
                           srgb_to_linear(
                               std::round(255 * static_cast<double>(
                                                    render.samples[static_cast<std::size_t>(v * 48 + u) * 3 + c])) /
                               255))
                     : 1;
          photo.samples.push_back(static_cast<float>(value));
        }
    photo.bits = 16;
  }
};

TEST(Fit, FindsExposureAndWhiteBalance) {
  const Photograph p(1, 0);
  const FittedPair pair =
      fit_to_reference(p.photo, p.render, {.crop = {}, .corners = {}, .exposure = true, .white_balance = true});
  const double mean = std::cbrt(1.3 * 0.7) * 0.5;
  EXPECT_NEAR(pair.fit.stops, std::log2(mean), 0.01);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(pair.fit.balance[c], Photograph::kGain[c] / mean, 0.01);
  EXPECT_LT(measure(pair.reference, pair.test).rmse, 0.5);
  EXPECT_THAT(pair.fit.text(),
              testing::AllOf(testing::HasSubstr("exposure -1.0"), testing::HasSubstr("white balance 1.3")));
}

// A chart of six patches as a camera with mixed channels and half the light sees it.
struct Chart {
  static constexpr std::array<std::array<double, 3>, 6> kKnown = {
      {{115, 82, 68}, {194, 150, 130}, {98, 122, 157}, {87, 108, 67}, {243, 243, 242}, {122, 122, 121}}};
  static constexpr double kCamera[3][3] = {{0.40, 0.08, 0.02}, {0.05, 0.38, 0.07}, {0.01, 0.10, 0.45}};
  Picture photo;
  std::vector<ColorTarget> targets;
  explicit Chart(std::size_t patches) {
    photo.width = 8 * static_cast<int>(patches), photo.height = 8, photo.bits = 16;
    for (int y = 0; y < 8; ++y)
      for (std::size_t t = 0; t < patches; ++t)
        for (int x = 0; x < 8; ++x)
          for (const auto& row : kCamera) {
            double v = 0;
            for (std::size_t c = 0; c < 3; ++c) v += row[c] * srgb_to_linear(kKnown[t][c] / 255);
            photo.samples.push_back(static_cast<float>(linear_to_srgb(v)));
          }
    for (std::size_t t = 0; t < patches; ++t) targets.push_back({8 * static_cast<int>(t) + 2, 2, 4, 4, kKnown[t]});
  }
};

TEST(Fit, ColorTargetsUndoAMatrix) {
  const Chart chart(6);
  const TargetFit fit = fit_targets(chart.photo, chart.targets);
  EXPECT_TRUE(fit.whole_matrix);
  for (const double error : fit.errors) EXPECT_LT(error, 0.01);
  EXPECT_THAT(fit.text(), testing::HasSubstr("6 targets (a matrix), which are then 0.00 CIEDE2000 off"));
  // Applied, and with the exposure fitted, the photograph has the known colours.
  Picture known = chart.photo;
  for (std::size_t i = 0; i < known.samples.size(); ++i)
    known.samples[i] = static_cast<float>(Chart::kKnown[i / 24 % 6][i % 3] / 255);
  FitOptions options;
  options.targets = chart.targets, options.exposure = true;
  const FittedPair pair = fit_to_reference(chart.photo, known, options);
  EXPECT_LT(measure(pair.reference, pair.test).max_abs, 0.5);
  EXPECT_NEAR(pair.fit.stops, -1, 0.2);  // half the light
  ASSERT_TRUE(pair.fit.targets);
}

TEST(Fit, FewColorTargetsAreAFactorForEachChannel) {
  Chart chart(6);
  chart.targets = {chart.targets[4]};
  const TargetFit fit = fit_targets(chart.photo, chart.targets);
  EXPECT_FALSE(fit.whole_matrix);
  EXPECT_LT(fit.errors.at(0), 0.01);
  EXPECT_EQ(fit.matrix[1], 0);
  const Picture mended = with_mended_colors(chart.photo, fit);
  const auto white = static_cast<std::size_t>(3 * (4 * 8 + 4));
  EXPECT_NEAR(mended.samples[white], mended.samples[white + 2], 0.005);  // as grey as 243, 243, 242
  EXPECT_GT(std::fabs(chart.photo.samples[white] - chart.photo.samples[white + 2]), 0.03);
}

TEST(Fit, ColorTargetsThatCannotBeReadSaySo) {
  Chart chart(6);
  const auto said = [&] {
    try {
      fit_targets(chart.photo, chart.targets);
    } catch (const PictureMismatch& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  chart.targets[2].x = 46;
  EXPECT_THAT(said(), testing::StartsWith("target 3 at 46, 2, 4, 4 is not inside the picture of 48x8"));
  chart.targets[2].x = 18;
  chart.photo.samples[(3 * 48 + 3) * 3] = 1;
  EXPECT_EQ(said(), "target 1 is clipped in the photograph at 3, 3");
  for (const char* text : {"1,2,3,4=1,2", "1,2,3,4=1,2,300", "a", "1,2,3,4=1,2,3,"})
    EXPECT_THROW(color_target_of(text), std::invalid_argument) << text;
  EXPECT_EQ(color_target_of("1,2,3,4=5,6,7").srgb, (std::array<double, 3>{5, 6, 7}));
}

TEST(Fit, ExposureAloneIsOneFactor) {
  const Picture a = scene_like_picture(30, 20),
                b = changed(a, [](double v) {
                  return 255 * linear_to_srgb(2 * srgb_to_linear(v / 255) < 1 ? 2 * srgb_to_linear(v / 255) : 1);
                });
  const FittedPair pair = fit_to_reference(a, b, {.crop = {}, .corners = {}, .exposure = true, .white_balance = false});
  EXPECT_NEAR(pair.fit.stops, -1, 0.01);
  EXPECT_EQ(pair.fit.balance, (std::array<double, 3>{1, 1, 1}));
}

TEST(Fit, CropsAndAverages) {
  const Photograph p(3, 5);
  const FittedPair pair = fit_to_reference(
      p.photo, p.render, {.crop = Crop{5, 5, 144, 108}, .corners = {}, .exposure = true, .white_balance = true});
  EXPECT_TRUE(pair.fit.resampled);
  EXPECT_EQ(pair.reference.width, 48);
  EXPECT_EQ(pair.fit.reference_width, 144);
  EXPECT_LT(measure(pair.reference, pair.test).rmse, 0.5);
  EXPECT_THAT(pair.fit.text(), testing::HasSubstr("144x108 at 5, 5"));
}

TEST(Fit, AveragesPartsOfPixels) {
  Picture a = picture_of(3, 1, [](int x, int, int) { return x == 1 ? 0.0 : 255.0; });
  const FittedPair pair = fit_to_reference(a, constant_picture(2, 1, 0, 0, 0), {});
  EXPECT_NEAR(srgb_to_linear(pair.reference.samples[0]), 2.0 / 3, 1e-6);
  EXPECT_NEAR(srgb_to_linear(pair.reference.samples[3]), 2.0 / 3, 1e-6);
}

TEST(Fit, RefusesCropsOutside) {
  const Picture a = scene_like_picture(30, 20);
  for (const Crop crop :
       {Crop{-1, 0, 5, 5}, Crop{0, 0, 31, 5}, Crop{28, 0, 5, 5}, Crop{0, 0, 0, 5}, Crop{2147483647, 0, 2147483647, 1}})
    EXPECT_THROW(fit_to_reference(a, a, {.crop = crop, .corners = {}}), PictureMismatch);
}

TEST(Fit, BlackPicturesAreLeftAlone) {
  const Picture a = scene_like_picture(30, 20), black = constant_picture(30, 20, 0, 0, 0);
  EXPECT_EQ(fit_to_reference(a, black, {.crop = {}, .corners = {}, .exposure = true, .white_balance = true}).fit.stops,
            0);
  EXPECT_TRUE(std::isfinite(
      fit_to_reference(black, a, {.crop = {}, .corners = {}, .exposure = true, .white_balance = false}).fit.stops));
}

TEST(Truth, LargestAndMeanError) {
  const Picture p = picture_of(4, 3, [](int x, int y, int c) { return 255 * (0.1 * x + 0.01 * y + 0.001 * c); });
  const TruthError e = truth_error(p, {"", {{1, 2, {0.12, 0.121, 0.122}}, {3, 0, {0.3, 0.301, 0.332}}}, 0.01});
  EXPECT_NEAR(e.max, 0.03, 1e-6);
  EXPECT_NEAR(e.rms, 0.03 / std::sqrt(6), 1e-6);
  EXPECT_EQ(e.worst_x, 3);
  EXPECT_NEAR(e.values[0][1], 0.121, 1e-6);
  EXPECT_THROW(truth_error(p, {"", {{4, 0, {}}}, 0.01}), PictureMismatch);
}

}  // namespace
}  // namespace verisim::compare
