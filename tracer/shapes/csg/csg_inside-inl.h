// Which points are inside a part of a CSG tree. `Number` is a packet of the points that go together: Packet, or
// PacketOf<1>.
// Included once for each target by kernels.
#if defined(VERISIM_SHAPES_CSG_CSG_INSIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_SHAPES_CSG_CSG_INSIDE_INL_H
#undef VERISIM_SHAPES_CSG_CSG_INSIDE_INL_H
#else
#define VERISIM_SHAPES_CSG_CSG_INSIDE_INL_H
#endif

#include "tracer/math/packet_vector-inl.h"
#include "tracer/shapes/intersections.h"
#include "tracer/shapes/csg/csg_tree.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/quadrics/box_intersections.inc"
#include "tracer/shapes/quadrics/cone_intersections.inc"
#include "tracer/shapes/quadrics/plane_intersections.inc"
#include "tracer/shapes/quadrics/quadric_intersections.inc"
#include "tracer/shapes/quadrics/sphere_intersections.inc"

template <class Number>
HWY_INLINE Vec3 lane_of(const PacketVector<Number>& p, int k) {
  return {p.x[k], p.y[k], p.z[k]};
}

// As the shapes' `formula`.
template <class Number>
unsigned inside_simple(const CsgNode& n, const PacketVector<Number>& at) {
  const SimpleSolid& s = n.simple;
  // Not copied where there is no matrix: GCC copies by halves of the widest registers, and who reads them whole waits.
  PacketVector<Number> moved;
  if (s.matrix) moved = transform_point(s.matrix->inv, at);
  const PacketVector<Number>& p = s.matrix ? moved : at;
  const unsigned turned = s.inverted ? (1u << Number::kCount) - 1 : 0;
  switch (s.form) {
    case SimpleSolid::Form::plane:
      return bits(within_plane(s.a, s.c, p)) ^ turned;
    case SimpleSolid::Form::sphere: {
      const Number distance2 = distance2_between(p, s.a);
      return bits(s.inverted ? distance2 > s.c : distance2 < s.c);
    }
    case SimpleSolid::Form::box:
      return bits(within_box(p, s.a, s.b)) ^ turned;
    case SimpleSolid::Form::cone:
      return bits(within_cone(p, s.cylinder, s.open, s.c)) ^ turned;
    default:
      return bits(quadric_inside(*s.quadric, p));
  }
}

// Of `lanes`, those whose points are within a prism's outline. As Prism::covers: segments that the line from a point
// along +x may meet count where they do.
template <class Number>
unsigned covered(const CsgNode& n, unsigned lanes, const Number& x, const Number& z) {
  const Rectangle& r = n.walls->outline;
  lanes &= bits((x <= r.max.x) & (x >= r.min.x) & (z >= r.min.y) & (z <= r.max.y));
  unsigned odd = 0;
  for (const BoundedSegment& w : n.walls->segments) {
    const typename Number::Mask level = (z >= w.z_low) & (z <= w.z_high) & (x <= w.x_high);
    const unsigned met = bits(level) & lanes, right = w.z_low != w.z_high ? met & bits(x < w.x_low) : 0;
    odd ^= right;
    const unsigned beside = met & ~right;
    if (beside == 0 || std::fabs(w.dz) < kEpsilon) continue;
    const Number at = -(Number(w.z) - z) / w.dz;
    odd ^= beside & bits((at >= 0) & (at <= 1) & (w.dx * at + w.x >= x));
  }
  return odd;
}

template <class Number>
unsigned inside_prism(const CsgNode& n, unsigned lanes, const PacketVector<Number>& at) {
  const StraightPrism::Walls& w = *n.walls;
  const PacketVector<Number> p = w.matrix ? transform_point(w.matrix->inv, at) : at;
  const unsigned level = bits((p.y >= w.low) & (p.y < w.high)) & lanes;
  const unsigned within = level != 0 ? covered(n, level, p.x, p.z) : 0;
  return w.inverted ? lanes & ~within : within;
}

template <class Number>
unsigned inside_parts(const CsgTree& tree, const CsgNode& n, unsigned lanes, const PacketVector<Number>& p);

// Of `lanes`, those whose points are inside a node.
template <class Number>
unsigned inside(const CsgTree& tree, const CsgNode& n, unsigned lanes, const PacketVector<Number>& p) {
  if (n.boxed_solid) {
    const unsigned here = bits((p.x >= n.solid.min.x) & (p.x <= n.solid.max.x) & (p.y >= n.solid.min.y) &
                               (p.y <= n.solid.max.y) & (p.z >= n.solid.min.z) & (p.z <= n.solid.max.z)) &
                          lanes;
    const unsigned beyond = n.far_is_inside ? lanes & ~here : 0;
    return here == 0 ? beyond : beyond | inside_parts(tree, n, here, p);
  }
  return inside_parts(tree, n, lanes, p);
}
template <class Number>
unsigned inside_parts(const CsgTree& tree, const CsgNode& n, unsigned lanes, const PacketVector<Number>& p) {
  for (std::uint32_t i = 0; i < n.clip_count && lanes != 0; ++i)
    lanes = inside(tree, tree.nodes[tree.children[n.clips + i]], lanes, p);
  if (lanes == 0) return 0;
  switch (n.kind) {
    case CsgNode::Kind::simple:
      return inside_simple(n, p) & lanes;
    case CsgNode::Kind::prism:
      return inside_prism(n, lanes, p);
    case CsgNode::Kind::intersection:
      for (std::uint32_t i = 0; i < n.child_count && lanes != 0; ++i)
        lanes = inside(tree, tree.nodes[tree.children[n.children + i]], lanes, p);
      return lanes;
    case CsgNode::Kind::sum: {
      unsigned found = 0;
      for (std::uint32_t i = 0; i < n.child_count && lanes != found; ++i)
        found |= inside(tree, tree.nodes[tree.children[n.children + i]], lanes & ~found, p);
      return found;
    }
    default: {
      unsigned found = 0;
      each_lane(lanes, [&](int k) {
        const Vec3 at = lane_of(p, k);
        found |= n.shape->inside(at) ? 1u << k : 0;
      });
      return found;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#endif
