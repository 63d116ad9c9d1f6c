// Every instruction set finds the intervals that class Intervals finds for one ray, bit by bit: where pieces end in one
// place, hits alone do not tell (they are compared in tests/wide).
#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <vector>

#include "tracer/shapes/blob/blob_intervals.h"
#include "tracer/shapes/blob/blob_parts.h"
#include "tracer/shapes/test_support.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes::testing {
namespace {

// Balls and capsules on a grid, so that many ends of pieces lie in one place.
scene::Blob random_blob(std::mt19937& random) {
  const auto step = [&] { return static_cast<double>(random() % 5) * 0.5 - 1; };
  scene::Blob result;
  result.threshold = 0.3 + 0.1 * static_cast<double>(random() % 5);
  const std::size_t count = 1 + random() % 5;
  while (result.components.size() < count) {
    scene::BlobComponent c{};
    c.a = {step(), step(), step()}, c.b = c.a + Vec3(step(), step(), 0.5);
    c.radius = 0.5 + 0.5 * static_cast<double>(random() % 3);
    c.strength = random() % 4 == 0 ? -0.5 : 1;
    c.cylinder = random() % 2 == 0;
    result.components.push_back(c);
  }
  return result;
}

// Of a packet that mostly looks one way, from outside or from within.
void aim(std::mt19937& random, RayBatch& rays) {
  std::uniform_real_distribution<double> u(-1, 1);
  const double away = random() % 3 == 0 ? 0.5 : 4;
  const Vec3 from = normalize(Vec3(u(random), u(random), u(random) + 2)) * away;
  for (int k = 0; k < RayPacket::kCount; ++k) {
    rays.origin.set(k, random() % 8 == 0 ? Vec3(u(random), u(random), u(random)) : from);
    const Vec3 at = random() % 4 == 0 ? Vec3(0.5, 0, 0.5) : Vec3(u(random), u(random), u(random));
    rays.direction.set(k, normalize(at - rays.origin.at(k)));
  }
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

// The intervals of one ray that may have roots, by class Intervals.
std::vector<blob::Interval> intervals_of(const std::vector<PiecePacket>& met, const LocalPacket& l, int k,
                                         double threshold) {
  std::vector<blob::Piece> pieces;
  std::vector<blob::Event> events;
  for (const PiecePacket& p : met)
    if (p.met >> k & 1) pieces.push_back({std::max(p.t0[k], 0.0), p.t1[k], p.part, p.scale2[k], p.peak[k], {}});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    events.push_back({pieces[i].t0, static_cast<std::int32_t>(i), true, pieces[i].part});
    events.push_back({pieces[i].t1, static_cast<std::int32_t>(i), false, pieces[i].part});
  }
  std::vector<blob::Interval> result;
  if (events.empty()) return result;
  std::ranges::sort(events, std::less<>());
  blob::Intervals intervals({{l.ox[k], l.oy[k], l.oz[k]}, {l.dx[k], l.dy[k], l.dz[k]}, l.scale[k]}, events.data(),
                            events.size(), pieces.data(), threshold);
  while (intervals.next())
    if (!blob::field::keeps_its_sign(intervals.power, intervals.from, intervals.to)) result.push_back(intervals);
  return result;
}

TEST(BlobIntervals, AreThoseOfOneRayWithEveryInstructionSet) {
  for (int set = 0; set < simd::kInstructionSets; ++set) {
    const BlobKernels* kernels = blob_kernels(set);
    if (!kernels) continue;  // this machine cannot run it
    std::mt19937 random(7);
    int found = 0;
    for (int n = 0; n < 400; ++n) {
      const scene::Blob blob = random_blob(random);
      const blob::PartList parts = blob::parts_of(blob);
      RayBatch rays;
      aim(random, rays);
      LocalPacket l;
      packet_kernels().local(nullptr, {rays, 0, 255}, l);
      std::vector<PiecePacket> met(parts.parts.size());
      met.resize(kernels->pieces(parts.parts.data(), (std::uint64_t{1} << parts.parts.size()) - 1, l, 255, met.data()));
      std::vector<const PiecePacket*> pointers;
      for (const PiecePacket& p : met) pointers.push_back(&p);
      const std::array<double, RayPacket::kCount> from{}, to{1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9};
      IntervalLists lists;
      kernels->intervals(pointers.data(), pointers.size(), l, 255, {blob.threshold, 0, from.data(), to.data(), false},
                         lists);
      for (int k = 0; k < RayPacket::kCount; ++k) {
        std::vector<const IntervalPacket*> own;
        for (std::size_t i = 0; i < lists.count; ++i)
          if (lists.intervals[i].lanes >> k & 1) own.push_back(&lists.intervals[i]);
        std::size_t next = 0;  // some are left out: the field stays below the threshold there
        for (const blob::Interval& interval : intervals_of(met, l, k, blob.threshold)) {
          if (next == own.size() || bits(own[next]->from[k]) != bits(interval.from)) continue;
          ASSERT_EQ(bits(own[next]->to[k]), bits(interval.to));
          ASSERT_EQ(bits(lists.start[k]), bits(interval.start));
          ASSERT_EQ(bits(lists.span[k]), bits(interval.span));
          for (int i = 0; i < 5; ++i) ASSERT_EQ(bits(own[next]->power[i][k]), bits(interval.power[i]));
          ++next, ++found;
        }
        ASSERT_EQ(next, own.size());
      }
    }
    EXPECT_GT(found, 1000);
  }
}

}  // namespace
}  // namespace verisim::shapes::testing
