// tiling: the 27 tilings of the x-z plane (spec 05 section 9.1).
#include "tracer/textures/patterns/tilings/tiling.h"

#include "tracer/textures/patterns/formulas.h"

namespace verisim::textures {

double formulas::tiling(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  const TilingData& data = c.as<TilingData>();
  return data.tiling ? evaluate_tiling(*data.tiling, p.x, p.z) : penrose_tiling(data.number, p.x, p.z);
}

}  // namespace verisim::textures
