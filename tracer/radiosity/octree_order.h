// The order in which POV-Ray's octree of radiosity samples is walked (spec 07 2.8): the children of a node before what
// is filed in the node itself, children by x, then y, then z.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>

namespace verisim::global {

// A cube of the lattice: its index along each axis, and the power of two that is its side.
struct LatticeCell {
  static constexpr int kMinLevel = -6, kMaxLevel = 63;  // of cells that samples are filed in
  std::int64_t x = 0, y = 0, z = 0;
  int level = 0;
  LatticeCell parent() const { return {x >> 1, y >> 1, z >> 1, level + 1}; }
  friend bool operator==(const LatticeCell&, const LatticeCell&) = default;
};

// Where a cell comes in the walk. A cell comes where the last of the smallest cells in it would, behind it: the bits of
// that one's coordinates in turn (Morton's code), and the level.
class OctreeOrder {
 public:
  OctreeOrder() = default;
  // cell: with indices that are not negative.
  explicit OctreeOrder(const LatticeCell& cell) {
    const int finer = cell.level - LatticeCell::kMinLevel;
    const auto last = [shift = std::min(finer, kBits)](std::int64_t index) {  // larger cubes hold all there is
      return (static_cast<std::uint64_t>(index + 1) << shift) - 1;
    };
    const std::uint64_t x = last(cell.x), y = last(cell.y), z = last(cell.z);
    constexpr int kHalf = kBits / 2;
    constexpr std::uint64_t kLower = (std::uint64_t{1} << kHalf) - 1;
    upper_ = interleaved(x >> kHalf, y >> kHalf, z >> kHalf);
    lower_ = interleaved(x & kLower, y & kLower, z & kLower) << kLevelBits | static_cast<std::uint64_t>(finer);
  }
  // Without branches: what is compared is in no order that a processor could foretell.
  friend bool operator<(const OctreeOrder& a, const OctreeOrder& b) {
    return static_cast<int>(a.upper_ < b.upper_) |
           (static_cast<int>(a.upper_ == b.upper_) & static_cast<int>(a.lower_ < b.lower_));
  }
  friend bool operator==(const OctreeOrder&, const OctreeOrder&) = default;

 private:
  // Of coordinates below 2^32 in units of the smallest side; 3 * kBits / 2 + kLevelBits fit in a word.
  static constexpr int kBits = 32 - LatticeCell::kMinLevel, kLevelBits = 7;

  static std::uint64_t interleaved(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    return spread(x) << 2 | spread(y) << 1 | spread(z);
  }
  // Two zeros between any two bits of 21.
  static std::uint64_t spread(std::uint64_t v) {
    v &= 0x1FFFFF;
    v = (v | v << 32) & 0x1F00000000FFFF;
    v = (v | v << 16) & 0x1F0000FF0000FF;
    v = (v | v << 8) & 0x100F00F00F00F00F;
    v = (v | v << 4) & 0x10C30C30C30C30C3;
    return (v | v << 2) & 0x1249249249249249;
  }

  std::uint64_t upper_ = 0, lower_ = 0;
};

}  // namespace verisim::global
