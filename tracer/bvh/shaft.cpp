#include "tracer/bvh/shaft.h"

namespace verisim::accel {

std::optional<Shaft> Shaft::between(const Box3& from, const Box3& to) {
  // The axis with the widest gap between the boxes.
  int axis = -1;
  double gap = 0, widest = 0;
  for (int i = 0; i < 3; ++i) {
    const double g = std::fmax(to.min[i] - from.max[i], from.min[i] - to.max[i]);
    if (g > gap) gap = g, axis = i;
    widest = std::fmax(widest, std::fmax(from.max[i] - from.min[i], to.max[i] - to.min[i]));
    if (!std::isfinite(from.min[i] + from.max[i] + to.min[i] + to.max[i])) return std::nullopt;
  }
  if (axis < 0 || !(gap > 0.5 * widest)) return std::nullopt;
  Shaft shaft;
  shaft.axis_ = axis;
  shaft.from_ = from, shaft.to_ = to;
  shaft.low_ = std::fmin(from.min[axis], to.min[axis]);
  shaft.high_ = std::fmax(from.max[axis], to.max[axis]);
  const Box3 &left = from.max[axis] < to.min[axis] ? from : to, &right = &left == &from ? to : from;
  int n = 0;
  for (int other = 0; other < 3; ++other) {
    if (other == axis) continue;
    for (const bool upper : {false, true}) {
      // The line through a corner of either box that has both boxes on one side: through the left corners if it leads
      // away from the boxes, else through the right ones.
      const double y0 = upper ? left.max[other] : left.min[other], y1 = upper ? right.max[other] : right.min[other];
      const bool outwards = upper ? y1 > y0 : y1 < y0;
      const double x0 = outwards ? left.min[axis] : left.max[axis], x1 = outwards ? right.min[axis] : right.max[axis];
      const double slope = (y1 - y0) / (x1 - x0);
      shaft.sides_[n++] = {other, upper, slope, y0 - slope * x0};
    }
  }
  return shaft;
}

NodeShaft::NodeShaft(const Shaft& shaft, const Vec3& center, double slack) {
  const int axis = shaft.axis();
  low_plane_ = 4 * axis, high_plane_ = 12 + 4 * axis;
  low_ = Float4(round_down(shaft.low() - center[axis] - slack));
  high_ = Float4(-round_down(-(shaft.high() - center[axis] + slack)));
  for (int i = 0; i < 4; ++i) {
    const Shaft::Side& from = shaft.side(i);
    Side& to = sides_[i];
    const double sign = from.upper ? -1 : 1, slope = sign * from.slope;
    // Widened like the boxes once more, and by the rounding of far-away lines.
    double offset = sign * (from.slope * center[axis] + from.offset - center[from.other]);
    offset -= (1 + std::fabs(slope)) * slack + 4e-7 * std::fabs(offset) +
              1e-14 * (std::fabs(from.offset) + std::fabs(from.slope * center[axis]));
    to.slope = Float4(static_cast<float>(slope));
    to.offset = Float4(static_cast<float>(offset));
    to.sign = Float4(static_cast<float>(sign));
    to.face = from.upper ? 4 * from.other : 12 + 4 * from.other;
    to.end = slope >= 0 ? 4 * axis : 12 + 4 * axis;
  }
}

}  // namespace verisim::accel
