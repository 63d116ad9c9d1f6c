// Where eight rays enter and leave the container of an isosurface, and its normals at eight points: the operations of
// container.cpp and isosurface.cpp. Included once for each target by
// isosurface_kernels.cpp.
#if defined(VERISIM_SHAPES_ISOSURFACE_ENTRY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef VERISIM_SHAPES_ISOSURFACE_ENTRY_INL_H
#undef VERISIM_SHAPES_ISOSURFACE_ENTRY_INL_H
#else
#define VERISIM_SHAPES_ISOSURFACE_ENTRY_INL_H
#endif

#include <cmath>
#include <limits>

#include "tracer/math/packet_vector-inl.h"
#include "tracer/shapes/implicit/isosurface_batch.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

using Vector = PacketVector<Packet>;

HWY_INLINE Mask meet_box(const Vec3& low, const Vec3& high, const Vector& origin, const Vector& direction,
                         EntryPacket& e) {
  constexpr double kFarthest = 2e10, kNearest = 1e-6, kTie = 1e-6;
  const Packet origins[3] = {origin.x, origin.y, origin.z}, directions[3] = {direction.x, direction.y, direction.z};
  Packet enter{}, leave = kFarthest, enter_slope{}, leave_slope{};
  IntPacket enter_face(0), leave_face(0);
  Mask met = Mask::all();
  for (int k = 0; k < 3; ++k) {
    const Packet o = origins[k], d = directions[k], slope = abs(d), lower = low[k], upper = high[k];
    const Mask along = slope > kEpsilon, forward = d > 0.0;
    const Packet near_t = (select(forward, lower, upper) - o) / d, far_t = (select(forward, upper, lower) - o) / d;
    met &= select(along, ~(far_t < kNearest), ~((o < lower) | (o > upper)));
    const Mask leaves = along & ((far_t < leave - kTie) | ((far_t < leave + kTie) & (slope > leave_slope)));
    leave = select(along, min(leave, far_t), leave);
    const Mask at_leave = leaves & (far_t < leave + kTie);
    leave_face = select(at_leave, select(forward, IntPacket(2 * k + 2), IntPacket(2 * k + 1)), leave_face);
    leave_slope = select(at_leave, slope, leave_slope);
    const Mask at_enter =
        along & ((near_t > enter + kTie) | ((near_t > 0.0) & (near_t > enter - kTie) & (slope > enter_slope)));
    enter_face = select(at_enter, select(forward, IntPacket(2 * k + 1), IntPacket(2 * k + 2)), enter_face);
    enter_slope = select(at_enter, slope, enter_slope);
    enter = select(along, max(enter, near_t), enter);
    met &= ~along | ~(enter > leave);
  }
  store(e.enter, enter), store(e.leave, leave), store(e.enter_face, enter_face), store(e.leave_face, leave_face);
  return met;
}

HWY_INLINE Mask meet_sphere(const Vec3& center, double radius, const Vector& origin, const Vector& direction,
                            const Packet& speed, EntryPacket& e) {
  const Packet shorter = Packet(1.0) / speed;
  const Vector d{direction.x * shorter, direction.y * shorter, direction.z * shorter},
      to_center{center.x - origin.x, center.y - origin.y, center.z - origin.z};
  const Packet closest = dot(to_center, d), distance2 = dot(to_center, to_center), radius2 = radius * radius;
  const Packet half2 = radius2 - distance2 + closest * closest, half = sqrt(half2);
  store(e.enter, (closest - half) / speed), store(e.leave, (closest + half) / speed);
  store(e.enter_face, IntPacket(7)), store(e.leave_face, IntPacket(7));
  return ~((distance2 >= radius2) & (closest < kEpsilon)) & (half2 > kEpsilon);
}

