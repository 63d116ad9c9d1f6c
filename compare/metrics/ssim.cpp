#include "compare/metrics/ssim.h"

#include <algorithm>
#include <array>

namespace verisim::compare {
namespace {

constexpr double kC1 = (0.01 * 255) * (0.01 * 255), kC2 = (0.03 * 255) * (0.03 * 255);

// Weighted sums of a window; the weights sum to one in the end.
struct Moments {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  double ssim() const {
    const double var_a = std::max(0.0, aa - a * a), var_b = std::max(0.0, bb - b * b), cov = ab - a * b;
    return (2 * a * b + kC1) * (2 * cov + kC2) / ((a * a + b * b + kC1) * (var_a + var_b + kC2));
  }
};

std::vector<double> window(int side) {
  const int n = std::min(11, side);
  std::vector<double> w;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double d = i - 0.5 * (n - 1);
    w.push_back(std::exp(-d * d / (2 * 1.5 * 1.5)));
    sum += w.back();
  }
  for (double& v : w) v /= sum;
  return w;
}

}  // namespace

double ssim_mean(const Values& reference, const Values& test) {
  const int w = reference.width(), h = reference.height();
  const std::vector<double> across = window(w), down = window(h);
  const int columns = w - static_cast<int>(across.size()) + 1, n = static_cast<int>(down.size());
  // The row moments of the last n rows, in a ring.
  std::vector<std::vector<Moments>> ring(down.size(), std::vector<Moments>(static_cast<std::size_t>(columns)));
  std::vector<double> a(static_cast<std::size_t>(w)), b(a);
  double total = 0;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) a[x] = reference.luma(x, y), b[x] = test.luma(x, y);
    for (int x = 0; x < columns; ++x) {
      Moments m;
      for (std::size_t i = 0; i < across.size(); ++i) {
        const double k = across[i], p = a[x + i], q = b[x + i];
        m.a += k * p, m.b += k * q, m.aa += k * p * p, m.bb += k * q * q, m.ab += k * p * q;
      }
      ring[y % n][x] = m;
    }
    if (y + 1 < n) continue;
    for (int x = 0; x < columns; ++x) {
      Moments m;
      for (int j = 0; j < n; ++j) {
        const Moments& r = ring[(y + 1 - n + j) % n][x];
        const double k = down[j];
        m.a += k * r.a, m.b += k * r.b, m.aa += k * r.aa, m.bb += k * r.bb, m.ab += k * r.ab;
      }
      total += m.ssim();
    }
  }
  return total / (static_cast<double>(columns) * (h - n + 1));
}

double ssim_block_min(const Values& reference, const Values& test) {
  double worst = 1;
  for (int y0 = 0; y0 < reference.height(); y0 += 8)
    for (int x0 = 0; x0 < reference.width(); x0 += 8) {
      const int x1 = std::min(x0 + 8, reference.width()), y1 = std::min(y0 + 8, reference.height());
      const double k = 1.0 / ((x1 - x0) * (y1 - y0));
      Moments m;
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
          const double p = reference.luma(x, y), q = test.luma(x, y);
          m.a += k * p, m.b += k * q, m.aa += k * p * p, m.bb += k * q * q, m.ab += k * p * q;
        }
      worst = std::min(worst, m.ssim());
    }
  return worst;
}

}  // namespace verisim::compare
