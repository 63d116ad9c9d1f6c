#include "compare/causes/registration.h"

namespace verisim::compare {
namespace {

constexpr int kMaxNumbers = 7;
// What shrinks to a few pixels, or grows from them, or comes from outside explains every loss of contrast. An object is
// known to be there.
constexpr double kMaxZoom = 0.5, kMaxZoomOfObject = 0.8, kMaxShift = 0.2;  // parts; of the picture's longer side

Pixel between(const Case& c, const Pixels& picture, double x, double y) {
  const double fx = std::floor(x), fy = std::floor(y);
  const auto u = static_cast<float>(x - fx), v = static_cast<float>(y - fy);
  const int i = static_cast<int>(std::clamp(fx, -2.0, c.width + 1.0)),
            j = static_cast<int>(std::clamp(fy, -2.0, c.height + 1.0));
  const Pixel &p = picture[c.clamped(i, j)], &q = picture[c.clamped(i + 1, j)], &r = picture[c.clamped(i, j + 1)],
              &s = picture[c.clamped(i + 1, j + 1)];
  Pixel out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = (1 - v) * ((1 - u) * p[k] + u * q[k]) + v * ((1 - u) * r[k] + u * s[k]);
  return out;
}

class Registration {
 public:
  Registration(const Case& c, const Freedom& f, double mx, double my, const Mask& mask,
               const std::vector<float>& nearness)
      : c_(c), f_(f), mx_(mx), my_(my), mask_(mask), nearness_(nearness) {}

  Registered run() {
    Registered out;
    for (const double sigma : {6.0, 3.0, 1.5}) {
      if (too_far()) break;
      a_ = blurred(c_, c_.reference, sigma), b_ = blurred(c_, c_.test, sigma);
      for (int i = 0; i < 6 && step(); ++i) {
      }
    }
    const Pixels still = a_, there = warped(a_);
    double before = 0, after = 0;
    for (std::size_t i = 0; i < c_.size(); ++i)
      if (looked_at(i)) before += squared_distance(still[i], b_[i]), after += squared_distance(there[i], b_[i]);
    out.explained = before > 0 && !too_far() ? 1 - after / before : 0;
    out.motion = m_, out.moved = too_far() ? c_.reference : warped(c_.reference);
    return out;
  }

 private:
  bool too_far() const {
    const double zoom = mask_.empty() ? kMaxZoom : kMaxZoomOfObject, shift = kMaxShift * std::max(c_.width, c_.height);
    return std::max(std::fabs(m_.zoom_x), std::fabs(m_.zoom_y)) > zoom ||
           std::max(std::fabs(m_.dx), std::fabs(m_.dy)) > shift;
  }
  bool looked_at(std::size_t i) const { return mask_.empty() || mask_[i]; }
  double near(std::size_t i) const { return f_.parallax ? nearness_[i] : 0; }
  std::pair<double, double> motion(double x, double y, double near) const {
    return {m_.dx + m_.zoom_x * x - m_.turn * y + m_.parallax_x * near,
            m_.dy + m_.zoom_y * y + m_.turn * x + m_.parallax_y * near};
  }
  Pixels warped(const Pixels& picture) const {
    Pixels out(c_.size());
    for (int y = 0; y < c_.height; ++y)
      for (int x = 0; x < c_.width; ++x) {
        const auto [u, v] = motion(x - mx_, y - my_, near(c_.at(x, y)));
        out[c_.at(x, y)] = between(c_, picture, x - u, y - v);
      }
    return out;
  }

