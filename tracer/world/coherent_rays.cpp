#include "tracer/world/coherent_rays.h"

#include <bit>

namespace verisim::accel {
namespace {

// After this many shafts their worth is judged: each must have served so many rays on average, or there are none for a
// while.
constexpr std::uint32_t kTrial = 64, kWorthwhile = 3, kPause = 20000;
constexpr double kLargestIndex = 1e9;
constexpr std::uint64_t kExponentBias = 1023;

// floor(x) of |x| < 2^31, inline.
std::int32_t cell_of(double x) {
  const auto i = static_cast<std::int32_t>(x);
  return i - (x < i);
}

std::size_t mixed(std::int32_t a, std::int32_t b, std::int32_t c, std::uint32_t d) {
  const auto u = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
  const std::uint64_t h = (u(a) * 0x9e3779b97f4a7c15ull) ^ (u(b) * 0xc2b2ae3d27d4eb4full) ^
                          (u(c) * 0x165667b19e3779f9ull) ^ (d * 0x27d4eb2f165667c5ull);
  return static_cast<std::size_t>(h >> 40);
}

}  // namespace

void CoherentRays::Worth::count_built() {
  if (++built < kTrial) return;
  if (used < built * kWorthwhile) pause = kPause;
  built = used = 0;
}

void CoherentRays::set_camera(const CameraCoherence& camera) {
  camera_ = camera;
  cell_point_ = Vec3(std::numeric_limits<double>::quiet_NaN());
  if (!(camera_.spread > 0 && std::isfinite(camera_.spread)) || world_.tree().empty())
    camera_.kind = CameraCoherence::Kind::none;
}

WorldEntry* CoherentRays::remember(Slot& slot, const std::optional<Shaft>& shaft) {
  slot.usable = shaft.has_value();
  if (!shaft) return nullptr;
  world_.enter(*shaft, slot.entry);
  return &slot.entry;
}

// Cells are as wide as the power of two next to a number of pixels at the distance of p.
// All lights are asked about one point after another, so the last cell is kept.
bool CoherentRays::find_cell(const Vec3& p) {
  cell_point_ = p;
  cell_found_ = false;
  const double footprint =
      camera_.kind == CameraCoherence::Kind::parallel ? camera_.spread : camera_.spread * length(p - viewpoint_);
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(footprint * kShadowCell) >> 52;
  if (!(exponent > kExponentBias - 60 && exponent < kExponentBias + 60)) return false;
  cell_.width = std::bit_cast<double>((exponent + 1) << 52);
  const double inverse = std::bit_cast<double>((2 * kExponentBias - exponent - 1) << 52);
  for (int i = 0; i < 3; ++i) {
    const double place = p[i] * inverse;
    if (!(std::fabs(place) < kLargestIndex)) return false;
    cell_.key.cell[i] = cell_of(place);
  }
  cell_.exponent = static_cast<std::uint32_t>(exponent - kExponentBias + 64) << 1;
  cell_found_ = true;
  return true;
}

template <class ShaftOf>
WorldEntry* CoherentRays::shadow_entry(const Vec3& p, std::uint32_t light, Viewer viewer, ShaftOf&& shaft_of) {
  served_.makeEmpty();
  if (camera_.kind == CameraCoherence::Kind::none || !viewer_known_) return nullptr;
  Worth& worth = cell_worth_[static_cast<int>(viewer)];
  if (worth.paused() || !(p == cell_point_ ? cell_found_ : find_cell(p))) return nullptr;
  ++worth.used;
  Key& key = cell_.key;
  key.kind = light << 9 | cell_.exponent | static_cast<std::uint32_t>(viewer);
  bool known;
  Slot& slot = cells_.find(key, mixed(key.cell[0], key.cell[1], key.cell[2], key.kind), known);
  const Vec3 low(key.cell[0] * cell_.width, key.cell[1] * cell_.width, key.cell[2] * cell_.width);
  served_ = Box3(low, low + Vec3(cell_.width));
  if (known) return slot.usable ? &slot.entry : nullptr;
  worth.count_built();
  return remember(slot, shaft_of(served_));
}

WorldEntry* CoherentRays::shadow(const Vec3& p, std::uint32_t light, const Box3& target, Viewer viewer) {
  return shadow_entry(p, light, viewer, [&](const Box3& cell) { return Shaft::between(cell, target); });
}

WorldEntry* CoherentRays::parallel_shadow(const Vec3& p, std::uint32_t light, const Vec3& towards, Viewer viewer) {
  return shadow_entry(p, light, viewer, [&](const Box3& cell) {
    // Far enough to leave everything behind, what is beside the tree as well.
    Box3 all = world_.tree().bounds();
    if (const Box3 finite = world_.bounds(); !is_empty(finite)) all.extendBy(finite);
    const double reach =
        2 * (length(all.max - all.min) + length(cell.max - all.center()) + length(cell.max - cell.min));
    return Shaft::between(cell, Box3(cell.min + towards * reach, cell.max + towards * reach));
  });
}

}  // namespace verisim::accel
