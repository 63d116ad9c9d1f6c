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
  void add(const Affine& m) {
    bytes.append(reinterpret_cast<const char*>(m.numbers().data()), m.numbers().size_bytes());
  }
  template <class T>
  void add(const std::shared_ptr<T>& p) {
    add(p.get());
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

  void add(const scene::NoParams&) {}
  template <class Params>
  requires requires(const Params& p, Signature& s) { p.fields(s); }
  void add(const Params& p) { p.fields(*this); }
  template <class... Members>
  void operator()(const auto& /*name*/, const Members&... members) {
    (add(members), ...);
  }
};

}  // namespace

std::string pattern_signature(const scene::Pattern& pattern) {
  Signature s;
  s.bytes.reserve(400);  // with a transformation
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
