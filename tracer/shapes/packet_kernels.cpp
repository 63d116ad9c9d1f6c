#include "tracer/shapes/packet_kernels.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/packet_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "hwy/highway.h"
#include "tracer/simd/kernel_table.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

// Plain loops, which the compiler turns into wide instructions. Conditions are written with & and |, so that nothing
// branches.

constexpr int kLanes = RayPacket::kCount;
using Lane = double[kLanes];

// Primitive::local without its normalisation.
void enter_space(const Transform* matrix, const RayPacket& rays, LocalPacket& l) {
  const double *ox = rays.rays.origin.x + rays.first, *oy = rays.rays.origin.y + rays.first,
               *oz = rays.rays.origin.z + rays.first;
  const double *dx = rays.rays.direction.x + rays.first, *dy = rays.rays.direction.y + rays.first,
               *dz = rays.rays.direction.z + rays.first;
  if (!matrix) {
    for (int i = 0; i < kLanes; ++i)
      l.ox[i] = ox[i], l.oy[i] = oy[i], l.oz[i] = oz[i], l.dx[i] = dx[i], l.dy[i] = dy[i], l.dz[i] = dz[i];
    return;
  }
  const Mat4 a = matrix->inv;
  for (int i = 0; i < kLanes; ++i) {
    l.ox[i] = ox[i] * a[0][0] + oy[i] * a[1][0] + oz[i] * a[2][0] + a[3][0];
    l.oy[i] = ox[i] * a[0][1] + oy[i] * a[1][1] + oz[i] * a[2][1] + a[3][1];
    l.oz[i] = ox[i] * a[0][2] + oy[i] * a[1][2] + oz[i] * a[2][2] + a[3][2];
    l.dx[i] = dx[i] * a[0][0] + dy[i] * a[1][0] + dz[i] * a[2][0];
    l.dy[i] = dx[i] * a[0][1] + dy[i] * a[1][1] + dz[i] * a[2][1];
    l.dz[i] = dx[i] * a[0][2] + dy[i] * a[1][2] + dz[i] * a[2][2];
  }
}
void normalise(const Transform* matrix, LocalPacket& l, double* scale) {
  if (!matrix) {
    for (int i = 0; i < kLanes; ++i) scale[i] = 1;
    return;
  }
  for (int i = 0; i < kLanes; ++i) {
    scale[i] = std::sqrt(l.dx[i] * l.dx[i] + l.dy[i] * l.dy[i] + l.dz[i] * l.dz[i]);
    const double inverse = 1.0 / scale[i];
    l.dx[i] *= inverse, l.dy[i] *= inverse, l.dz[i] *= inverse;
  }
}

void local(const Transform* matrix, const RayPacket& rays, LocalPacket& packet) {
  enter_space(matrix, rays, packet);
  normalise(matrix, packet, packet.scale);
}

void sphere(const Vec3& center, double radius2, const Transform* matrix, const RayPacket& rays, double t_min,
            const double* t_max, PacketHits& met) {
  constexpr double kNearest = 1e-6, kFarthest = 1e7;
  LocalPacket l;
  alignas(64) Lane scale;
  enter_space(matrix, rays, l);
  normalise(matrix, l, scale);
  const double cx = center.x, cy = center.y, cz = center.z;
  for (int i = 0; i < kLanes; ++i) {
    const double x = cx - l.ox[i], y = cy - l.oy[i], z = cz - l.oz[i];
    const double distance_squared = x * x + y * y + z * z, closest = x * l.dx[i] + y * l.dy[i] + z * l.dz[i];
    const double half_chord2 = radius2 - distance_squared + closest * closest;
    const bool crosses = !((distance_squared >= radius2) & (closest < kEpsilon)) & (half_chord2 > kEpsilon);
    const double half_chord = std::sqrt(half_chord2), near = closest - half_chord, far = closest + half_chord;
    const double t_near = near / scale[i], t_far = far / scale[i];
    const bool first = crosses & (near > kNearest) & (near < kFarthest) & (t_near >= t_min) & (t_near < t_max[i]);
    const bool second = crosses & (far > kNearest) & (far < kFarthest) & (t_far >= t_min) & (t_far < t_max[i]);
    met.local[i] = first ? near : far;
    met.t[i] = first ? t_near : t_far;
    met.part[i] = (first | second) ? 0 : -1;
  }
}

