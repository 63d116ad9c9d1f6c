// From the description of a pattern to its compiled form.
#pragma once

#include <functional>

#include "tracer/textures/patterns/pattern.h"

namespace verisim::textures {

// What the compilation of a pattern needs from its surroundings.
struct PatternContext {
  const Settings& settings;
  std::function<const CompiledPigment*(const scene::PigmentPtr&)> pigment;       // for pigment_pattern
  std::function<std::shared_ptr<const std::vector<WaveSource>>()> wave_sources;  // for ripples and waves
  TurbulenceTable& turbulences;
};

// Throws std::invalid_argument when the description lacks what its kind needs (a fault of the caller).
CompiledPattern compile_pattern(const scene::Pattern& description, const PatternContext& context);
// Its CompiledPattern::frame.
std::vector<Transform> frame_of(const scene::Pattern& description);

}  // namespace verisim::textures
