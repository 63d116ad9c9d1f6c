#include <bit>
#include <cmath>
#include <cstdint>

#include "tracer/shapes/julia/julia_packet.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/julia/julia_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/functions/library_lanes-inl.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes::julia {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;
#include "tracer/shapes/julia/julia_formulas.inc"
#include "tracer/shapes/julia/julia_functions.inc"

// ---- how rays of a packet meet the cells of a grid
// Of numbers from 0 to 2^51.
HWY_INLINE IntPacket whole_part(const Packet& v) {
  constexpr double kShift = 0x1p52;
  const Packet shifted = v + kShift;
  const IntPacket whole = bits_of(shifted) - IntPacket(std::bit_cast<std::int64_t>(kShift));
  return select(shifted - kShift > v, whole - IntPacket(1), whole);
}

HWY_INLINE Packet number_of_cells(const IntPacket& count) {
  constexpr double kShift = 0x1p52;
  return number_of(count + IntPacket(std::bit_cast<std::int64_t>(kShift))) - kShift;
}

// The lanes whose row of cells has bit `place`.
HWY_INLINE Mask has_bit(const BasicPacket<std::uint64_t, simd::HWY_NAMESPACE::kLanes>& row, const IntPacket& place) {
  using Row = BasicPacket<std::uint64_t, simd::HWY_NAMESPACE::kLanes>;
  constexpr int kVectors = Row::kVectors;
  Row moved;
  VERISIM_EACH_VECTOR moved.v[i] = row.v[i] >> hn::BitCast(Row::D(), place.v[i]);
  return (moved & Row(1u)) == Row(1u);
}

// Map::last for the lanes of `active`: a walk through the grid from the far end.
HWY_INLINE Packet last_cell(const Grid& grid, const LocalPacket& rays, Packet begin, Packet end, Mask active) {
  constexpr int kSide = Grid::kSide;
  const Packet none = Packet(-1.0);
  if (grid.box.isEmpty()) return none;
  const Packet o[3] = {load(rays.ox), load(rays.oy), load(rays.oz)},
               d[3] = {load(rays.dx), load(rays.dy), load(rays.dz)};
  for (int k = 0; k < 3; ++k) {
    const Mask across = d[k] != 0.0;
    active &= across | ((o[k] >= grid.box.min[k]) & (o[k] <= grid.box.max[k]));
    const Packet a = (grid.box.min[k] - o[k]) / d[k], b = (grid.box.max[k] - o[k]) / d[k];
    begin = select(across, max(begin, min(a, b)), begin), end = select(across, min(end, max(a, b)), end);
  }
  active &= begin <= end;
  // Where the ray, seen from its end, leaves the cell; the length of a cell along it.
  Packet next[3], delta[3];
  IntPacket cell[3], step[3];
  for (int k = 0; k < 3; ++k) {
    const Packet place = (o[k] + end * d[k] - grid.low) / grid.cell;
    const Mask across = d[k] != 0.0, forward = d[k] > 0.0;
    cell[k] = whole_part(select(active, min(max(Packet(0.0), place), Packet(kSide - 1.0)), Packet(0.0)));
    step[k] = select(forward, IntPacket(-1), IntPacket(1));
    const Packet wall =
        grid.low + grid.cell * select(forward, number_of_cells(cell[k]), number_of_cells(cell[k]) + 1.0);
    next[k] = select(across, (wall - o[k]) / d[k], Packet(-1e300));
    delta[k] = select(across, grid.cell / abs(d[k]), Packet(0.0));
  }
  Packet t = end, result = none;
  for (;;) {
    static_assert(kSide == 1 << 5);
    const Mask found = active & has_bit(gather(grid.rows, shift_left<5>(cell[2]) + cell[1], active), cell[0]);
    result = select(found, t, result);
    active &= ~found;
    const Mask x_y = next[0] > next[1], x_z = next[0] > next[2], y_z = next[1] > next[2];
    const Mask nearest[3] = {x_y & x_z, ~x_y & y_z, ~((x_y & x_z) | (~x_y & y_z))};
    t = select(nearest[0], next[0], select(nearest[1], next[1], next[2]));
    active &= t > begin;
    for (int k = 0; k < 3; ++k) {
      cell[k] = select(nearest[k], cell[k] + step[k], cell[k]);
      active &= (cell[k] & IntPacket(~static_cast<std::int64_t>(kSide - 1))) == IntPacket(0);
      next[k] = select(nearest[k], next[k] - delta[k], next[k]);
    }
    if (bits(active) == 0) return result;
  }
}

