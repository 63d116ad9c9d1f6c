// The compiled chain of warps and transformations that a point walks through before a pattern is evaluated (spec 05 sections 3.1 and 6).
#pragma once

#include <variant>
#include <vector>

#include "tracer/scene/pattern.h"
#include "tracer/textures/noise.h"

namespace verisim::textures {

// p' = p * (3x3 part) + offset: the inverse of what SDL wrote.
struct AffineStep {
  double m[3][3];
  Vec3 offset;
};
struct TurbulenceStep {
  Vec3 amount;
  Octaves octaves;
};
using RepeatStep = scene::RepeatWarp;
using BlackHoleStep = scene::BlackHoleWarp;
using ProjectionStep = scene::ProjectionWarp;  // orientation normalised
using CubicStep = scene::CubicWarp;
using WarpStep = std::variant<AffineStep, TurbulenceStep, RepeatStep, BlackHoleStep, ProjectionStep, CubicStep>;
// Most chains are one transformation or none; that is applied without a look at the rest.
struct WarpChain {
  bool transforms = false;
  AffineStep first;
  std::vector<WarpStep> rest;
};

// Octaves within what POV-Ray allows, single precision values widened.
TurbulenceStep compile_turbulence(const scene::Turbulence& turbulence);
// Leaves out steps that change nothing. `classic`: the turbulence at the end of the chain, or null.
WarpChain compile_warps(const scene::List<scene::Warp>& warps, const TurbulenceStep* classic);

inline Vec3 transformed(const AffineStep& s, const Vec3& p) {
  return {p.x * s.m[0][0] + p.y * s.m[1][0] + p.z * s.m[2][0] + s.offset.x, p.x * s.m[0][1] + p.y * s.m[1][1] + p.z * s.m[2][1] + s.offset.y,
          p.x * s.m[0][2] + p.y * s.m[1][2] + p.z * s.m[2][2] + s.offset.z};
}
Vec3 walk(const std::vector<WarpStep>& steps, const Vec3& p);

// Walks the chain and clamps the result to +-1e17.
inline Vec3 warp_point(const WarpChain& chain, Vec3 p) {
  if (chain.transforms) p = transformed(chain.first, p);
  if (!chain.rest.empty()) p = walk(chain.rest, p);
  constexpr double kLimit = 1e17;
  const auto clamped = [](double v) {
    v = kLimit < v ? kLimit : v;
    return -kLimit > v ? -kLimit : v;
  };
  return {clamped(p.x), clamped(p.y), clamped(p.z)};
}

}  // namespace verisim::textures
