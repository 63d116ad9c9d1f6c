#include "tracer/shapes/mesh/mesh_packet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/mesh/mesh_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/bvh/node_rays-inl.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace accel::HWY_NAMESPACE;
using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/mesh/triangle_hit.inc"

// As triangle_hit.inc asks for them.
struct RaysOfTriangle {
  const double *o[3], *d[3];
  HWY_INLINE Packet origin(int axis) const { return load(o[axis]); }
  HWY_INLINE Packet direction(int axis) const { return load(d[axis]); }
};

// The search of eight rays in one mesh: they walk its tree together as long as two meet the same nodes, and from there
// one by one, by the formula for one ray.
class Search {
 public:
  HWY_INLINE Search(const MeshGeometry& mesh, unsigned active, double t_min, const double* t_max, bool any,
                    MeshPacket& p)
      : mesh_(mesh), any_(any), t_min_(t_min), p_(p) {
    const LocalPacket& r = p.rays;
    const double* const origin[3] = {r.ox, r.oy, r.oz};
    const double* const direction[3] = {r.dx, r.dy, r.dz};
    const accel::Bvh& tree = mesh.tree();
    enter_tree(tree.bounds(), tree.center(), tree.slack(), origin, direction, MeshGeometry::kNearest, there_);
    for (int k = 0; k < kLanes; ++k) {
      p.triangle[k] = -1;
      p.t[k] = t_max[k];
      near_enough(k);
    }
    open_ = entering(active, there_);
    p.passed_over = p.met_two = 0;
  }

  HWY_ATTR void run(const accel::EntryPoints* entry) {
    if (entry) {
      for (int n = entry->count - 1; n >= 0; --n) expand(entry->nodes[n], open_);
    } else if (open_ != 0) {
      expand(mesh_.tree().node(0), open_);
    }
    while (size_ > 0) {
      const Waiting& next = stack_[--size_];
      const unsigned lanes = next.lanes & open_ & bits(FloatPacket::load(next.near) <= FloatPacket::load(far_));
      if (lanes == 0) continue;
      const std::uint32_t child = next.child;
      if ((lanes & (lanes - 1)) == 0) {
        go_alone(child, std::countr_zero(lanes));
      } else if (child & BoxNode::kLeaf) {
        leaf(child, lanes);
      } else {
        expand(mesh_.tree().node(child), lanes);
      }
    }
  }

 private:
  using BoxNode = accel::BoxNode;
  struct alignas(64) Waiting {
    float near[kLanes];
    std::uint32_t child;
    unsigned lanes;
  };

  // Lowers the distance beyond which boxes do not concern lane k any more.
  HWY_INLINE void near_enough(int k) { far_[k] = accel::round_up(local_limit(k) - there_.start[k] + there_.slack); }
  HWY_INLINE double local_limit(int k) const {
    return std::min(MeshGeometry::kFarthest, p_.t[k] * p_.rays.scale[k] * (1 + 1e-12));
  }

  // The children that some of the lanes meet, the nearest on top.
  HWY_INLINE void expand(const BoxNode& node, unsigned lanes) {
    accel::ChildrenMet met;
    test_children(node, there_, FloatPacket::load(far_), met);
    Order order;
    for (int k = 0; k < 4; ++k) {
      met.lanes[k] &= lanes;
      if (met.lanes[k] != 0) order.add(k, met.near[k][std::countr_zero(met.lanes[k])]);
    }
    for (int i = 0; i < order.count; ++i) {
      const int k = order.child[i];
      push(node.child[k], met.lanes[k], FloatPacket::load(met.near[k]));
    }
  }
  // The same for one lane.
  HWY_INLINE void expand_alone(const BoxNode& node, int lane) {
    alignas(16) float near[4];
    Order order;
    for (unsigned met = lone_ray(lane).test(node, far_[lane], near); met != 0; met &= met - 1)
      order.add(std::countr_zero(met), near[std::countr_zero(met)]);
    for (int i = 0; i < order.count; ++i) push(node.child[order.child[i]], 1u << lane, FloatPacket(order.near[i]));
  }
  // Children of a node, the farthest first.
  struct Order {
    int child[4], count = 0;
    float near[4];
    HWY_INLINE void add(int k, float distance) {
      int at = count++;
      for (; at > 0 && near[at - 1] < distance; --at) near[at] = near[at - 1], child[at] = child[at - 1];
      near[at] = distance, child[at] = k;
    }
  };
  HWY_INLINE void push(std::uint32_t child, unsigned lanes, const FloatPacket& near) {
    Waiting& w = stack_[size_++];
    store(w.near, near);
    w.child = child, w.lanes = lanes;
  }
  // The ray of a lane that goes alone, made when it first does.
  HWY_INLINE const accel::NodeRay& lone_ray(int lane) {
    const auto at = [&](const accel::NodeRays::Lane* v) HWY_ATTR { return Vec3(v[0][lane], v[1][lane], v[2][lane]); };
    accel::NodeRay& ray = lone_[lane].ray;
    if (!(lone_made_ >> lane & 1)) ray = accel::NodeRay(at(there_.origin), at(there_.inverse));
    lone_made_ |= 1u << lane;
    return ray;
  }

