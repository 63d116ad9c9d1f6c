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

constexpr int kAlone = 2;  // so many rays cost less one by one

// The search of eight rays in one mesh: they walk its tree together as long as enough of them meet the same nodes.
class Search {
 public:
  HWY_INLINE Search(const MeshGeometry& mesh, unsigned active, double t_min, const double* t_max, bool any,
                    MeshPacket& p)
      : mesh_(mesh), any_(any), t_min_(t_min), open_(active), p_(p) {
    const LocalPacket& r = p.rays;
    const double* const origin[3] = {r.ox, r.oy, r.oz};
    const double* const direction[3] = {r.dx, r.dy, r.dz};
    const accel::Bvh& tree = mesh.tree();
    enter_tree(tree.bounds(), tree.center(), tree.slack(), origin, direction, MeshGeometry::kNearest, there_);
    for (int k = 0; k < kLanes; ++k) {
      p.triangle[k] = -1;
      p.t[k] = t_max[k];
      near_enough(k);
      // Strange numbers would defeat the comparisons of boxes.
      const float sum = there_.origin[0][k] + there_.origin[1][k] + there_.origin[2][k];
      if (!(there_.start[k] < HUGE_VAL && std::fabs(sum) < HUGE_VALF)) open_ &= ~(1u << k);
    }
    p.passed_over = 0;
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
      if (std::popcount(lanes) <= kAlone) {
        for (unsigned rest = lanes; rest != 0; rest &= rest - 1) walk_alone(child, std::countr_zero(rest));
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
    int order[4], count = 0;
    float near[4];
    for (int k = 0; k < 4; ++k) {
      met.lanes[k] &= lanes;
      if (met.lanes[k] == 0) continue;
      const float distance = met.near[k][std::countr_zero(met.lanes[k])];
      int at = count++;
      for (; at > 0 && near[at - 1] < distance; --at) near[at] = near[at - 1], order[at] = order[at - 1];
      near[at] = distance, order[at] = k;
    }
    for (int i = 0; i < count; ++i) {
      Waiting& w = stack_[size_++];
      const int k = order[i];
      store(w.near, FloatPacket::load(met.near[k]));
      w.child = node.child[k], w.lanes = met.lanes[k];
    }
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

  HWY_ATTR void walk_alone(std::uint32_t child, int k) {
    const LocalPacket& r = p_.rays;
    const Vec3 origin(r.ox[k], r.oy[k], r.oz[k]), direction(r.dx[k], r.dy[k], r.dz[k]);
    const auto limit = [&]() HWY_ATTR { return open_ >> k & 1 ? local_limit(k) : -HUGE_VAL; };
    accel::EntryPoints entry;
    BoxNode& node = entry.nodes[0];
    node.clear();
    for (int i = 0; i < 6; ++i) node.planes[i][0] = i < 3 ? -3e37f : 3e37f;  // met by every ray
    node.child[0] = child;
    entry.count = 1;
    mesh_.tree().traverse_leaves(
        {origin, direction}, MeshGeometry::kNearest, limit(),
        [&](std::uint32_t first, std::uint32_t count, double) HWY_ATTR {
          for (std::uint32_t i = first; i < first + count; ++i) {
            const double t = mesh_.hit(i, origin, direction);
            if (t >= 0) take(k, i, t);
          }
          return limit();
        },
        &entry);
  }

  // Lane k meets triangle i.
  HWY_INLINE void take(int k, std::uint32_t i, double local) {
    const double t = local / p_.rays.scale[k];
    if (t < t_min_) p_.passed_over |= 1u << k;
    const bool before = p_.triangle[k] >= 0;
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
