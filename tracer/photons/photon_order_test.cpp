#include "tracer/photons/photon_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tracer/photons/photon_search.h"

namespace verisim::global {
namespace {

struct Single {
  PhotonPosition position;
  std::size_t number;
  std::uint8_t axis = 0;
};

// The order of POV-Ray's maps, exchange by exchange.
void sort_slowly(Single* first, Single* last) {
  if (last < first) return;
  const auto longest = [&] {
    float low[3], high[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = high[a] = first->position[a];
      for (Single* p = first; p <= last; ++p)
        low[a] = std::min(low[a], p->position[a]), high[a] = std::max(high[a], p->position[a]);
    }
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
    return axis;
  };
  const int axis = longest();
  Single* const middle = first + (last - first) / 2;
  const auto at = [axis](const Single* p) { return p->position[axis]; };
  const auto in_order = [&](Single* a, Single* b) {
    if (at(a) > at(b)) std::swap(*a, *b);
  };
  Single *from = first, *to = last;
  while (last - first >= 2 && from < to) {
    std::swap(from[(to - from) / 2], from[1]);
    in_order(from + 1, to), in_order(from, to), in_order(from + 1, from);
    if (to - from == 1) break;
    Single *i = from + 1, *j = to;
    const float pivot = at(from);
    while (true) {
      do ++i;
      while (at(i) < pivot);
      do --j;
      while (at(j) > pivot);
      if (j < i) break;
      std::swap(*i, *j);
    }
    std::swap(*from, *j);
    if (j == middle) break;
    middle < j ? to = j - 1 : from = j + 1;
  }
  middle->axis = static_cast<std::uint8_t>(axis);
  sort_slowly(first, middle - 1), sort_slowly(middle + 1, last);
}

TEST(PhotonOrder, ExchangesWhatPlainQuickselectDoes) {
  std::mt19937 random(7);
  for (const int kinds : {3, 50, 1 << 20}) {  // many equal coordinates, some, hardly any
    for (const std::size_t count : {1u, 2u, 3u, 64u, 127u, 128u, 129u, 131u, 200u, 1000u, 20000u}) {
      std::vector<Single> expected(count);
      PhotonList photons;
      for (std::size_t i = 0; i < count; ++i) {
        for (float& x : expected[i].position)
          x = static_cast<float>(static_cast<int>(random() % static_cast<unsigned>(kinds)));
        expected[i].number = i;
        Photon photon;
        std::memcpy(photon.energy.data(), &i, 4);  // tells it apart
        photons.add(expected[i].position, photon);
      }
      sort_slowly(expected.data(), expected.data() + count - 1);
      sort_photons(photons);
      for (std::size_t i = 0; i < count; ++i) {
        std::uint32_t number;
        std::memcpy(&number, photons.photons[i].energy.data(), 4);
        ASSERT_EQ(number, expected[i].number) << count << " photons, " << kinds << " kinds, at " << i;
        ASSERT_EQ(photons.positions[i], expected[i].position);
        ASSERT_EQ(photons.photons[i].axis, expected[i].axis);
      }
    }
  }
}

// All nodes above a photon that it is on the wrong side of, and how far at most.
TEST(PhotonOrder, FindsThePlanesThatHideAPhoton) {
  constexpr std::uint32_t kCount = 3000;
  std::mt19937 random(3);
  PhotonIndex index;
  const auto coordinate = [&] { return static_cast<float>(random() % 1000); };
  for (std::uint32_t i = 0; i < kCount; ++i) index.photons.add({coordinate(), coordinate(), 0.5f}, {});
  sort_photons(index.photons);
  index.build();
  std::size_t all = 0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    std::vector<std::uint32_t> expected, found;
    float overhang = 0;
    for (std::uint32_t first = 0, last = kCount - 1, node; (node = (first + last) / 2) != i;) {
      const std::uint8_t axis = index.photons.photons[node].axis;
      const float beyond = index.photons.positions[i][axis] - index.photons.positions[node][axis];
      if (i < node ? beyond > 0 : beyond < 0) {
        expected.push_back(node);
        overhang = std::max(overhang, std::fabs(beyond));
      }
      i < node ? last = node - 1 : first = node + 1;
    }
    for (const double far : {-1e6, 1e6}) {  // on either side of all planes
      index.planes.for_each_hiding(index.photons, i, Vec3(far), 0.0, [&](std::uint32_t node, double) {
        found.push_back(node);
        return true;
      });
    }
    std::ranges::sort(found), std::ranges::sort(expected);
    ASSERT_EQ(found, expected) << i;
    all += found.size();
    const PhotonOverhangs& overhangs = index.planes.overhangs();
    const std::uint32_t level = overhangs.levels[i];
    ASSERT_EQ(level == 0, expected.empty());
    if (level == 0) continue;
    const float noted = std::bit_cast<float>((overhangs.base + level) << PhotonOverhangs::kShift);
    EXPECT_GE(noted, overhang);
    EXPECT_LE(noted, 1.13f * overhang);
  }
  EXPECT_GT(all, 100u);
}

}  // namespace
}  // namespace verisim::global