// Narrows near .. far by one axis, whose faces are `low_face` and the next one.
struct alignas(64) Slabs {
  Lane near, far, near_size, far_size;  // |d| along the axes of the faces
  std::int64_t near_face[kLanes], far_face[kLanes], alive[kLanes];
};
void slab(const double* o, const double* d, double low, double high, std::int64_t low_face, Slabs& s) {
  for (int i = 0; i < kLanes; ++i) {
    const double size = std::fabs(d[i]);
    const bool along = size <= kEpsilon, across = !along, backward = d[i] < 0;
    const double to_low = (low - o[i]) / d[i], to_high = (high - o[i]) / d[i];
    const double enter = backward ? to_high : to_low, leave = backward ? to_low : to_high;
    const std::int64_t enter_face = backward ? low_face + 1 : low_face, leave_face = backward ? low_face : low_face + 1;
    const double near = s.near[i], far = s.far[i], near_gain = enter - near, far_gain = far - leave;
    const bool enters =
        across & ((near_gain > 1e-6) | ((s.near_face[i] >= 0) & (near_gain > -1e-6) & (size > s.near_size[i])));
    const bool leaves =
        across & ((far_gain > 1e-6) | ((s.far_face[i] >= 0) & (far_gain > -1e-6) & (size > s.far_size[i])));
    s.near_face[i] = enters ? enter_face : s.near_face[i];
    s.near_size[i] = enters ? size : s.near_size[i];
    s.far_face[i] = leaves ? leave_face : s.far_face[i];
    s.far_size[i] = leaves ? size : s.far_size[i];
    const double new_near = (across & (enter > near)) ? enter : near, new_far = (across & (leave < far)) ? leave : far;
    s.near[i] = new_near;
    s.far[i] = new_far;
    const bool within = (o[i] >= low) & (o[i] <= high), open = !(enter > leave) & (new_near <= new_far);
    s.alive[i] &= (along & within) | (across & open) ? 1 : 0;
  }
}
void box(const SimpleSolid& solid, const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) {
  constexpr double kNearest = 1e-6, kFarthest = 2e10;
  const Vec3 low = solid.a, high = solid.b;
  const bool near_wins = solid.turned;
  LocalPacket l;
  enter_space(solid.matrix, rays, l);
  Slabs s;
  for (int i = 0; i < kLanes; ++i)
    s.near[i] = 0, s.far[i] = kFarthest, s.near_size[i] = s.far_size[i] = 0, s.near_face[i] = s.far_face[i] = -1,
    s.alive[i] = 1;
  slab(l.ox, l.dx, low.x, high.x, 0, s);
  slab(l.oy, l.dy, low.y, high.y, 2, s);
  slab(l.oz, l.dz, low.z, high.z, 4, s);
  for (int i = 0; i < kLanes; ++i) {
    const double near = s.near[i], far = s.far[i];
    const bool alive = (s.alive[i] != 0) & !(far < kNearest);
    const bool first = alive & (s.near_face[i] >= 0) & (near > kNearest) & (near >= t_min) & (near < t_max[i]) &
                       ((near < far) | near_wins);
    const bool second = alive & (far >= t_min) & (far < t_max[i]);  // where there is no face, it is -1
    met.t[i] = first ? near : far;
    met.part[i] = first ? s.near_face[i] : second ? s.far_face[i] : -1;
  }
}

