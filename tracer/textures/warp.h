// The compiled chain of warps and transformations that a point walks through before a pattern is evaluated (spec 05
// sections 3.1 and 6).
#pragma once

#include <map>
#include <tuple>
#include <variant>
#include <vector>

#include "tracer/scene/pattern.h"
#include "tracer/noise/noise.h"

namespace verisim::textures {

// p' = p.x * row 0 + p.y * row 1 + p.z * row 2 + row 3: the inverse of what SDL wrote.
struct AffineStep {
  alignas(32) double rows[4][4];  // the offset last; the fourth column is zero
};
struct TurbulenceStep {
  Vec3 amount;
  Octaves octaves;
};
using RepeatStep = scene::RepeatWarp;
using BlackHoleStep = scene::BlackHoleWarp;
using ProjectionStep = scene::ProjectionWarp;  // orientation normalised
using CubicStep = scene::CubicWarp;
// Turbulence is a pointer: it is large, and copies of an object have the same.
using WarpStep = std::variant<AffineStep, const TurbulenceStep*, RepeatStep, BlackHoleStep, ProjectionStep, CubicStep>;
// Most chains are one transformation or none; that is applied without a look at the rest.
struct WarpChain {
  AffineStep first;
  std::vector<WarpStep> rest;
  bool transforms = false;
};

// Octaves within what POV-Ray allows, single precision values widened; equal ones are one.
class TurbulenceTable {
 public:
  const TurbulenceStep* get(const scene::Turbulence& turbulence);

 private:
  using Key = std::tuple<double, double, double, int, float, float>;
  std::map<Key, TurbulenceStep> known_;
};
// What turbulence is where none is written.
const TurbulenceStep& no_turbulence();

// Leaves out steps that change nothing. `classic`: the turbulence at the end of the chain, or null. What it points to
// is in the table.
WarpChain compile_warps(const scene::List<scene::Warp>& warps, const TurbulenceStep* classic, TurbulenceTable& table);

// One step other than turbulence.
Vec3 walk_step(const WarpStep& step, const Vec3& p);

}  // namespace verisim::textures
