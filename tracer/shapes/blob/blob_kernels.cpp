#include "tracer/shapes/blob/blob_packet.h"
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/blob/blob_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/bvh/bvh.h"
#include "tracer/bvh/node_rays-inl.h"
#include "tracer/math/packet_vector-inl.h"
#include "tracer/shapes/intersections.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace accel::HWY_NAMESPACE;
using namespace simd::HWY_NAMESPACE;

#include "tracer/shapes/blob/blob_field.inc"

// Where rays are within reach of a part; `nearest2`: their squared distance from the centre or axis there. `whole_end`:
// where they leave the sphere or the endless cylinder that the part is cut from.
template <class Number>
struct Course {
  Number t0, t1, scale2, nearest2, whole_end;
};

// One ray need not go on once it is out of reach.
template <class Number>
HWY_INLINE bool out_of_reach(const typename Number::Mask& met) {
  if constexpr (Number::kCount == 1) return bits(met) == 0;
  return false;
}

// The lanes whose lines come within reach, before or behind. `Number` is a packet of the rays that go together: Packet,
// or PacketOf<1>. The order of operations is POV-Ray's (spec 08 N).
template <class Number>
HWY_INLINE typename Number::Mask line_meets(const BlobPart& part, PacketVector<Number> o, PacketVector<Number> d,
                                            Course<Number>& course) {
  using Mask = typename Number::Mask;
  Number scale = 1.0;
  if (part.moved) {
    const Affine& inverse = part.transform->inv;
    o = transform_point(inverse, o), d = transform_direction(inverse, d);
    scale = sqrt(dot(d, d));
    const Number inverse_scale = 1.0 / scale;
    d = {d.x * inverse_scale, d.y * inverse_scale, d.z * inverse_scale};
  }
  o = {o.x - part.center.x, o.y - part.center.y, o.z - part.center.z};
  Mask met = Mask::all();
  if (part.kind == BlobPartKind::cylinder) {
    const Number a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y, c = o.x * o.x + o.y * o.y;
    const Number beyond = c - part.radius2, discriminant = b * b - a * beyond;
    const Mask slanted = a > kEpsilon;
    met = (slanted & (discriminant > 0)) | (~slanted & (beyond < 0));
    if (out_of_reach<Number>(met)) return met;
    const Number root = sqrt(discriminant);
    course.t0 = select(slanted, (-b - root) / a, -HUGE_VAL), course.t1 = select(slanted, (-b + root) / a, HUGE_VAL);
    course.nearest2 = select(slanted, c - b * b / a, c);
  } else {
    const Number b = dot(o, d), c = dot(o, o), discriminant = b * b - c + part.radius2;
    met = discriminant > 0;
    if (out_of_reach<Number>(met)) return met;
    const Number root = sqrt(discriminant);
    course.t0 = -b - root, course.t1 = -b + root;
    course.nearest2 = c - b * b;
  }
  course.whole_end = course.t1;
  if (part.kind != BlobPartKind::sphere) {
    const double low = part.kind == BlobPartKind::base ? -HUGE_VAL : 0;
    const double high = part.kind == BlobPartKind::base       ? 0
                        : part.kind == BlobPartKind::cylinder ? part.length
                                                              : HUGE_VAL;
    const Mask across = abs(d.z) < kEpsilon;
    met = met & ~(across & ((o.z < low) | (o.z > high)));
    const Number to_low = (low - o.z) / d.z, to_high = (high - o.z) / d.z;
    const Mask swapped = to_low > to_high;
    course.t0 = select(across, course.t0, max(course.t0, select(swapped, to_high, to_low)));
    course.t1 = select(across, course.t1, min(course.t1, select(swapped, to_low, to_high)));
  }
  if (part.moved)
    course.t0 = course.t0 / scale, course.t1 = course.t1 / scale, course.whole_end = course.whole_end / scale;
  course.scale2 = scale * scale / part.radius2;
  return met & (course.t1 > course.t0) & (course.t1 < HUGE_VAL);
}

// What a part adds to the field at most: that of a positive part is largest where the ray is closest.
template <class Number>
HWY_INLINE Number peak_of(const BlobPart& part, const Course<Number>& course) {
  if (!(part.k2 > 0)) return 0.0;
  const Number d2 = max(course.nearest2, Number(0.0));
  return (part.k0 * d2 + part.k1) * d2 + part.k2;
}

