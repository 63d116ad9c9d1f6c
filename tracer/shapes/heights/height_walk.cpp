#include "tracer/shapes/heights/height_walk.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace verisim::shapes {
namespace {

// The smallest block that holds the cells of the ray between `enter` and `leave`.
HeightWalk::Block smallest_block(const HeightGrid& grid, const Vec3& o, const Vec3& d, double enter, double leave,
                                 double margin) {
  const auto first_and_last = [&](double from, double along, int cells) {
    const double a = from + enter * along, b = from + leave * along;
    const auto cell = [&](double at) { return static_cast<unsigned>(at > 0 ? std::min(at, cells - 1.0) : 0); };
    return std::pair(cell(std::min(a, b) - margin), cell(std::max(a, b) + margin));
  };
  const auto [i0, i1] = first_and_last(o.x, d.x, grid.width() - 1);
  const auto [k0, k1] = first_and_last(o.z, d.z, grid.depth() - 1);
  const int level = std::max(1, static_cast<int>(std::bit_width((i0 ^ i1) | (k0 ^ k1)) + 1) / 2);
  return {level, static_cast<int>(i0 >> 2 * level), static_cast<int>(k0 >> 2 * level), -HUGE_VALF};
}

const auto next_of_best = height_walk_kernels().next;

}  // namespace

HeightWalk::HeightWalk(const HeightGrid& grid, const Vec3& o, const Vec3& d, double enter, double leave) {
  State& s = state_;
  s.grid = &grid, s.origin = o;
  s.enter = static_cast<float>(enter - std::fabs(enter) * 1e-6);
  const auto reciprocal = [](double v) {
    return static_cast<float>(std::clamp(1 / (v == 0 ? 1e-30 : v), -1e30, 1e30));
  };
  s.inverse_x = reciprocal(d.x), s.inverse_z = reciprocal(d.z);
  for (int c = 0; c < HeightGrid::kChildren; ++c) {
    s.x_steps[c] = static_cast<float>(HeightGrid::column(c)) * s.inverse_x;
    s.z_steps[c] = static_cast<float>(HeightGrid::row(c)) * s.inverse_z;
  }
  s.backward_x = d.x < 0, s.backward_z = d.z < 0;
  s.flip = (s.backward_x ? 5u : 0u) | (s.backward_z ? 10u : 0u);
  s.height = static_cast<float>(o.y), s.slope = static_cast<float>(d.y);
  // Triangles are accepted slightly beyond their edges, and their planes reach beyond the heights at the corners by as
  // much.
  s.side_margin = static_cast<float>(1e-3 + 1e-6 * (std::fabs(o.x) + std::fabs(o.z) + grid.width() + grid.depth()));
  s.height_margin = static_cast<float>(1 + 1e-6 * (65536 + 2 * std::fabs(o.y)));
  s.waiting = 1;
  s.blocks[0] = smallest_block(grid, o, d, enter, leave, s.side_margin);
}

int HeightWalk::next(float end, HeightCell cells[kCells]) { return next_of_best(state_, end, cells); }

int HeightWalk::next(int set, float end, HeightCell cells[kCells]) {
  const HeightWalkKernels* kernels = height_walk_kernels(set);
  return kernels ? kernels->next(state_, end, cells) : -1;
}

}  // namespace verisim::shapes
