#include "compare/metrics/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "compare/metrics/test_pictures.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

double flip(const Picture& a, const Picture& b, double ppd = kDefaultPixelsPerDegree) {
  return mean(ldr_flip(a, b, ppd));
}

TEST(Flip, PixelsPerDegreeOfThePapersViewer) { EXPECT_NEAR(pixels_per_degree(0.7, 3840, 0.7), 67.0206, 5e-5); }

TEST(Flip, EqualPicturesHaveNoError) {
  for (float e : ldr_flip(random_picture(40, 30, 1), random_picture(40, 30, 1))) EXPECT_EQ(e, 0);
}

TEST(Flip, IsSymmetric) {
  const Picture a = random_picture(40, 30, 1), b = scene_like_picture(40, 30);
  EXPECT_NEAR(flip(a, b), flip(b, a), 1e-7);
}

// The largest colour difference of the model, by definition.
TEST(Flip, GreenAgainstBlueIsOne) {
  EXPECT_NEAR(flip(constant_picture(9, 9, 0, 255, 0), constant_picture(9, 9, 0, 0, 255)), 1, 1e-6);
}

// HyAB of black and white is 100; the paper's c_max is 41.2760: 0.95 + 0.05 (100^0.7 - 0.4 c_max) / (0.6 c_max).
TEST(Flip, BlackAgainstWhite) {
  const double c_max = 41.2760, expected = 0.95 + 0.05 * (std::pow(100, 0.7) - 0.4 * c_max) / (0.6 * c_max);
  EXPECT_NEAR(flip(constant_picture(9, 9, 0, 0, 0), constant_picture(9, 9, 255, 255, 255)), expected, 1e-5);
}

// Two greys: only lightness differs, and flat pictures have no features.
TEST(Flip, GreysByHand) {
  const auto lightness = [](double v) { return 116 * std::cbrt(srgb_to_linear(v / 255)) - 16; };
  const double distance = std::pow(lightness(140) - lightness(128), 0.7);
  EXPECT_NEAR(flip(constant_picture(20, 20, 128, 128, 128), constant_picture(20, 20, 140, 140, 140)),
              0.95 / (0.4 * 41.2760) * distance, 1e-5);
}

TEST(Flip, RefusesDifferentSizesAndNonsense) {
  EXPECT_THROW(flip(random_picture(4, 4, 1), random_picture(5, 4, 1)), PictureMismatch);
  EXPECT_THROW(flip(random_picture(4, 4, 1), random_picture(4, 4, 1), 0), std::invalid_argument);
  EXPECT_THROW(flip(random_picture(4, 4, 1), random_picture(4, 4, 1), -3), std::invalid_argument);
  EXPECT_THROW(flip(random_picture(4, 4, 1), random_picture(4, 4, 1), NAN), std::invalid_argument);
}

TEST(Flip, OnePixel) {
  EXPECT_NEAR(flip(constant_picture(1, 1, 0, 255, 0), constant_picture(1, 1, 0, 0, 255)), 1, 1e-6);
}

// The same model a second time, as the paper writes it: whole pictures, square kernels, no separation, no bands.
class Plain {
 public:
  explicit Plain(double ppd) : ppd_(ppd) {}

  std::vector<double> errors(const Picture& a, const Picture& b) const {
    const Look p = look(a), q = look(b);
    const Rgb green = hunt({0, 1, 0}), blue = hunt({0, 0, 1});
    const double c_max = std::pow(hyab(green, blue), 0.7), knee = 0.4 * c_max;
    std::vector<double> out;
    for (std::size_t i = 0; i < p.lab.size(); ++i) {
      const double d = std::pow(hyab(p.lab[i], q.lab[i]), 0.7);
      const double color = d < knee ? 0.95 / knee * d : 0.95 + (d - knee) / (c_max - knee) * 0.05;
      const double feature =
          std::pow(std::max(std::fabs(p.edge[i] - q.edge[i]), std::fabs(p.point[i] - q.point[i])) / std::sqrt(2), 0.5);
      out.push_back(std::pow(color, 1 - feature));
    }
    return out;
  }

 private:
  struct Look {
    std::vector<Rgb> lab;
    std::vector<double> edge, point;
  };
  using Grid = std::vector<double>;  // (2 r + 1)^2

