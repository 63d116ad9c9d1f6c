// What the formulas in *_intersections.inc are written with: each stands once, as templates over a vector, which are
// included by the shape for one ray (Vec3; `using namespace one_ray`) and by kernels, once for each instruction set,
// for packets (PacketVector). Conditions are joined by & and |, negated by !, and choose by `select`, which serve bool
// and masks.
//
// Intersections go to a `report`:
//   using Part = ...;                         // std::int32_t, or a packet of integers
//   bool any(mask);                           // whether a ray for which it holds is still of interest
//   bool operator()(t, mask, const Part& p);  // an intersection at t of the rays of the mask, with a part of the
//   surface;
//                                             // true: those behind it are not wanted
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#define VERISIM_FORMULA inline __attribute__((always_inline))
#ifndef VERISIM_INLINE_LAMBDA
#define VERISIM_INLINE_LAMBDA __attribute__((always_inline))
#endif

namespace verisim::shapes {

enum ConePart : std::int32_t { kConeWall, kConeNarrowCap, kConeWideCap };

namespace one_ray {
using std::abs, std::sqrt, std::min, std::max;

template <class T>
constexpr T select(bool where, const T& a, const T& b) {
  return where ? a : b;
}
constexpr bool any(bool where) { return where; }

// Crossings of one ray: add(t, part) takes one, and says whether those behind it are not wanted.
template <class Add>
struct Report {
  using Part = std::int32_t;
  Add add;
  bool any(bool where) const { return where; }
  bool operator()(double t, bool where, Part part) const { return where && add(t, part); }
};
template <class Add>
Report(Add) -> Report<Add>;

}  // namespace one_ray
}  // namespace verisim::shapes