// JuliaFractal::enters for eight rays.
unsigned enter(const Grid* grid, double radius, const LocalPacket& l, unsigned active_mask, const double* t_max,
               RaysInGrid& within) {
  const Packet ox = load(l.ox), oy = load(l.oy), oz = load(l.oz), dx = load(l.dx), dy = load(l.dy), dz = load(l.dz);
  const Packet closest = -(ox * dx + oy * dy + oz * dz), distance2 = ox * ox + oy * oy + oz * oz,
               half2 = radius * radius - distance2 + closest * closest;
  const Mask meets =
      Mask::of_bits(active_mask) & (half2 > kEpsilon) & ~((closest < kEpsilon) & (distance2 >= radius * radius));
  const Packet half = sqrt(select(meets, half2, Packet(0.0))), end = closest + half,
               begin = max(closest - half, Packet(kFine));
  const Mask ahead = meets & (end >= kFine);
  const Packet last = grid ? last_cell(*grid, l, begin, end, ahead) : end;
  for (int axis = 0; axis < 3; ++axis) {
    store(within.rays.origin[axis], axis == 0 ? ox : axis == 1 ? oy : oz);
    store(within.rays.direction[axis], axis == 0 ? dx : axis == 1 ? dy : dz);
  }
  store(within.interval.begin, begin), store(within.interval.end, end), store(within.interval.last, last);
  store(within.interval.limit, load(t_max) * load(l.scale) * (1 + 1e-9));
  return bits(ahead & ~(last < 0.0));
}

// ---- the iteration
constexpr unsigned kAll = (1u << kLanes) - 1;

// Like Number.
struct Numbers {
  Packet x, y, z, w;
};

struct PacketPoint {
  Packet x, y, z;
};
HWY_INLINE PacketPoint load_point(const double (&at)[3][kLanes]) { return {load(at[0]), load(at[1]), load(at[2])}; }
HWY_INLINE PacketPoint onward(const PacketPoint& p, const Packet& by, const PacketPoint& direction) {
  return {p.x + by * direction.x, p.y + by * direction.y, p.z + by * direction.z};
}
HWY_INLINE PacketPoint select_point(const Mask& where, const PacketPoint& a, const PacketPoint& b) {
  return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}

// Of Kind::function, of the lanes `asked`: both complex numbers of each lane side by side.
HWY_NOINLINE Numbers image_by_function(const Field& f, const Numbers& h, unsigned asked) {
  constexpr int kVectors = Packet::kVectors;
  using Both = PacketOf<2 * kLanes>;
  const auto join = [](const Packet& a, const Packet& b) VERISIM_INLINE_LAMBDA {
    Both r;
    VERISIM_EACH_VECTOR r.v[i] = a.v[i], r.v[kVectors + i] = b.v[i];
    return r;
  };
  const auto part = [](const Both& a, int begin) VERISIM_INLINE_LAMBDA {
    Packet r;
    VERISIM_EACH_VECTOR r.v[i] = a.v[begin + i];
    return r;
  };
  const Complex<Packet> p = first_of(h), q = second_of(h);
  const ComplexFunctions<functions::HWY_NAMESPACE::LibraryLanes<2 * kLanes>> complex{{asked | asked << kLanes}};
  const Complex<Both> image = complex.image(f, {join(p.re, q.re), join(p.im, q.im)});
  return hypercomplex_of<Numbers>(Complex<Packet>{part(image.re, 0), part(image.im, 0)},
                                  Complex<Packet>{part(image.re, kVectors), part(image.im, kVectors)});
}
// Only the lanes `asked` are of interest.
template <Kind K>
HWY_INLINE Numbers image_of(const Field& f, const Numbers& h, const Mask& asked) {
  if constexpr (K == Kind::function)
    return image_by_function(f, h, bits(asked));
  else
    return image<K>(h);
}
template <Kind K>
HWY_INLINE Numbers next(const Numbers& h, const Number& c) {
  return plus(image<K>(h), c);
}
HWY_INLINE Numbers select_numbers(const Mask& where, const Numbers& a, const Numbers& b) {
  return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z), select(where, a.w, b.w)};
}

