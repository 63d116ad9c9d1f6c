// The point of a hit in the space of its shape. What comes back from the hit's world point is a few units in the last
// place beside it, and POV-Ray's normals of some shapes are those of the point that was found: the distance fits into
// one parameter of the hit.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdlib>

#include "tracer/shapes/shape.h"

namespace verisim::shapes {

namespace kept_point {

inline constexpr int kBits = 21;  // of each coordinate
inline constexpr std::int64_t kMax = (std::int64_t{1} << (kBits - 1)) - 1;

// Numbers in their order: neighbours differ by 1.
inline std::int64_t rank(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits < 0 ? INT64_MIN - bits : bits;
}
inline double of_rank(std::int64_t rank) { return std::bit_cast<double>(rank < 0 ? INT64_MIN - rank : rank); }

}  // namespace kept_point

// What leads from `back` to `point`; coordinates that are further apart stay those of `back`.
inline double keep_point(const Vec3& point, const Vec3& back) {
  using namespace kept_point;
  std::uint64_t kept = 0;
  for (int x = 0; x < 3; ++x) {
    const auto steps = static_cast<std::int64_t>(static_cast<std::uint64_t>(rank(point[x])) -
                                                 static_cast<std::uint64_t>(rank(back[x])));
    kept = kept << kBits | static_cast<std::uint64_t>((steps >= -kMax && steps <= kMax ? steps : 0) + kMax);
  }
  return std::bit_cast<double>(kept);
}

inline Vec3 kept_point_of(double kept, const Vec3& back) {
  using namespace kept_point;
  auto bits = std::bit_cast<std::uint64_t>(kept);
  Vec3 point = back;
  for (int x = 2; x >= 0; --x, bits >>= kBits)
    point[x] = of_rank(rank(back[x]) + static_cast<std::int64_t>(bits & ((1u << kBits) - 1)) - kMax);
  return point;
}

// Adds a hit that was found at `point` of the shape's own space; `matrix`: null where it is the world.
template <class Sink>
void add_found(Sink& sink, double depth, const Vec3& point, const Transform* matrix, std::int32_t part, double u = 0) {
  if (!matrix) {
    sink.add(
        depth, [&] { return point; }, part, u);
    return;
  }
  const Vec3 in_world = matrix->point(point);
  sink.add(
      depth, [&] { return in_world; }, part, u, keep_point(point, matrix->inverse_point(in_world)));
}
inline Vec3 found_point(const Hit& hit, const Transform* matrix) {
  return matrix ? kept_point_of(hit.v, matrix->inverse_point(hit.point)) : hit.point;
}

}  // namespace verisim::shapes
