#include "compare/verdict/welch.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/metrics/rounding.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

// Continued fraction of the incomplete beta function (Lentz's method; DLMF 8.17.22).
double beta_fraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  const auto guard = [](double v) { return std::fabs(v) < kTiny ? kTiny : v; };
  double c = 1, d = 1 / guard(1 - (a + b) * x / (a + 1)), h = d;
  for (int m = 1; m <= 500; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / guard(1 + even * d), c = guard(1 + even / c), h *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / guard(1 + odd * d), c = guard(1 + odd / c);
    h *= d * c;
    if (std::fabs(d * c - 1) < 1e-14) break;
  }
  return h;
}

double incomplete_beta(double a, double b, double x) {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
  return x < (a + 1) / (a + b + 2) ? front * beta_fraction(a, b, x) / a : 1 - front * beta_fraction(b, a, 1 - x) / b;
}

struct Sample {
  double mean = 0, variance = 0;  // unbiased
};
Sample describe(const std::vector<double>& v) {
  Sample s;
  for (double x : v) s.mean += x;
  s.mean /= static_cast<double>(v.size());
  for (double x : v) s.variance += (x - s.mean) * (x - s.mean);
  s.variance /= static_cast<double>(v.size() - 1);
  return s;
}

// Welch (1947); degrees of freedom by Satterthwaite. The floor is a known part of the variance: it does not lower the
// degrees of freedom below n - 1.
struct Statistic {
  double t = 0, degrees_of_freedom = 1;
  double p() const { return student_two_sided(t, degrees_of_freedom); }
};
Statistic welch_statistic(const std::vector<double>& a, const std::vector<double>& b, double variance_floor) {
  const Sample p = describe(a), q = describe(b);
  const double na = static_cast<double>(a.size()), nb = static_cast<double>(b.size());
  const double va = std::max(p.variance, variance_floor) / na, vb = std::max(q.variance, variance_floor) / nb;
  return {(q.mean - p.mean) / std::sqrt(va + vb), (va + vb) * (va + vb) / (va * va / (na - 1) + vb * vb / (nb - 1))};
}

// All runs of both sides: the luma of every pixel, and the mean of every picture.
struct Runs {
  std::size_t pixels = 0;
  int width = 0;
  std::vector<std::vector<float>> luma;
  std::vector<double> means;

  void add(const Picture& picture) {
    const Values v(picture);
    width = v.width(), pixels = static_cast<std::size_t>(v.width()) * static_cast<std::size_t>(v.height());
    std::vector<float>& values = luma.emplace_back();
    double sum = 0;
    for (int y = 0; y < v.height(); ++y)
      for (int x = 0; x < v.width(); ++x) values.push_back(static_cast<float>(v.luma(x, y))), sum += values.back();
    means.push_back(sum / static_cast<double>(pixels));
  }
};

// The smallest p over the pixels, and that of the means, when the runs marked `test` are one side and the others the
// other.
struct Outcome {
  double pixel_p = 1, mean_p = 1, mean_difference = 0;
  std::size_t worst = 0;
};
Outcome divided(const Runs& runs, const std::vector<bool>& test) {
  constexpr double kMeanFloor = 0.05 * 0.05;
  Outcome out;
  std::vector<double> a, b;
  const auto statistic = [&](const auto& value, double floor) {
    a.clear(), b.clear();
    for (std::size_t i = 0; i < test.size(); ++i) (test[i] ? b : a).push_back(value(i));
    return welch_statistic(a, b, floor);
  };
  // With more degrees of freedom the same t is less probable: a t below this one cannot be the smallest p.
  const double most_degrees = static_cast<double>(test.size()) - 2;
  double worth = 0;
  for (std::size_t pixel = 0; pixel < runs.pixels; ++pixel) {
    const Statistic s =
        statistic([&](std::size_t i) { return static_cast<double>(runs.luma[i][pixel]); }, kRoundingVariance);
    if (std::fabs(s.t) <= worth) continue;
    const double p = s.p();
    if (!(p < out.pixel_p)) continue;
    out.pixel_p = p, out.worst = pixel;
    double low = worth, high = std::fabs(s.t);
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (student_two_sided(middle, most_degrees) > p ? low : high) = middle;
    }
    worth = low;
  }
  out.mean_p = statistic([&](std::size_t i) { return runs.means[i]; }, kMeanFloor).p();
  out.mean_difference = describe(b).mean - describe(a).mean;
  return out;
}

