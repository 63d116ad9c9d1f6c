#include "tracer/shading/sky.h"

namespace verisim::shading {

Sky::Sky(const scene::Scene& scene, textures::Compiler& compiler, bool output_alpha)
    : version_(scene.version), output_alpha_(output_alpha), background_(scene.background) {
  if (!scene.background_given) background_ = output_alpha ? Color(0, 0, 0, 0, 1) : Color();
  if (!output_alpha && version_ >= 370) background_ = Color(scene.background.rgb() * (1 - background_.t));
  if (version_ < 370) background_.f = background_.t = 0;
  if (scene.sky_sphere) {
    for (auto p = scene.sky_sphere->pigments.rbegin(); p != scene.sky_sphere->pigments.rend(); ++p) pigments_.push_back(compiler.pigment(*p));
    emission_ = scene.sky_sphere->emission;
    transform_ = scene.sky_sphere->transform;
  }
}

Color Sky::seen(const Vec3& direction, bool opaque) const {
  if (version_ < 370 && output_alpha_ && !opaque) return {0, 0, 0, 0, 1};
  Color background = background_;
  if (!output_alpha_ || opaque) background.f = background.t = 0;
  if (pigments_.empty()) {
    const float a = background.opacity();
    return {background.rgb() * a, 0, std::min(1.0f, std::fabs(background.transmission().grey()))};
  }
  const Vec3 q = transform_.inverse_point(direction);
  return version_ < 370 ? legacy(q, background.rgb()) : modern(q, background);
}

Color Sky::modern(const Vec3& q, const Color& background) const {
  Rgb sum, filter(1);
  for (const auto* pigment : pigments_) {
    Color c;
    textures::evaluate(*pigment, q, nullptr, c);
    sum += c.rgb() * filter * emission_ * c.opacity();
    filter *= c.transmission();
  }
  sum += background.rgb() * filter * background.opacity();
  filter *= background.transmission();
  return {sum, 0, std::min(1.0f, std::fabs(filter.grey()))};
}

// Before 3.7 filter does not tint deeper layers, only the background.
Color Sky::legacy(const Vec3& q, const Rgb& background) const {
  Rgb sum;
  Color product(1, 1, 1, 1, 1);
  float passed = 1;
  for (const auto* pigment : pigments_) {
    Color c;
    textures::evaluate(*pigment, q, nullptr, c);
    sum += c.rgb() * (passed * c.opacity());
    product = {product.r * c.r, product.g * c.g, product.b * c.b, product.f * c.f, product.t * c.t};
    passed = std::fabs(product.f) + std::fabs(product.t);
  }
  sum *= emission_;
  sum += background * (product.rgb() * product.f + Rgb(product.t));
  return sum;
}

}  // namespace verisim::shading
