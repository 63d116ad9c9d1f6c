// What finds hits of a height_field, shared by copies: its heights, a pyramid of their extremes for fast traversal, and
// quantised normals (spec 04 section 5).
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "tracer/scene/object.h"

namespace verisim::shapes {

class HeightGrid {
 public:
  static std::shared_ptr<const HeightGrid> of(const std::shared_ptr<const scene::HeightField>& field);
  explicit HeightGrid(const scene::HeightField& field);

  // Samples along x and z; fewer than two of either: there is no surface.
  int width() const { return width_; }
  int depth() const { return depth_; }
  bool empty() const { return width_ < 2 || depth_ < 2; }
  // k counts from the bottom row of the image.
  int at(int i, int k) const {
    return heights_[static_cast<std::size_t>(k) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i)];
  }
  int lowest() const { return map_->lowest; }
  int highest() const { return map_->highest; }
  double water() const { return water_; }
  // Vertical limits of what is visible, in grid units.
  double bottom() const { return limits_.bottom; }
  double top() const { return limits_.top; }
  struct Limits {
    double bottom, top;
  };
  static Limits limits(const scene::HeightField& field);
  struct Cells {
    double x, z;
  };
  static Cells cells(const scene::HeightField& field);  // how many there are along each side

  // A block of 4^level cells a side has sixteen children, in Morton's order; those beyond the edge of the field have
  // low > high.
  static constexpr int kChildren = 16, kMaxLevels = 18;
  static constexpr int column(int child) { return (child & 1) | (child >> 1 & 2); }
  static constexpr int row(int child) { return (child >> 1 & 1) | (child >> 2 & 2); }
  struct alignas(64) Block {
    std::uint16_t low[kChildren], high[kChildren];
  };
  int levels() const { return static_cast<int>(levels_.size()); }  // level 0 is one cell
  const Block& block(int level, int i, int k) const {
    const Level& l = levels_[static_cast<std::size_t>(level)];
    return l.blocks[static_cast<std::size_t>(k) * static_cast<std::size_t>(l.width) + static_cast<std::size_t>(i)];
  }

  // The block of cells, and how high and low it is, in which POV-Ray's search looks at cell (i, k).
  struct SearchBlock {
    double x0, x1, z0, z1;
    std::uint16_t low, high;
  };
  const SearchBlock& search_block(int i, int k) const {
    return search_blocks_[static_cast<std::size_t>(k / search_depth_) * static_cast<std::size_t>(search_across_) +
                          static_cast<std::size_t>(i / search_width_)];
  }

  bool smooth() const { return smooth_; }
  // The sum of the unit normals of the up to four triangles around a sample, cut to multiples of 1/32767. Heights count
  // 65536 to a unit, so the vertical part is small and coarse, as it is in POV-Ray. Computed when it is first
  // asked for: few pictures look at all samples of a field.
  Vec3 smooth_normal(int i, int k) const;

 private:
  struct Level {
    Level() = default;
    Level(int children_wide, int children_deep)
        : width((children_wide - 1) / 4 + 1),
          depth((children_deep - 1) / 4 + 1),
          blocks(static_cast<std::size_t>(width) * static_cast<std::size_t>(depth)) {}
    int width = 0, depth = 0;
    std::vector<Block> blocks;
  };
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  Vec3 normal_from_heights(int i, int k) const;
  void batch_of_cells(int k, std::vector<std::uint16_t>& low, std::vector<std::uint16_t>& high) const;
  Level blocks_of_cells() const;
  static Level blocks_of_blocks(const Level& below);
  void build_pyramid();
  SearchBlock block_between(int i0, int i1, int k0, int k1) const;
  void build_search_blocks();

  std::shared_ptr<const scene::HeightMap> map_;
  int width_ = 0, depth_ = 0;
  double water_ = 0;
  Limits limits_;
  const std::uint16_t* heights_ = nullptr;  // of the map
  std::vector<Level> levels_;
  int search_width_ = 1, search_depth_ = 1, search_across_ = 0;  // cells of a block; blocks from left to right
  std::vector<SearchBlock> search_blocks_;
  bool smooth_ = false;
  // Normals that have been asked for: three times sixteen bits, and one that says so. What nobody looks at takes no
  // memory. Null: there was none, they are computed each time.
  std::unique_ptr<std::uint64_t[], Free> normals_;
};

}  // namespace verisim::shapes
