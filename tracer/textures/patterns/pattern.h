// A compiled pattern: warp chain, formula, wave form (spec 05 sections 3 and 8).
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "tracer/scene/solid.h"
#include "tracer/textures/lookup/image_lookup.h"
#include "tracer/textures/patterns/density_file.h"
#include "tracer/textures/patterns/pavement.h"
#include "tracer/textures/patterns/tilings/tiling.h"
#include "tracer/textures/point_batch.h"
#include "tracer/textures/texture.h"
#include "tracer/textures/warp.h"

namespace verisim::textures {

// Sources of the patterns ripples and waves.
struct WaveSource {
  Vec3 position;
  double frequency;  // k of spec 05 section 8
};

// Parameters in the form the formulas want; see patterns/*.cpp.
struct BrickData {
  Vec3 size;
  double mortar;
};
struct CrackleData {
  scene::CrackleParams p;
  double offset_power;
};
struct GradientData {
  Vec3 unit;
};
struct QuiltedData {
  double control0, control1;
};
struct SlopeData {
  Vec3 direction;  // unit, or the point to look at
  Vec3 altitude;   // unit
  bool point_at = false, has_altitude = false;
  double slope_weight = 1;
  double slope_low = 0, slope_width = 0, altitude_low = 0, altitude_width = 0;  // width 0: no range
};
struct PigmentData {
  const CompiledPigment* pigment;
};
struct ObjectData {
  scene::ObjectPtr description;
  std::shared_ptr<const scene::Solid> solid;
};
struct WaveData {
  std::shared_ptr<const std::vector<WaveSource>> sources;
};
struct TilingData {
  const Tiling* tiling;
  int number;
};
struct PavementData {
  Pavement pavement;
};
// What a formula reads: the parameters of the description, or the form made of them.
using PatternData = DistinctVariant<scene::PatternParams, BrickData, CrackleData, GradientData, QuiltedData, SlopeData,
                                    TilingData, PavementData, ObjectData, PigmentData, ImageLookup, WaveData>;

struct CompiledPattern {
  WarpChain chain;
  scene::PatternKind kind = scene::PatternKind::none;
  scene::Wave wave = scene::Wave::ramp;
  bool plain_wave = false;  // ramp wave, frequency 1, phase 0: values in [0, 1] stay what they are
  bool turbulent = false;   // turbulence was written
  int noise_generator = 2;
  double frequency = 1, phase = 0, exponent = 1;
  // The classic record, as the formulas of agate, marble, wood and spirals use it.
  const TurbulenceStep* turbulence = &no_turbulence();
  // The transformations alone, in order of evaluation: what happens to normals. Where one asks for it.
  scene::List<Transform> frame;
  PatternData data;
  // Not 0: several pigments or textures use this pattern, and its last value at a point is worth remembering. Unique in
  // the program.
  std::uint64_t shared_id = 0;

  template <class T>
  const T& as() const {
    return *std::get_if<T>(&data);
  }
};

// The point that the formula, and the children of a map, see.
Vec3 warped(const CompiledPattern& pattern, const Vec3& p);
// Formula, frequency, phase and wave form at an already warped point.
double value_at(const CompiledPattern& pattern, const Vec3& warped_point, const SurfacePoint* surface);
// The formula alone, of the patterns that evaluation.inc does not know.
double formula(const CompiledPattern& pattern, const Vec3& warped_point, const SurfacePoint* surface);
// The same of a batch, filled up, for patterns that ask a function or a pigment. False: this is another one, or the
// batches are nested too deep.
bool formulas_of_others(const CompiledPattern& pattern, int count, const PointBatch& warped_points,
                        const SurfacePoint* const* surfaces, double* values);

// The warped point and the value there.
struct PatternValue {
  Vec3 point;
  double value;
};
PatternValue value_of(const CompiledPattern& pattern, const Vec3& p, const SurfacePoint* surface);
PatternValue remembered_value(const CompiledPattern& pattern, const Vec3& p);  // of a shared pattern
// Whether a value hangs on the point alone and takes longer than looking it up.
bool worth_remembering(const CompiledPattern& pattern);

// Takes a normal into the space of a pattern and back; each step re-normalises unless `no_bump_scale` (spec 05 10.1).
Vec3 normal_into_frame(const CompiledPattern& pattern, bool no_bump_scale, Vec3 n);
Vec3 normal_out_of_frame(const CompiledPattern& pattern, bool no_bump_scale, Vec3 n);

}  // namespace verisim::textures
