// Transfer curves between the working space, which scenes compute in, and what a file stores (spec 02 section 4.2).
// Single precision.
#pragma once

#include <cmath>

#include "tracer/scene/scene.h"

namespace verisim::image {

inline float srgb_encode(float x) { return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f; }
inline float srgb_decode(float x) { return x < 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

// One curve: identity, a power or sRGB. Encoding goes from linear light to stored values.
class Curve {
 public:
  static Curve identity() { return Curve(Kind::identity, 1); }
  static Curve srgb() { return Curve(Kind::srgb, 1); }
  // Stored = linear^(1/gamma); an exponent within 0.01 of 1 is the identity.
  static Curve power(double gamma) {
    return std::fabs(1.0 / gamma - 1.0) <= 0.01 ? identity() : Curve(Kind::power, static_cast<float>(gamma));
  }

  float encode(float x) const {
    if (kind_ == Kind::srgb) return srgb_encode(x);
    return kind_ == Kind::power ? std::pow(std::fmax(x, 0.0f), 1.0f / gamma_) : x;
  }
  float decode(float x) const {
    if (kind_ == Kind::srgb) return srgb_decode(x);
    return kind_ == Kind::power ? std::pow(std::fmax(x, 0.0f), gamma_) : x;
  }
  bool is_identity() const { return kind_ == Kind::identity; }
  bool is_srgb() const { return kind_ == Kind::srgb; }
  bool is_power() const { return kind_ == Kind::power; }
  float gamma() const { return gamma_; }

 private:
  enum class Kind : unsigned char { identity, power, srgb };
  Curve(Kind kind, float gamma) : kind_(kind), gamma_(gamma) {}
  Kind kind_;
  float gamma_;
};

// From working-space values to file values and back.
class OutputCurve {
 public:
  // `working` none: values pass unchanged, whatever the file's curve is.
  OutputCurve(scene::Gamma working, double working_gamma, Curve file) : first_(Curve::identity()), second_(file) {
    if (working == scene::Gamma::none) {
      second_ = Curve::identity();
    } else if (working == scene::Gamma::srgb) {
      first_ = Curve::srgb();
      if (file.is_srgb()) first_ = second_ = Curve::identity();
    } else {
      first_ = Curve::power(working_gamma);
      if (first_.is_power() && (file.is_power() || file.is_identity())) {  // two powers fold into one
        second_ = Curve::power(static_cast<double>(file.gamma()) / first_.gamma());
        first_ = Curve::identity();
      }
    }
  }
  float encode(float x) const { return second_.encode(first_.decode(x)); }
  float decode(float x) const { return first_.encode(second_.decode(x)); }
  bool is_identity() const { return first_.is_identity() && second_.is_identity(); }

 private:
  Curve first_, second_;  // encode = second.encode(first.decode(x))
};

}  // namespace verisim::image
