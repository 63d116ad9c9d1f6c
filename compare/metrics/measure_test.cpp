#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/metrics/blame.h"
#include "compare/metrics/edges.h"
#include "compare/metrics/flip.h"
#include "compare/metrics/metrics.h"
#include "compare/metrics/ssim.h"
#include "compare/metrics/test_pictures.h"
#include "compare/verdict/verdict.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace {

TEST(Measure, EqualPictures) {
  const Metrics m = measure(random_picture(33, 21, 1), random_picture(33, 21, 1));
  EXPECT_EQ(m.max_abs, 0);
  EXPECT_EQ(m.rmse, 0);
  EXPECT_EQ(m.psnr, kPsnrOfEqualPictures);
  EXPECT_EQ(m.within_1_pct, 100);
  EXPECT_NEAR(m.ssim_mean, 1, 1e-12);
  EXPECT_NEAR(m.ssim_block_min, 1, 1e-12);
  EXPECT_EQ(m.flip_mean, 0);
  EXPECT_EQ(m.ciede2000_p95, 0);
  EXPECT_TRUE(m.worst.empty());
  EXPECT_EQ(m.histogram[0], 33u * 21u);
}

// Four pixels, twelve values: +1, -2 and +6 in three of them.
TEST(Measure, FiguresByHand) {
  const Picture a = constant_picture(2, 2, 100, 100, 100);
  Picture b = a;
  b.samples[0] = 101 / 255.0f, b.samples[4] = 98 / 255.0f, b.samples[11] = 106 / 255.0f;
  const Metrics m = measure(a, b);
  EXPECT_DOUBLE_EQ(m.max_abs, 6);
  EXPECT_DOUBLE_EQ(m.mae, 9.0 / 12);
  EXPECT_DOUBLE_EQ(m.bias, 5.0 / 12);
  EXPECT_DOUBLE_EQ(m.rmse, std::sqrt(41.0 / 12));
  EXPECT_DOUBLE_EQ(m.psnr, 20 * std::log10(255 / std::sqrt(41.0 / 12)));
  EXPECT_DOUBLE_EQ(m.within_1_pct, 50);
  EXPECT_DOUBLE_EQ(m.within_2_pct, 75);
  EXPECT_EQ(m.histogram[0], 1u);
  EXPECT_EQ(m.histogram[6], 1u);
  ASSERT_FALSE(m.worst.empty());
  EXPECT_EQ(m.worst[0].x, 1);
  EXPECT_EQ(m.worst[0].y, 1);
  EXPECT_DOUBLE_EQ(m.worst[0].test[2], 106);
}

TEST(Measure, OneCodeValueIsWithinOneForEveryValue) {
  for (int v = 0; v < 255; ++v) {
    const Metrics m = measure(constant_picture(1, 1, v, v, v), constant_picture(1, 1, v + 1, v, v));
    ASSERT_EQ(m.within_1_pct, 100) << v;
    ASSERT_EQ(m.max_abs, 1) << v;
  }
}

TEST(Measure, SixteenBitPicturesKeepTheirFractions) {
  Picture a = constant_picture(1, 1, 100, 100, 100), b = a;
  a.bits = b.bits = 16;
  b.samples[0] += 128 / 65535.0f;
  EXPECT_NEAR(measure(a, b).max_abs, 128 / 257.0, 1e-4);
}

TEST(Measure, GreyAgainstColour) {
  const Picture grey = picture_of(
      4, 4, [](int, int, int) { return 77; }, 1);
  EXPECT_EQ(measure(grey, constant_picture(4, 4, 77, 77, 77)).max_abs, 0);
  EXPECT_EQ(measure(grey, constant_picture(4, 4, 77, 80, 77)).max_abs, 3);
}

TEST(Measure, AlphaIsComparedWhenPresent) {
  const Picture opaque = constant_picture(4, 4, 9, 9, 9);
  const Picture glass = picture_of(
      4, 4, [](int, int, int c) { return c == 3 ? 200 : 9; }, 4);
  const Metrics m = measure(opaque, glass);
  EXPECT_EQ(m.max_abs, 0);
  EXPECT_DOUBLE_EQ(*m.alpha_max_abs, 55);
  EXPECT_EQ(m.within_1_pct, 0);
  EXPECT_EQ(judge_deterministic(m, false).status, Status::differ);
  MetricOptions colors;
  colors.alpha = false;
  EXPECT_EQ(measure(opaque, glass, colors).within_1_pct, 100);
  EXPECT_FALSE(measure(opaque, opaque).alpha_max_abs);
}