// Are the two sides more unlike than any other way to divide the same runs into two? Noise is not normal (a pixel that
// is black in one run of eight), and Student's distribution then promises too much; but runs of one renderer can be
// exchanged, so each division is as probable as the other.
struct Extreme {
  bool pixel = true, mean = true;
};
Extreme most_extreme(const Runs& runs, std::size_t references, const Outcome& observed, bool ask_pixel, bool ask_mean) {
  constexpr int kMaxDivisions = 400;
  const std::size_t n = runs.luma.size();
  std::vector<bool> original(n);
  for (std::size_t i = references; i < n; ++i) original[i] = true;
  std::vector<bool> mirrored(original);
  mirrored.flip();
  std::vector<bool> division(n, false);
  std::fill(division.end() - static_cast<std::ptrdiff_t>(n - references), division.end(), true);
  std::sort(division.begin(), division.end());
  Extreme out{ask_pixel, ask_mean};
  int seen = 0;
  do {
    if (division == original || (division == mirrored && 2 * references == n)) continue;
    if (2 * references == n && division[0]) continue;  // the same two halves, exchanged
    const Outcome other = divided(runs, division);
    out.pixel = out.pixel && other.pixel_p > observed.pixel_p;
    out.mean = out.mean && other.mean_p > observed.mean_p;
  } while ((out.pixel || out.mean) && ++seen < kMaxDivisions &&
           std::next_permutation(division.begin(), division.end()));
  return out;
}

}  // namespace

std::vector<float> pixel_p_values(const std::vector<Picture>& reference, const std::vector<Picture>& test) {
  Runs runs;
  for (const auto* side : {&reference, &test})
    for (const Picture& picture : *side) require_same_size(reference[0], picture), runs.add(picture);
  std::vector<float> out;
  std::vector<double> a(reference.size()), b(test.size());
  for (std::size_t pixel = 0; pixel < runs.pixels; ++pixel) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = runs.luma[i][pixel];
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = runs.luma[a.size() + i][pixel];
    out.push_back(static_cast<float>(welch_statistic(a, b, kRoundingVariance).p()));
  }
  return out;
}

std::string WelchResult::text() const {
  return mean_p < pixel_p ? fmt::format("the means differ by {:+.3f} (p = {:.2g})", mean_difference, mean_p)
                          : fmt::format("pixel {}, {} differs (p = {:.2g})", worst_x, worst_y, pixel_p);
}

double student_two_sided(double t, double nu) { return incomplete_beta(0.5 * nu, 0.5, nu / (nu + t * t)); }

WelchResult welch_test(const std::vector<Picture>& reference, const std::vector<Picture>& test, double significance) {
  if (reference.size() < 2 || test.size() < 2)
    throw PictureMismatch("Welch's test needs at least two pictures on each side");
  Runs runs;
  std::vector<bool> sides;
  for (const auto* side : {&reference, &test})
    for (const Picture& picture : *side) {
      require_same_size(reference[0], picture);
      runs.add(picture), sides.push_back(side == &test);
    }
  const Outcome observed = divided(runs, sides);
  WelchResult out;
  out.worst_x = static_cast<int>(observed.worst % static_cast<std::size_t>(runs.width)),
  out.worst_y = static_cast<int>(observed.worst / static_cast<std::size_t>(runs.width));
  out.pixel_p = -std::expm1(static_cast<double>(runs.pixels) * std::log1p(-std::min(observed.pixel_p, 1 - 1e-16)));
  out.mean_p = observed.mean_p, out.mean_difference = observed.mean_difference;
  const double each = 1 - std::sqrt(1 - significance);
  const bool pixel = out.pixel_p < each, mean = out.mean_p < each;
  if (!pixel && !mean) return out;
  const Extreme extreme = most_extreme(runs, reference.size(), observed, pixel, mean);
  out.rejected = extreme.pixel || extreme.mean;
  return out;
}

}  // namespace verisim::compare