  HWY_INLINE void leaf(std::uint32_t child, unsigned lanes) {
    const std::uint32_t first = BoxNode::leaf_first(child), end = first + BoxNode::leaf_count(child);
    const LocalPacket& r = p_.rays;
    const RaysOfTriangle rays{{r.ox, r.oy, r.oz}, {r.dx, r.dy, r.dz}};
    for (std::uint32_t i = first; i < end; ++i) {
      const MeshGeometry::Triangle& tri = mesh_.triangle(i);
      Packet t;
      const Mask hit = TriangleHit::meets(tri, tri.axes(), rays, MeshGeometry::kNearest, MeshGeometry::kFarthest, t);
      const unsigned met = bits(hit) & lanes & open_;
      if (met == 0) continue;
      alignas(64) double local[kLanes];
      store(local, t);
      for (unsigned rest = met; rest != 0; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        take(k, i, local[k]);
      }
    }
  }

  HWY_INLINE void go_alone(std::uint32_t child, int lane) {
    if (!(child & BoxNode::kLeaf)) {
      expand_alone(mesh_.tree().node(child), lane);
      return;
    }
    const LocalPacket& r = p_.rays;
    const Vec3 origin(r.ox[lane], r.oy[lane], r.oz[lane]), direction(r.dx[lane], r.dy[lane], r.dz[lane]);
    const std::uint32_t first = BoxNode::leaf_first(child), end = first + BoxNode::leaf_count(child);
    for (std::uint32_t i = first; i < end && (open_ >> lane & 1); ++i) {
      const double t = mesh_.hit(i, origin, direction);
      if (t >= 0) take(lane, i, t);
    }
  }

  // Lane k meets triangle i.
  HWY_INLINE void take(int k, std::uint32_t i, double local) {
    const double t = local / p_.rays.scale[k];
    if (t < t_min_) p_.passed_over |= 1u << k;
    const bool before = p_.triangle[k] >= 0;
    if (before && t >= t_min_) {
      if (MeshGeometry::in_one_place(t, p_.t[k]))
        p_.met_two |= 1u << k;
      else if (t < p_.t[k])
        p_.met_two &= ~(1u << k);
    }
    if (!(t >= t_min_) || !(before ? t <= p_.t[k] : t < p_.t[k])) return;
    if (before && t == p_.t[k] &&
        mesh_.triangle(i).id() < mesh_.triangle(static_cast<std::uint32_t>(p_.triangle[k])).id())
      return;
    p_.t[k] = t, p_.triangle[k] = i;
    near_enough(k);
    if (any_) open_ &= ~(1u << k);
  }

  const MeshGeometry& mesh_;
  const bool any_;
  const double t_min_;
  unsigned open_;
  MeshPacket& p_;
  accel::NodeRays there_;
  alignas(64) float far_[kLanes];
  Waiting stack_[accel::Bvh::kStackSize];
  int size_ = 0;
  // Without a value until it is made: most meshes are so small that clearing eight would show.
  union Lone {
    Lone() {}
    accel::NodeRay ray;
  };
  Lone lone_[kLanes];
  unsigned lone_made_ = 0;
};

void meet(const MeshGeometry& mesh, const accel::EntryPoints* entry, unsigned active, double t_min, const double* t_max,
          bool any, MeshPacket& packet) {
  Search(mesh, active, t_min, t_max, any, packet).run(entry);
}

void triangle(const FlatTriangle<double>& shape, PlaneAxes axes, const RayPacket& packet, double t_min,
              const double* t_max, PacketHits& met) {
  const auto &origin = packet.rays.origin, &direction = packet.rays.direction;
  const int first = packet.first;
  const RaysOfTriangle rays{{origin.x + first, origin.y + first, origin.z + first},
                            {direction.x + first, direction.y + first, direction.z + first}};
  Packet t;
  const Mask hit = TriangleHit::meets(shape, axes, rays, std::max(kTriangleNearest, t_min), kTriangleFarthest, t);
  store(met.t, t);
  store(met.part, select(hit & (t < load(t_max)), IntPacket(0), IntPacket(-1)));
}

const MeshKernels kKernels = {meet, triangle};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(MeshKernels, mesh_kernels)
}  // namespace verisim::shapes
#endif
