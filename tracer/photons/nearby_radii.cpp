#include "tracer/photons/nearby_radii.h"

#include <cmath>
#include <cstdint>

namespace verisim::global {

NearbyRadii::Places NearbyRadii::at(const Vec3& p, double radius) {
  Known& around = cell(large_, p, 0.35 * radius);
  return {around, cell(small_, p, 0.5 * around.radius)};
}

// Of a lattice with sides that are powers of two.
NearbyRadii::Known& NearbyRadii::cell(std::vector<Known>& cells, const Vec3& p, double side) {
  if (!(side > 1e-30 && side < 1e30)) return nowhere_ = {};
  const int level = std::ilogb(side);
  const double inverse = std::ldexp(1.0, -level);
  if (!(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) * inverse < 1e15)) return nowhere_ = {};
  const auto index = [inverse](double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v * inverse)));
  };
  const std::uint64_t mixed = index(p.x) * 0x9E3779B97F4A7C15u + index(p.y) * 0xC2B2AE3D27D4EB4Fu +
                              index(p.z) * 0x165667B19E3779F9u +
                              static_cast<std::uint64_t>(level) * 0xD6E8FEB86659FD93u;
  if (cells.empty()) cells.resize(kPlaces);
  return cells[((mixed ^ mixed >> 32) * 0x9E3779B97F4A7C15u >> 40) % kPlaces];
}

}  // namespace verisim::global
