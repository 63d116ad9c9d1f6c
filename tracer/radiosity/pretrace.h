// Where the radiosity pretrace looks: positions in the picture, pass by pass (spec 07 section 2.9).
#pragma once

#include <vector>

#include "tracer/math/vec.h"
#include "tracer/scene/scene.h"

namespace verisim::global {

struct PretracePlan {
  double first = 0, last = 1;  // spacing in pixels
  int passes = 0;
  double spacing(int pass) const;
};
PretracePlan pretrace_plan(const scene::Radiosity& description, int width, int height);

// Pixels with left <= x < right and top <= y < bottom, where the centre of pixel (i, j) is (i, j). Parts of a tile have
// real borders.
struct PretraceBlock {
  double left, top, right, bottom;
};

// The queries of primary hits made so far, and the sum of the weights that they found.
struct PretraceQueries {
  int count = 0;
  double weight = 0;
};

// One tile of the picture on its way through the passes. Blocks of it are done with early: those without any query
// (sky), and, if nearest_count has its second value, those whose queries find that weight on average. For the latter a
// tile is cut into smaller blocks from pass to pass, as long as each has four positions in a row. (Which positions are
// in which block, and that those of blocks that are done with take no jitter, measured with 3.7.0.10.)
class PretraceTile {
 public:
  PretraceTile(int number, const PretraceBlock& tile) : number_(number), tile_(tile), blocks_{tile} {}

  bool finished() const { return blocks_.empty(); }
  // Calls look(x, y) for the positions of a pass in POV-Ray's order; queries() tells what was asked for until then.
  // `adaptive`: the second value; 0: none.
  template <class Look, class Queries>
  void run(const PretracePlan& plan, int pass, int adaptive, Look&& look, Queries&& queries);

 private:
  // Of a block; `draw` is the place in the table of jitter.
  static void positions(const PretraceBlock& block, double spacing, int& draw, std::vector<Vec2>& out);
  int first_draw(int pass) const;
  void split(double spacing);

  int number_;
  PretraceBlock tile_;
  std::vector<PretraceBlock> blocks_;
  int across_ = 1, down_ = 1;  // how many blocks the tile is cut into
};

template <class Look, class Queries>
void PretraceTile::run(const PretracePlan& plan, int pass, int adaptive, Look&& look, Queries&& queries) {
  constexpr std::size_t kMin = 9;  // positions that tell anything
  std::vector<PretraceBlock> left;
  std::vector<Vec2> at;
  int draw = first_draw(pass);
  for (const PretraceBlock& block : blocks_) {
    positions(block, plan.spacing(pass), draw, at);
    const PretraceQueries before = queries();
    for (const Vec2& p : at) look(p.x, p.y);
    const PretraceQueries after = queries();
    const int active = after.count - before.count;
    const bool done =
        at.size() >= kMin && (active == 0 || (adaptive > 0 && (after.weight - before.weight) / active >= adaptive));
    if (!done) left.push_back(block);
  }
  blocks_ = std::move(left);
  if (adaptive > 0 && pass + 1 < plan.passes) split(plan.spacing(pass + 1));
}

}  // namespace verisim::global
