// Pavements: polyforms that tile the x-z plane (spec 05 section 9.2).
#pragma once

#include <cstdint>

#include "tracer/scene/pattern.h"

namespace verisim::textures {

// A pavement with its cell flags (pavement_flags.h); null flags: every number was checked by the parser, so this does
// not happen.
struct Pavement {
  int sides = 3, exterior = 0, interior = 0, form = 0;
  int columns = 1, rows = 1;
  const std::uint16_t* flags = nullptr;  // row-major
};

Pavement compile_pavement(const scene::PavementParams& params);
double evaluate_pavement(const Pavement& pavement, double x, double z);

}  // namespace verisim::textures