  static double hyab(const Rgb& a, const Rgb& b) {
    return std::fabs(a[0] - b[0]) + std::sqrt((a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
  }
  static Rgb xyz(const Rgb& c) {  // sRGB primaries
    return {(10135552.0 * c[0] + 8788810.0 * c[1] + 4435075.0 * c[2]) / 24577794.0,
            (2613072.0 * c[0] + 8788810.0 * c[1] + 887015.0 * c[2]) / 12288897.0,
            (1425312.0 * c[0] + 8788810.0 * c[1] + 70074185.0 * c[2]) / 73733382.0};
  }
  static constexpr Rgb kWhite = {0.950428545, 1.0, 1.088900371};
  static Rgb rgb(const Rgb& v) {  // the inverse by Cramer's rule
    const Rgb a = xyz({1, 0, 0}), b = xyz({0, 1, 0}), c = xyz({0, 0, 1});
    const auto det = [](const Rgb& p, const Rgb& q, const Rgb& r) {
      return p[0] * (q[1] * r[2] - q[2] * r[1]) - q[0] * (p[1] * r[2] - p[2] * r[1]) +
             r[0] * (p[1] * q[2] - p[2] * q[1]);
    };
    const double d = det(a, b, c);
    return {det(v, b, c) / d, det(a, v, c) / d, det(a, b, v) / d};
  }
  static Rgb hunt(const Rgb& linear) {
    const Rgb v = xyz(linear);
    const auto f = [](double t) {
      return t > std::pow(6.0 / 29, 3) ? std::pow(t, 1.0 / 3) : t * 29 * 29 / (3.0 * 36) + 4.0 / 29;
    };
    const double x = f(v[0] / kWhite[0]), y = f(v[1] / kWhite[1]), z = f(v[2] / kWhite[2]), l = 116 * y - 16;
    return {l, 0.01 * l * 500 * (x - y), 0.01 * l * 200 * (y - z)};
  }

  Grid csf(double a1, double b1, double a2, double b2, int r) const {
    Grid g;
    double sum = 0;
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x) {
        const double d2 = (x * x + y * y) / (ppd_ * ppd_), pi = std::numbers::pi;
        g.push_back(a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * d2 / b1) +
                    a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * d2 / b2));
        sum += g.back();
      }
    for (double& v : g) v /= sum;
    return g;
  }
  Grid feature(bool point, bool vertical, int r) const {
    const double sd = 0.5 * 0.082 * ppd_;
    Grid g;
    double positive = 0, negative = 0;
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x) {
        const double u = vertical ? y : x, gauss = std::exp(-(x * x + y * y) / (2 * sd * sd));
        const double v = point ? (u * u / (sd * sd) - 1) * gauss : -u * gauss;
        g.push_back(v);
        (v > 0 ? positive : negative) += std::fabs(v);
      }
    for (double& v : g) v /= v > 0 ? positive : negative;
    return g;
  }
  static double apply(const Grid& g, int r, const Picture& p, int x, int y, const std::vector<double>& plane) {
    double sum = 0;
    for (int j = -r; j <= r; ++j)
      for (int i = -r; i <= r; ++i) {
        const int u = std::clamp(x + i, 0, p.width - 1), v = std::clamp(y + j, 0, p.height - 1);
        sum += g[static_cast<std::size_t>((j + r) * (2 * r + 1) + i + r)] *
               plane[static_cast<std::size_t>(v * p.width + u)];
      }
    return sum;
  }

  Look look(const Picture& p) const {
    std::vector<double> plane[3], luminance;
    for (std::size_t i = 0; i < p.samples.size(); i += 3) {
      const Rgb v =
          xyz({srgb_to_linear(p.samples[i]), srgb_to_linear(p.samples[i + 1]), srgb_to_linear(p.samples[i + 2])});
      const double x = v[0] / kWhite[0], y = v[1], z = v[2] / kWhite[2];
      plane[0].push_back(116 * y - 16), plane[1].push_back(500 * (x - y)), plane[2].push_back(200 * (y - z)),
          luminance.push_back(y);
    }
    const int r = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * std::numbers::pi * std::numbers::pi)) * ppd_));
    const Grid kernel[3] = {csf(1, 0.0047, 0, 1e-5, r), csf(1, 0.0053, 0, 1e-5, r), csf(34.1, 0.04, 13.5, 0.025, r)};
    const int fr = static_cast<int>(std::ceil(3 * 0.5 * 0.082 * ppd_));
    Look out;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x) {
        double o[3];
        for (int c = 0; c < 3; ++c) o[c] = apply(kernel[c], r, p, x, y, plane[c]);
        const double l = (o[0] + 16) / 116;
        Rgb linear = rgb({(l + o[1] / 500) * kWhite[0], l, (l - o[2] / 200) * kWhite[2]});
        for (double& v : linear) v = std::clamp(v, 0.0, 1.0);
        out.lab.push_back(hunt(linear));
        const auto norm = [&](bool point) {
          return std::hypot(apply(feature(point, false, fr), fr, p, x, y, luminance),
                            apply(feature(point, true, fr), fr, p, x, y, luminance));
        };
        out.edge.push_back(norm(false)), out.point.push_back(norm(true));
      }
    return out;
  }

  double ppd_;
};