// What the searches of a packet leave: of each lane its latest iterates, and the last one before hN of the latest point
// that stayed.
using Left = Numbers[Kernels::kMostKept + 1];

// The points of the first three halvings, one of them twice, and those of the fourth: two orbits that wait for nothing
// of each other. A lane is moved by the halves whose farther part it lies in, one after another, and by half of what is
// left, as a search moves.
template <Kind K>
HWY_INLINE unsigned halvings_of(const Field& f, const Vec3& from, const Vec3& d, double width) {
  const PacketPoint direction{Packet(d.x), Packet(d.y), Packet(d.z)},
      start_place{Packet(from.x), Packet(from.y), Packet(from.z)};
  const auto move = [&](PacketPoint& place, unsigned lanes, double by) {
    place = select_point(Mask::of_bits(lanes), onward(place, Packet(by), direction), place);
  };
  const double half = width / 2, quarter = half / 2, eighth = quarter / 2;
  PacketPoint first = start_place, last = start_place;
  move(first, 0b11100101, half), move(first, 0b11010110, quarter), move(first, 0b11111000, eighth);
  move(last, 0b11110000, half), move(last, 0b11001100, quarter), move(last, 0b10101010, eighth);
  move(last, kAll, eighth / 2);
  Numbers h = first_iterate<Numbers>(f, first), g = first_iterate<Numbers>(f, last);
  Mask out = Mask::of_bits(0), out_last = out;
  for (int i = 1; i <= f.iterations; ++i) {
    out = out | (norm2<K>(h) > f.escape), out_last = out_last | (norm2<K>(g) > f.escape);
    if (bits(out & out_last) == kAll) return 0;
    h = next<K>(h, f.parameter), g = next<K>(g, f.parameter);
  }
  return (~bits(out) & 0x7f) | (~bits(out_last) & kAll) << 7;
}

HWY_INLINE Packet logarithms(const Packet& v, unsigned asked) {
  return functions::HWY_NAMESPACE::of_library<functions::LibraryFunction::log, kLanes>(v, v, asked);
}

struct Marched {
  Mask inside;
  Packet estimate;
};

