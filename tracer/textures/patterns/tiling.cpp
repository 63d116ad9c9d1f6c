#include "tracer/textures/patterns/tiling.h"

#include <stdexcept>

#include "tracer/textures/patterns/pavement.h"

namespace verisim::textures {
const Tiling* periodic_tiling(int) { throw std::runtime_error("tiling"); }
double evaluate_tiling(const Tiling&, double, double) { return 0; }
double penrose_tiling(int, double, double) { return 0; }
Pavement compile_pavement(const scene::PavementParams&) { throw std::runtime_error("pavement"); }
double evaluate_pavement(const Pavement&, double, double) { return 0; }
}  // namespace verisim::textures