void expect_the_papers_formulas(const Picture& a, const Picture& b, const std::vector<double>& viewers) {
  for (double ppd : viewers) {
    if (ppd > 70 && a.height > 40) continue;  // square kernels are slow
    const std::vector<double> expected = Plain(ppd).errors(a, b);
    const std::vector<float> got = ldr_flip(a, b, ppd);
    ASSERT_EQ(expected.size(), got.size());
    for (std::size_t i = 0; i < got.size(); ++i)
      ASSERT_NEAR(got[i], expected[i], 2e-6)
          << "pixel " << i << " of " << a.width << "x" << a.height << " at " << ppd << " pixels per degree";
  }
}

TEST(Flip, EqualsThePapersFormulasAtSeveralViewingDistances) {
  const std::pair<Picture, Picture> pairs[] = {
      {scene_like_picture(31, 23),
       changed(scene_like_picture(31, 23), [](double v) { return std::min(255.0, v + 9); })},
      {random_picture(17, 70, 3), random_picture(17, 70, 4)},  // more rows than one band
      {scene_like_picture(24, 24), random_picture(24, 24, 5)}};
  for (const auto& [a, b] : pairs) expect_the_papers_formulas(a, b, {4.0, 20.0, 67.0206, 90.5});
}

// Everything is border here.
TEST(Flip, EqualsThePapersFormulasOnPicturesSmallerThanTheKernels) {
  for (const auto& [w, h] : {std::pair(1, 1), std::pair(2, 1), std::pair(1, 9), std::pair(3, 5), std::pair(13, 2)})
    expect_the_papers_formulas(random_picture(w, h, 6), random_picture(w, h, 7), {1.0, 30.0, 67.0206, 120.0});
}

TEST(Flip, EqualsThePapersFormulasOnSixteenBitPictures) {
  Picture a = random_picture(20, 14, 8), b = random_picture(20, 14, 9);
  a.bits = b.bits = 16;
  for (Picture* p : {&a, &b})
    for (float& v : p->samples)
      v = static_cast<float>(std::floor(65535 * std::fmod(7.31 * static_cast<double>(v) + 0.01, 1.0)) / 65535);
  expect_the_papers_formulas(a, b, {15.0, 67.0206});
}

Picture float_picture(Picture p, double scale) {
  p.is_float = true, p.bits = 32;
  for (float& v : p.samples) v = static_cast<float>(v * scale);
  return p;
}

// aces(x) = 0.85 for the brightest pixel and for the median: solved by bisection here.
TEST(HdrFlip, ExposuresBringTheBrightestAndTheMedianTo85Percent) {
  const auto aces = [](double x) {
    return (0.36 * 2.51 * x * x + 0.6 * 0.03 * x) / (0.36 * 2.43 * x * x + 0.6 * 0.59 * x + 0.14);
  };
  Picture p = float_picture(constant_picture(5, 1, 255, 255, 255), 1);
  for (int i = 0; i < 5; ++i)
    for (int c = 0; c < 3; ++c)
      p.samples[static_cast<std::size_t>(3 * i + c)] =
          static_cast<float>(std::pow(4.0, i));  // median 16, brightest 256
  const Exposures e = hdr_flip_exposures(p);
  EXPECT_NEAR(aces(std::exp2(e.start) * 256), 0.85, 1e-6);
  EXPECT_NEAR(aces(std::exp2(e.stop) * 16), 0.85, 1e-6);
  EXPECT_NEAR(e.stop - e.start, 4, 1e-6);
  EXPECT_TRUE(e.count == 4 || e.count == 5);  // ceil of 4 up to rounding
}

