#include "tracer/shading/dispersion.h"

#include <array>

namespace verisim::shading {
namespace {

constexpr int kNodes = 74;  // at 375 + 5 k nm

double red(double h) {
  double v = 1.15 - 25 * (h - 0.75) * (h - 0.75);
  if (v < 0) v = 0.12 - 16 * (h - 0.12) * (h - 0.12);
  return std::max(v, 0.0);
}
double green(double h) { return std::max(0.0, 0.97 * (1.1 - 4.5 * 4.5 * (h - 0.57) * (h - 0.57))); }
double blue(double h) { return std::max(0.0, 0.98 * (1 - 16 * (h - 0.28) * (h - 0.28))); }

std::array<Rgb, kNodes> make_nodes() {
  std::array<std::array<double, 3>, kNodes> sums{};
  for (int k = 1; k < kNodes; ++k) {
    const double h = 0.03 + 0.934 * k / 73;
    sums[k] = {sums[k - 1][0] + red(h), sums[k - 1][1] + green(h), sums[k - 1][2] + blue(h)};
  }
  const auto rounded = [&](int k, int c) {
    return static_cast<float>(std::round(sums[k][c] / sums[kNodes - 1][c] * 1e4) / 1e4);
  };
  std::array<Rgb, kNodes> nodes;
  for (int k = 0; k < kNodes; ++k) nodes[k] = {rounded(k, 0), rounded(k, 1), rounded(k, 2)};
  return nodes;
}

}  // namespace

Rgb cumulative_hue(double wavelength) {
  static const auto nodes = make_nodes();
  const double position = (wavelength - 375) / 5;
  if (position <= 0) return nodes.front();
  if (position >= kNodes - 1) return nodes.back();
  const int k = static_cast<int>(position);
  const auto f = static_cast<float>(position - k);
  return nodes[k] * (1 - f) + nodes[k + 1] * f;
}

Rgb spectral_weight(int i, int n) {
  const double width = 350.0 / n, wavelength = spectral_wavelength(i, n);
  return static_cast<float>(n) * (cumulative_hue(wavelength + width / 2) - cumulative_hue(wavelength - width / 2));
}

double ratio_at(double ratio, double dispersion, double wavelength) {
  return ratio * std::pow(dispersion, (555 - static_cast<double>(static_cast<float>(wavelength))) / 350);
}

}  // namespace verisim::shading