// Sets up the rays in object space; those that meet the container.
unsigned enter(SearchPacket& s, EntryPacket& e, const RayPacket& rays, const scene::Contained& container,
               const Affine* to_object, double max_gradient, double steepest) {
  const auto given = [&](const RayBatch::Vectors& v) VERISIM_INLINE_LAMBDA {
    return Vector{load(v.x + rays.first), load(v.y + rays.first), load(v.z + rays.first)};
  };
  Vector origin = given(rays.rays.origin), direction = given(rays.rays.direction);
  if (to_object) {
    const Affine& m = *to_object;
    origin = transform_point(m, origin), direction = transform_direction(m, direction);
  }
  store(s.origin[0], origin.x), store(s.origin[1], origin.y), store(s.origin[2], origin.z);
  store(s.direction[0], direction.x), store(s.direction[1], direction.y), store(s.direction[2], direction.z);
  const Packet speed = sqrt(dot(direction, direction));
  store(e.speed, speed);
  store(s.slope, max_gradient * speed), store(s.sign, Packet(1.0));
  store(s.steepest, steepest * speed * (1 - 0x1p-51));  // a little less, so that rounding does not make it more
  const Mask met = container.sphere ? meet_sphere(container.center, container.radius, origin, direction, speed, e)
                                    : meet_box(container.low, container.high, origin, direction, e);
  if (s.map) {
    store(s.speed2, speed * speed * (1 + 1e-12));
    const CurvatureMap& map = *s.map;
    const double per_length = 1 / map.edge();
    Packet reach{};
    Mask near_enough = Mask::all();
    for (int axis = 0; axis < 3; ++axis) {
      const Packet o = load(s.origin[axis]), d = load(s.direction[axis]), step = d * per_length;
      store(s.cell_origin[axis], (o - map.low()[axis]) * per_length), store(s.cell_step[axis], step);
      reach = max(reach, abs(step));
      near_enough &= abs(o) + load(e.leave) * abs(d) <= map.farthest();
    }
    const Packet unknown = std::numeric_limits<double>::infinity();
    store(s.reach, select(near_enough, reach, unknown));
    const Packet x = abs(direction.x), y = abs(direction.y), z = abs(direction.z);
    const std::array<double, 6>& most = map.parts();
    const Packet bend = most[0] * (x * x) + most[1] * (y * y) + most[2] * (z * z) +
                        2.0 * (most[3] * (x * y) + most[4] * (x * z) + most[5] * (y * z));
    store(s.bend_anywhere,
          select(near_enough & (bend < unknown), bend * (1 + 1e-12), unknown));  // infinity by zero is NaN
  }
  store(e.begin, max(load(e.enter), Packet(0.0))), store(e.end, load(e.leave));
  return bits(met) & rays.active;
}

Intervals intervals(const SearchPacket& s, const EntryPacket& e) {
  constexpr double kFarthest = 2e10;
  const Packet begin = load(e.begin), end = load(e.end), length = end - begin;
  return {bits(~(begin > s.accuracy)), bits(begin < s.accuracy), bits(length >= s.accuracy),
          bits((end <= kFarthest) & (length < s.accuracy * 0x1p50))};
}

void place(const SearchPacket& s, const double* t, double* points) {
  for (int axis = 0; axis < 3; ++axis)
    store(points + axis * kLanes, load(s.origin[axis]) + load(t) * load(s.direction[axis]));
}

Judged judge(const SearchPacket& s, const double* found, double near_zero, unsigned active, double* values) {
  const Packet v = load(found) - s.threshold, size = abs(v);
  store(values, select(Mask::of_bits(active), v, load(values)));
  const unsigned sure = s.doubt > 0 ? bits((size > s.doubt) & (abs(size - near_zero) > s.doubt)) : 255;
  return {bits(v < 0.0) & active, bits(v < near_zero) & active, bits(size < near_zero) & active, ~sure & active};
}

void set_up(SearchPacket& s, const EntryPacket& e, unsigned active, bool open) {
  const Mask here = Mask::of_bits(active);
  const Packet one = 1.0, begin = load(e.begin), at_begin = load(e.at_begin), given = load(s.sign);
  const Packet sign = open ? select(given * at_begin < 0.0, -given, given) : given;
  store(s.sign, sign);
  store(s.begin, select(here, begin, Packet(0.0))), store(s.width, select(here, load(e.end) - begin, one));
  store(s.end, select(here, load(e.end), one));
  store(s.value0, select(here, sign * at_begin, one)), store(s.value1, select(here, sign * load(e.at_end), one));
}

// Like normalize.
Vector unit(const Vector& v) {
  const Packet one = 1.0, inverse = one / sqrt(dot(v, v));
  return {v.x * inverse, v.y * inverse, v.z * inverse};
}

// From the values at the points and a little further along each axis.
void normals(const double* values, const Affine* to_object, double* normals) {
  const Packet here = load(values);
  Vector n{load(values + kLanes) - here, load(values + 2 * kLanes) - here, load(values + 3 * kLanes) - here};
  const Mask flat = (n.x == 0.0) & (n.y == 0.0) & (n.z == 0.0);
  n = unit(n);
  n = {select(flat, 1.0, n.x), select(flat, Packet(0.0), n.y), select(flat, Packet(0.0), n.z)};
  if (to_object) {
    const Affine& a = *to_object;  // normals go by the transpose
    n = {n.x * a[0][0] + n.y * a[0][1] + n.z * a[0][2], n.x * a[1][0] + n.y * a[1][1] + n.z * a[1][2],
         n.x * a[2][0] + n.y * a[2][1] + n.z * a[2][2]};
  }
  n = unit(n);
  store(normals, n.x), store(normals + kLanes, n.y), store(normals + 2 * kLanes, n.z);
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#endif
