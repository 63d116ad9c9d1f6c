// What one thread remembers of rays that go the same way: camera rays of neighbouring pixels, and shadow rays from
// neighbouring points to one light.
//
// The picture is cut into tiles and space into cells a few pixels wide. All camera rays of a tile lie in one shaft, and
// so do all shadow rays from a cell to one light; the subtrees of the world that the shaft meets are kept, and the rays
// start at those. What is found does not depend on what is remembered: shafts are conservative, and the world decides
// ties by rules of its own.
#pragma once

#include <memory>

#include "tracer/bvh/bvh.h"
#include "tracer/bvh/shaft.h"
#include "tracer/world/world.h"

namespace verisim::accel {

// How far apart the camera rays of neighbouring pixels are.
struct CameraCoherence {
  enum class Kind : unsigned char { none, common_origin, parallel } kind = Kind::none;
  double spread = 0;  // an angle, or a distance if the rays are parallel
};

class CoherentRays {
 public:
  explicit CoherentRays(const World& world) : world_(world) {}

  void set_camera(const CameraCoherence& camera);
  // The viewer stands here now: shadow rays start from points seen from there.
  void set_viewpoint(const Vec3& p) { viewpoint_ = p, viewer_known_ = true; }

  // Where the camera rays of a pixel enter the world; null: at the root. shaft_of(left, top, right, bottom) gives the
  // shaft of a rectangle of the picture in pixels, whose centres are at integers; it must always be that of the same
  // camera.
  template <class ShaftOf>
  const WorldEntry* camera(double x, double y, ShaftOf&& shaft_of) {
    int count = 1;
    return camera_batch(x, y, count, shaft_of);
  }
  // The same for pixels (x, y), (x + 1, y) ..., `count` of them at most; sets it to the number of those that this entry
  // serves.
  template <class ShaftOf>
  const WorldEntry* camera_batch(double x, double y, int& count, ShaftOf&& shaft_of);

  // Side of the squares of pixels that share an entry; the first of them begins at pixel 0.
  static constexpr int camera_tile() { return kTile; }
  // Entries of pixels no further apart than this, in either direction, can be used together: none takes the place of
  // another.
  static constexpr double camera_reach();

  // Who looks at the points that shadow rays start from: they are denser where the camera sees them.
  enum class Viewer : unsigned char { camera, other };
  // Where shadow rays from p to points of `target` enter the world; null: at the root. `light`: any number that stands
  // for the target.
  WorldEntry* shadow(const Vec3& p, std::uint32_t light, const Box3& target, Viewer viewer);
  // The same for parallel light that comes from a unit direction.
  WorldEntry* parallel_shadow(const Vec3& p, std::uint32_t light, const Vec3& towards, Viewer viewer);
  // The points for which the entry last given by these two holds, too; empty: none. Whoever uses it for them says so.
  const Box3& served() const { return served_; }
  void used_again(Viewer viewer) { ++cell_worth_[static_cast<int>(viewer)].used; }

 private:
  static constexpr int kTile = 8;            // pixels
  static constexpr int kTiles = 8;           // in each direction are remembered: a block of the picture and more
  static constexpr double kShadowCell = 16;  // pixels, at least

  struct Key {
    std::int32_t cell[3];
    std::uint32_t kind;
    bool operator==(const Key&) const = default;
  };
  static constexpr std::uint32_t kNoKey = 0xffffffffu;

  struct Slot {
    WorldEntry entry;
    bool usable;  // the rays lie in a shaft
  };

  // Cells that are not visited again cost more than they save: those of a kind of rays are given up for a while when
  // they prove so.
  struct Worth {
    std::uint32_t built = 0, used = 0, pause = 0;
    bool paused() {
      if (pause == 0) return false;
      --pause;
      return true;
    }
    void count_built();
  };

  // A table of shafts, found by a few bits of their keys; slots are not touched before they are used.
  template <std::size_t kSlots>
  struct Table {
    std::unique_ptr<Key[]> keys;
    std::unique_ptr<Slot[]> slots;
    // The slot of a key; `known`: it holds the key's shaft already.
    Slot& find(const Key& key, std::size_t hash, bool& known);
  };
  struct ShadowCell {
    Key key;  // without its kind
    double width;
    std::uint32_t exponent;  // of the width, for the key's kind
  };

  WorldEntry* remember(Slot& slot, const std::optional<Shaft>& shaft);
  bool find_cell(const Vec3& p);
  template <class ShaftOf>
  WorldEntry* shadow_entry(const Vec3& p, std::uint32_t light, Viewer viewer, ShaftOf&& shaft_of);

  const World& world_;
  CameraCoherence camera_;
  Vec3 viewpoint_{0, 0, 0};
  bool viewer_known_ = false;
  Table<static_cast<std::size_t>(kTiles) * kTiles> tiles_;
  Table<512> cells_;
  Vec3 cell_point_{0, 0, 0};  // the last point that was asked for, and its cell
  ShadowCell cell_;
  bool cell_found_ = false;
  Box3 served_;
  int last_column_ = -1, last_row_ = -1;  // the tile last asked for
  const WorldEntry* last_tile_ = nullptr;
  Worth tile_worth_, cell_worth_[2];
};

constexpr double CoherentRays::camera_reach() { return (kTiles - 1) * kTile; }

template <std::size_t kSlots>
CoherentRays::Slot& CoherentRays::Table<kSlots>::find(const Key& key, std::size_t hash, bool& known) {
  if (!keys) {
    keys = std::make_unique_for_overwrite<Key[]>(kSlots);
    slots = std::make_unique_for_overwrite<Slot[]>(kSlots);
    for (std::size_t i = 0; i < kSlots; ++i) keys[i] = {{0, 0, 0}, kNoKey};
  }
  const std::size_t index = hash % kSlots;
  known = keys[index] == key;
  keys[index] = key;
  return slots[index];
}

template <class ShaftOf>
const WorldEntry* CoherentRays::camera_batch(double x, double y, int& count, ShaftOf&& shaft_of) {
  if (camera_.kind == CameraCoherence::Kind::none || tile_worth_.paused()) return nullptr;
  // Positions are within a pixel of the picture, which has fewer than 2^30 pixels a side.
  const int column = static_cast<int>(x + (kTile + 0.5)) / kTile, row = static_cast<int>(y + (kTile + 0.5)) / kTile;
  count = std::min(count, (column + 1) * kTile - static_cast<int>(x + (kTile + 0.5)));
  tile_worth_.used += static_cast<std::uint32_t>(count);
  if (column == last_column_ && row == last_row_) return last_tile_;
  last_column_ = column, last_row_ = row;
  bool known;
  Slot& slot =
      tiles_.find({{column, row, 0}, 0}, static_cast<std::size_t>(column % kTiles + row % kTiles * kTiles), known);
  if (known) return last_tile_ = slot.usable ? &slot.entry : nullptr;
  tile_worth_.count_built();
  const double left = (column - 1) * kTile - 0.5, top = (row - 1) * kTile - 0.5, margin = 1e-3;
  return last_tile_ =
             remember(slot, shaft_of(left - margin, top - margin, left + kTile + margin, top + kTile + margin));
}

}  // namespace verisim::accel
