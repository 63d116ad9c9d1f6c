// Tilings 1 .. 24: the value falls from the edges of a tile inwards until it is flat; classes of tiles get different
// ranges (spec 05 section 9.1). A point is moved into the lattice cell of the tiling, and the tile that holds it is
// found by its edges.
#include "tracer/textures/patterns/tilings/tiling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tracer/textures/patterns/tilings/tiling_borders.h"

namespace verisim::textures {
namespace {

// From 0 at its border to 1 where it is flat; negative outside. Given up where it is at most `least`.
double distance_within(const Tile& tile, double x, double z, double least) {
  double nearest = 1;
  for (const Tile::Edge& e : tile.edges) {
    nearest = std::min(nearest, e.nx * x + e.nz * z - e.c);
    if (nearest <= least) break;
  }
  return nearest;
}

// The tile that a point of the cell lies in, and how far within; null: the point is NaN.
std::pair<const Tile*, double> tile_at(const Tiling& t, double x, double z) {
  const Tile* holder = nullptr;
  double distance = -std::numeric_limits<double>::infinity();
  for (const Tile& tile : t.tiles) {
    const double nearest = distance_within(tile, x, z, distance);
    if (nearest <= distance) continue;
    distance = nearest;
    holder = &tile;
    if (distance > 0) break;
  }
  return {holder, distance};
}

// Of the tiles that share the border a point lies on, the one of the highest class, but of those of tilings with
// dodecagons the lowest class goes first; `one` is one of them.
const Tile* first_of_rank(const Tiling& t, double x, double z, const Tile* one) {
  const Tile* first = one;
  for (const Tile& tile : t.tiles)
    if (distance_within(tile, x, z, -1) >= -t.border && tile.rank > first->rank) first = &tile;
  return first;
}

// From 0 to 1, which is what hardly lies below 0.
double fraction_of(double v) { return v - std::floor(v); }

// Below 1 also for that.
double cell_fraction(double fraction) { return std::min(fraction, 1 - 0x1p-53); }

}  // namespace

double evaluate_tiling(const Tiling& t, double x, double z) {
  if (std::fabs(x) < kHardlyBeside || std::fabs(z) < kHardlyBeside)
    if (const std::optional<double> value = value_beside_zero(t, x, z)) return *value;
  const bool exchanged = t.exchanged && (x == std::floor(x) || fraction_of(x) == 1);
  if (t.mirrored) {
    x = std::fabs(x - std::floor(x / 6) * 6 - 3);
    z = std::fabs(z - std::floor(z / 6) * 6 - 3);
  }
  double u = x * t.inverse[0][0] + z * t.inverse[0][1], v = x * t.inverse[1][0] + z * t.inverse[1][1];
  u = fraction_of(u), v = fraction_of(v);
  if (t.seams != 0) {
    const bool across_z = on_seam(t, v, z);
    if (across_z || on_seam(t, u, x)) return value_on_seam(t, !across_z, v, z);
  }
  u = cell_fraction(u), v = cell_fraction(v);
  const double px = u * t.lattice[0][0] + v * t.lattice[1][0], pz = u * t.lattice[0][1] + v * t.lattice[1][1];
  auto [holder, distance] = tile_at(t, px, pz);
  if (!holder) return 0;  // not a number
  constexpr double kHardly = 1e-11;
  if (distance < kHardly && t.border > 0 && t.level_line == 0) {
    const double beside_x = beside_border(x), beside_z = beside_border(z);
    if (beside_x != x || beside_z != z) return evaluate_tiling(t, beside_x, beside_z);
  }
  if (!(distance > t.border)) {
    const Vec2 lean = t.level_line != 0 && z == 0 ? lean_on_level_line(t, x) : t.lean;
    holder = t.ranked ? first_of_rank(t, px, pz, holder) : tile_at(t, px + lean.x, pz + lean.y).first;
    distance = 0;
  }
  const double top = exchanged ? 1.5 - holder->top : holder->top;
  const double value = top - holder->step * distance + holder->offset;
  return std::max(value, holder->minimum);
}

}  // namespace verisim::textures