void cone(bool cylinder, bool open, double narrow, const Transform* matrix, const RayPacket& rays, double t_min,
          const double* t_max, PacketHits& met) {
  constexpr double kNearest = 1e-9, kFarthest = 1e7;
  enum : std::int64_t { wall, narrow_cap, wide_cap };
  LocalPacket l;
  alignas(64) Lane scale, first, second, best;
  alignas(64) std::int64_t first_met[kLanes], second_met[kLanes];
  enter_space(matrix, rays, l);
  normalise(matrix, l, scale);
  if (cylinder) {
    for (int i = 0; i < kLanes; ++i) {
      const double a = l.dx[i] * l.dx[i] + l.dy[i] * l.dy[i], b = l.ox[i] * l.dx[i] + l.oy[i] * l.dy[i],
                   c = l.ox[i] * l.ox[i] + l.oy[i] * l.oy[i] - 1;
      const double discriminant = b * b - a * c, root = std::sqrt(discriminant);
      first[i] = (-b + root) / a;
      second[i] = (-b - root) / a;
      first_met[i] = second_met[i] = ((a > kEpsilon) & (discriminant >= 0)) ? 1 : 0;
    }
  } else {
    for (int i = 0; i < kLanes; ++i) {
      const double a = l.dx[i] * l.dx[i] + l.dy[i] * l.dy[i] - l.dz[i] * l.dz[i],
                   b = l.ox[i] * l.dx[i] + l.oy[i] * l.dy[i] - l.oz[i] * l.dz[i];
      const double c = l.ox[i] * l.ox[i] + l.oy[i] * l.oy[i] - l.oz[i] * l.oz[i];
      const double discriminant = b * b - a * c, root = std::sqrt(discriminant);
      const bool linear = std::fabs(a)<kEpsilon, real = discriminant >= 0, sloped = std::fabs(b)> kEpsilon;
      first[i] = linear ? -0.5 * c / b : (-b - root) / a;
      second[i] = (-b + root) / a;
      first_met[i] = (linear & sloped) | (!linear & real) ? 1 : 0;
      second_met[i] = (!linear & real) ? 1 : 0;
    }
  }
  for (int i = 0; i < kLanes; ++i) met.part[i] = -1, best[i] = t_max[i];
  const auto take = [&](const double* ts, const std::int64_t* valid, std::int64_t part) {
    for (int i = 0; i < kLanes; ++i) {
      const double t = ts[i], depth = t / scale[i];
      const bool taken = (valid[i] != 0) & (t > kNearest) & (t < kFarthest) & (depth >= t_min) &
                         ((depth < best[i]) | ((met.part[i] >= 0) & (depth <= best[i])));
      best[i] = taken ? depth : best[i];
      met.part[i] = taken ? part : met.part[i];
    }
  };
  const auto on_wall = [&](const double* t, std::int64_t* valid) {
    for (int i = 0; i < kLanes; ++i) {
      const double z = l.oz[i] + t[i] * l.dz[i];
      valid[i] = ((z >= narrow) & (z <= 1)) ? valid[i] : 0;
    }
  };
  on_wall(first, first_met);
  on_wall(second, second_met);
  take(first, first_met, wall);
  take(second, second_met, wall);
  if (!open) {
    const auto take_cap = [&](double end, double radius2, std::int64_t part) {
      for (int i = 0; i < kLanes; ++i) {
        const double t = (end - l.oz[i]) / l.dz[i], x = l.ox[i] + t * l.dx[i], y = l.oy[i] + t * l.dy[i];
        first[i] = t;
        first_met[i] = ((std::fabs(l.dz[i]) > kEpsilon) & (x * x + y * y <= radius2)) ? 1 : 0;
      }
      take(first, first_met, part);
    };
    take_cap(1, 1, wide_cap);
    take_cap(narrow, cylinder ? 1 : narrow * narrow, narrow_cap);
  }
  for (int i = 0; i < kLanes; ++i) met.t[i] = best[i];
}

double larger(double a, double b) { return a < b ? b : a; }  // std::max, and the next std::min
double smaller(double a, double b) { return b < a ? b : a; }

std::int64_t flag(bool b) { return b ? 1 : 0; }

