// The compiled chain of warps and transformations that a point walks through before a pattern is evaluated (spec 05 sections 3.1 and 6).
#pragma once

#include <variant>
#include <vector>

#include "tracer/scene/pattern.h"

namespace verisim::textures {

// p' = p * (3x3 part) + offset: the inverse of what SDL wrote.
struct AffineStep {
  double m[3][3];
  Vec3 offset;
};
struct TurbulenceStep {
  Vec3 amount;
  int octaves;
  double lambda, omega;
};
using RepeatStep = scene::RepeatWarp;
using BlackHoleStep = scene::BlackHoleWarp;
using ProjectionStep = scene::ProjectionWarp;  // orientation normalised
using CubicStep = scene::CubicWarp;
using WarpStep = std::variant<AffineStep, TurbulenceStep, RepeatStep, BlackHoleStep, ProjectionStep, CubicStep>;
using WarpChain = std::vector<WarpStep>;

// Octaves within what POV-Ray allows, single precision values widened.
TurbulenceStep compile_turbulence(const scene::Turbulence& turbulence);
// Leaves out steps that change nothing. `classic`: the turbulence at the end of the chain, or null.
WarpChain compile_warps(const std::vector<scene::Warp>& warps, const TurbulenceStep* classic);

// Walks the chain and clamps the result to +-1e17.
Vec3 warp_point(const WarpChain& chain, Vec3 p);

}  // namespace verisim::textures