TEST(Measure, NanNeverPassesAndStaysOutOfTheMeans) {
  Picture a = constant_picture(10, 10, 50, 50, 50);
  a.is_float = true;
  Picture b = a;
  b.samples[5] = NAN, b.samples[100] = INFINITY;
  const Metrics m = measure(a, b);
  EXPECT_EQ(m.nan_pixels, 2u);
  EXPECT_EQ(m.rmse, 0);
  EXPECT_EQ(m.within_1_pct, 98);
  EXPECT_EQ(judge_deterministic(m, false).status, Status::differ);
  EXPECT_EQ(judge_thresholds(m, {{"max_rmse", 1}}).status, Status::differ);
  EXPECT_EQ(judge_stochastic(m, false, {}, {}).status, Status::differ);
  // The same pixel broken in both is no agreement either.
  EXPECT_EQ(measure(b, b).nan_pixels, 2u);
}

TEST(Measure, FloatPicturesAreSrgbEncoded) {
  Picture a = constant_picture(2, 2, 0, 0, 0);
  a.is_float = true;
  Picture b = a;
  for (float& v : a.samples) v = 0.5f;
  for (float& v : b.samples) v = 0.5f, v *= 2;
  const Metrics m = measure(a, b);
  EXPECT_NEAR(m.max_abs, 255 - 187.516, 1e-2);  // sRGB of 0.5
  EXPECT_TRUE(m.hdr_flip_mean);
}

// Nothing is clipped when both pictures hold floats: a light of 50 is not one of 2, and -7 is not 0.
TEST(Measure, FloatsBeyondBlackAndWhiteAreJudged) {
  const auto floats = [](float value) {
    Picture p = constant_picture(16, 16, 0, 0, 0);
    p.is_float = true;
    for (float& v : p.samples) v = value;
    return p;
  };
  for (const auto& [reference, test] :
       {std::pair(2.0f, 50.0f), {50.0f, 2.0f}, {0.0f, -7.0f}, {-7.0f, 0.0f}, {1.0f, 1.05f}, {1000.0f, 1050.0f}}) {
    const Metrics m = measure(floats(reference), floats(test));
    EXPECT_EQ(judge_deterministic(m, false).status, Status::differ) << reference << " " << test;
    EXPECT_EQ(m.bias > 0, test > reference);
    EXPECT_DOUBLE_EQ(m.worst.at(0).error, m.max_abs);
    EXPECT_EQ(blame(floats(reference), floats(test), {16, 16, 1, {}, {{}}, std::vector<int>(256, 0), {}}).bad, 256u);
    EXPECT_GT(low_pass(floats(reference), floats(test)).mad, 1);
  }
  // Half floats round by less than 0.05 % whatever the size.
  EXPECT_EQ(judge_deterministic(measure(floats(30000), floats(30008)), false).status, Status::exact);
  EXPECT_NEAR(measure(floats(1), floats(std::exp(1.0f))).max_abs, 255 * 1.055 / 2.4, 1e-3);
  EXPECT_NEAR(measure(floats(-0.5f), floats(0.5f)).max_abs, 2 * 187.516, 1e-2);
  // A picture of whole numbers cannot hold more than white.
  EXPECT_EQ(measure(constant_picture(16, 16, 255, 255, 255), floats(7)).max_abs, 0);
}

