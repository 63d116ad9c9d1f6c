// The comparison of noisy pictures: hand-made figures, then its false-alarm rate and its power by simulation.
#include <gtest/gtest.h>

#include "compare/metrics/test_pictures.h"
#include "compare/verdict/verdict.h"
#include "compare/verdict/welch.h"

namespace verisim::compare {
namespace {

TEST(LowPass, ConstantDifference) {
  const LowPass l = low_pass(constant_picture(20, 10, 50, 50, 50), constant_picture(20, 10, 53, 50, 46));
  EXPECT_NEAR(l.mad, 7.0 / 3, 1e-9);
  EXPECT_NEAR(l.bias, 4, 1e-9);
  EXPECT_NEAR(l.rmse, std::sqrt(25.0 / 3), 1e-9);
}

// White noise of sigma s is left with s / (2 sigma_blur sqrt(pi)) after the blur.
TEST(LowPass, AveragesNoiseAway) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 5);
  const Picture a = constant_picture(200, 200, 128, 128, 128),
                b = picture_of(200, 200, [&](int, int, int) { return 128 + noise(random); });
  Picture c = b;
  c.bits = 16;
  EXPECT_NEAR(low_pass(a, c).rmse, 5 / (2 * 2 * std::sqrt(3.14159265)), 0.05);
}

TEST(LowPass, LimitsAreTheRulesOfTheDocumentation) {
  const NoiseLimits l = noise_limits({1, 2, 3});
  EXPECT_DOUBLE_EQ(l.mad, 2.1);
  EXPECT_DOUBLE_EQ(l.bias, 4);
  EXPECT_DOUBLE_EQ(l.rmse, 5.5);
}

TEST(Student, TwoSidedProbabilities) {
  EXPECT_NEAR(student_two_sided(12.7062, 1), 0.05, 1e-6);  // tables
  EXPECT_NEAR(student_two_sided(2.2281389, 10), 0.05, 1e-7);
  EXPECT_NEAR(student_two_sided(1.9599640, 1e9), 0.05, 1e-6);
  EXPECT_NEAR(student_two_sided(0, 5), 1, 1e-12);
  EXPECT_NEAR(student_two_sided(1, 1), 0.5, 1e-12);  // Cauchy
  EXPECT_GT(student_two_sided(200, 6), 0);
}

// A noisy render: the noise of a pixel is correlated with its neighbours' (radiosity, media), differs over the picture,
// and part of the picture is without any.
class NoisyRenderer {
 public:
  NoisyRenderer(unsigned seed, double sigma, int width = 64, int height = 48)
      : random_(seed), scene_(scene_like_picture(width, height)), sigma_(sigma) {}
  Picture render(double gain = 1) {
    const int w = scene_.width, h = scene_.height;
    std::vector<double> white(static_cast<std::size_t>(w + 2) * (h + 2));
    for (double& v : white) v = normal_(random_);
    Picture out = scene_;
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        double n = 0;
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i) n += white[static_cast<std::size_t>((y + j) * (w + 2) + x + i)] / 3;
        const double sigma = y < h / 3 ? 0 : sigma_ * (0.5 + x / static_cast<double>(w));
        for (int c = 0; c < 3; ++c) {
          float& v = out.samples[static_cast<std::size_t>(3 * (y * w + x) + c)];
          v = static_cast<float>(std::round(std::clamp(255.0 * v * gain + sigma * n, 0.0, 255.0)) / 255);
        }
      }
    return out;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  Picture scene_;
  double sigma_;
};

// The rule of docs/comparison.md. 400 scenes of all noise levels, the oracle against itself: at most 2.5 % may fail
// (none is expected to).
TEST(LowPass, FalseAlarmRateOfTheOracleAgainstItself) {
  int alarms = 0;
  for (unsigned i = 0; i < 400; ++i) {
    NoisyRenderer renderer(i, 0.25 * (1 + i % 40));
    const Picture a = renderer.render(), b = renderer.render(), ours = renderer.render();
    alarms += judge_stochastic(measure(a, ours), false, low_pass(a, ours), low_pass(a, b)).status == Status::differ;
  }
  EXPECT_LE(alarms, 10);
}

// Pictures 2 % brighter than their mean (119 here, so 2.4 code values), noise up to 10 code values: at least 95 % must
// be found.
TEST(LowPass, PowerAgainstTwoPercent) {
  int found = 0;
  for (unsigned i = 0; i < 100; ++i) {
    NoisyRenderer renderer(1000 + i, 0.25 * (1 + i % 40));
    const Picture a = renderer.render(), b = renderer.render(), ours = renderer.render(1.02);
    found += judge_stochastic(measure(a, ours), false, low_pass(a, ours), low_pass(a, b)).status == Status::differ;
  }
  EXPECT_GE(found, 95);
}

std::vector<Picture> several(NoisyRenderer& renderer, int n, double gain = 1) {
  std::vector<Picture> out;
  for (int i = 0; i < n; ++i) out.push_back(renderer.render(gain));
  return out;
}

