#include "tracer/shapes/quadrics/box_set.h"
#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/quadrics/box_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

HWY_INLINE void clip(const EightBoxes& boxes, const Vec3& o, const Vec3& inverse, Packet& enter, Packet& leave) {
  for (int axis = 0; axis < 3; ++axis) {
    const Packet a = (load(boxes.low[axis]) - o[axis]) * inverse[axis],
                 b = (load(boxes.high[axis]) - o[axis]) * inverse[axis];
    enter = max(enter, min(a, b)), leave = min(leave, max(a, b));
  }
}

unsigned meet(const EightBoxes& boxes, const Vec3& o, const Vec3& inverse, double t_min, double t_max) {
  Packet enter = t_min, leave = t_max;
  clip(boxes, o, inverse, enter, leave);
  return bits(enter <= leave);
}

unsigned meet_at(const EightBoxes& boxes, const Vec3& o, const Vec3& inverse, double t_min, double t_max,
                 double* near) {
  Packet enter = t_min, leave = t_max;
  clip(boxes, o, inverse, enter, leave);
  store(near, enter);
  return bits(enter <= leave);
}

unsigned around(const EightBoxes& boxes, const Vec3& p) {
  Mask here = Mask::all();
  for (int axis = 0; axis < 3; ++axis) here &= (load(boxes.low[axis]) <= p[axis]) & (load(boxes.high[axis]) >= p[axis]);
  return bits(here);
}

const BoxKernels kKernels = {meet, meet_at, around};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(BoxKernels, box_kernels)
}  // namespace verisim::shapes
#endif