std::uint64_t near_parts(const PartSpheres* spheres, std::size_t blocks, const Vec3& o, const Vec3& d, double apart,
                         double bent) {
  const double size2 = dot(d, d), inverse2 = 1 / size2;
  if (!(size2 < HUGE_VAL)) apart = HUGE_VAL;  // any part may be near, as for packets with such a ray
  std::uint64_t near = 0;
  for (std::size_t n = 0; n < blocks; ++n) {
    const PartSpheres& s = spheres[n];
    const Packet x = load(s.x) - o.x, y = load(s.y) - o.y, z = load(s.z) - o.z, radius = load(s.radius);
    const Packet away2 = x * x + y * y + z * z, along = x * d.x + y * d.y + z * d.z,
                 beside2 = away2 - along * along * inverse2;
    Packet reach = radius + apart;
    if (bent > 0) reach += bent * (sqrt(away2) + apart);
    // What is NaN may be anything.
    near |= std::uint64_t{bits((radius >= 0) & ~(beside2 > reach * reach * (1 + 1e-6) + 1e-9 * away2))} << 8 * n;
  }
  return near;
}

std::uint64_t parts_around(const PartSpheres* spheres, std::size_t blocks, const Vec3& p) {
  std::uint64_t around = 0;
  for (std::size_t n = 0; n < blocks; ++n) {
    const PartSpheres& s = spheres[n];
    const Packet x = load(s.x) - p.x, y = load(s.y) - p.y, z = load(s.z) - p.z, radius = load(s.radius),
                 away2 = x * x + y * y + z * z;
    around |= std::uint64_t{bits((radius >= 0) & ~(away2 > radius * radius * (1 + 1e-6)))} << 8 * n;
  }
  return around;
}

using RayVectors = PacketVector<Packet>;
HWY_INLINE RayVectors origins(const LocalPacket& rays) { return {load(rays.ox), load(rays.oy), load(rays.oz)}; }
HWY_INLINE RayVectors directions(const LocalPacket& rays) { return {load(rays.dx), load(rays.dy), load(rays.dz)}; }

// False: the lines of none of the lanes come within reach of the part.
HWY_INLINE bool take_piece(const BlobPart& part, const RayVectors& o, const RayVectors& d, unsigned lanes,
                           PiecePacket& piece) {
  Course<Packet> course;
  const unsigned line = bits(line_meets(part, o, d, course)) & lanes;
  if (line == 0) return false;
  piece.met = line & bits(course.t1 > 0.0);
  piece.behind = part.kind == BlobPartKind::base || part.kind == BlobPartKind::apex ? line & ~piece.met : 0;
  if ((piece.met | piece.behind) == 0) return false;
  store(piece.t0, piece.behind != 0 ? course.t0 : max(Packet(0.0), course.t0)), store(piece.t1, course.t1);
  store(piece.scale2, course.scale2), store(piece.peak, peak_of(part, course));
  store(piece.whole_end, course.whole_end);
  piece.part = &part;
  return true;
}

std::size_t find_pieces(const BlobPart* parts, std::uint64_t near, const LocalPacket& rays, unsigned active,
                        PiecePacket* pieces) {
  const RayVectors o = origins(rays), d = directions(rays);
  std::size_t found = 0;
  for (; near != 0; near &= near - 1) found += take_piece(parts[__builtin_ctzll(near)], o, d, active, pieces[found]);
  return found;
}

std::size_t find_pieces_in_tree(const BlobPart* parts, const accel::Bvh& tree, const LocalPacket& rays, unsigned active,
                                PiecePacket* pieces, std::size_t most) {
  using accel::BoxNode;
  const RayVectors o = origins(rays), d = directions(rays);
  const double* const origin[3] = {rays.ox, rays.oy, rays.oz};
  const double* const direction[3] = {rays.dx, rays.dy, rays.dz};
  accel::NodeRays there;
  enter_tree(tree.bounds(), tree.center(), tree.slack(), origin, direction, 0, there);
  const FloatPacket end = node_limits(there, HUGE_VAL);
  std::uint64_t stack[accel::Bvh::kStackSize];  // lanes above the child that they meet
  int size = 0;
  std::size_t found = 0;
  if (const unsigned lanes = entering(active, there)) stack[size++] = std::uint64_t{lanes} << 32;
  while (size > 0) {
    const std::uint64_t next = stack[--size];
    const auto child = static_cast<std::uint32_t>(next);
    const auto lanes = static_cast<unsigned>(next >> 32);
    if (child & BoxNode::kLeaf) {
      if (found == most) return most + 1;
      found += take_piece(parts[BoxNode::leaf_first(child)], o, d, lanes, pieces[found]);
      continue;
    }
    const BoxNode& node = tree.node(child);
    accel::ChildrenMet met;
    test_children(node, there, end, met);
    for (int k = 0; k < 4; ++k)
      if (const unsigned here = met.lanes[k] & lanes) stack[size++] = std::uint64_t{here} << 32 | node.child[k];
  }
  return found;
}