  // One step: the change of the numbers that makes the difference smallest where the picture is as straight as its
  // slopes. False when it is small.
  bool step() {
    const Pixels there = warped(a_);
    std::array<std::array<double, kMaxNumbers + 1>, kMaxNumbers> equations{};
    int n = 0;
    for (int y = 0; y < c_.height; ++y)
      for (int x = 0; x < c_.width; ++x) {
        const std::size_t i = c_.at(x, y);
        if (!looked_at(i)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          const double gx = (there[c_.clamped(x + 1, y)][k] - there[c_.clamped(x - 1, y)][k]) / 2,
                       gy = (there[c_.clamped(x, y + 1)][k] - there[c_.clamped(x, y - 1)][k]) / 2;
          const std::array<double, kMaxNumbers> slope = slopes(gx, gy, x - mx_, y - my_, near(i), n);
          const double rest = b_[i][k] - there[i][k];
          for (int p = 0; p < n; ++p) {
            for (int q = 0; q < n; ++q) equations[p][q] += slope[p] * slope[q];
            equations[p][kMaxNumbers] += slope[p] * rest;
          }
        }
      }
    std::array<double, kMaxNumbers> change{};
    if (n == 0 || !solve(equations, n, change)) return false;
    return apply(change);
  }
  // How the picture changes with each free number.
  std::array<double, kMaxNumbers> slopes(double gx, double gy, double x, double y, double near, int& n) const {
    std::array<double, kMaxNumbers> out{};
    n = 0;
    if (f_.shift) out[n++] = -gx, out[n++] = -gy;
    if (f_.zoom) out[n++] = -gx * x - gy * y;
    if (f_.stretch) out[n++] = -gx * x, out[n++] = -gy * y;
    if (f_.turn) out[n++] = gx * y - gy * x;
    if (f_.parallax) out[n++] = -gx * near, out[n++] = -gy * near;
    return out;
  }
  bool apply(const std::array<double, kMaxNumbers>& d) {
    const double far = std::hypot(c_.width, c_.height) / 2;
    int n = 0;
    double largest = 0;
    const auto next = [&](double limit, double lever) {
      const double v = std::clamp(d[static_cast<std::size_t>(n++)], -limit, limit);
      largest = std::max(largest, std::fabs(v) * lever);
      return v;
    };
    if (f_.shift) m_.dx += next(4, 1), m_.dy += next(4, 1);
    if (f_.zoom) {
      const double z = next(0.1, far);
      m_.zoom_x += z, m_.zoom_y += z;
    }
    if (f_.stretch) m_.zoom_x += next(0.1, far), m_.zoom_y += next(0.1, far);
    if (f_.turn) m_.turn += next(0.1, far);
    if (f_.parallax) m_.parallax_x += next(4, 1), m_.parallax_y += next(4, 1);
    return largest > 0.005;
  }
  static bool solve(std::array<std::array<double, kMaxNumbers + 1>, kMaxNumbers>& e, int n,
                    std::array<double, kMaxNumbers>& out) {
    for (int p = 0; p < n; ++p) {
      int best = p;
      for (int q = p + 1; q < n; ++q)
        if (std::fabs(e[q][p]) > std::fabs(e[best][p])) best = q;
      std::swap(e[p], e[best]);
      if (std::fabs(e[p][p]) < 1e-9) return false;
      for (int q = 0; q < n; ++q) {
        if (q == p) continue;
        const double f = e[q][p] / e[p][p];
        for (int k = p; k < n; ++k) e[q][k] -= f * e[p][k];
        e[q][kMaxNumbers] -= f * e[p][kMaxNumbers];
      }
    }
    for (int p = 0; p < n; ++p) out[static_cast<std::size_t>(p)] = e[p][kMaxNumbers] / e[p][p];
    return true;
  }

  const Case& c_;
  const Freedom& f_;
  double mx_, my_;
  const Mask& mask_;
  const std::vector<float>& nearness_;
  Motion m_;
  Pixels a_, b_;
};

}  // namespace

Pixels blurred(const Case& c, const Pixels& picture, double sigma) {
  const int radius = static_cast<int>(std::ceil(2 * sigma));
  std::vector<float> kernel;
  float sum = 0;
  for (int i = -radius; i <= radius; ++i)
    kernel.push_back(static_cast<float>(std::exp(-i * i / (2 * sigma * sigma)))), sum += kernel.back();
  for (float& k : kernel) k /= sum;
  Pixels rows(c.size()), out(c.size());
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      for (int i = -radius; i <= radius; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          rows[c.at(x, y)][k] += kernel[static_cast<std::size_t>(i + radius)] * picture[c.clamped(x + i, y)][k];
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x)
      for (int i = -radius; i <= radius; ++i)
        for (std::size_t k = 0; k < 3; ++k)
          out[c.at(x, y)][k] += kernel[static_cast<std::size_t>(i + radius)] * rows[c.clamped(x, y + i)][k];
  return out;
}

Registered registered(const Case& c, const Freedom& freedom, double middle_x, double middle_y, const Mask& mask,
                      const std::vector<float>& nearness) {
  return Registration(c, freedom, middle_x, middle_y, mask, nearness).run();
}

}  // namespace verisim::compare
