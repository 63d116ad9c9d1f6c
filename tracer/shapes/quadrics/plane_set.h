// The planes of one solid, eight at a time against one ray or one point: what is found is what each plane finds alone
// (spec 03 4.5). Compiled for several instruction sets; every lane does the operations of the scalar code in the same
// order.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "tracer/math/ray_batch.h"

namespace verisim::shapes {

// Eight planes as arrays; behind the last plane of a set stand planes that nothing meets.
struct alignas(64) EightPlanes {
  double x[8] = {}, y[8] = {}, z[8] = {}, distance[8] = {};
  double side[8] = {};  // 1: what lies behind is inside, -1: what lies before
};

struct PlaneKernels {
  // Bit i: the ray meets plane i, at t[i]. Raises `enter` and lowers `leave` to where the ray comes to lie inside all
  // planes and where it leaves one of them, by `doubt` before and behind the planes.
  unsigned (*meet)(const EightPlanes& planes, const Ray& ray, double doubt, double* t, double& enter, double& leave);
  // Bit i: p lies behind plane i, not inverted.
  unsigned (*behind)(const EightPlanes& planes, const Vec3& p);
  // Bit k: ray k of a batch, from `first`, meets plane i, at t[k]. Raises enter[k] and lowers leave[k] in the same way.
  unsigned (*meet_batch)(const EightPlanes& planes, int i, const RayBatch& rays, int first, const double* doubt,
                         double* t, double* enter, double* leave);
  // Raises near[k] and lowers far[k] to where ray k is inside a box: to nowhere, if it misses it.
  void (*clip_batch)(const Box3& box, const RayBatch& rays, int first, double* near, double* far);
};

// Those of any instruction set, for tests; null: this machine cannot run it.
const PlaneKernels* plane_kernels(int instruction_set);
// Those of the best instruction set of this machine.
const PlaneKernels& plane_kernels();

class PlaneSet {
 public:
  static constexpr int kMax = 64;

  // Far more than a hit's point may be off the ray and than the inside test's own tolerance: what this leaves out, that
  // would refuse.
  static double doubt_at(const Vec3& origin) {
    return 1e-6 * (1 + std::fabs(origin.x) + std::fabs(origin.y) + std::fabs(origin.z));
  }

  PlaneSet();
  bool full() const { return count_ == kMax; }
  int size() const { return count_; }
  void add(const Vec3& normal, double distance, bool inverted);

  // Bit i: the ray meets plane i, at t[i]; there is room for kMax. enter .. leave is narrowed to where points of the
  // ray may be inside all planes.
  std::uint64_t meet(const Ray& ray, double* t, double& enter, double& leave) const {
    const double doubt = doubt_at(ray.origin);
    std::uint64_t met = 0;
    for (std::size_t k = 0; k < blocks_.size(); ++k)
      met |= std::uint64_t{kernels_.meet(blocks_[k], ray, doubt, t + 8 * k, enter, leave)} << 8 * k;
    return met;
  }
  // The same for eight rays: bit k of met[i] tells whether ray k meets plane i, at t[i][k].
  struct Lanes {
    alignas(64) double t[kMax][RayPacket::kCount];
    unsigned met[kMax];
  };
  void meet(const RayPacket& rays, Lanes& lanes, double* enter, double* leave) const;
  // Narrows near .. far to where rays are inside a box.
  void clip(const Box3& box, const RayPacket& rays, double* near, double* far) const {
    kernels_.clip_batch(box, rays.rays, rays.first, near, far);
  }
  // Bit i: p is not inside plane i.
  std::uint64_t outside(const Vec3& p) const {
    std::uint64_t behind = 0;
    for (std::size_t k = 0; k < blocks_.size(); ++k) behind |= std::uint64_t{kernels_.behind(blocks_[k], p)} << 8 * k;
    return (behind ^ inside_) & all_;
  }

 private:
  const PlaneKernels& kernels_;
  std::vector<EightPlanes> blocks_;
  std::uint64_t all_ = 0, inside_ = 0;  // which planes there are; of which of them the back is inside
  int count_ = 0;
};

}  // namespace verisim::shapes
