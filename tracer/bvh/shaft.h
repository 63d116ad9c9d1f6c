// A shaft: all segments between two boxes (Haines and Wallace, "Shaft culling for efficient ray-traced radiosity",
// 1991). Camera rays of a few neighbouring pixels lie in one, and so do shadow rays from neighbouring points to a
// light.
#pragma once

#include <optional>

#include "tracer/bvh/box_node.h"

namespace verisim::accel {

class Shaft {
 public:
  // Nothing if the boxes are so close together, for their size, that the shaft would say little.
  static std::optional<Shaft> between(const Box3& from, const Box3& to);

  // The axis along which the boxes are apart, and lines below and above both in the two planes of that axis and
  // another: other >= / <= slope * axis + offset.
  struct Side {
    int other;
    bool upper;
    double slope, offset;
  };
  int axis() const { return axis_; }
  const Side& side(int i) const { return sides_[i]; }
  const Box3& from() const { return from_; }
  const Box3& to() const { return to_; }
  double low() const { return low_; }  // along axis()
  double high() const { return high_; }

 private:
  int axis_ = 0;
  double low_ = 0, high_ = 0;
  Side sides_[4];
  Box3 from_, to_;
};

// A shaft in the single precision of the nodes of one tree.
class NodeShaft {
 public:
  // Nodes are relative to `center`, and widened by `slack`.
  NodeShaft(const Shaft& shaft, const Vec3& center, double slack);

  // Bit k: the shaft may meet child k.
  unsigned test(const BoxNode& node) const {
    const float* planes = node.planes[0];
    Mask4 met = (Float4::load(planes + low_plane_) <= high_) & (low_ <= Float4::load(planes + high_plane_));
    for (const Side& s : sides_) {
      // A lower side is met where its line, at the end of the box where it is lowest, lies below the upper face; an
      // upper side is turned into a lower one by changing signs.
      const Float4 line = Float4::load(planes + s.end) * s.slope + s.offset;
      met = met & (line <= Float4::load(planes + s.face) * s.sign);
    }
    return met.bits();
  }

 private:
  struct Side {
    Float4 slope, offset, sign;
    int face, end;  // in floats from the start of a node
  };
  Side sides_[4];
  Float4 low_, high_;
  int low_plane_, high_plane_;
};

}  // namespace verisim::accel
