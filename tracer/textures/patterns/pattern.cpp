#include "tracer/textures/patterns/pattern.h"

#include "tracer/functions/function.h"
#include "tracer/noise/noise.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {
namespace {

double function_value(const FunctionData& data, const Vec3& p) {
  const double v = (*data.function)(p.x, p.y, p.z);
  return v > 1 ? std::fmod(v, 1.0) : v;
}

double pigment_grey(const PigmentData& data, const Vec3& p, const SurfacePoint* surface) {
  Color color;
  return evaluate(*data.pigment, p, surface, color) ? color.grey() : 0.0f;
}

double tiling_value(const TilingData& data, const Vec3& p) {
  return data.tiling ? evaluate_tiling(*data.tiling, p.x, p.z) : penrose_tiling(data.number, p.x, p.z);
}

}  // namespace

double formula(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  using enum scene::PatternKind;
  switch (c.kind) {
    case aoi:
      return surface ? angle_of_incidence(*surface) : 0;
    case boxed:
      return textures::boxed(p);
    case brick:
      return textures::brick(c.as<BrickData>(), p);
    case bump_map:
    case image_map:
    case image_pattern:
      return textures::image_pattern(c.as<ImageLookup>(), p);
    case cells:
      return textures::cells(p);
    case checker:
      return textures::checker(p);
    case crackle:
      return textures::crackle(c.as<CrackleData>(), c.noise_generator, p);
    case cubic:
      return textures::cubic(p);
    case cylindrical:
      return textures::cylindrical(p);
    case density_file:
      return textures::density_file(c.as<scene::DensityFileParams>(), p);
    case dents: {
      const double n = noise(p, c.noise_generator);
      return n * n * n;
    }
    case function:
      return function_value(c.as<FunctionData>(), p);
    case gradient:
      return textures::gradient(c.as<GradientData>(), p);
    case hexagon:
      return textures::hexagon(p);
    case julia:
    case magnet_julia:
    case magnet_mandel:
    case mandel:
      return fractal(c.as<scene::FractalParams>(), c.kind, p);
    case leopard:
      return textures::leopard(p);
    case object:
      return c.as<ObjectData>().solid->inside(p) ? 1 : 0;
    case onion:
      return textures::onion(p);
    case pavement:
      return evaluate_pavement(c.as<PavementData>().pavement, p.x, p.z);
    case pigment_pattern:
      return pigment_grey(c.as<PigmentData>(), p, surface);
    case planar:
      return textures::planar(p);
    case quilted:
      return textures::quilted(c.as<QuiltedData>(), p);
    case radial:
      return textures::radial(p);
    case ripples:
      return textures::ripples(c, p);
    case slope:
      return surface ? textures::slope(c.as<SlopeData>(), p, *surface) : 0;
    case spherical:
      return textures::spherical(p);
    case spiral1:
      return textures::spiral1(c, p);
    case spiral2:
      return textures::spiral2(c, p);
    case square:
      return textures::square(p);
    case tiling:
      return tiling_value(c.as<TilingData>(), p);
    case triangular:
      return textures::triangular(p);
    case waves:
      return textures::waves(c, p);
    case agate:
    case bozo:
    case bumps:
    case granite:
    case marble:
    case spotted:
    case wood:
    case wrinkles:
      break;  // evaluation.inc
    case average:
    case facets:
    case none:
    case plain:
    case uv_mapping:
      break;  // never asked for a value
  }
  return 0;
}

bool worth_remembering(const CompiledPattern& c) {
  using enum scene::PatternKind;
  switch (c.kind) {
    case aoi:
    case slope:
    case pigment_pattern:  // these may look at the surface
    case average:
    case facets:
    case image_map:
    case none:
    case plain:
    case uv_mapping:
      return false;
    case agate:
    case bozo:
    case bumps:
    case crackle:
    case dents:
    case density_file:
    case function:
    case granite:
    case julia:
    case magnet_julia:
    case magnet_mandel:
    case mandel:
    case object:
    case pavement:
    case ripples:
    case spotted:
    case tiling:
    case waves:
    case wrinkles:
      return true;
    default:
      return c.turbulent || !c.chain.rest.empty();
  }
}

PatternValue remembered_value(const CompiledPattern& c, const Vec3& p) {
  struct Memory {
    std::uint64_t id;
    Vec3 p;
    PatternValue result;
  };
  constexpr std::size_t kSlots = 64;
  static thread_local Memory memory[kSlots];
  Memory& slot = memory[c.shared_id % kSlots];
  if (slot.id != c.shared_id || slot.p != p) {
    const Vec3 q = warped(c, p);
    const PatternValue result{q, value_at(c, q, nullptr)};  // may use the slot itself, for a pattern within
    slot = {c.shared_id, p, result};
  }
  return slot.result;
}

Vec3 normal_into_frame(const CompiledPattern& pattern, bool no_bump_scale, Vec3 n) {
  if (!no_bump_scale) n = normalize(n);
  for (const Transform& t : pattern.frame) n = t.inverse_normal(n);
  return no_bump_scale ? n : normalize(n);
}

Vec3 normal_out_of_frame(const CompiledPattern& pattern, bool no_bump_scale, Vec3 n) {
  if (!no_bump_scale) n = normalize(n);
  for (auto t = pattern.frame.rbegin(); t != pattern.frame.rend(); ++t) n = t->normal(n);
  return no_bump_scale ? n : normalize(n);
}

}  // namespace verisim::textures
