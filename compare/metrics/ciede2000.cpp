#include "compare/metrics/ciede2000.h"

#include <numbers>

namespace verisim::compare {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double hue(double b, double a) {  // degrees, 0..360; 0 for grey
  if (a == 0 && b == 0) return 0;
  const double h = std::atan2(b, a) / kDegree;
  return h < 0 ? h + 360 : h;
}
double pow7(double v) { return v * v * v * v * v * v * v; }

}  // namespace

Lab srgb_to_lab(const Rgb& value) {
  Rgb c;
  for (int i = 0; i < 3; ++i) c[i] = srgb_to_linear(value[i] / 255);
  const double xyz[3] = {(0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047,
                         0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2],
                         (0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883};
  constexpr double kEpsilon = 216.0 / 24389.0, kKappa = 24389.0 / 27.0;
  double f[3];
  for (int i = 0; i < 3; ++i) f[i] = xyz[i] > kEpsilon ? std::cbrt(xyz[i]) : (kKappa * xyz[i] + 16) / 116;
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

// The names are the paper's; k_L = k_C = k_H = 1.
double ciede2000(const Lab& first, const Lab& second) {
  const double c_mean = 0.5 * (std::hypot(first[1], first[2]) + std::hypot(second[1], second[2]));
  const double g = 0.5 * (1 - std::sqrt(pow7(c_mean) / (pow7(c_mean) + pow7(25))));
  const double a1 = (1 + g) * first[1], a2 = (1 + g) * second[1];
  const double c1 = std::hypot(a1, first[2]), c2 = std::hypot(a2, second[2]);
  const double h1 = hue(first[2], a1), h2 = hue(second[2], a2);

  double dh = 0, h_mean = h1 + h2;
  if (c1 * c2 != 0) {
    dh = h2 - h1;
    if (dh > 180) dh -= 360;
    if (dh < -180) dh += 360;
    if (std::fabs(h1 - h2) <= 180)
      h_mean = 0.5 * (h1 + h2);
    else
      h_mean = 0.5 * (h1 + h2 + (h1 + h2 < 360 ? 360 : -360));
  }
  const double delta_l = second[0] - first[0], delta_c = c2 - c1,
               delta_h = 2 * std::sqrt(c1 * c2) * std::sin(0.5 * dh * kDegree);

  const double l_mean = 0.5 * (first[0] + second[0]), cp_mean = 0.5 * (c1 + c2);
  const double t = 1 - 0.17 * std::cos((h_mean - 30) * kDegree) + 0.24 * std::cos(2 * h_mean * kDegree) +
                   0.32 * std::cos((3 * h_mean + 6) * kDegree) - 0.20 * std::cos((4 * h_mean - 63) * kDegree);
  const double delta_theta = 30 * std::exp(-((h_mean - 275) / 25) * ((h_mean - 275) / 25));
  const double r_c = 2 * std::sqrt(pow7(cp_mean) / (pow7(cp_mean) + pow7(25)));
  const double l50 = (l_mean - 50) * (l_mean - 50);
  const double s_l = 1 + 0.015 * l50 / std::sqrt(20 + l50), s_c = 1 + 0.045 * cp_mean, s_h = 1 + 0.015 * cp_mean * t;
  const double r_t = -std::sin(2 * delta_theta * kDegree) * r_c;
  const double l = delta_l / s_l, c = delta_c / s_c, h = delta_h / s_h;
  return std::sqrt(l * l + c * c + h * h + r_t * c * h);
}

}  // namespace verisim::compare
