// Normals at the points of a batch: the same, bit by bit, as normal.cpp finds one by one. Kinds that have no wide form
// are asked point by point, also those among others in maps and averages.
#include <algorithm>

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
  if (c.method == CompiledNormal::Method::unusable) return false;
  if (c.method != CompiledNormal::Method::displacement) return true;
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

void apply(const CompiledNormal& c, int count, const PointBatch& points, SurfacePoint* const* surfaces, PointBatch& n);

// The points that have one of the children in common are asked together; child_of(i) < 0: point i is left as it is.
template <class ChildOf>
void apply_children(const CompiledNormal& c, int count, const PointBatch& points, SurfacePoint* const* surfaces,
                    ChildOf&& child_of, PointBatch& n) {
  int waiting[PointBatch::kMax], left = 0;
  for (int i = 0; i < count; ++i)
    if (child_of(i) >= 0) waiting[left++] = i;
  while (left > 0) {
    const int child = child_of(waiting[0]);
    PointBatch some, normals;
    SurfacePoint* seen[PointBatch::kMax];
    int taken[PointBatch::kMax], same = 0, others = 0;
    for (int k = 0; k < left; ++k) {
      const int i = waiting[k];
      if (child_of(i) != child) {
        waiting[others++] = i;
        continue;
      }
      some.set(same, points.at(i)), normals.set(same, n.at(i));
      seen[same] = surfaces[i];
      taken[same++] = i;
    }
    some.fill_up(same), normals.fill_up(same);
    apply(*c.children[static_cast<std::size_t>(child)], same, some, seen, normals);
    for (int k = 0; k < same; ++k) n.set(taken[k], normals.at(k));
    left = others;
  }
}

// mapped() for a batch.
void blend(const CompiledNormal& c, int count, const PointBatch& p, SurfacePoint* const* surfaces, PointBatch& n) {
  alignas(64) double values[PointBatch::kMax];
  patterns_of().values_batch(*c.pattern, count, p, surfaces, values);
  MapPlace places[PointBatch::kMax];
  for (int i = 0; i < count; ++i) places[i] = c.positions.find(values[i]);
  PointBatch lower = n;
  apply_children(
      c, count, p, surfaces, [&](int i) { return places[i].upper; }, n);
  apply_children(
      c, count, p, surfaces, [&](int i) { return places[i].single() ? -1 : places[i].lower; }, lower);
  for (int i = 0; i < count; ++i)
    if (!places[i].single()) n.set(i, (1 - places[i].t) * lower.at(i) + places[i].t * n.at(i));
  n.fill_up(count);
}

// averaged() for a batch.
void take_average(const CompiledNormal& c, int count, const PointBatch& p, SurfacePoint* const* surfaces,
                  PointBatch& n) {
  Vec3 sums[PointBatch::kMax];
  std::fill_n(sums, count, Vec3(0, 0, 0));
  float total = 0;
  for (std::size_t k = 0; k < c.children.size(); ++k) {
    PointBatch one = n;
    apply(*c.children[k], count, p, surfaces, one);
    for (int i = 0; i < count; ++i) sums[i] += static_cast<double>(c.positions.position(k)) * one.at(i);
    total += c.positions.position(k);
  }
  for (int i = 0; i < count; ++i) n.set(i, sums[i] * (1.0 / total));
  n.fill_up(count);
}

// The whole process of one normal at the points of a batch, as perturb_alone() has it; normals in and out, filled up.
void apply(const CompiledNormal& c, int count, const PointBatch& points, SurfacePoint* const* surfaces, PointBatch& n) {
  using enum CompiledNormal::Method;
  if (count < kFewPoints || !has_wide_form(c)) {
    for (int i = 0; i < count; ++i) n.set(i, perturb_alone(c, points.at(i), n.at(i), *surfaces[i]));
    n.fill_up(count);
    return;
  }
  PointBatch p;
  if (c.method == uv_mapping) {
    for (int i = 0; i < count; ++i) p.set(i, uv_point(*surfaces[i]));
    p.fill_up(count);
    return apply(*c.children[0], count, p, surfaces, n);
  }
  patterns_of().warp_batch(c.pattern->chain, count, points, p);
  normals_of().into_frame(*c.pattern, c.no_bump_scale, count, n);
  switch (c.method) {
    case height:
      raise(c, count, p, surfaces, n);
      break;
    case displacement:
      displace(c, count, p, n);
      break;
    case map:
      blend(c, count, p, surfaces, n);
      break;
    default:
      take_average(c, count, p, surfaces, n);
  }
  normals_of().out_of_frame(*c.pattern, c.no_bump_scale, count, n);
  if (c.method == map) {  // normalised once more, as there
    for (int i = 0; i < count; ++i) n.set(i, normalize(n.at(i)));
    n.fill_up(count);
  }
  for (int i = 0; i < count; ++i) surfaces[i]->normal = n.at(i);
}

}  // namespace

void perturb(const CompiledNormal& c, int count, const PointBatch& points, SurfacePoint* const* surfaces,
             Vec3* normals) {
  PointBatch n;
  for (int i = 0; i < count; ++i) n.set(i, normals[i]);
  n.fill_up(count);
  apply(c, count, points, surfaces, n);
  for (int i = 0; i < count; ++i) normals[i] = c.no_bump_scale ? n.at(i) / length(n.at(i)) : n.at(i);
}

}  // namespace verisim::textures
