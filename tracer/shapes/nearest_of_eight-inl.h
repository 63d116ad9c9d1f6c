// What kernels report intersections of eight rays to (intersections.h).
// Included once for each target by kernels.
#if defined(VERISIM_SHAPES_NEAREST_OF_EIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_SHAPES_NEAREST_OF_EIGHT_INL_H
#undef VERISIM_SHAPES_NEAREST_OF_EIGHT_INL_H
#else
#define VERISIM_SHAPES_NEAREST_OF_EIGHT_INL_H
#endif

#include "tracer/shapes/packet_kernels.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

// Keeps what NearestHit keeps of each ray. kInOrder: intersections come by distance, so that the first of equal ones
// counts.
template <bool kInOrder>
class NearestOfEight {
 public:
  using Part = IntPacket;
  // `scale`: distances in the world are smaller by it; null: they are the same.
  HWY_INLINE NearestOfEight(const Packet* scale, double t_min, const double* t_max)
      : scale_(scale), t_min_(t_min), t_(Packet::load(t_max)), local_(0.0), part_(-1), found_(~Mask::all()) {}

  HWY_INLINE bool any(const Mask& where) const { return bits(where) != 0; }
  HWY_INLINE bool operator()(const Packet& t, const Mask& where, const Part& part) {
    const Packet depth = scale_ ? t / *scale_ : t;
    const Mask within = where & (depth >= t_min_);
    Mask taken = within & (depth < t_);
    if constexpr (!kInOrder) taken |= within & found_ & (depth <= t_), found_ |= taken;
    t_ = select(taken, depth, t_), local_ = select(taken, t, local_), part_ = select(taken, part, part_);
    return false;
  }
  HWY_INLINE void store_to(PacketHits& met) const {
    store(met.t, t_), store(met.local, local_), store(met.part, part_);
  }

 private:
  const Packet* const scale_;
  const double t_min_;
  Packet t_, local_;
  IntPacket part_;
  [[maybe_unused]] Mask found_;
};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#endif