TEST(Welch, FalseAlarmRate) {
  int alarms = 0;
  for (unsigned i = 0; i < 400; ++i) {
    NoisyRenderer renderer(i, 0.25 * (1 + i % 40), 32, 24);
    alarms += welch_test(several(renderer, 4), several(renderer, 4)).rejected;
  }
  EXPECT_LE(alarms, 10) << "2.5 % of 400";
}

TEST(Welch, PowerAgainstTwoPercent) {
  int found = 0;
  for (unsigned i = 0; i < 100; ++i) {
    NoisyRenderer renderer(5000 + i, 0.25 * (1 + i % 40));
    found += welch_test(several(renderer, 4), several(renderer, 4, 1.02)).rejected;
  }
  EXPECT_GE(found, 95);
}

bool refused_by_low_pass(const std::vector<Picture>& references, const std::vector<Picture>& tests) {
  const auto refused = [&](const LowPass& ours, const LowPass& noise) {
    return judge_stochastic(measure(references[0], tests[0]), false, ours, noise).status == Status::differ;
  };
  const std::span<const Picture> all(references);
  const std::size_t half = all.size() / 2;
  return refused(low_pass(references[0], tests[0]), low_pass(references[0], references[1])) &&
         refused(low_pass(mean_of(all), mean_of(tests)),
                 low_pass(mean_of(all.first(half)), mean_of(all.subspan(half))));
}

// Both rules together, as `verisim compare` asks them by default: four runs on each side.
bool refused(const std::vector<Picture>& references, const std::vector<Picture>& tests) {
  return refused_by_low_pass(references, tests) || welch_test(references, tests).rejected;
}

// Pictures whose brightness as a whole is noisy, as radiosity's is: one pair of them often says that it is not, and the
// means of four do not.
TEST(LowPass, MeansOfSeveralAcquitNoiseOfTheWholePicture) {
  int once = 0, again = 0, found = 0;
  for (unsigned i = 0; i < 100; ++i) {
    NoisyRenderer renderer(40000 + i, 1);
    std::mt19937 random(i);
    std::normal_distribution<double> brightness(1, 0.8 / 119);
    const auto renders = [&](double gain) {
      std::vector<Picture> out;
      for (int k = 0; k < 4; ++k) out.push_back(renderer.render(gain * brightness(random)));
      return out;
    };
    const std::vector<Picture> references = renders(1), tests = renders(1), bright = renders(1.03);
    once += judge_stochastic(measure(references[0], tests[0]), false, low_pass(references[0], tests[0]),
                             low_pass(references[0], references[1]))
                .status == Status::differ;
    again += refused_by_low_pass(references, tests);
    found += refused(references, bright);
  }
  EXPECT_GE(once, 10);
  EXPECT_LE(again, 4);
  EXPECT_GE(found, 90) << "3 % too bright, by either rule";
}

TEST(Noise, FalseAlarmRateOfTheVerdict) {
  int alarms = 0;
  for (unsigned i = 0; i < 400; ++i) {
    NoisyRenderer renderer(20000 + i, 0.25 * (1 + i % 40));
    const std::vector<Picture> references = several(renderer, 4);
    alarms += refused(references, several(renderer, 4));
  }
  EXPECT_LE(alarms, 10) << "2.5 % of 400";
}

TEST(Noise, PowerOfTheVerdictAgainstTwoPercent) {
  int found = 0;
  for (unsigned i = 0; i < 100; ++i) {
    NoisyRenderer renderer(30000 + i, 0.25 * (1 + i % 40));
    const std::vector<Picture> references = several(renderer, 4);
    found += refused(references, several(renderer, 4, 1.02));
  }
  EXPECT_GE(found, 95);
}

TEST(Welch, FindsOneWrongPixel) {
  NoisyRenderer renderer(3, 1);
  const std::vector<Picture> a = several(renderer, 8);
  std::vector<Picture> b = several(renderer, 8);
  for (Picture& p : b)
    for (std::size_t c = 0; c < 3; ++c) p.samples[3 * (40 * 64 + 20) + c] += 60 / 255.0f;
  const WelchResult r = welch_test(a, b);
  EXPECT_TRUE(r.rejected);
  EXPECT_EQ(r.worst_x, 20);
  EXPECT_EQ(r.worst_y, 40);
}

// Without noise a difference of rounding, one code value here and there, is no finding.
TEST(Welch, VarianceFloorForgivesRounding) {
  const Picture a = scene_like_picture(30, 30);
  Picture b = a;
  b.samples[3 * 100] += 1 / 255.0f;
  EXPECT_FALSE(welch_test({a, a, a}, {b, b, b}).rejected);
}

TEST(Welch, RefusesTooFewOrUnequalPictures) {
  const Picture a = random_picture(4, 4, 1);
  EXPECT_THROW(welch_test({a}, {a, a}), PictureMismatch);
  EXPECT_THROW(welch_test({a, a}, {a, random_picture(4, 5, 1)}), PictureMismatch);
}

}  // namespace
}  // namespace verisim::compare