// Of an even number of luminances the lower of the two in the middle counts, as torch.median has it.
TEST(HdrFlip, MedianOfAnEvenNumberIsTheLower) {
  Picture p = float_picture(constant_picture(4, 1, 255, 255, 255), 1);
  for (int i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c)
      p.samples[static_cast<std::size_t>(3 * i + c)] = static_cast<float>(std::pow(4.0, i));  // 1 4 16 64
  const Exposures e = hdr_flip_exposures(p);
  EXPECT_NEAR(e.stop - e.start, 4, 1e-5);  // 64 over 4
}

TEST(HdrFlip, OfOneExposureIsLdrFlipOfToneMappedPictures) {
  const Picture a = float_picture(scene_like_picture(30, 20), 3), b = float_picture(scene_like_picture(30, 20), 2.5);
  const auto mapped = [](const Picture& p, double stops) {
    Picture out = p;
    out.is_float = false, out.bits = 16;
    for (float& v : out.samples) {
      const double x = std::exp2(stops) * v;
      v = static_cast<float>(linear_to_srgb(std::clamp(
          (0.36 * 2.51 * x * x + 0.6 * 0.03 * x) / (0.36 * 2.43 * x * x + 0.6 * 0.59 * x + 0.14), 0.0, 1.0)));
    }
    return out;
  };
  const std::vector<float> expected_1 = ldr_flip(mapped(a, -1), mapped(b, -1)),
                           expected_2 = ldr_flip(mapped(a, 2), mapped(b, 2));
  const std::vector<float> got = hdr_flip(a, b, kDefaultPixelsPerDegree, {-1, 2, 2});
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], std::max(expected_1[i], expected_2[i]), 1e-5);
}

// The whole of HDR-FLIP a second time: exposures by bisection, the plain pipeline on tone-mapped pictures, the largest
// error of each pixel.
TEST(HdrFlip, EqualsThePapersFormulas) {
  const auto aces = [](double x) {
    x *= 0.6;
    return std::clamp((2.51 * x * x + 0.03 * x) / (2.43 * x * x + 0.59 * x + 0.14), 0.0, 1.0);
  };
  double low = 0, high = 100;
  for (int i = 0; i < 200; ++i) (aces(0.5 * (low + high)) < 0.85 ? low : high) = 0.5 * (low + high);
  std::mt19937 random(11);
  std::normal_distribution<double> stops(0, 2.5);
  for (const auto& [w, h] : {std::pair(23, 17), std::pair(4, 3), std::pair(1, 1)}) {
    Picture a = float_picture(random_picture(w, h, 3), 1), b = a;
    for (float& v : a.samples) v = static_cast<float>(std::exp2(stops(random)));
    for (std::size_t i = 0; i < b.samples.size(); ++i)
      b.samples[i] = static_cast<float>(a.samples[i] * std::exp2(0.1 * stops(random)));
    std::vector<double> luminance;
    for (std::size_t i = 0; i < a.samples.size(); i += 3)
      luminance.push_back(0.2126 * a.samples[i] + 0.7152 * a.samples[i + 1] + 0.0722 * a.samples[i + 2]);
    std::sort(luminance.begin(), luminance.end());
    const double start = std::log2(low / luminance.back()),
                 stop = std::log2(low / luminance[(luminance.size() - 1) / 2]);
    const int count = std::max(2, static_cast<int>(std::ceil(stop - start)));
    for (double ppd : {12.0, 67.0206}) {
      std::vector<double> expected(luminance.size());
      for (int i = 0; i < count; ++i) {
        const double gain = std::exp2(start + i * (stop - start) / (count - 1));
        const auto mapped = [&](const Picture& p) {
          Picture out = p;
          for (float& v : out.samples) v = static_cast<float>(linear_to_srgb(aces(gain * v)));
          return out;
        };
        const std::vector<double> error = Plain(ppd).errors(mapped(a), mapped(b));
        for (std::size_t p = 0; p < error.size(); ++p) expected[p] = std::max(expected[p], error[p]);
      }
      const std::vector<float> got = hdr_flip(a, b, ppd);
      for (std::size_t p = 0; p < got.size(); ++p)
        ASSERT_NEAR(got[p], expected[p], 2e-5) << "pixel " << p << " of " << w << "x" << h << " at " << ppd;
    }
  }
}

TEST(HdrFlip, SurvivesBlackNegativeAndInfinitePixels) {
  Picture a = float_picture(constant_picture(6, 4, 0, 0, 0), 1), b = a;
  b.samples[0] = INFINITY, b.samples[4] = NAN, b.samples[9] = -3;
  for (float e : hdr_flip(a, b)) EXPECT_TRUE(std::isfinite(e));
}

}  // namespace
}  // namespace verisim::compare
