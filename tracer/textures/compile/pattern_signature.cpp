#include "tracer/textures/compile/pattern_signature.h"

#include <type_traits>

namespace verisim::textures {
namespace {

// The bytes of every field, one after the other.
struct Signature {
  std::string bytes;

  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_pointer_v<T>
  void add(const T& v) { bytes.append(reinterpret_cast<const char*>(&v), sizeof v); }
  void add(const Vec2& v) { add(v.x, v.y); }
  void add(const Vec3& v) { add(v.x, v.y, v.z); }
  void add(const Mat4& m) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) add(m[i][j]);
  }
  template <class T>
  void add(const std::shared_ptr<T>& p) {
    add(p.get());
  }
  template <class T, std::size_t n>
  void add(const T (&array)[n]) {
    for (const T& v : array) add(v);
  }
  template <class First, class Second, class... Rest>
  void add(const First& first, const Second& second, const Rest&... rest) {
    add(first);
    add(second);
    (add(rest), ...);
  }

  void add(const Transform& t) { add(t.m, t.inv); }
  void add(const scene::Turbulence& t) { add(t.amount, t.octaves, t.lambda, t.omega); }
  void add(const scene::RepeatWarp& w) { add(w.axis, w.width, w.offset, w.flip); }
  void add(const scene::BlackHoleWarp& w) {
    add(w.center, w.radius, w.strength, w.falloff, w.inverse, w.type);
    add(w.repeats, w.repeat, w.turbulent, w.turbulence);
  }
  void add(const scene::ProjectionWarp& w) {
    add(w.kind, w.orientation, w.distance_exponent, w.major_radius, w.offset);
  }
  void add(const scene::CubicWarp&) {}

  void add(const std::monostate&) {}
  void add(const scene::AgateParams& p) { add(p.turbulence); }
  void add(const scene::BrickParams& p) { add(p.size, p.mortar); }
  void add(const scene::CrackleParams& p) { add(p.form, p.metric, p.offset, p.solid); }
  void add(const scene::FacetsParams& p) { add(p.size, p.coords, p.metric); }
  void add(const scene::FractalParams& p) {
    add(p.julia, p.iterations, p.exponent, p.magnet, p.exterior_type, p.interior_type, p.exterior_factor,
        p.interior_factor);
  }
  void add(const scene::GradientParams& p) { add(p.direction); }
  void add(const scene::QuiltedParams& p) { add(p.control0, p.control1); }
  void add(const scene::SlopeParams& p) {
    add(p.direction, p.altitude, p.point_at, p.slope_low, p.slope_high, p.altitude_low, p.altitude_high);
  }
  void add(const scene::SpiralParams& p) { add(p.arms); }
  void add(const scene::TilingParams& p) { add(p.number); }
  void add(const scene::PavementParams& p) { add(p.sides, p.tiles, p.pattern, p.exterior, p.interior, p.form); }
  void add(const scene::FunctionParams& p) { add(p.function); }
  void add(const scene::ObjectParams& p) { add(p.object); }
  void add(const scene::PigmentPatternParams& p) { add(p.pigment); }
  void add(const scene::DensityFileParams& p) { add(p.samples, p.size, p.bytes, p.interpolate); }
  void add(const scene::ImageParams& p) {
    add(p.image, p.map_type, p.interpolate, p.once, p.use_alpha, p.use_index, p.repeat, p.offset, p.filter_all,
        p.transmit_all);
  }
};

}  // namespace

std::string pattern_signature(const scene::Pattern& pattern) {
  Signature s;
  s.add(pattern.kind, pattern.wave, pattern.frequency, pattern.phase, pattern.exponent, pattern.noise_generator);
  const scene::PatternParams& params = *pattern.params;
  s.add(params.index());
  std::visit([&](const auto& p) { s.add(p); }, params);
  s.add(pattern.warps.size());
  for (const scene::Warp& warp : pattern.warps) {
    s.add(warp.index());
    std::visit([&](const auto& w) { s.add(w); }, warp);
  }
  s.add(pattern.turbulence.has_value());
  if (pattern.turbulence) s.add(*pattern.turbulence);
  return s.bytes;
}

}  // namespace verisim::textures
