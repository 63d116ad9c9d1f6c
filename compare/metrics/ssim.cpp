#include "compare/metrics/ssim.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "tracer/base/parallel.h"

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

namespace {

constexpr int kChunk = 64;  // rows that one thread works on

// The sums of the windows that end in the rows from begin to end, row by row; `each`, if given, is told every window.
template <typename Each>
void add_windows(const Values& reference, const Values& test, int begin, int end, double* sums, const Each& each) {
  const int w = reference.width();
  const std::vector<double> across = window(w), down = window(reference.height());
  const int columns = w - static_cast<int>(across.size()) + 1, n = static_cast<int>(down.size());
  // The row moments of the last n rows, in a ring.
  std::vector<std::vector<Moments>> ring(down.size(), std::vector<Moments>(static_cast<std::size_t>(columns)));
  std::vector<double> a(static_cast<std::size_t>(w)), b(a);
  for (int y = std::max(0, begin + 1 - n); y < end; ++y) {
    for (int x = 0; x < w; ++x) a[x] = reference.luma(x, y), b[x] = test.luma(x, y);
    for (int x = 0; x < columns; ++x) {
      Moments m;
      for (std::size_t i = 0; i < across.size(); ++i) {
        const double k = across[i], p = a[x + i], q = b[x + i];
        m.a += k * p, m.b += k * q, m.aa += k * p * p, m.bb += k * q * q, m.ab += k * p * q;
      }
      ring[y % n][x] = m;
    }
    if (y < begin || y + 1 < n) continue;
    double sum = 0;
    for (int x = 0; x < columns; ++x) {
      Moments m;
      for (int j = 0; j < n; ++j) {
        const Moments& r = ring[(y + 1 - n + j) % n][x];
        const double k = down[j];
        m.a += k * r.a, m.b += k * r.b, m.aa += k * r.aa, m.bb += k * r.bb, m.ab += k * r.ab;
      }
      const double similarity = m.ssim();
      sum += similarity;
      each(x, y + 1 - n, similarity);
    }
    sums[y - begin] = sum;
  }
}

}  // namespace

double ssim_sum(const Values& reference, const Values& test, int begin, int end) {
  std::vector<double> sums(static_cast<std::size_t>(end - begin));
  parallel_for(static_cast<std::size_t>((end - begin + kChunk - 1) / kChunk), 1, [&](std::size_t chunk) {
    const int first = begin + static_cast<int>(chunk) * kChunk;
    add_windows(reference, test, first, std::min(end, first + kChunk), &sums[static_cast<std::size_t>(first - begin)],
                [](int, int, double) {});
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double ssim_windows(int width, int height) {
  return static_cast<double>(std::max(1, width - 10)) * std::max(1, height - 10);
}

double ssim_mean(const Values& reference, const Values& test) {
  return ssim_sum(reference, test, 0, reference.height()) / ssim_windows(reference.width(), reference.height());
}

std::vector<float> ssim_map(const Values& reference, const Values& test) {
  const int width = reference.width(), height = reference.height();
  const int columns = std::max(1, width - 10), rows = std::max(1, height - 10);
  std::vector<float> windows(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)), out;
  std::vector<double> sums(static_cast<std::size_t>(height));
  add_windows(reference, test, 0, height, sums.data(), [&](int x, int y, double similarity) {
    windows[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)] =
        static_cast<float>(similarity);
  });
  out.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      out.push_back(
          windows[static_cast<std::size_t>(std::clamp(y - 5, 0, rows - 1)) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(std::clamp(x - 5, 0, columns - 1))]);
  return out;
}

double ssim_block_min(const Values& reference, const Values& test) {
  return ssim_block_min(reference, test, 0, reference.height());
}

double ssim_block_min(const Values& reference, const Values& test, int begin, int end) {
  std::vector<double> worst(static_cast<std::size_t>((end - begin + 7) / 8), 1);
  parallel_for(worst.size(), 1, [&](std::size_t row) {
    const int y0 = begin + 8 * static_cast<int>(row), y1 = std::min(y0 + 8, end);
    for (int x0 = 0; x0 < reference.width(); x0 += 8) {
      const int x1 = std::min(x0 + 8, reference.width());
      const double k = 1.0 / ((x1 - x0) * (y1 - y0));
      Moments m;
      for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x) {
          const double p = reference.luma(x, y), q = test.luma(x, y);
          m.a += k * p, m.b += k * q, m.aa += k * p * p, m.bb += k * q * q, m.ab += k * p * q;
        }
      worst[row] = std::min(worst[row], m.ssim());
    }
  });
  return *std::min_element(worst.begin(), worst.end());
}

}  // namespace verisim::compare
