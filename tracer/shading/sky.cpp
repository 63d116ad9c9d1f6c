#include "tracer/shading/sky.h"

namespace verisim::shading {
namespace {

// Pigments one behind the other, top first.
struct Blend {
  Rgb sum, filter{1};

  void add(const Color& c, const Rgb& emission) {
    sum += c.rgb() * filter * emission * c.opacity();
    filter *= c.transmission();
  }
  Color over(const Color& background) const {
    const Rgb whole = sum + background.rgb() * filter * background.opacity(), through = filter * background.transmission();
    return {whole, 0, std::min(1.0f, std::fabs(through.grey()))};
  }
};

}  // namespace

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

Color Sky::background(bool opaque) const {
  Color color = background_;
  if (!output_alpha_ || opaque) color.f = color.t = 0;
  return color;
}

Color Sky::seen(const Vec3& direction, bool opaque) const {
  if (version_ < 370 && output_alpha_ && !opaque) return {0, 0, 0, 0, 1};
  const Color background = this->background(opaque);
  if (pigments_.empty()) {
    const float a = background.opacity();
    return {background.rgb() * a, 0, std::min(1.0f, std::fabs(background.transmission().grey()))};
  }
  const Vec3 q = transform_.inverse_point(direction);
  return version_ < 370 ? legacy(q, background.rgb()) : modern(q, background);
}

void Sky::seen(int count, const textures::PointRow& directions, bool opaque, Color* colors) const {
  if (version_ < 370 || pigments_.empty()) {
    for (int i = 0; i < count; ++i) colors[i] = seen(directions.at(i), opaque);
    return;
  }
  textures::PointRow q;
  for (int i = 0; i < count; ++i) q.set(i, transform_.inverse_point(directions.at(i)));
  q.fill_up(count);
  Blend blends[textures::PointRow::kMost];
  for (const auto* pigment : pigments_) {
    bool colored[textures::PointRow::kMost];
    textures::evaluate(*pigment, count, q, nullptr, colors, colored);
    for (int i = 0; i < count; ++i) blends[i].add(colors[i], emission_);
  }
  for (int i = 0; i < count; ++i) colors[i] = blends[i].over(background(opaque));
}

Color Sky::modern(const Vec3& q, const Color& background) const {
  Blend blend;
  for (const auto* pigment : pigments_) {
    Color c;
    textures::evaluate(*pigment, q, nullptr, c);
    blend.add(c, emission_);
  }
  return blend.over(background);
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
