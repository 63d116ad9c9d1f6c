// The store of radiosity samples and its spatial lookup (spec 07 sections 2.5 and 2.8).
//
// POV-Ray files a sample in one cell of a lattice of cubes whose sides are powers of two, and finds it again only from inside that cell doubled. At depths
// above 0 this loses samples on purpose, which pictures show; so the same cells are used here, in a hash table instead of a tree.
#pragma once

#include <cstdint>
#include <vector>

#include "tracer/math/color.h"
#include "tracer/math/vec.h"

namespace verisim::global {

struct IrradianceSample {
  Vec3 point, normal;
  Vec3 nearest_direction{0, 0, 0};  // unit, towards the nearest surface; zero if nothing was hit
  Rgb irradiance;
  float mean_distance = 0;          // harmonic, clamped by the reuse limits
  float nearest_distance = 0;
  float quality = 1;
  std::int16_t depth = 0;
  std::int16_t pass = -1;           // in which it was taken; -1: loaded from a file
  std::int32_t tile = -1;
};

class IrradianceCache {
 public:
  // error_bound: of the scene, without low_error_factor; it decides how far a sample reaches.
  explicit IrradianceCache(double error_bound) : error_bound_(error_bound) {}

  void add(const IrradianceSample& sample);
  const std::vector<IrradianceSample>& samples() const { return samples_; }
  bool empty() const { return samples_.empty(); }
  void clear_keep_settings();

  // Calls visit(sample) for every sample of this depth that POV-Ray's lookup finds from x.
  template <class Visit>
  void visit(int depth, const Vec3& x, Visit&& visit) const {
    if (depth >= static_cast<int>(levels_.size())) return;
    for (const int level : levels_[depth]) {
      const double side = std::ldexp(1.0, level);
      std::int32_t cell[3], other[3];
      for (int a = 0; a < 3; ++a) {
        const double scaled = (x[a] + kOrigin) / side, floor = std::floor(scaled);
        cell[a] = static_cast<std::int32_t>(floor);
        const double fraction = scaled - floor;
        // The neighbour whose doubled cell reaches here; exactly in the middle there is none.
        other[a] = fraction < 0.5 ? cell[a] - 1 : fraction > 0.5 ? cell[a] + 1 : cell[a];
      }
      for (int i = 0; i < 8; ++i) {
        const Key key{(i & 1) ? other[0] : cell[0], (i & 2) ? other[1] : cell[1], (i & 4) ? other[2] : cell[2], static_cast<std::int16_t>(level),
                      static_cast<std::int16_t>(depth)};
        if (((i & 1) && other[0] == cell[0]) || ((i & 2) && other[1] == cell[1]) || ((i & 4) && other[2] == cell[2])) continue;
        if (is_root(key)) continue;
        for (std::int32_t s = head(key); s >= 0; s = next_[s]) visit(samples_[s]);
      }
    }
    if (has_root_) {
      Key key = root_;
      key.depth = static_cast<std::int16_t>(depth);
      for (std::int32_t s = head(key); s >= 0; s = next_[s]) visit(samples_[s]);
    }
  }

 private:
  struct Key {
    std::int32_t x = 0, y = 0, z = 0;
    std::int16_t level = 0, depth = -1;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Slot {
    Key key;
    std::int32_t head = -1;
  };
  static constexpr double kOrigin = 1e7;

  static std::uint64_t hash(const Key& k);
  bool is_root(const Key& k) const { return has_root_ && k.level == root_.level && k.x == root_.x && k.y == root_.y && k.z == root_.z; }
  std::int32_t head(const Key& key) const;
  Slot& slot(const Key& key);
  void include_in_root(const Key& key);

  double error_bound_;
  std::vector<IrradianceSample> samples_;
  std::vector<std::int32_t> next_;        // next sample in the same cell
  std::vector<Slot> slots_;               // open addressing, a power of two
  std::size_t used_ = 0;
  std::vector<std::vector<int>> levels_;  // per depth: lattice levels in use
  Key root_;                              // smallest lattice cell that contains all cells in use
  bool has_root_ = false;
};

}  // namespace verisim::global
