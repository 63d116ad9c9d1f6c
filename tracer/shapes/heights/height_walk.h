// The way of a ray over a height field: finds the cells that it may meet, from near to far, in the pyramid of extremes.
// Sixteen children of a block are tested at once. It only narrows: single precision with margins for its rounding.
// Compiled for several instruction sets.
#pragma once

#include "tracer/shapes/heights/height_grid.h"

namespace verisim::shapes {

struct HeightCell {
  int i, k;
  float near;  // the ray enters it here, or later
};

class HeightWalk {
 public:
  static constexpr int kCells = HeightGrid::kChildren;  // most at a time

  // A ray in grid units, between `enter` and `leave`.
  HeightWalk(const HeightGrid& grid, const Vec3& o, const Vec3& d, double enter, double leave);

  // The next cells that may be met before `end`; how many, 0: there are no more. `end` may shrink from call to call.
  int next(float end, HeightCell cells[kCells]);

  // The same with a given instruction set, for tests; -1: this machine cannot run it.
  int next(int instruction_set, float end, HeightCell cells[kCells]);

  struct Block {
    int level, i, k;
    float near;
  };
  // All that the kernels need.
  struct State {
    alignas(64) float x_steps[HeightGrid::kChildren],
        z_steps[HeightGrid::kChildren];  // what it takes to get to a child, for children of one cell
    const HeightGrid* grid;
    Vec3 origin;
    float inverse_x, inverse_z, height, slope, side_margin, height_margin, enter;
    bool backward_x, backward_z;
    unsigned flip;  // child n ^ flip is the nth along the ray
    int waiting;
    Block blocks[HeightGrid::kMaxLevels * HeightGrid::kChildren];
  };

 private:
  State state_;
};

// Bit n becomes bit n ^ flip: children of a block in the order in which a ray meets them.
inline unsigned in_order(unsigned bits, bool backward_x, bool backward_z) {
  const auto swapped = [](unsigned b, unsigned low, int by) { return (b & low) << by | (b >> by & low); };
  if (backward_x) bits = swapped(swapped(bits, 0x5555, 1), 0x0f0f, 4);
  if (backward_z) bits = swapped(swapped(bits, 0x3333, 2), 0x00ff, 8);
  return bits;
}

struct HeightWalkKernels {
  int (*next)(HeightWalk::State& state, float end, HeightCell* cells);
};
// Those of the best instruction set of this machine; of any set, for tests; null: this machine cannot run it.
const HeightWalkKernels& height_walk_kernels();
const HeightWalkKernels* height_walk_kernels(int instruction_set);

}  // namespace verisim::shapes
