#include "tracer/textures/compile/compile_pattern.h"

#include <cmath>
#include <stdexcept>

#include "tracer/functions/function.h"

namespace verisim::textures {
namespace {

template <class T>
const T& parameters(const scene::Pattern& d) {
  if (const T* p = std::get_if<T>(&*d.params)) return *p;
  static const T defaults{};
  return defaults;
}

BrickData brick(const scene::BrickParams& p) {
  return {p.size, static_cast<float>(static_cast<double>(p.mortar) - 2 * kEpsilon)};
}

GradientData gradient(const scene::GradientParams& p) {
  const double n = length(p.direction);
  return {n > 0 ? p.direction / n : Vec3(0, 0, 0)};
}

SlopeData slope(const scene::SlopeParams& p) {
  SlopeData s;
  s.point_at = p.point_at;
  const double direction = length(p.direction), altitude = length(p.altitude);
  s.direction = p.point_at || direction == 0 ? p.direction : p.direction / direction;
  s.has_altitude = altitude != 0 && !p.point_at;
  if (s.has_altitude) {
    s.altitude = p.altitude / altitude;
    s.slope_weight = direction / (direction + altitude);
  }
  s.slope_low = p.slope_low;
  s.slope_width = p.slope_high - p.slope_low;
  s.altitude_low = p.altitude_low;
  s.altitude_width = p.altitude_high - p.altitude_low;
  return s;
}

PatternData compile_parameters(const scene::Pattern& d, const PatternContext& context) {
  using enum scene::PatternKind;
  switch (d.kind) {
    case agate:
      return parameters<scene::AgateParams>(d);
    case brick:
      return textures::brick(parameters<scene::BrickParams>(d));
    case crackle: {
      const auto& p = parameters<scene::CrackleParams>(d);
      return CrackleData{p, p.offset == 0 ? 0 : std::pow(p.offset, p.metric)};
    }
    case facets:
      return parameters<scene::FacetsParams>(d);
    case julia:
    case magnet_julia:
    case magnet_mandel:
    case mandel:
      return parameters<scene::FractalParams>(d);
    case gradient:
      return textures::gradient(parameters<scene::GradientParams>(d));
    case quilted: {
      const auto& p = parameters<scene::QuiltedParams>(d);
      return QuiltedData{p.control0, p.control1};
    }
    case slope:
      return textures::slope(parameters<scene::SlopeParams>(d));
    case spiral1:
    case spiral2:
      return parameters<scene::SpiralParams>(d);
    case tiling: {
      const int number = parameters<scene::TilingParams>(d).number;
      if (number < 1 || number > 27) throw std::invalid_argument("tiling number out of range");
      return TilingData{periodic_tiling(number), number};
    }
    case pavement:
      return PavementData{compile_pavement(parameters<scene::PavementParams>(d))};
    case function: {
      const auto& p = parameters<scene::FunctionParams>(d);
      if (!p.function || p.function->parameters() != 3)
        throw std::invalid_argument("a function pattern needs a function of x, y, z");
      return FunctionData{p.function};
    }
    case object: {
      const auto& p = parameters<scene::ObjectParams>(d);
      if (!p.object) throw std::invalid_argument("an object pattern without object");
      return ObjectData{p.object, scene::compile_solid(*p.object)};
    }
    case pigment_pattern: {
      const auto& p = parameters<scene::PigmentPatternParams>(d);
      if (!p.pigment) throw std::invalid_argument("a pigment pattern without pigment");
      return PigmentData{context.pigment(p.pigment)};
    }
    case density_file:
      return parameters<scene::DensityFileParams>(d);
    case bump_map:
    case image_map:
    case image_pattern:
      return compile_image(parameters<scene::ImageParams>(d));
    case ripples:
    case waves:
      return WaveData{context.wave_sources()};
    default:
      return std::monostate{};
  }
}

// Marble, wood and patterns without a type do not displace the point by the classic turbulence (spec 05 3.1).
bool displaces(scene::PatternKind kind) {
  return kind != scene::PatternKind::marble && kind != scene::PatternKind::wood && kind != scene::PatternKind::none;
}

}  // namespace

CompiledPattern compile_pattern(const scene::Pattern& d, const PatternContext& context) {
  CompiledPattern c;
  c.kind = d.kind;
  c.wave = d.wave;
  c.frequency = d.frequency;
  c.phase = d.phase;
  c.exponent = d.exponent;
  c.plain_wave = c.wave == scene::Wave::ramp && c.frequency == 1 && c.phase == 0;
  const int generator = d.noise_generator & 3;
  c.noise_generator = generator != 0 ? generator : context.settings.noise_generator;
  if (d.turbulence) {
    c.turbulence = compile_turbulence(*d.turbulence);
    c.turbulent = true;
  }
  c.chain = compile_warps(d.warps, d.turbulence && displaces(d.kind) ? &c.turbulence : nullptr);
  for (const scene::Warp& warp : d.warps)
    if (const Transform* t = std::get_if<Transform>(&warp); t && !t->is_identity()) c.frame.push_back(*t);
  c.data = compile_parameters(d, context);
  return c;
}

}  // namespace verisim::textures
