#include "tracer/shapes/julia_lanes.h"

#include <cmath>
#include <cstring>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // vectors are only passed to functions that are inlined
#endif
// One body, compiled for several instruction sets and chosen when the program is loaded.
#if defined(__x86_64__) && defined(__GNUC__) && defined(__linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VERISIM_ALL_MACHINES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define VERISIM_ALL_MACHINES
#endif
#define VERISIM_INLINE [[gnu::always_inline]] inline

namespace verisim::shapes::julia {

namespace {

using Lanes = double __attribute__((vector_size(kLanes * 8)));
constexpr unsigned kAll = (1u << kLanes) - 1;
using Mask = long long __attribute__((vector_size(kLanes * 8)));

VERISIM_INLINE Lanes all(double v) { return Lanes{} + v; }
VERISIM_INLINE Lanes choose(const Mask& m, const Lanes& a, const Lanes& b) { return m ? a : b; }
// All lanes joined by OR or AND: halves with halves.
template <class Join>
VERISIM_INLINE long long joined(const Mask& m, Join join) {
  using Half = long long __attribute__((vector_size(kLanes * 4)));
  using Quarter = long long __attribute__((vector_size(kLanes * 2)));
  static_assert(kLanes == 8);
  const Half h = join(__builtin_shufflevector(m, m, 0, 1, 2, 3), __builtin_shufflevector(m, m, 4, 5, 6, 7));
  const Quarter q = join(__builtin_shufflevector(h, h, 0, 1), __builtin_shufflevector(h, h, 2, 3));
  return join(q[0], q[1]);
}
VERISIM_INLINE bool any(const Mask& m) {
  return joined(m, [](const auto& a, const auto& b) { return a | b; }) != 0;
}
VERISIM_INLINE bool every(const Mask& m) {
  return joined(m, [](const auto& a, const auto& b) { return a & b; }) != 0;
}
VERISIM_INLINE unsigned bits(const Mask& m) {
  const Mask places = {1, 2, 4, 8, 16, 32, 64, 128};
  return static_cast<unsigned>(joined(m & places, [](const auto& a, const auto& b) { return a | b; }));
}

struct Wide {
  Lanes x, y, z, w;
};

VERISIM_INLINE Lanes norm2(const Wide& h) { return h.x * h.x + (h.y * h.y + h.z * h.z + h.w * h.w); }
VERISIM_INLINE Wide product(const Wide& a, const Wide& b) {
  return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
          a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
}

template <Kind K>
VERISIM_INLINE Wide next(const Wide& h, const Number& c) {
  Wide r;
  if constexpr (K == Kind::quaternion_square) {
    const Lanes q = h.y * h.y + h.z * h.z + h.w * h.w, t = 2 * h.x;
    r = {h.x * h.x - q, t * h.y, t * h.z, t * h.w};
  } else if constexpr (K == Kind::quaternion_cube) {
    const Lanes q = h.y * h.y + h.z * h.z + h.w * h.w, x2 = h.x * h.x, t = 3 * x2 - q;
    r = {h.x * (x2 - 3 * q), h.y * t, h.z * t, h.w * t};
  } else {
    r = product(h, h);
  }
  return {r.x + c.x, r.y + c.y, r.z + c.z, r.w + c.w};
}

VERISIM_INLINE Lanes load(const double* p) {
  Lanes v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
// Lanes whose bit is set.
VERISIM_INLINE Mask mask_of(unsigned bits) {
  const Mask places = {1, 2, 4, 8, 16, 32, 64, 128};
  return (places & static_cast<long long>(bits)) != 0;
}

// Points of one ray.
struct OneRay {
  const Vec3 &origin, &direction;
  VERISIM_INLINE Lanes at(int axis, const Lanes& t) const { return origin[axis] + t * direction[axis]; }
  VERISIM_INLINE Lanes along(const Lanes& x, const Lanes& y, const Lanes& z) const { return x * direction.x + y * direction.y + z * direction.z; }
};
// One point of each ray.
struct ManyRays {
  const Rays& rays;
  VERISIM_INLINE Lanes at(int axis, const Lanes& t) const { return load(rays.origin[axis]) + t * load(rays.direction[axis]); }
  VERISIM_INLINE Lanes along(const Lanes& x, const Lanes& y, const Lanes& z) const {
    return x * load(rays.direction[0]) + y * load(rays.direction[1]) + z * load(rays.direction[2]);
  }
};

template <class Source>
VERISIM_INLINE Wide start(const Field& f, const Source& rays, const double* t) {
  const Lanes at = load(t), x = rays.at(0, at), y = rays.at(1, at), z = rays.at(2, at);
  return {x, y, z, (f.slice_distance - f.slice.x * x - f.slice.y * y - f.slice.z * z) / f.slice_w};
}

template <Kind K>
VERISIM_INLINE unsigned inside_of(const Field& f, const Vec3& o, const Vec3& d, const double* t) {
  Wide h = start(f, OneRay{o, d}, t);
  Mask out{};
  for (int i = 1; i <= f.iterations; ++i) {
    out |= norm2(h) > f.escape;
    if (every(out)) return 0;
    h = next<K>(h, f.parameter);
  }
  return ~bits(out) & ((1u << kLanes) - 1);
}

template <Kind K, class Source>
VERISIM_INLINE unsigned march_of(const Field& f, const Source& rays, const double* t, unsigned asked, unsigned estimated, double* estimate) {
  constexpr bool kQuaternion = K != Kind::hypercomplex_square;
  Wide h = start(f, rays, t);
  Mask out = ~mask_of(asked);
  // Of each lane when it escapes: |h|^2 and, for quaternions, the product of all |h|^2 before and k^steps; for others the slope along the ray.
  Lanes q{}, product2 = all(1), power = all(1), slope{};
  Lanes running2 = all(1), running_power = all(1);
  Wide m = h;
  double scale = 2;
  for (int i = 1; i <= f.iterations; ++i) {
    const Lanes n2 = norm2(h);
    const Mask now = (n2 > f.escape) & ~out;
    if constexpr (kQuaternion) {
      running2 = running2 * n2;
      running_power = running_power * (K == Kind::quaternion_cube ? 1.0 / 3 : 1.0 / 2);
      product2 = choose(now, running2, product2);
      power = choose(now, running_power, power);
    } else {
      if (any(now)) {
        Wide n = h;
        if (f.doubled) n = {n.x * scale, n.y * scale, n.z * scale, n.w * scale};
        const Lanes vx = m.x * n.x + m.y * n.y + m.z * n.z + m.w * n.w, vy = -m.y * n.x + m.x * n.y - m.w * n.z + m.z * n.w,
                    vz = -m.z * n.x - m.w * n.y + m.x * n.z + m.y * n.w;
        slope = choose(now, rays.along(vx, vy, vz), slope);
      }
      if (i > 1) {
        m = product(h, m);
        scale *= 2;
      }
    }
    q = choose(now, n2, q);
    out |= now;
    if (every(out)) break;
    h = next<K>(h, f.parameter);
  }
  const unsigned inside = ~bits(out) & ((1u << kLanes) - 1);
  Lanes result;
  if constexpr (kQuaternion) {
    const unsigned outside = estimated & ~inside;
    Lanes root = q / product2;
    for (int k = 0; k < kLanes; ++k) root[k] = std::sqrt(root[k]);
    root = power * root;
    result = all(f.precision);
    for (int k = 0; k < kLanes; ++k) {
      if (!(outside >> k & 1)) continue;
      // ln q <= q - 1 spares most of the logarithms.
      result[k] = root[k] * (q[k] - 1) > f.precision ? root[k] * std::log(q[k]) : f.precision;
    }
  } else {
    const Lanes decrease = -2 * slope;
    const Mask near = (slope < -1e-8) & (f.precision * decrease < q) & (q < 30 * f.precision * decrease);
    result = choose(near, q / decrease, all(f.precision));
  }
  for (int k = 0; k < kLanes; ++k) estimate[k] = inside >> k & 1 ? f.precision : result[k];
  return inside;
}

}  // namespace

VERISIM_ALL_MACHINES unsigned inside_lanes(const Field& f, const Vec3& o, const Vec3& d, const double t[kLanes]) {
  switch (f.kind) {
    case Kind::quaternion_square: return inside_of<Kind::quaternion_square>(f, o, d, t);
    case Kind::quaternion_cube: return inside_of<Kind::quaternion_cube>(f, o, d, t);
    default: return inside_of<Kind::hypercomplex_square>(f, o, d, t);
  }
}

VERISIM_ALL_MACHINES unsigned march_lanes(const Field& f, const Vec3& o, const Vec3& d, const double t[kLanes], double estimate[kLanes]) {
  switch (f.kind) {
    case Kind::quaternion_square: return march_of<Kind::quaternion_square>(f, OneRay{o, d}, t, kAll, kAll, estimate);
    case Kind::quaternion_cube: return march_of<Kind::quaternion_cube>(f, OneRay{o, d}, t, kAll, kAll, estimate);
    default: return march_of<Kind::hypercomplex_square>(f, OneRay{o, d}, t, kAll, kAll, estimate);
  }
}

VERISIM_ALL_MACHINES unsigned march_rays(const Field& f, const Rays& rays, const double t[kLanes], unsigned asked, unsigned estimated, double estimate[kLanes]) {
  switch (f.kind) {
    case Kind::quaternion_square: return march_of<Kind::quaternion_square>(f, ManyRays{rays}, t, asked, estimated, estimate);
    case Kind::quaternion_cube: return march_of<Kind::quaternion_cube>(f, ManyRays{rays}, t, asked, estimated, estimate);
    default: return march_of<Kind::hypercomplex_square>(f, ManyRays{rays}, t, asked, estimated, estimate);
  }
}

}  // namespace verisim::shapes::julia