// At one point of each ray that is asked for; estimates only where they are asked for.
template <Kind K>
HWY_INLINE Marched march_of(const Field& f, const PacketPoint& place, const PacketPoint& direction,
                            const Mask& active_mask, const Mask& estimated, Numbers* left = nullptr) {
  constexpr bool kQuaternion = is_quaternion(K);
  Numbers h = first_iterate<Numbers>(f, place);
  Mask out = ~active_mask;
  // Of each lane when it escapes: |h|^2 and, for quaternions, |h(i-1) ... h1 h0|^2 (the product of lengths has other
  // last bits) and k^steps; for others the slope along the ray.
  const Packet one = Packet(1.0);
  Packet q(0.0), product2 = one, power = one, slope(0.0);
  double running_power = 1, scale = 2;
  Numbers m = h;
  for (int i = 1;; ++i) {
    if constexpr (!is_power(K))
      if (left) left[i - 1] = select_numbers(~out, h, left[i - 1]);
    const Packet n2 = norm2<K>(h);
    const Mask now = (n2 > f.escape) & ~out;
    if constexpr (kQuaternion) {
      running_power = running_power * (K == Kind::quaternion_cube ? 1.0 / 3 : 1.0 / 2);
      if (bits(estimated & ~out) != 0) {
        if (i > 1) m = quaternion_product<K>(h, m);
        if (bits(now) != 0) {
          product2 = select(now, norm2_of_product(m), product2);
          power = select(now, Packet(running_power), power);
        }
      }
    } else {
      if (bits(now) != 0) {
        Numbers n = h;
        if constexpr (K == Kind::hypercomplex_square) n = scaled(n, scale);
        const PacketPoint v = hypercomplex_gradient<PacketPoint>(m, n);
        slope = select(now, v.x * direction.x + v.y * direction.y + v.z * direction.z, slope);
      }
    }
    q = select(now, n2, q);
    out = out | now;
    if (bits(out) == kAll || i == f.iterations) break;
    const Numbers image = image_of<K>(f, h, ~out);
    if constexpr (!kQuaternion) {
      if (i > 1) {
        m = with_iterate<K>(m, h, image);
        scale *= 2;
      }
    }
    h = plus(image, f.parameter);
  }
  if constexpr (!is_power(K))
    if (left) left[f.iterations] = select_numbers(~out, h, left[f.iterations]);
  const Packet smallest = Packet(f.precision);
  Marched result{~out, smallest};
  if constexpr (kQuaternion) {
    // ln q <= q - 1 spares most of the logarithms.
    const Packet root = power * sqrt(q / product2);
    const Mask far = estimated & out & (root * (q - 1.0) > f.precision);
    if (const unsigned lanes = bits(far); lanes != 0)
      result.estimate = select(far, root * logarithms(q, lanes), smallest);
  } else {
    const Mask near = out & slope_tells(slope, q, f.precision);
    result.estimate = select(near, q / (-2.0 * slope), smallest);
  }
  return result;
}

template <Kind K>
HWY_INLINE unsigned march_one(const Field& f, const Points& points, const Vec3& d, double* estimate) {
  const Mask all = Mask::all();
  const Marched at = march_of<K>(f, load_point(points.at), {Packet(d.x), Packet(d.y), Packet(d.z)}, all, all);
  store(estimate, at.estimate);
  return bits(at.inside);
}

// Where the plain inside test looks for a point: POV-Ray replaces z by y for functions.
template <Kind K>
HWY_INLINE PacketPoint place_of_inside(const PacketPoint& p) {
  return {p.x, p.y, K == Kind::function ? p.y : p.z};
}

// JuliaFractal::keep_normal for the hits of a packet.
template <Kind K>
HWY_INLINE void keep_normals(const Field& f, const PacketPoint& place, const Mask& found, Numbers* left,
                             NormalsOfSearch& kept) {
  const PacketPoint nowhere{Packet(0.0), Packet(0.0), Packet(0.0)};
  const Mask escaped =
      found & ~march_of<K>(f, place_of_inside<K>(place), nowhere, found, Mask::of_bits(0), left).inside;
  kept.lanes = bits(escaped);
  if (kept.lanes == 0) return;
  Numbers m = left[0];
  for (int j = 1; j < f.iterations; ++j) m = with_iterate<K>(m, left[j], image_of<K>(f, left[j], escaped));
  const Numbers& before_last = left[f.iterations];
  const PacketPoint n = hypercomplex_gradient<PacketPoint>(m, plus(image_of<K>(f, before_last, escaped), f.parameter));
  store(kept.normals.at[0], n.x), store(kept.normals.at[1], n.y), store(kept.normals.at[2], n.z);
}

