#include "compare/metrics/welch.h"

#include <algorithm>

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
  const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
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

// Welch (1947); degrees of freedom by Satterthwaite. The floor is a known part of the variance: it does not lower the degrees of freedom below n - 1.
double welch_p(const std::vector<double>& a, const std::vector<double>& b, double variance_floor) {
  const Sample p = describe(a), q = describe(b);
  const double na = static_cast<double>(a.size()), nb = static_cast<double>(b.size());
  const double va = std::max(p.variance, variance_floor) / na, vb = std::max(q.variance, variance_floor) / nb;
  const double t = (q.mean - p.mean) / std::sqrt(va + vb);
  return student_two_sided(t, (va + vb) * (va + vb) / (va * va / (na - 1) + vb * vb / (nb - 1)));
}

}  // namespace

double student_two_sided(double t, double nu) { return incomplete_beta(0.5 * nu, 0.5, nu / (nu + t * t)); }

WelchResult welch_test(const std::vector<Picture>& reference, const std::vector<Picture>& test, double significance) {
  constexpr double kRounding = 1.0 / 12, kMeanFloor = 0.05 * 0.05;
  if (reference.size() < 2 || test.size() < 2) throw PictureMismatch("Welch's test needs at least two pictures on each side");
  for (const auto* side : {&reference, &test})
    for (const Picture& picture : *side) require_same_size(reference[0], picture);
  const std::vector<Values> a(reference.begin(), reference.end()), b(test.begin(), test.end());
  const int w = a[0].width(), h = a[0].height();

  WelchResult out;
  std::vector<double> pa(a.size()), pb(b.size()), mean_a(a.size()), mean_b(b.size());
  double smallest = 1;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      for (std::size_t i = 0; i < a.size(); ++i) mean_a[i] += pa[i] = a[i].luma(x, y);
      for (std::size_t i = 0; i < b.size(); ++i) mean_b[i] += pb[i] = b[i].luma(x, y);
      if (const double p = welch_p(pa, pb, kRounding); p < smallest) smallest = p, out.worst_x = x, out.worst_y = y;
    }
  const double pixels = static_cast<double>(w) * h;
  for (double& v : mean_a) v /= pixels;
  for (double& v : mean_b) v /= pixels;
  out.pixel_p = -std::expm1(pixels * std::log1p(-std::min(smallest, 1 - 1e-16)));
  out.mean_p = welch_p(mean_a, mean_b, kMeanFloor);
  out.mean_difference = describe(mean_b).mean - describe(mean_a).mean;
  const double each = 1 - std::sqrt(1 - significance);
  out.rejected = out.pixel_p < each || out.mean_p < each;
  return out;
}

}  // namespace verisim::compare