// Larger than a band and a tile of any metric, with differences on the seams, and equal parts that are passed over
// quickly.
class Bands : public testing::Test {
 protected:
  Bands() {
    const int w = 531, h = 333;
    reference_ = picture_of(w, h, [](int x, int y, int c) {
      return 127.5 + 60 * std::sin(0.07 * x * (c + 1)) + 50 * std::cos(0.05 * y) + ((x / 37 + y / 23) % 2 ? 15 : 0);
    });
    test_ = reference_;
    std::mt19937 random(4);
    std::uniform_int_distribution<int> change(-9, 9);
    for (int y = 40; y < h; ++y)
      for (int x = 0; x < 300; ++x)
        for (int c = 0; c < 3; ++c) {
          float& v = test_.samples[static_cast<std::size_t>(3 * (y * w + x) + c)];
          v = static_cast<float>(std::clamp(std::round(255.0 * v + change(random)), 0.0, 255.0) / 255);
        }
    image::write_picture(reference_, folder_.path() / "a.png"), image::write_picture(test_, folder_.path() / "b.png");
    reference_ = image::read_picture(folder_.path() / "a.png"), test_ = image::read_picture(folder_.path() / "b.png");
  }
  static void expect_same(const Metrics& a, const Metrics& b) {
    EXPECT_EQ(a.max_abs, b.max_abs);
    EXPECT_EQ(a.mae, b.mae);
    EXPECT_EQ(a.rmse, b.rmse);
    EXPECT_EQ(a.within_1_pct, b.within_1_pct);
    EXPECT_NEAR(a.ssim_mean, b.ssim_mean, 1e-13);  // the sums are taken band by band
    EXPECT_EQ(a.ssim_block_min, b.ssim_block_min);
    EXPECT_EQ(a.flip_mean, b.flip_mean);
    EXPECT_EQ(a.ciede2000_mean, b.ciede2000_mean);
    EXPECT_EQ(a.ciede2000_p95, b.ciede2000_p95);
    EXPECT_EQ(a.edge_rmse, b.edge_rmse);
    EXPECT_EQ(a.interior_rmse, b.interior_rmse);
    EXPECT_EQ(a.edge_pct, b.edge_pct);
    EXPECT_EQ(a.histogram, b.histogram);
    ASSERT_EQ(a.worst.size(), b.worst.size());
    for (std::size_t i = 0; i < a.worst.size(); ++i)
      EXPECT_TRUE(a.worst[i].x == b.worst[i].x && a.worst[i].y == b.worst[i].y && a.worst[i].test == b.worst[i].test);
  }
  TemporaryFolder folder_;
  Picture reference_, test_;
};

TEST_F(Bands, FilesReadByRowsGiveTheFiguresOfWholePictures) {
  MetricOptions whole;
  whole.band_rows = 64 * 100;
  const Metrics expected = measure(reference_, test_, whole);
  EXPECT_GT(expected.flip_mean, 0.01);
  EXPECT_NEAR(expected.ssim_mean, ssim_mean(Values(reference_), Values(test_)), 1e-13);
  EXPECT_NEAR(expected.flip_mean, mean(ldr_flip(reference_, test_, whole.flip_pixels_per_degree)), 1e-12);
  MetricOptions bands;
  double done = 0;
  bands.progress = [&](double now) {
    EXPECT_GT(now, done);
    done = now;
  };
  for (int rows : {64, 128}) {
    bands.band_rows = rows, done = 0;
    expect_same(measure(reference_, test_, bands), expected);
    done = 0;
    expect_same(measure_files(folder_.path() / "a.png", folder_.path() / "b.png", bands), expected);
    EXPECT_EQ(done, 1);
  }
}

