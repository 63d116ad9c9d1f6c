#include "tracer/shading/finish.h"

#include "tracer/math/constants.h"
#include "tracer/math/scaled.h"

namespace verisim::shading {
namespace {

double acos_clamped(double c) { return std::acos(std::clamp(c, -1.0, 1.0)); }

}  // namespace

Vec3 reflected_direction(const Vec3& d, const Vec3& normal, const Vec3& geometric_normal) {
  Vec3 r = mirrored(d, normal);
  const double below = dot(r, geometric_normal);
  if (below < 0) r = dot(r, normal) < 0 ? mirrored(d, geometric_normal) : r - geometric_normal * (2 * below);
  return normalize(r);
}

std::optional<Vec3> refracted_direction(const Vec3& d, const Vec3& normal, double ratio) {
  const double signed_cosine = dot(d, normal), k = std::fabs(signed_cosine);
  const Vec3 n = signed_cosine <= 0 ? normal : -normal;
  const double q = 1 + ratio * ratio * (k * k - 1);
  if (q < 0) return std::nullopt;
  return d * ratio + n * (ratio * k - std::sqrt(q));
}

double metallic_fresnel(double cosine) {
  const double x = std::fabs(acos_clamped(cosine)) / (kPi / 2);
  return std::clamp(0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903, 0.0, 1.0);
}

Rgb metallic_tint(const Rgb& pigment, float metallic, double cosine) {
  return Rgb(1) + scaled(pigment - Rgb(1), metallic * (1 - metallic_fresnel(cosine)));
}

Rgb iridescence(float amount, double thickness, double cosines, const Rgb& wavelength) {
  const auto factor = [&](float wl) {
    return static_cast<float>(1 + amount * std::cos(2 * kPi * thickness * cosines / wl));
  };
  return {factor(wavelength.r), factor(wavelength.g), factor(wavelength.b)};
}

double fresnel_reflectance(double eta, double cosine) {
  const double q = eta * eta + cosine * cosine - 1;
  if (q <= 0) return 1;
  const double g = std::sqrt(q), minus = g - cosine, plus = g + cosine;
  const double a = minus / plus, b = (cosine * plus - 1) / (cosine * minus + 1);
  return std::clamp(0.5 * a * a * (1 + b * b), 0.0, 1.0);
}

Mirror mirror_of(const scene::Reflection& reflection, const Rgb& pigment, double cosine, double eta) {
  Rgb rho;
  if (reflection.fresnel) {
    const double f = fresnel_reflectance(eta, cosine);
    rho = scaled(reflection.maximum, f) + scaled(reflection.minimum, 1 - f);
  } else {
    double x = 1 - cosine;
    // A view that is perpendicular up to rounding makes POV-Ray's power of a negative base NaN; here it is 0 (spec
    // 06 5.1).
    if (reflection.falloff != 1) x = std::pow(std::max(x, 0.0), static_cast<double>(reflection.falloff));
    if (std::fabs(x) < kEpsilon) {
      rho = reflection.minimum;
    } else if (std::fabs(x - 1) < kEpsilon) {
      rho = reflection.maximum;
    } else {
      rho = scaled(reflection.maximum, x) + scaled(reflection.minimum, 1 - x);
    }
  }
  const float strength = reflection.fresnel ? rho.max() : std::max(reflection.minimum.max(), reflection.maximum.max());
  if (reflection.metallic != 0) {
    // Unlike the tint of highlights, that of mirrors is not rounded by itself.
    const double m = reflection.metallic * (1 - metallic_fresnel(cosine));
    const auto tinted = [m](float share, double color) { return static_cast<float>(share * (1 + m * (color - 1))); };
    rho = {tinted(rho.r, pigment.r), tinted(rho.g, pigment.g), tinted(rho.b, pigment.b)};
  }
  return {rho, strength};
}

}  // namespace verisim::shading
