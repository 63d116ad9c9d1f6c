// Normals at the points of a batch: the same, bit by bit, as normal.cpp finds one by one. Kinds that have no wide form
// are asked point by point.
#include "tracer/functions/program_packet.h"
#include "tracer/textures/evaluation/evaluation.h"
#include "tracer/textures/normals/normal.h"
#include "tracer/textures/normals/normal_kernels.h"
#include "tracer/textures/point_batch.h"

namespace verisim::textures {
namespace {

constexpr int kFewPoints = 3;  // not worth a batch

const NormalKernels& normals_of() {
  static const NormalKernels& best = normal_kernels();
  return best;
}
const EvaluationKernels& patterns_of() {
  static const EvaluationKernels& best = evaluation_kernels(simd::best_instruction_set());
  return best;
}

bool has_wide_form(const CompiledNormal& c) {
  using enum scene::PatternKind;
  if (c.method == CompiledNormal::Method::height) return true;
  if (c.method != CompiledNormal::Method::displacement) return false;
  const scene::PatternKind kind = c.pattern->kind;
  return kind == bumps || kind == dents || kind == wrinkles || kind == ripples || kind == waves;
}

// waves_bump() for a batch.
void add_waves(const CompiledNormal& c, int count, const PointBatch& p, PointBatch& n) {
  using functions::Code, functions::Instruction;
  static_assert(PointBatch::kMax == functions::ProgramKernels::kWide);
  static constexpr Instruction kSine[] = {{Code::sin, 0, 0}};
  static const functions::ProgramKernels& programs = functions::packet_kernels();
  for (const WaveSource& source : *c.pattern->as<WaveData>().sources) {
    const SourceWave wave(*c.pattern, c.amount, source);
    alignas(64) double distances[PointBatch::kMax], sines[PointBatch::kMax];
    normals_of().wave_angles(source, wave, count, p, distances, sines);
    programs.wide(std::span(kSine), {}, sines, ~0ull >> (PointBatch::kMax - count));
    normals_of().add_wave(source, wave, count, p, distances, sines, n);
  }
}

void displace(const CompiledNormal& c, int count, const PointBatch& p, PointBatch& n) {
  using enum scene::PatternKind;
  if (c.pattern->kind == ripples || c.pattern->kind == waves) return add_waves(c, count, p, n);
  PointBatch vectors;
  double amount = c.amount;
  if (c.pattern->kind == wrinkles) {
    patterns_of().wrinkles_batch(count, p, vectors);
  } else {
    patterns_of().vector_noise_batch(count, p, vectors);
    if (c.pattern->kind == dents) {
      alignas(64) double noise[PointBatch::kMax];
      patterns_of().noise_batch(c.pattern->noise_generator, count, p, noise);
      normals_of().scale_by_cubes(std::exchange(amount, 1), count, noise, vectors);
    }
  }
  normals_of().displace(amount, count, vectors, n);
}

void raise(const CompiledNormal& c, int count, const PointBatch& p, const SurfacePoint* const* surfaces,
           PointBatch& n) {
  const double strength = height_strength(c);
  for (const Vec3& direction : kHeightSamples) {
    PointBatch moved;
    alignas(64) double heights[PointBatch::kMax];
    normals_of().move(p, c.accuracy, direction, count, moved);
    patterns_of().values_batch(*c.pattern, count, moved, surfaces, heights);
    if (!c.slopes.empty())
      for (int i = 0; i < count; ++i) heights[i] = height_of(c, heights[i]);
    normals_of().raise(heights, strength, direction, count, n);
  }
}

}  // namespace

void perturb(const CompiledNormal& c, int count, const PointBatch& points, SurfacePoint* const* surfaces,
             Vec3* normals) {
  if (count < kFewPoints || !has_wide_form(c)) {
    for (int i = 0; i < count; ++i) normals[i] = perturb(c, points.at(i), normals[i], *surfaces[i]);
    return;
  }
  PointBatch p, n;
  patterns_of().warp_batch(c.pattern->chain, count, points, p);
  for (int i = 0; i < count; ++i) n.set(i, normals[i]);
  n.fill_up(count);
  normals_of().into_frame(*c.pattern, c.no_bump_scale, count, n);
  if (c.method == CompiledNormal::Method::height)
    raise(c, count, p, surfaces, n);
  else
    displace(c, count, p, n);
  normals_of().out_of_frame(*c.pattern, c.no_bump_scale, count, n);
  for (int i = 0; i < count; ++i) {
    surfaces[i]->normal = n.at(i);
    normals[i] = c.no_bump_scale ? n.at(i) / length(n.at(i)) : n.at(i);
  }
}

}  // namespace verisim::textures