bool find_piece(const BlobPart& part, const Vec3& origin, const Vec3& direction, RayPiece& piece) {
  using One = PacketOf<1>;
  Course<One> course;
  const PacketVector<One> o = {origin.x, origin.y, origin.z}, d = {direction.x, direction.y, direction.z};
  if (bits(line_meets(part, o, d, course)) == 0) return false;
  store(&piece.t0, course.t0), store(&piece.t1, course.t1), store(&piece.scale2, course.scale2);
  store(&piece.peak, peak_of(part, course)), store(&piece.whole_end, course.whole_end);
  return true;
}

// The running sums of eight rays, each of which goes from one end of a piece to the next: what class Intervals does for
// one ray.
class RunningSums {
 public:
  HWY_INLINE RunningSums(const PiecePacket* const* pieces, std::size_t count, const LocalPacket& rays, unsigned lanes,
                         const IntervalQuery& query)
      : pieces_(pieces), count_(count), query_(query), scale_(load(rays.scale)) {
    Packet end = -HUGE_VAL, peak = 0.0;
    start = HUGE_VAL;
    for (std::size_t i = 0; i < count; ++i) {
      const PiecePacket& p = *pieces[i];
      const Mask met = Mask::of_bits(p.met & lanes);
      const Packet t0 = max(load(p.t0), Packet(0.0)), t1 = load(p.t1);
      start = select(met, min(start, t0), start), end = select(met, max(end, t1), end);
      peak = select(met, peak + load(p.peak), peak);
      left_ = select(met, left_ + 2.0, left_);
      next_[i] = select(met, t0, HUGE_VAL);
      inside_[i] = 0;
    }
    span = end - start;
    alive_ = Mask::of_bits(lanes) & (span > 0.0) & (span < HUGE_VAL);
    // What the running sum over so long a way may be off by: the coefficients of thin parts are huge.
    Packet sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const Packet size = 1 + load(pieces[i]->scale2) * span * span;
      sum = select(Mask::of_bits(pieces[i]->met), sum + std::fabs(pieces[i]->part->k2) * size * size, sum);
    }
    rounding_ = 1e-12 * sum;
    alive_ &= ~stays_below(peak, query.threshold, rounding_);
    origin_ = point_at(origins(rays), start, directions(rays));
    const RayVectors d = directions(rays);
    direction_ = {span * d.x, span * d.y, span * d.z};
    too_near_ = (query.too_near * scale_ - start) / span;
    power_[0] = -query.threshold;
    for (int i = 1; i < 5; ++i) power_[i] = 0.0;
  }

  // Writes the intervals that may have roots.
  HWY_INLINE void run(IntervalLists& found) {
    const Packet lower = load(query_.from), upper = load(query_.to);
    Mask merging = Mask::of_bits(0);
    Packet from = 0.0, here = nearest();
    for (alive_ &= left_ > 1.0; bits(alive_) != 0; alive_ &= left_ > 1.0) {
      pass(here);
      const Packet next = nearest();
      from = select(merging, from, (here - start) / span);
      const Packet to = (next - start) / span;
      here = next;
      merging = alive_ & (to - from < kShortestInterval) & (left_ > 1.0);
      Mask candidates = alive_ & ~merging & (within_ > 0.0);
      const Mask beyond = candidates & (depth(from) > upper);
      alive_ &= ~beyond;
      candidates &=
          ~(beyond | (depth(to) < lower) | (to < too_near_) | stays_below(peak_, query_.threshold, rounding_));
      if (bits(candidates) == 0) continue;
      candidates &= ~keeps_its_sign(power_, from, to);
      if (const Mask doubtful = candidates & (from < too_near_); bits(doubtful) != 0)
        candidates &= ~(doubtful & keeps_its_sign_by_far(power_, too_near_, to));
      const unsigned lanes = bits(candidates);
      if (lanes == 0) continue;
      IntervalPacket& interval = found.intervals[found.count++];
      store(interval.from, from), store(interval.to, to);
      for (int i = 0; i < 5; ++i) store(interval.power[i], power_[i]);
      interval.lanes = lanes;
      if (query_.first) alive_ &= ~candidates;
    }
  }

  Packet start, span;

 private:
  HWY_INLINE Packet depth(const Packet& place) const { return (place * span + start) / scale_; }
  HWY_INLINE Packet nearest() const {
    Packet t = HUGE_VAL;
    for (std::size_t i = 0; i < count_; ++i) t = min(t, next_[i]);
    return t;
  }

  // Goes past the ends of pieces at t, of each lane the first one that lies there, in the order of parts.
  HWY_INLINE void pass(const Packet& t) {
    Mask waiting = alive_;
    for (std::size_t i = 0; i < count_ && bits(waiting) != 0; ++i) {
      const Mask here = waiting & (next_[i] == t);
      const unsigned lanes = bits(here);
      if (lanes == 0) continue;
      waiting &= ~here;
      const PiecePacket& p = *pieces_[i];
      const Mask leaves = Mask::of_bits(inside_[i]);
      if (!expanded_[i]) expand(i);
      for (int k = 0; k < 5; ++k) {
        const Packet own = load(powers_[i][k]);
        power_[k] = select(here, power_[k] + select(leaves, -own, own), power_[k]);
      }
      const Packet peak = load(p.peak);
      peak_ = select(here, peak_ + select(leaves, -peak, peak), peak_);
      within_ = select(here, within_ + select(leaves, Packet(-1.0), Packet(1.0)), within_);
      left_ = select(here, left_ - 1.0, left_);
      next_[i] = select(here, select(leaves, Packet(HUGE_VAL), load(p.t1)), next_[i]);
      inside_[i] ^= lanes;
    }
  }
  HWY_INLINE void expand(std::size_t i) {
    const BlobPart& part = *pieces_[i]->part;
    const RayVectors q = part.moved ? transform_point(part.transform->inv, origin_) : origin_,
                     d = part.moved ? transform_direction(part.transform->inv, direction_) : direction_;
    Packet power[5];
    field_powers(part, RayVectors{q.x - part.center.x, q.y - part.center.y, q.z - part.center.z}, d, span, power);
    for (int k = 0; k < 5; ++k) store(powers_[i][k], power[k]);
    expanded_[i] = true;
  }

  const PiecePacket* const* pieces_;
  std::size_t count_;
  const IntervalQuery& query_;
  Packet scale_, rounding_, too_near_, power_[5], peak_ = 0.0;
  Packet within_ = 0.0, left_ = 0.0;  // pieces that the ray is in; ends of pieces that it has not passed
  Mask alive_;
  RayVectors origin_, direction_;
  Packet next_[IntervalLists::kMaxPieces];  // where each piece begins or, within it, ends
  unsigned inside_[IntervalLists::kMaxPieces];
  bool expanded_[IntervalLists::kMaxPieces] = {};
  alignas(64) double powers_[IntervalLists::kMaxPieces][5][kLanes];  // of those that are expanded
};

