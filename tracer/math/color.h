// Colours are single precision, as in POV-Ray: decisions that hang on them (adc_bailout, thresholds) must round alike.
#pragma once

#include <algorithm>
#include <cmath>

namespace verisim {

struct Rgb {
  float r = 0, g = 0, b = 0;

  Rgb() = default;
  constexpr Rgb(float red, float green, float blue) : r(red), g(green), b(blue) {}
  // Not trivial on purpose: the calling convention would return three floats in two registers, packed by way of the
  // stack, where each call waits for its own stores.
  constexpr Rgb(const Rgb& o) : r(o.r), g(o.g), b(o.b) {}
  constexpr Rgb& operator=(const Rgb& o) {
    r = o.r, g = o.g, b = o.b;
    return *this;
  }
  explicit constexpr Rgb(float grey_value) : r(grey_value), g(grey_value), b(grey_value) {}

  friend bool operator==(const Rgb&, const Rgb&) = default;
  Rgb& operator+=(const Rgb& o) {
    r += o.r, g += o.g, b += o.b;
    return *this;
  }
  Rgb& operator-=(const Rgb& o) {
    r -= o.r, g -= o.g, b -= o.b;
    return *this;
  }
  Rgb& operator*=(const Rgb& o) {
    r *= o.r, g *= o.g, b *= o.b;
    return *this;
  }
  Rgb& operator*=(float s) {
    r *= s, g *= s, b *= s;
    return *this;
  }
  friend Rgb operator+(Rgb a, const Rgb& b) { return a += b; }
  friend Rgb operator-(Rgb a, const Rgb& b) { return a -= b; }
  friend Rgb operator*(Rgb a, const Rgb& b) { return a *= b; }
  friend Rgb operator*(Rgb a, float s) { return a *= s; }
  friend Rgb operator*(float s, Rgb a) { return a *= s; }
  friend Rgb operator/(const Rgb& a, float s) { return {a.r / s, a.g / s, a.b / s}; }

  // Luma as POV-Ray weighs it everywhere (spec 02, 06 section 1).
  float grey() const { return 0.297f * r + 0.589f * g + 0.114f * b; }
  float max() const { return std::max(r, std::max(g, b)); }
  float max_abs() const { return std::max(std::fabs(r), std::max(std::fabs(g), std::fabs(b))); }
};

// A POV-Ray colour: light reflected plus what passes through, filtered by the colour (f) or unfiltered (t).
struct Color {
  float r = 0, g = 0, b = 0, f = 0, t = 0;

  Color() = default;
  constexpr Color(float red, float green, float blue, float filter = 0, float transmit = 0)
      : r(red), g(green), b(blue), f(filter), t(transmit) {}
  constexpr Color(const Rgb& c, float filter = 0, float transmit = 0)
      : r(c.r), g(c.g), b(c.b), f(filter), t(transmit) {}

  friend bool operator==(const Color&, const Color&) = default;
  Rgb rgb() const { return {r, g, b}; }
  float grey() const { return 0.297f * r + 0.589f * g + 0.114f * b; }
  // Light passed per channel: f * (r,g,b) + t.
  Rgb transmission() const { return {f * r + t, f * g + t, f * b + t}; }
  // 1 - f - t, in double precision as in POV-Ray: may be negative, if only by 1e-8.
  double opacity() const { return 1.0 - f - t; }

  Color& operator+=(const Color& o) {
    r += o.r, g += o.g, b += o.b, f += o.f, t += o.t;
    return *this;
  }
  Color& operator-=(const Color& o) {
    r -= o.r, g -= o.g, b -= o.b, f -= o.f, t -= o.t;
    return *this;
  }
  Color& operator*=(float s) {
    r *= s, g *= s, b *= s, f *= s, t *= s;
    return *this;
  }
  friend Color operator+(Color a, const Color& b) { return a += b; }
  friend Color operator-(Color a, const Color& b) { return a -= b; }
  friend Color operator*(Color a, float s) { return a *= s; }
  friend Color operator*(float s, Color a) { return a *= s; }
};

// An opacity as colours are multiplied by it: computed in double precision, then rounded to single (spec 06 3.3).
inline float rounded_opacity(double opacity) { return static_cast<float>(opacity); }

}  // namespace verisim