// All rays evaluate one point at a time, whatever they are about: the first point, a step, or a halving.
template <Kind K>
HWY_INLINE unsigned cross(const Field& f, const Rays& rays, const Interval& interval, unsigned active_mask,
                          double* depths, Points& points, [[maybe_unused]] NormalsOfSearch* normals) {
  const PacketPoint origin = load_point(rays.origin), direction = load_point(rays.direction);
  const Packet end = load(interval.end), last = load(interval.last), limit = load(interval.limit);
  const Mask none = Mask::of_bits(0);
  Mask active = Mask::of_bits(active_mask), first = active, again = none, halving = none, in = none, found = none;
  Packet at = load(interval.begin), base(0.0), width(0.0), depth(0.0);
  // Points are carried along, step by step: their bits are not those of the distances.
  PacketPoint place = onward(origin, at, direction), base_place = place, found_place = place;
  [[maybe_unused]] std::conditional_t<is_power(K), int, Left> memory;
  Numbers* left = nullptr;
  if constexpr (!is_power(K)) left = normals ? memory : nullptr;
  while (bits(active) != 0) {
    const PacketPoint asked = K == Kind::function ? select_point(halving, place_of_inside<K>(place), place) : place;
    const Marched now = march_of<K>(f, asked, direction, active, active & ~halving, left);
    const Mask same = ~(now.inside ^ in);
    const Mask halved = active & halving, began = active & first, began_in = began & now.inside,
               entered = active & again, walked = active & ~(halving | first | again);
    // A ray that begins inside looks a little farther on once more.
    first = none;
    again = began_in;
    in = (in | began_in) & ~(entered & ~now.inside);
    const Mask steps = (began & ~now.inside) | entered | (walked & same), changed = walked & ~same;
    const Mask moved = steps | (halved & same);
    base = select(moved, at, base), base_place = select_point(moved, place, base_place);
    width = select(steps, select(now.estimate < f.precision, Packet(f.precision), now.estimate), width);
    // The state changes between base and base + width.
    halving = halving | changed;
    base = select(changed, at - width, base);  // as March::walk has it
    const Mask fine = width > kFine, halves = (halved | changed) & fine, done = (halved | changed) & ~fine;
    width = select(halves, width / 2.0, width);
    const Packet ahead = base + width;
    const PacketPoint place_ahead = onward(base_place, width, direction);
    if (bits(done) != 0) {
      depth = select(done, select(in, base, ahead), depth);
      found_place = select_point(done, select_point(in, base_place, place_ahead), found_place);
      found = found | done;
    }
    const Mask onwards = steps | halves;
    if (bits(began_in) != 0) {
      at = select(began_in, at + 2 * kFine, at);
      place = select_point(began_in, onward(place, Packet(2 * kFine), direction), place);
    }
    at = select(onwards, ahead, at), place = select_point(onwards, place_ahead, place);
    const Mask useful = (base <= last) & (base <= limit) & (at <= end);
    active &= ~(done | (began_in & (at > end)) | (steps & ~useful));
  }
  if constexpr (!is_power(K))
    if (left && any(found)) keep_normals<K>(f, found_place, found, left, *normals);
  store(depths, depth);
  store(points.at[0], found_place.x), store(points.at[1], found_place.y), store(points.at[2], found_place.z);
  return bits(found);
}

// So that what some kinds keep in memory does not make others' frames larger.
template <Kind K>
HWY_NOINLINE unsigned cross_apart(const Field& f, const Rays& rays, const Interval& interval, unsigned active_mask,
                                  double* depths, Points& points, NormalsOfSearch* normals) {
  return cross<K>(f, rays, interval, active_mask, depths, points, normals);
}

unsigned halvings(const Field& f, const Vec3& from, const Vec3& direction, double width) {
  return with_kind(f.kind, [&]<Kind K>() VERISIM_INLINE_LAMBDA {
    if constexpr (is_power(K)) return halvings_of<K>(f, from, direction, width);
    return 0u;
  });
}
unsigned march_packet(const Field& f, const Points& points, const Vec3& direction, double* estimate) {
  return with_kind(f.kind,
                   [&]<Kind K>() VERISIM_INLINE_LAMBDA { return march_one<K>(f, points, direction, estimate); });
}
unsigned first_intersections(const Field& f, const Rays& rays, const Interval& interval, unsigned active_mask,
                             double* depth, Points& points, NormalsOfSearch* normals) {
  return with_kind(f.kind, [&]<Kind K>() VERISIM_INLINE_LAMBDA {
    return cross_apart<K>(f, rays, interval, active_mask, depth, points, normals);
  });
}

constexpr Kernels kKernels{halvings, march_packet, enter, first_intersections};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes::julia
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes::julia {
VERISIM_EXPORT_KERNELS(Kernels, kernels)
}  // namespace verisim::shapes::julia
#endif
