// Automatic boxes of quadrics, with POV-Ray's two errors that change pictures: they cull whole rays (spec 03 4.11).
#include <algorithm>

#include "tracer/scene/bounds.h"
#include "tracer/scene/complement.h"

namespace verisim::scene {
namespace {

double clean(double v) { return std::fabs(v) < kEpsilon ? 0.0 : v; }
Vec3 clean(const Vec3& v) { return {clean(v.x), clean(v.y), clean(v.z)}; }

// The axis of a cone or a hyperboloid of one sheet; -1: it is neither.
int hyperboloid_axis(const Vec3& sq, double j) {
  int odd = -1;
  if (sq.x > 0 && sq.y < 0 && sq.z < 0) odd = 0;
  if (sq.x > 0 && sq.y < 0 && sq.z > 0) odd = 1;
  if (sq.x > 0 && sq.y > 0 && sq.z < 0) odd = 2;
  const bool cone = j == 0, one_sheet = odd == 0 ? j > 0 : j < 0;
  return cone || one_sheet ? odd : -1;
}

// The box of a quadric without mixed terms whose centre (or vertex) was moved to the origin, within `range`. False:
// unknown form.
bool fit_centered(Vec3 sq, Vec3 lin, double j, const BoxRange& range, Vec3& low, Vec3& high) {
  low = range.low, high = range.high;
  const auto set = [&](int k, double half) { low[k] = -half, high[k] = half; };
  const int zeros = (sq.x == 0) + (sq.y == 0) + (sq.z == 0);

  if (sq.x > 0 && sq.y > 0 && sq.z > 0 && j < 0) {  // ellipsoid
    for (int k = 0; k < 3; ++k) set(k, std::sqrt(-j / sq[k]));
    return true;
  }
  if (zeros == 1 && j < 0 && lin == Vec3(0)) {  // elliptic cylinder
    bool positive = true;
    for (int k = 0; k < 3; ++k) positive = positive && sq[k] >= 0;
    if (!positive) return false;
    for (int k = 0; k < 3; ++k)
      if (sq[k] != 0) set(k, std::sqrt(-j / sq[k]));
    return true;
  }
  if (zeros == 0) {
    const int odd = hyperboloid_axis(sq, j);
    if (odd < 0) return false;
    for (int k = 0; k < 3; ++k) {
      if (k == odd) continue;
      double half = 0;
      for (const double q : {range.low[odd], range.high[odd]}) {
        // POV-Ray takes 1 where |j| belongs.
        const double square = ((j == 0 ? 0.0 : 1.0) + std::fabs(sq[odd]) * q * q) / std::fabs(sq[k]);
        half = std::max(half, std::sqrt(square));
      }
      set(k, half);
    }
    return true;
  }
  if (zeros == 1 && j == 0) {  // paraboloid
    const int axis = sq.x == 0 ? 0 : sq.y == 0 ? 1 : 2;
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    if (lin[axis] == 0 || sq[a] * sq[b] <= 0) return false;
    if (sq[a] / lin[axis] < 0)
      low[axis] = std::max(low[axis], 0.0);
    else
      high[axis] = std::min(high[axis], 0.0);
    for (const int k : {a, b}) {
      double half = 0;
      for (const double q : {low[axis], high[axis]}) half = std::max(half, std::sqrt(std::fabs(lin[axis] * q / sq[k])));
      set(k, half);
    }
    return true;
  }
  return false;
}

}  // namespace

void fit_quadric(Object& object, BoxRange range) {
  const Quadric& q = *object.as<Quadric>();
  bool limited = false;
  for (const ObjectPtr& clip : object.clipped_by) {
    if (object.clip_from_bound) break;
    limited = limited || !is_complement(*clip);
    if (clip->as<Plane>())
      clip_by_plane(*clip, range);
    else if (!is_complement(*clip))
      range.clip(clip->bounds);
  }
  Vec3 sq = clean(q.square), lin = clean(q.linear);
  const Vec3 mixed = clean(q.mixed);
  double j = clean(q.constant);

  Vec3 low = range.low, high = range.high;
  if (mixed != Vec3(0)) {
    if (object.clips_in_bounds == 0) object.automatic_box = false;  // as defined; rotation alone does not take it away
  } else {
    Vec3 shift(0);
    const double constant = j;
    for (int k = 0; k < 3; ++k) {
      if (sq[k] != 0) {
        shift[k] = -lin[k] / (2 * sq[k]);
        j -= sq[k] * shift[k] * shift[k];
        lin[k] = 0;
      } else if (lin[k] != 0) {
        shift[k] = constant / lin[k];  // POV-Ray's sign; the vertex is at -constant / lin
        j -= constant;
      }
    }
    j = clean(j);
    if (sq.x < 0) sq = -sq, lin = -lin, j = -j;
    object.automatic_box = limited || hyperboloid_axis(sq, j) < 0;
    BoxRange moved{range.low - shift, range.high - shift};
    if (!fit_centered(sq, lin, j, moved, low, high)) return;
    for (int k = 0; k < 3; ++k)
      low[k] = std::max(low[k], moved.low[k]) + shift[k], high[k] = std::min(high[k], moved.high[k]) + shift[k];
  }
  // A long side would make the box unbounded, which is never smaller than the present one.
  for (int k = 0; k < 3; ++k)
    if (!(high[k] - low[k] <= kCriticalLength)) return;
  const Bounds fitted = make_bounds(low, high);
  if (volume(fitted) < volume(object.bounds)) object.bounds = fitted;
}

}  // namespace verisim::scene
