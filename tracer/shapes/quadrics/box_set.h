// A few boxes, eight at a time against one ray or one point: what a tree would find, sooner. Compiled for several
// instruction sets; all find the same.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "tracer/math/vec.h"

namespace verisim::shapes {

// Eight boxes as arrays; what stands behind the last box of a set means nothing.
struct alignas(64) EightBoxes {
  double low[3][8] = {}, high[3][8] = {};
};

struct BoxKernels {
  // Bit i: the ray, whose direction has these reciprocals, meets box i between t_min and t_max.
  unsigned (*meet)(const EightBoxes& boxes, const Vec3& origin, const Vec3& reciprocal, double t_min, double t_max);
  // The same; near[i]: where it enters those.
  unsigned (*meet_at)(const EightBoxes& boxes, const Vec3& origin, const Vec3& reciprocal, double t_min, double t_max,
                      double* near);
  // Bit i: box i contains p.
  unsigned (*around)(const EightBoxes& boxes, const Vec3& p);
};

// Those of any instruction set, for tests; null: this machine cannot run it.
const BoxKernels* box_kernels(int instruction_set);
// Those of the best instruction set of this machine.
const BoxKernels& box_kernels();

class BoxSet {
 public:
  static constexpr std::size_t kMax = 32;

  BoxSet();
  // Not empty and not unbounded ones, kMax of them at most. Like the boxes of a tree, they are taken a little larger
  // than they are.
  explicit BoxSet(std::span<const Box3> boxes);
  bool empty() const { return blocks_.empty(); }

  // The boxes, as bits, that a ray may meet between t_min and t_max.
  std::uint32_t meet(const Ray& ray, double t_min, double t_max) const {
    const Vec3 inverse = reciprocal(ray.direction);
    std::uint32_t met = 0;
    for (std::size_t n = 0; n < blocks_.size(); ++n)
      met |= std::uint32_t{kernels_->meet(blocks_[n], ray.origin, inverse, t_min, t_max)} << 8 * n;
    return met & all_;
  }
  // Calls visit(box, t_max) -> t_max for the boxes that a ray meets between t_min and t_max, from near to far, as a
  // tree does.
  template <class Visit>
  void traverse(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
    if (!is_ray(ray)) return;
    const Vec3 inverse = reciprocal(ray.direction);
    alignas(64) double near[kMax];
    std::uint32_t met = 0;
    for (std::size_t n = 0; n < blocks_.size(); ++n)
      met |= std::uint32_t{kernels_->meet_at(blocks_[n], ray.origin, inverse, t_min, t_max, near + 8 * n)} << 8 * n;
    met &= all_;
    while (met != 0) {
      int next = std::countr_zero(met);
      for (std::uint32_t others = met & (met - 1); others != 0; others &= others - 1)
        if (const int k = std::countr_zero(others); near[k] < near[next]) next = k;
      if (near[next] > t_max) return;
      met &= ~(std::uint32_t{1} << next);
      t_max = visit(static_cast<std::uint32_t>(next), t_max);
    }
  }
  // Calls visit(box) for the boxes that a ray meets, in any order, until it returns true. Returns whether it did.
  template <class Visit>
  bool any_along(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
    if (!is_ray(ray)) return false;
    for (std::uint32_t met = meet(ray, t_min, t_max); met != 0; met &= met - 1)
      if (visit(static_cast<std::uint32_t>(std::countr_zero(met)))) return true;
    return false;
  }
  // Those that contain p.
  std::uint32_t around(const Vec3& p) const {
    std::uint32_t here = 0;
    for (std::size_t n = 0; n < blocks_.size(); ++n) here |= std::uint32_t{kernels_->around(blocks_[n], p)} << 8 * n;
    return here & all_;
  }

 private:
  // Other numbers would defeat the comparisons.
  static bool is_ray(const Ray& ray) {
    return dot(ray.origin, ray.origin) + dot(ray.direction, ray.direction) < std::numeric_limits<double>::infinity();
  }
  static Vec3 reciprocal(const Vec3& direction) {
    constexpr double kHuge = 1e300;  // in the place of infinity, which times 0 would be NaN
    const auto of = [](double d) { return d > 1 / kHuge || d < -1 / kHuge ? 1 / d : kHuge; };
    return {of(direction.x), of(direction.y), of(direction.z)};
  }

  const BoxKernels* kernels_;
  std::vector<EightBoxes> blocks_;
  std::uint32_t all_ = 0;  // which boxes there are
};

}  // namespace verisim::shapes
