#include "tracer/textures/compile/compile_pattern.h"

#include <cmath>
#include <stdexcept>

#include "tracer/functions/function.h"

namespace verisim::textures {
namespace {

// From the parameters of a description to what the formula reads: mostly the same.
struct CompileParams {
  const PatternContext& context;

  template <class Params>
  PatternData operator()(const Params& p) const {
    return p;
  }
  PatternData operator()(const scene::BrickParams& p) const {
    return BrickData{p.size, static_cast<float>(static_cast<double>(p.mortar) - 2 * kEpsilon)};
  }
  PatternData operator()(const scene::CrackleParams& p) const {
    return CrackleData{p, p.offset == 0 ? 0 : std::pow(p.offset, p.metric)};
  }
  PatternData operator()(const scene::GradientParams& p) const {
    const double n = length(p.direction);
    return GradientData{n > 0 ? p.direction * (1 / n) : Vec3(0, 0, 0)};
  }
  PatternData operator()(const scene::QuiltedParams& p) const { return QuiltedData{p.control0, p.control1}; }
  PatternData operator()(const scene::SlopeParams& p) const {
    SlopeData s;
    s.point_at = p.point_at;
    const double direction = length(p.direction), altitude = length(p.altitude);
    s.direction = p.point_at || direction == 0 ? p.direction : normalize(p.direction);
    s.has_altitude = altitude != 0 && !p.point_at;
    if (s.has_altitude) s.altitude = normalize(p.altitude);
    // POV-Ray keeps the sum in single precision, also where there is no altitude: then it may be a little off 1.
    if (!p.point_at) s.slope_weight = direction / static_cast<double>(static_cast<float>(direction + altitude));
    s.slope_low = p.slope_low;
    s.slope_width = p.slope_high - p.slope_low;
    s.altitude_low = p.altitude_low;
    s.altitude_width = p.altitude_high - p.altitude_low;
    return s;
  }
  PatternData operator()(const scene::TilingParams& p) const {
    if (p.number < 1 || p.number > 27) throw std::invalid_argument("tiling number out of range");
    return TilingData{periodic_tiling(p.number), p.number};
  }
  PatternData operator()(const scene::PavementParams& p) const { return PavementData{compile_pavement(p)}; }
  PatternData operator()(const scene::FunctionParams& p) const {
    if (!p.function || p.function->parameters() != 3)
      throw std::invalid_argument("a function pattern needs a function of x, y, z");
    return p;
  }
  PatternData operator()(const scene::ObjectParams& p) const {
    if (!p.object) throw std::invalid_argument("an object pattern without object");
    return ObjectData{p.object, scene::compile_solid(*p.object)};
  }
  PatternData operator()(const scene::PigmentPatternParams& p) const {
    if (!p.pigment) throw std::invalid_argument("a pigment pattern without pigment");
    return PigmentData{context.pigment(p.pigment)};
  }
  PatternData operator()(const scene::ImageParams& p) const { return compile_image(p); }
};

PatternData compile_parameters(const scene::Pattern& d, const PatternContext& context) {
  using enum scene::PatternKind;
  if (d.kind == ripples || d.kind == waves) return WaveData{context.wave_sources()};
  const scene::PatternParams defaults = default_params(d.kind);
  const scene::PatternParams& given = *d.params;
  return std::visit(CompileParams{context}, given.index() == defaults.index() ? given : defaults);
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
    c.turbulence = context.turbulences.get(*d.turbulence);
    c.turbulent = true;
  }
  const bool displaced = d.turbulence && !scene::info(d.kind).is(scene::PatternInfo::kUndisplaced);
  c.chain = compile_warps(d.warps, displaced ? c.turbulence : nullptr, context.turbulences);
  c.data = compile_parameters(d, context);
  return c;
}

std::vector<Transform> frame_of(const scene::Pattern& d) {
  std::vector<Transform> frame;
  for (const scene::Warp& warp : d.warps)
    if (const Transform* t = std::get_if<Transform>(&warp); t && !t->is_identity()) frame.push_back(*t);
  return frame;
}

}  // namespace verisim::textures
