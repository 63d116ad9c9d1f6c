#include "tracer/shading/atmosphere/sky.h"

#include <array>

#include "tracer/math/scaled.h"

namespace verisim::shading {
namespace {

// Pigments one behind the other, top first.
class Blend {
 public:
  void add(const Color& c, const Rgb& emission) {
    sum_ += c.rgb() * rounded_opacity(c.opacity()) * filter_ * emission;
    filter_ *= c.transmission();
  }
  Color over(const Color& background, const Rgb& /*emission*/) const {
    const Rgb whole = sum_ + scaled(background.rgb(), background.opacity()) * filter_,
              through = filter_ * background.transmission();
    return {whole, 0, std::min(1.0f, std::fabs(through.grey()))};
  }

 private:
  Rgb sum_, filter_{1};
};

// Before 3.7 filter does not tint deeper layers, only the background.
class LegacyBlend {
 public:
  void add(const Color& c, const Rgb& /*emission*/) {
    sum_ += scaled(c.rgb(), passed_ * c.opacity());
    product_ = {product_.r * c.r, product_.g * c.g, product_.b * c.b, product_.f * c.f, product_.t * c.t};
    passed_ = std::fabs(product_.f) + std::fabs(product_.t);
  }
  Color over(const Color& background, const Rgb& emission) const {
    return sum_ * emission + background.rgb() * (product_.rgb() * product_.f + Rgb(product_.t));
  }

 private:
  Rgb sum_;
  Color product_{1, 1, 1, 1, 1};
  float passed_ = 1;
};

}  // namespace

Sky::Sky(const scene::Scene& scene, textures::Compiler& compiler, bool output_alpha)
    : version_(scene.version), output_alpha_(output_alpha), background_(scene.background) {
  if (!scene.background_given) background_ = output_alpha ? Color(0, 0, 0, 0, 1) : Color();
  if (!scene.background_fades)
    background_.f = 0, background_.t = 1;
  else if (!output_alpha)
    background_ = Color(scene.background.rgb() * (1 - background_.t));
  if (version_ < 370) background_.f = background_.t = 0;
  if (scene.sky_sphere) {
    for (auto p = scene.sky_sphere->pigments.rbegin(); p != scene.sky_sphere->pigments.rend(); ++p)
      pigments_.push_back(compiler.pigment(*p));
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
    return {scaled(background.rgb(), background.opacity()), 0,
            std::min(1.0f, std::fabs(background.transmission().grey()))};
  }
  const Vec3 q = transform_.inverse_point(direction);
  const auto through = [&](auto blend) {
    for (const auto* pigment : pigments_) {
      Color c;
      textures::evaluate(*pigment, q, nullptr, c);
      blend.add(c, emission_);
    }
    return blend.over(background, emission_);
  };
  return version_ < 370 ? through(LegacyBlend()) : through(Blend());
}

void Sky::seen(int count, const textures::PointBatch& directions, bool opaque, Color* colors) const {
  if (pigments_.empty() || (version_ < 370 && output_alpha_ && !opaque)) {
    for (int i = 0; i < count; ++i) colors[i] = seen(directions.at(i), opaque);
    return;
  }
  textures::PointBatch q;
  for (int i = 0; i < count; ++i) q.set(i, transform_.inverse_point(directions.at(i)));
  q.fill_up(count);
  const auto through = [&](auto&& blends) {
    for (const auto* pigment : pigments_) {
      bool colored[textures::PointBatch::kMax];
      textures::evaluate(*pigment, count, q, nullptr, colors, colored);
      for (int i = 0; i < count; ++i) blends[i].add(colors[i], emission_);
    }
    for (int i = 0; i < count; ++i) colors[i] = blends[i].over(background(opaque), emission_);
  };
  if (version_ < 370)
    through(std::array<LegacyBlend, textures::PointBatch::kMax>());
  else
    through(std::array<Blend, textures::PointBatch::kMax>());
}

}  // namespace verisim::shading