void find_intervals(const PiecePacket* const* pieces, std::size_t count, const LocalPacket& rays, unsigned lanes,
                    const IntervalQuery& query, IntervalLists& found) {
  RunningSums sums(pieces, count, rays, lanes, query);
  found.count = 0;
  store(found.start, sums.start), store(found.span, sums.span);
  sums.run(found);
}

// How many of numbers[first .. end) stand before those of the packet.
template <class Before>
HWY_INLINE Packet count_before(const double* numbers, int first, int end, const Before& before) {
  // A sum waits for itself: four take turns.
  Packet sums[4] = {0.0, 0.0, 0.0, 0.0};
  int j = first;
  for (; j + 4 <= end; j += 4)
    for (int k = 0; k < 4; ++k) sums[k] += select(before(numbers[j + k]), Packet(1), Packet(0));
  for (; j < end; ++j) sums[0] += select(before(numbers[j]), Packet(1), Packet(0));
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// All are compared with all: no branch hangs on how they lie.
void ranks(const double* numbers, int count, double* places) {
  alignas(64) static constexpr double kLaneNumbers[] = {0, 1, 2, 3, 4, 5, 6, 7};
  const Packet lane = load(kLaneNumbers);
  for (int i = 0; i < count; i += kLanes) {
    const Packet here = load(numbers + i);
    Packet place = count_before(numbers, 0, i, [&](double other) { return Packet(other) <= here; });
    for (int k = 0; k < kLanes && i + k < count; ++k)
      place += select((Packet(numbers[i + k]) < here) |
                          ((Packet(numbers[i + k]) == here) & (Packet(static_cast<double>(k)) < lane)),
                      Packet(1), Packet(0));
    place += count_before(numbers, i + kLanes, count, [&](double other) { return Packet(other) < here; });
    store(places + i, place);
  }
}

const BlobKernels kKernels = {near_parts, parts_around,   find_pieces, find_pieces_in_tree,
                              find_piece, find_intervals, ranks};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(BlobKernels, blob_kernels)
}  // namespace verisim::shapes
#endif