TEST_F(Bands, DamagedFilesAreNamed) {
  const auto message = [&](const std::string& name) -> std::string {
    try {
      measure_files(folder_.path() / "a.png", folder_.path() / name);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  };
  std::filesystem::copy_file(folder_.path() / "b.png", folder_.path() / "short.png");
  std::filesystem::resize_file(folder_.path() / "short.png",
                               std::filesystem::file_size(folder_.path() / "b.png") * 2 / 3);
  EXPECT_THAT(message("short.png"), testing::HasSubstr("short.png"));
  image::write_picture(random_picture(531, 334, 1), folder_.path() / "taller.png");
  EXPECT_THAT(message("taller.png"), testing::HasSubstr("531x333 and 531x334"));
  EXPECT_THAT(message("missing.png"), testing::HasSubstr("missing.png"));
  EXPECT_EQ(message("b.png"), "no error");
}

TEST(Measure, RefusesWhatCannotBeCompared) {
  EXPECT_THROW(measure(random_picture(4, 5, 1), random_picture(5, 4, 1)), PictureMismatch);
  EXPECT_THROW(measure(Picture{}, Picture{}), PictureMismatch);
  Picture truncated = random_picture(4, 4, 1);
  truncated.samples.resize(20);
  EXPECT_THROW(measure(truncated, random_picture(4, 4, 1)), PictureMismatch);
}

TEST(Measure, OnePixelPictures) {
  const Metrics m = measure(constant_picture(1, 1, 10, 20, 30), constant_picture(1, 1, 20, 20, 30));
  EXPECT_DOUBLE_EQ(m.max_abs, 10);
  EXPECT_TRUE(std::isfinite(m.ssim_mean));
  EXPECT_TRUE(std::isfinite(m.flip_mean));
  EXPECT_FALSE(m.edge_rmse);
}

TEST(Measure, WorstPixelsLieApartAndAreSorted) {
  Picture a = constant_picture(60, 40, 100, 100, 100), b = a;
  const auto set = [&](int x, int y, double v) {
    b.samples[static_cast<std::size_t>(3 * (60 * y + x))] = static_cast<float>(v / 255);
  };
  set(10, 10, 200), set(11, 10, 190), set(40, 30, 150), set(0, 39, 120);
  const Metrics m = measure(a, b);
  ASSERT_EQ(m.worst.size(), 3u);
  EXPECT_EQ(m.worst[0].error, 100);
  EXPECT_EQ(m.worst[1].x, 40);
  EXPECT_EQ(m.worst[2].y, 39);
}

// A vertical edge in the middle; only pixels beside it differ, so the interior is clean.
TEST(Measure, EdgeAndInteriorErrorsAreApart) {
  const Picture a = picture_of(20, 10, [](int x, int, int) { return x < 10 ? 20 : 220; });
  const Picture b = picture_of(20, 10, [](int x, int, int) { return x < 9 ? 20 : 220; });
  const Metrics m = measure(a, b);
  EXPECT_DOUBLE_EQ(*m.interior_rmse, 0);
  EXPECT_GT(*m.edge_rmse, 50);
  EXPECT_DOUBLE_EQ(m.edge_pct, 20);  // two columns that see the step, one more on each side
}

TEST(Ssim, OfTwoConstantsIsTheLuminanceTerm) {
  const Picture a = constant_picture(32, 32, 100, 100, 100), b = constant_picture(32, 32, 120, 120, 120);
  const double c1 = 2.55 * 2.55, expected = (2 * 100 * 120 + c1) / (100.0 * 100 + 120.0 * 120 + c1);
  EXPECT_NEAR(ssim_mean(Values(a), Values(b)), expected, 1e-9);
  EXPECT_NEAR(ssim_block_min(Values(a), Values(b)), expected, 1e-9);
}

// One 8x8 block, half 0, half 100, against its mirror image: means 50, variances 2500, covariance -2500.
TEST(Ssim, BlockByHand) {
  const Picture a = picture_of(8, 8, [](int x, int, int) { return x < 4 ? 0 : 100; }),
                b = picture_of(8, 8, [](int x, int, int) { return x < 4 ? 100 : 0; });
  const double c2 = 7.65 * 7.65;
  EXPECT_NEAR(ssim_block_min(Values(a), Values(b)), (-2 * 2500 + c2) / (2 * 2500 + c2), 1e-9);
}

TEST(Ssim, TheWorstBlockIsFoundWhereverItIs) {
  const Picture a = random_picture(30, 27, 8);
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(29, 0), std::pair(13, 14), std::pair(29, 26)}) {
    Picture b = a;
    b.samples[static_cast<std::size_t>(3 * (30 * y + x) + 1)] =
        1 - b.samples[static_cast<std::size_t>(3 * (30 * y + x) + 1)];
    EXPECT_LT(ssim_block_min(Values(a), Values(b)), 1 - 1e-6);
  }
}

TEST(Verdict, Boundaries) {
  Metrics m;
  m.within_1_pct = 99.99, m.within_2_pct = 100;
  EXPECT_EQ(judge_deterministic(m, false).status, Status::exact);
  m.within_1_pct = 99.98, m.rmse = 2;
  EXPECT_EQ(judge_deterministic(m, false).status, Status::match);
  EXPECT_EQ(judge_deterministic(m, true).status, Status::exact);
  m.rmse = 2.001;
  EXPECT_EQ(judge_deterministic(m, false).status, Status::differ);
  EXPECT_THAT(judge_deterministic(m, false).reason, testing::HasSubstr("rmse"));
  m.rmse = 0.1, m.within_1_pct = 99.49;
  EXPECT_THAT(judge_deterministic(m, false).reason, testing::HasSubstr("within_1_pct"));
}

Picture with_patch(Picture p, int x0, int y0, int width, int height, double value) {
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x)
      for (int c = 0; c < 3; ++c)
        p.samples[static_cast<std::size_t>(3 * (y * p.width + x) + c)] = static_cast<float>(value / 255);
  return p;
}

