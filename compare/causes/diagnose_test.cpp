// Planted faults: each must be named, first of all.
#include "compare/causes/diagnose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/metrics/test_pictures.h"
#include "compare/metrics/values.h"
#include "compare/metrics/verdict.h"

namespace verisim::compare {
namespace {

using testing::HasSubstr;

// A scene that can be rendered at any place between the pixels, with soft shading and edges of 4x4 samples.
Picture scene(double dx = 0, double dy = 0, int width = 96, int height = 72) {
  const auto color = [=](double x, double y, int c) {
    const double u = x / width, v = y / height;
    if (std::hypot(u - 0.35, v - 0.5) < 0.22) return 60 + 120 * v + 20 * c;
    if (u > 0.7 && v > 0.3) return 170 - 45 * c + 30 * std::sin(9 * u);
    return 60 + 70 * u + 25 * std::sin(12 * v) + 12 * c;
  };
  return picture_of(width, height, [&](int x, int y, int c) {
    double sum = 0;
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) sum += color(x + (i + 0.5) / 4 - dx, y + (j + 0.5) / 4 - dy, c);
    return std::round(sum / 16);
  });
}
Picture rounded(const Picture& p, const std::function<double(double)>& f) {
  return changed(p, [&](double v) { return std::round(std::clamp(f(v), 0.0, 255.0)); });
}
Suspicion first(const Picture& test) {
  const std::vector<Suspicion> all = diagnose(scene(), test);
  return all.empty() ? Suspicion{"nothing", "", 0} : all[0];
}

TEST(Diagnose, EqualPicturesAreNotSuspected) { EXPECT_TRUE(diagnose(scene(), scene()).empty()); }

TEST(Diagnose, ThreePercentDarker) {
  const Picture test = rounded(scene(), [](double v) { return 255 * linear_to_srgb(0.97 * srgb_to_linear(v / 255)); });
  EXPECT_EQ(first(test).what, "brightness") << first(test).detail;
  EXPECT_THAT(first(test).detail, testing::ContainsRegex("(2.9|3.0|3.1) % darker"));
}

TEST(Diagnose, GammaSlip) {
  const Picture test = rounded(scene(), [](double v) { return 255 * std::pow(v / 255, 1 / 1.1); });
  EXPECT_EQ(first(test).what, "gamma");
  EXPECT_THAT(first(test).detail, HasSubstr("0.9"));
  EXPECT_GT(first(test).explained, 0.95);
}

TEST(Diagnose, HalfPixelShift) {
  for (const auto& [dx, dy] : {std::pair(0.5, 0.0), std::pair(0.0, -0.5), std::pair(0.5, 0.5), std::pair(-1.0, 0.0)}) {
    const Suspicion s = first(scene(dx, dy));
    EXPECT_EQ(s.what, "shift") << dx << " " << dy << ": " << s.detail;
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(s.detail.c_str(), "the picture is moved by %lf, %lf", &x, &y), 2);
    EXPECT_NEAR(x, dx, 0.1);
    EXPECT_NEAR(y, dy, 0.1);
  }
}

TEST(Diagnose, SwappedChannels) {
  Picture test = scene();
  for (std::size_t i = 0; i < test.samples.size(); i += 3) std::swap(test.samples[i], test.samples[i + 2]);
  EXPECT_EQ(first(test).what, "swapped channels");
  EXPECT_THAT(first(test).detail, HasSubstr("b, g, r"));
}

TEST(Diagnose, LightOfAnotherColour) {
  Picture test = scene();
  const double gain[3] = {1.1, 1, 0.8};
  for (std::size_t i = 0; i < test.samples.size(); ++i)
    test.samples[i] = static_cast<float>(
        std::round(255 * linear_to_srgb(std::min(1.0, gain[i % 3] * srgb_to_linear(test.samples[i])))) / 255);
  EXPECT_EQ(first(test).what, "color balance") << first(test).detail;
}

TEST(Diagnose, Mirrored) {
  Picture test = scene();
  for (int y = 0; y < test.height; ++y)
    for (int x = 0; x < test.width / 2; ++x)
      for (int c = 0; c < 3; ++c)
        std::swap(test.samples[static_cast<std::size_t>(3 * (y * test.width + x) + c)],
                  test.samples[static_cast<std::size_t>(3 * (y * test.width + test.width - 1 - x) + c)]);
  EXPECT_EQ(first(test).what, "mirrored");
}

TEST(Diagnose, FewPixels) {
  Picture test = scene();
  for (int i = 0; i < 20; ++i)
    test.samples[static_cast<std::size_t>(997 * i)] = 1 - test.samples[static_cast<std::size_t>(997 * i)];
  EXPECT_EQ(first(test).what, "few pixels");
}

TEST(Diagnose, NoiseIsNoneOfThem) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 6);
  EXPECT_EQ(first(rounded(scene(), [&](double v) { return v + noise(random); })).what, "nothing");
}

TEST(Diagnose, OnePixelAndNan) {
  EXPECT_NO_THROW(diagnose(constant_picture(1, 1, 1, 2, 3), constant_picture(1, 1, 9, 2, 3)));
  Picture broken = scene();
  broken.is_float = true;
  broken.samples[7] = NAN;
  EXPECT_NO_THROW(diagnose(broken, broken));
  EXPECT_THROW(diagnose(scene(), constant_picture(1, 1, 0, 0, 0)), PictureMismatch);
}

}  // namespace
}  // namespace verisim::compare
