#include "tracer/textures/patterns/pattern.h"

#include <cstddef>

#include "tracer/math/luma.h"
#include "tracer/functions/function.h"
#include "tracer/noise/noise.h"
#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {

// Patterns of what is defined elsewhere: noise, functions, objects, pigments, images.
namespace formulas {

double dents(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const double n = noise(p, c.noise_generator);
  return n * n * n;
}

double below_one(double v) { return v > 1 ? std::fmod(v, 1.0) : v; }
double function(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return below_one((*c.as<scene::FunctionParams>().function)(p.x, p.y, p.z));
}

double object(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return c.as<ObjectData>().solid->inside(p) ? 1 : 0;
}

double pigment_pattern(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  Color color;
  return evaluate(*c.as<PigmentData>().pigment, p, surface, color) ? luma(color) : 0.0f;
}

void function_batch(const Function& function, int count, const PointBatch& points, double* v) {
  static_assert(offsetof(PointBatch, y) == sizeof(PointBatch::x) &&
                offsetof(PointBatch, z) == 2 * sizeof(PointBatch::x));
  alignas(64) double values[kMaxFunctionComponents * PointBatch::kMax];
  function.evaluate_batch(points.x, PointBatch::kMax, static_cast<std::size_t>(count), values);
  for (int i = 0; i < count; ++i) v[i] = below_one(values[i]);
}
void pigment_pattern_batch(const CompiledPigment& pigment, int count, const PointBatch& points,
                           const SurfacePoint* const* surfaces, double* v) {
  Color colors[PointBatch::kMax];
  bool colored[PointBatch::kMax];
  evaluate(pigment, count, points, surfaces, colors, colored);
  for (int i = 0; i < count; ++i) v[i] = colored[i] ? luma(colors[i]) : 0.0f;
}

double image_pattern(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return textures::image_pattern(c.as<ImageLookup>(), p);
}
double image_map(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  return image_pattern(c, p, surface);
}
double bump_map(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  return image_pattern(c, p, surface);
}

}  // namespace formulas

double formula(const CompiledPattern& c, const Vec3& p, const SurfacePoint* surface) {
  using scene::info, scene::PatternInfo, scene::PatternKind;
  switch (c.kind) {
#define VERISIM_PATTERN(name, params, list, traits)                                                    \
  case PatternKind::name:                                                                              \
    if constexpr (!info(PatternKind::name).is(PatternInfo::kFormulaWithNoise | PatternInfo::kNoValue)) \
      return formulas::name(c, p, surface);                                                            \
    break;
    VERISIM_PATTERNS(VERISIM_PATTERN)
#undef VERISIM_PATTERN
  }
  return 0;
}

bool formulas_of_others(const CompiledPattern& c, int count, const PointBatch& points,
                        const SurfacePoint* const* surfaces, double* v) {
  using enum scene::PatternKind;
  if (c.kind != function && c.kind != pigment_pattern) return false;
  // Patterns within patterns: a batch takes some kilobytes of stack.
  constexpr int kDeepest = 8;
  static thread_local int depth = 0;
  if (depth == kDeepest) return false;
  ++depth;
  if (c.kind == function)
    formulas::function_batch(*c.as<scene::FunctionParams>().function, count, points, v);
  else
    formulas::pigment_pattern_batch(*c.as<PigmentData>().pigment, count, points, surfaces, v);
  --depth;
  return true;
}

bool worth_remembering(const CompiledPattern& c) {
  const scene::PatternInfo& info = scene::info(c.kind);
  if (info.is(scene::PatternInfo::kNoValue | scene::PatternInfo::kNotRemembered)) return false;
  return info.is(scene::PatternInfo::kSlow) || c.turbulent || !c.chain.rest.empty();
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

// Frames of textures are many and mostly the pattern's own space: what is a unit vector to the last bit stays one.
static Vec3 normalize_twice(const Vec3& n) {
  const Vec3 once = normalize(n);
  return once == n ? once : normalize(once);
}

Vec3 normal_into_frame(const CompiledPattern& pattern, bool no_bump_scale, Vec3 n) {
  if (pattern.frame.empty()) return no_bump_scale ? n : normalize_twice(n);
  if (!no_bump_scale) n = normalize(n);
  for (const Transform& t : pattern.frame) n = t.inverse_normal(n);
  return no_bump_scale ? n : normalize(n);
}

Vec3 normal_out_of_frame(const CompiledPattern& pattern, bool no_bump_scale, Vec3 n) {
  if (pattern.frame.empty()) return no_bump_scale ? n : normalize_twice(n);
  if (!no_bump_scale) n = normalize(n);
  for (std::size_t k = pattern.frame.size(); k-- > 0;) n = pattern.frame[k].normal(n);
  return no_bump_scale ? n : normalize(n);
}

}  // namespace verisim::textures