void torus(double major, double minor, const Transform* matrix, const RayPacket& rays, TorusPacket& packet) {
  LocalPacket l;
  enter_space(matrix, rays, l);
  normalise(matrix, l, packet.scale);
  const double outer = major + minor, inner = major > minor ? major - minor : 0, outer2 = outer * outer,
               inner2 = inner * inner;
  const double major2 = major * major, minor2 = minor * minor, around = major + minor + minor;
  const double hole2 =
      inner2 > 0 ? inner2 * (1 - 1e-9) : -HUGE_VAL;  // within this squared distance of the axis there is nothing
  for (int i = 0; i < kLanes; ++i) {
    const double ox = l.ox[i], oy = l.oy[i], oz = l.oz[i], dx = l.dx[i], dy = l.dy[i], dz = l.dz[i];
    // |y| <= r, distance from the axis between R - r and R + r.
    const bool level = std::fabs(dy) < kEpsilon;
    const double to_low = (-minor - oy) / dy, to_high = (minor - oy) / dy, enter = to_low > to_high ? to_high : to_low,
                 leave = to_low > to_high ? to_low : to_high;
    const double above = level ? 0 : larger(0, enter), below = level ? HUGE_VAL : smaller(HUGE_VAL, leave);
    const std::int64_t beside = level ? flag(std::fabs(oy) > minor) : flag(above > below);
    const double a = dx * dx + dz * dz, b = ox * dx + oz * dz, c = ox * ox + oz * oz;
    const double discriminant = b * b - a * (c - outer2), root = std::sqrt(discriminant);
    const double near = larger(above, (-b - root) / a), far = smaller(below, (-b + root) / a);
    const double rho_near = c + near * (2 * b + a * near), rho_far = c + far * (2 * b + a * far);
    const std::int64_t in_hole = flag(rho_near < hole2) & flag(rho_far < hole2),
                       misses = flag(discriminant < 0) | flag(near > far) | in_hole;
    // Along the axis the side is not asked: the ray has to cross an end within the ring.
    const double rho_above = c + above * (2 * b + a * above), rho_below = c + below * (2 * b + a * below);
    const std::int64_t in_ring = (flag(rho_above >= inner2 * (1 - 1e-9)) & flag(rho_above <= outer2 * (1 + 1e-9))) |
                                 (flag(rho_below >= inner2 * (1 - 1e-9)) & flag(rho_below <= outer2 * (1 + 1e-9)));
    const std::int64_t met = a < kEpsilon ? in_ring : 1 - misses;
    packet.met[i] = met & (1 - beside);
  }
  // The quartic loses its digits far away from the torus, so it starts near it.
  for (int i = 0; i < kLanes; ++i) {
    const double ox = l.ox[i], oy = l.oy[i], oz = l.oz[i], dx = l.dx[i], dy = l.dy[i], dz = l.dz[i];
    const double distance = std::sqrt(ox * ox + oy * oy + oz * oz), advance = distance > around ? distance - around : 0;
    const double px = ox + advance * dx, py = oy + advance * dy, pz = oz + advance * dz;
    const double y2 = py * py, ydy = py * dy;
    const double k1 = px * px + pz * pz + y2 - major2 - minor2, k2 = px * dx + pz * dz + ydy;
    packet.advance[i] = advance;
    packet.c[0][i] = 4 * k2;
    packet.c[1][i] = 2 * (k1 + 2 * (k2 * k2 + major2 * (dy * dy)));
    packet.c[2][i] = 4 * (k1 * k2 + 2 * major2 * ydy);
    packet.c[3][i] = k1 * k1 + 4 * major2 * (y2 - minor2);
  }
}

void quadric(const scene::Quadric& q, const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) {
  constexpr double kNearest = 1e-6, kFarthest = 1e7;
  LocalPacket r;
  enter_space(nullptr, rays, r);
  const double sx = q.square.x, sy = q.square.y, sz = q.square.z, mx = q.mixed.x, my = q.mixed.y, mz = q.mixed.z;
  const double lx = q.linear.x, ly = q.linear.y, lz = q.linear.z, constant = q.constant;
  for (int i = 0; i < kLanes; ++i) {
    const double ox = r.ox[i], oy = r.oy[i], oz = r.oz[i], dx = r.dx[i], dy = r.dy[i], dz = r.dz[i];
    const double a = dx * (sx * dx + mx * dy + my * dz) + dy * (sy * dy + mz * dz) + dz * sz * dz;
    const double b = dx * (sx * ox + 0.5 * (mx * oy + my * oz + lx)) + dy * (sy * oy + 0.5 * (mx * ox + mz * oz + ly)) +
                     dz * (sz * oz + 0.5 * (my * ox + mz * oy + lz));
    const double c =
        ox * (sx * ox + mx * oy + my * oz + lx) + oy * (sy * oy + mz * oz + ly) + oz * (sz * oz + lz) + constant;
    const double discriminant = b * b - a * c, root = std::sqrt(discriminant);
    const std::int64_t curved = flag(a != 0), real = curved & flag(discriminant > 0),
                       straight = (1 - curved) & flag(b != 0);
    const double first = curved != 0 ? (-b + root) / a : -0.5 * c / b, second = (-b - root) / a, limit = t_max[i];
    const std::int64_t takes_first = (real | straight) & flag(first > kNearest) & flag(first < kFarthest) &
                                     flag(first >= t_min) & flag(first < limit);
    const double best = takes_first != 0 ? first : limit;
    const std::int64_t takes_second =
        real & flag(second > kNearest) & flag(second < kFarthest) & flag(second >= t_min) & flag(second < best);
    met.t[i] = takes_second != 0 ? second : first;
    met.part[i] = (takes_first | takes_second) - 1;
  }
}

const PacketKernels kKernels = {local, sphere, box, cone, torus, quadric};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(PacketKernels, packet_kernels)
}  // namespace verisim::shapes
#endif