TEST(Verdict, ASmallPatchThatIsWrongIsAFault) {
  const Picture a = constant_picture(320, 240, 90, 90, 90);
  const auto verdict = [&](const Picture& b, bool antialiased = false) {
    return judge_deterministic(measure(a, b), antialiased);
  };
  EXPECT_EQ(verdict(with_patch(a, 100, 50, 4, 2, 200)).status, Status::differ);
  EXPECT_EQ(verdict(with_patch(a, 100, 50, 4, 2, 200), true).status, Status::differ);
  EXPECT_EQ(verdict(with_patch(a, 0, 237, 3, 3, 200)).status, Status::differ);
  Picture disc = a;  // an object of 53 pixels that is not there
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 9; ++x)
      if (std::hypot(x - 4, y - 4) < 4.2) disc = with_patch(disc, 60 + x, 70 + y, 1, 1, 140);
  EXPECT_THAT(verdict(disc).reason, testing::HasSubstr("solid_2_pixels"));
  const Metrics m = measure(a, disc);
  EXPECT_NEAR(m.solid_x, 64, 4);
  EXPECT_NEAR(m.solid_y, 74, 4);
  EXPECT_EQ(judge_deterministic(m, false, {.solid_pixels = 60, .drift_max = {}}).status, Status::match);
}

// What coincident surfaces and last bits do: lone pixels, pairs and lines.
TEST(Verdict, SpeckleIsNoPatch) {
  const Picture a = constant_picture(320, 240, 90, 90, 90);
  Picture speckle = a;
  for (int i = 0; i < 40; ++i) speckle = with_patch(speckle, 5 + 7 * i, 10 + 5 * i, 1 + i % 2, 1, i % 3 ? 115 : 65);
  speckle = with_patch(with_patch(speckle, 200, 20, 1, 40, 115), 20, 200, 60, 1, 65);
  EXPECT_EQ(judge_deterministic(measure(a, speckle), false).status, Status::match);
}

// One per cent of an object's brightness changes few code values of eight bits; sixteen bits show it everywhere.
TEST(Verdict, SystematicDifferencesBelowACodeValueAreFaults) {
  Picture a = scene_like_picture(160, 120);
  EXPECT_EQ(judge_deterministic(measure(a, changed(a, [](double v) { return v - 1; })), false).status, Status::differ)
      << "the whole picture one code value down";
  a.bits = 16;
  const auto darker = [&](double by, int x0, int y0, int width, int height) {
    Picture b = a;
    for (int y = y0; y < y0 + height; ++y)
      for (int x = x0; x < x0 + width; ++x)
        for (int c = 0; c < 3; ++c)
          b.samples[static_cast<std::size_t>(3 * (y * 160 + x) + c)] -= static_cast<float>(by / 255);
    return judge_deterministic(measure(a, b), false);
  };
  EXPECT_EQ(darker(0.1, 0, 0, 160, 120).status, Status::differ);
  EXPECT_EQ(darker(0.4, 90, 60, 8, 8).status, Status::differ) << "a small object";
  EXPECT_THAT(darker(0.4, 90, 60, 8, 8).reason, testing::HasSubstr("drift_max"));
  EXPECT_EQ(darker(0.02, 0, 0, 160, 120).status, Status::exact) << "rounding of another machine";
  EXPECT_EQ(judge_deterministic(measure(a, changed(a, [](double v) { return v - 0.3; })), false,
                                {.solid_pixels = 2, .drift_max = 0.5})
                .status,
            Status::exact)
      << "the manifest allows it";
  // To both sides it is no drift; and of a picture of whole code values what was rounded away is none.
  Picture noisy = a;
  for (std::size_t i = 0; i < noisy.samples.size(); ++i) noisy.samples[i] += (i / 3 % 2 ? 0.4f : -0.4f) / 255;
  EXPECT_EQ(judge_deterministic(measure(a, noisy), false).status, Status::exact);
  Picture whole = a;
  whole.bits = 8;
  EXPECT_EQ(judge_deterministic(measure(whole, changed(a, [](double v) { return v + 0.4; })), false).status,
            Status::exact);
}

TEST(Verdict, OwnThresholds) {
  Metrics m;
  m.rmse = 3, m.ssim_mean = 0.9, m.bias = -2;
  EXPECT_EQ(judge_thresholds(m, {{"max_rmse", 3}, {"min_ssim_mean", 0.9}}).status, Status::match);
  EXPECT_THAT(judge_thresholds(m, {{"max_rmse", 2.9}}).reason, testing::HasSubstr("rmse"));
  EXPECT_EQ(judge_thresholds(m, {{"max_bias", 1.5}}).status, Status::differ);
  EXPECT_THROW(judge_thresholds(m, {{"max_rsme", 1}}), std::invalid_argument);
  EXPECT_THROW(judge_thresholds(m, {{"rmse", 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace verisim::compare
