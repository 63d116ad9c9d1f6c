#include <bit>
#include <cmath>
#include <limits>

#include "tracer/shapes/implicit/isosurface_batch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tracer/shapes/implicit/isosurface_kernels.cpp"
#include "tracer/simd/each_target.h"

#include "tracer/shapes/implicit/isosurface_entry-inl.h"
#include "tracer/simd/kernel_table.h"
#include "tracer/simd/packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace verisim::shapes {
namespace {
namespace HWY_NAMESPACE {

using namespace simd::HWY_NAMESPACE;

alignas(64) constexpr std::int64_t kLaneNumbers[kLanes] = {0, 1, 2, 3, 4, 5, 6, 7};

constexpr std::int64_t kRoot = std::int64_t{1} << kMaxHalvings;

// Where the numbers of each lane at a depth are.
HWY_INLINE IntPacket entries(const IntPacket& depth) { return shift_left<3>(depth) + load(kLaneNumbers); }
static_assert(kLanes == 8);

void middles(const SearchPacket& s, double* points) {
  const Packet t = select(load_mask(s.homing), load(s.probe), load(s.begin) + load(s.width) / 2.0);
  for (int axis = 0; axis < 3; ++axis)
    store(points + axis * kLanes, load(s.origin[axis]) + t * load(s.direction[axis]));
}

// The state of the lanes while they look at nodes.
struct State {
  Packet begin, width, value0, value1;
  IntPacket place, unit, depth;
  Mask active;
};

// The node that begins where another one ends: its right sibling or that of one above it; of depth 0: none does.
struct NextNode {
  IntPacket place, unit, depth;
  Packet width;
};
HWY_INLINE NextNode next_node(const SearchPacket& s, const State& at) {
  constexpr double kShift = 0x1p52;
  // 2^-depth of the node there: of those that begin at `next` it is a right sibling that has the length of the lowest
  // bit.
  const IntPacket next = at.place + at.unit, unit = next & (IntPacket(0) - next);
  const Packet length = number_of(unit | IntPacket(std::bit_cast<std::int64_t>(kShift))) - kShift;
  return {next, unit, IntPacket(kMaxHalvings + 1023) - shift_right<52>(bits_of(length)),
          load(s.root_width) * (length * (1.0 / static_cast<double>(kRoot)))};
}
HWY_INLINE Packet begin_of(const SearchPacket& s, const NextNode& next, const Mask& lanes) {
  return gather(s.begins[0], entries(next.depth - IntPacket(1)), lanes) + next.width;
}
// Where nodes end: that is where the next one begins, to the last bit, not begin + width.
HWY_INLINE Packet end_of(const SearchPacket& s, const State& at, const Mask& lanes) {
  const NextNode next = next_node(s, at);
  const Mask within = lanes & (next.depth > IntPacket(0));
  return select(within, begin_of(s, next, within), load(s.end));
}

// Lanes whose node is done, and in which nothing was found, go on to the next one.
HWY_INLINE void turn_right(const SearchPacket& s, State& at, const Mask& done) {
  const NextNode next = next_node(s, at);
  const Mask turns = done & (next.depth > IntPacket(0));
  const Packet value1 = gather(s.ends[0], entries(next.depth - IntPacket(1)), turns);
  at.active &= ~done | turns;
  at.begin = select(turns, begin_of(s, next, turns), at.begin);
  at.width = select(turns, next.width, at.width);
  at.place = select(turns, next.place, at.place);
  at.unit = select(turns, next.unit, at.unit);
  at.depth = select(turns, next.depth, at.depth);
  at.value0 = select(turns, at.value1, at.value0);
  at.value1 = select(turns, value1, at.value1);
}

constexpr double kRound = 0x1.8p52;  // what is added to it and taken away again is rounded to an integer
HWY_INLINE Packet whole_below(const Packet& v) {
  return (v - 0.5 + kRound) - kRound;
}  // or, of an integer, the one below

// The largest second derivative along the rays within nodes that are not longer than a cell.
HWY_INLINE Packet bend_within(const SearchPacket& s, const State& at, const Mask& active_mask) {
  Packet place{};
  for (int axis = 0; axis < 3; ++axis) {
    const Packet step = load(s.cell_step[axis]), first = load(s.cell_origin[axis]) + at.begin * step;
    const Packet cell = whole_below(min(first, first + at.width * step)), last = s.map->count(axis) - 1.0;
    place = place * static_cast<double>(s.map->count(axis)) + min(max(cell, Packet(0.0)), last);
  }
  const IntPacket index = bits_of(place + kRound) - IntPacket(std::bit_cast<std::int64_t>(kRound));
  return gather(s.map->bends(), index, active_mask) * load(s.speed2);
}

// Of the nodes that would be halved: those without an intersection, and those with a single one that the search would
// find. In both cases the nodes below are not steeper than what has been met already. With values v0 and v1 at the ends
// and second derivatives up to k, the function is at least v0 (1 - s) + v1 s - q s (1 - s), q = k width^2 / 2, and its
// slope within q of v1 - v0.
struct Outlook {
  Mask clear, crossed;
  Packet bend, sag;  // k and q
};
HWY_INLINE Outlook outlook(const SearchPacket& s, const State& at, const Packet& rise, const Packet& steepest,
                           const Mask& halved) {
  Outlook o{};
  const Mask fits = halved & (at.width * load(s.reach) < 0.99);
  o.bend = load(s.bend_anywhere);
  if (bits(fits) != 0) o.bend = select(fits, min(o.bend, bend_within(s, at, fits)), o.bend);
  const Mask known = halved & (o.bend < std::numeric_limits<double>::infinity());
  if (bits(known) == 0) return o;
  const double error = 4 * s.map->error();
  const Packet q = o.sag = o.bend * (at.width * at.width) * (0.5 * (1 + 1e-12));
  // A computed slope may be off by what its two values are; leaves are at least half as long as the accuracy.
  const Packet swing = rise + q + error + at.width * (4 * error / s.accuracy), slope = load(s.slope) * (1 - 1e-9);
  const Mask calm = known & (swing <= steepest * at.width);
  const Mask monotone = rise - error >= q,
             high = (2.0 * q) * (at.value0 + at.value1 - 2 * error) > q * q + (rise + error) * (rise + error);
  o.clear = calm & (min(at.value0, at.value1) > error) & (monotone | high);
  o.crossed = calm & (at.value0 > error) & (at.value1 < -error) & (q < 0.75 * rise) & (swing <= slope * at.width);
  return o;
}

HWY_INLINE void begin_homing(SearchPacket& s, const State& at, const Packet& rise, const Outlook& o) {
  const auto set = [&](double* to, const Packet& v)
                       VERISIM_INLINE_LAMBDA { store(to, select(o.crossed, v, load(to))); };
  const double error = 4 * s.map->error();
  const Packet end = end_of(s, at, o.crossed);
  set(s.hit, end), set(s.low, at.begin), set(s.high, end), set(s.bend, o.bend), set(s.grain, abs(end) * 0x1p-48);
  set(s.fewest, at.width * (1 - 1e-12) / (rise + o.sag + error)),
      set(s.most, at.width * (1 + 1e-12) / (rise - o.sag - error));
  const Mask nearer = at.value0 < -at.value1;
  set(s.last, select(nearer, at.begin, end)), set(s.last_value, select(nearer, at.value0, at.value1));
  set(s.probe, at.begin + at.width * (at.value0 / rise));
  store_mask(s.homing, load_mask(s.homing) | o.crossed);
  store(s.tries, select(o.crossed, IntPacket(0), load(s.tries)));
}

// Takes the limits closer with the value at the last place; goes down to the node below for which it is certain that it
// has the intersection.
HWY_INLINE void home_in(SearchPacket& s, const Packet& value) {
  const Mask homing = load_mask(s.homing);
  constexpr std::int64_t kTries = 12;
  const double error = 4 * s.map->error();
  const Packet t = load(s.probe), last = load(s.last), apart = 1.0 / (t - last),
               chord = (load(s.last_value) - value) * apart;
  Packet low = load(s.low), high = load(s.high);
  const auto limit = [&](const Packet& fewest, const Packet& most) VERISIM_INLINE_LAMBDA {
    const Packet a = value * fewest, b = value * most, slack = error * most;
    low = max(low, t + min(a, b) - slack), high = min(high, t + max(a, b) + slack);
  };
  limit(load(s.fewest), load(s.most));
  // Somewhere between the two places the slope is that of the chord.
  const Packet spread = load(s.bend) * (max(high, max(t, last)) - min(low, min(t, last))) + error * abs(apart),
               least = chord - spread;
  const Mask better = (least > 0.0) & homing;
  const Packet fewest = select(better, max(load(s.fewest), (1 - 1e-12) / (chord + spread)), load(s.fewest)),
               most = select(better, min(load(s.most), (1 + 1e-12) / least), load(s.most));
  limit(fewest, most);
  Packet begin = load(s.begin), width = load(s.width), end = load(s.hit);
  const Packet grain = load(s.grain);
  for (;;) {
    const Packet half = width / 2.0, middle = begin + half;
    const Mask right = low > middle + grain, down = homing & (width >= s.accuracy) & (right | (high < middle - grain));
    if (bits(down) == 0) break;
    width = select(down, half, width);
    begin = select(down & right, middle, begin);
    end = select(down & ~right, middle, end);
  }
  const IntPacket tries = load(s.tries) + IntPacket(1);
  const Mask found = homing & (width < s.accuracy), lost = homing & ~found & (tries > IntPacket(kTries));
  const Packet next = t + value * (0.5 * (fewest + most));
  store(s.begin, select(homing, begin, load(s.begin))), store(s.width, select(homing, width, load(s.width)));
  store(s.hit, end);
  store(s.low, low), store(s.high, high), store(s.fewest, fewest), store(s.most, most);
  store(s.last, t), store(s.last_value, value), store(s.probe, min(max(next, low), high));
  store(s.tries, tries), store_mask(s.lost, load_mask(s.lost) | lost);
  store_mask(s.found, load_mask(s.found) | found), store_mask(s.homing, homing & ~found & ~lost);
}

// Leaves the lanes for which it matters how far values are from exact ones.
HWY_INLINE void lose_doubtful(SearchPacket& s, State& at, const Packet& rise, const Packet& steepest,
                              const Packet& slope) {
  const Mask leaf = at.width < s.accuracy, unsure_leaf = abs(at.value1) <= s.doubt,
             unsure_node = abs(at.value0 + at.value1 - slope * at.width) <= 3 * s.doubt;
  const Mask lost = at.active & ((rise + 3 * s.doubt > steepest * at.width) | select(leaf, unsure_leaf, unsure_node));
  at.active &= ~lost;
  store_mask(s.lost, load_mask(s.lost) | lost);
}

// Looks at the nodes until each lane has one that is to be halved, or has ended.
HWY_INLINE unsigned settle(SearchPacket& s, State& at) {
  const Packet slope = load(s.slope);
  Packet steepest = load(s.steepest);
  Mask halved, examined = Mask::of_bits(0);
  for (;;) {
    Packet rise;
    for (;;) {
      rise = abs(at.value1 - at.value0);
      if (s.doubt > 0) lose_doubtful(s, at, rise, steepest, slope);
      if (const Mask steeper = at.active & (rise > steepest * at.width); bits(steeper) != 0)
        steepest = select(steeper, rise / at.width, steepest);
      const Mask leaf = at.width < s.accuracy, found = at.active & leaf & (at.value1 < 0.0);
      halved = at.active & ~leaf & (at.value0 + at.value1 < slope * at.width);
      if (bits(found) != 0) store(s.hit, select(found, end_of(s, at, found), load(s.hit)));
      store_mask(s.found, load_mask(s.found) | found);
      at.active &= ~found;
      const Mask done = at.active & ~halved;
      if (bits(done) == 0) break;
      turn_right(s, at, done);
      examined &= ~done;
    }
    if (!s.map || bits(halved & ~examined) == 0) break;
    const Outlook o = outlook(s, at, rise, steepest, halved & ~examined);
    if (bits(o.crossed) != 0) begin_homing(s, at, rise, o);
    at.active &= ~o.crossed;
    halved &= ~o.crossed;
    if (bits(o.clear) == 0) break;
    turn_right(s, at, o.clear);
    examined = halved & ~o.clear;
  }
  store(s.begin, at.begin), store(s.width, at.width), store(s.value0, at.value0), store(s.value1, at.value1),
      store(s.steepest, steepest);
  store(s.place, at.place), store(s.unit, at.unit), store(s.depth, at.depth), store_mask(s.active, at.active);
  return bits(halved | load_mask(s.homing));
}

unsigned start(SearchPacket& s, unsigned active_mask) {
  const Mask none = Mask::of_bits(0);
  store(s.root_width, load(s.width));
  store_mask(s.found, none), store_mask(s.homing, none), store_mask(s.lost, none), store(s.tries, IntPacket(0));
  for (double* const unset : {s.hit, s.low, s.high, s.fewest, s.most, s.bend, s.grain, s.probe, s.last, s.last_value})
    store(unset, Packet(0.0));
  State at{load(s.begin), load(s.width),    load(s.value0), load(s.value1),
           IntPacket(0),  IntPacket(kRoot), IntPacket(0),   Mask::of_bits(active_mask)};
  return settle(s, at);
}

unsigned advance(SearchPacket& s, const double* values) {
  const Packet value = load(s.sign) * (load(values) - s.threshold);
  if (bits(load_mask(s.homing)) != 0) home_in(s, value);
  const IntPacket here = entries(load(s.depth));
  scatter(s.begins[0], here, load(s.begin)), scatter(s.ends[0], here, load(s.value1));
  const Mask active = load_mask(s.active);
  State at{load(s.begin),
           load(s.width),
           load(s.value0),
           select(active, value, load(s.value1)),
           load(s.place),
           load(s.unit),
           select(active, load(s.depth) + IntPacket(1), load(s.depth)),
           active};
  at.unit = select(active, shift_right<1>(at.unit), at.unit);
  at.width = select(active, at.width / 2.0, at.width);
  return settle(s, at);
}

constexpr IsosurfaceKernels kKernels{enter, intervals, place, judge, set_up, middles, start, advance, normals};

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace verisim::shapes
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace verisim::shapes {
VERISIM_EXPORT_KERNELS(IsosurfaceKernels, isosurface_kernels)
}  // namespace verisim::shapes
#endif
