#include "tracer/photons/photon_order.h"

#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace verisim::global {
namespace {

// The order of POV-Ray's maps, exchange by exchange.
void sort_slowly(Photon* first, Photon* last) {
  if (last < first) return;
  const auto longest = [&] {
    float low[3], high[3];
    for (int a = 0; a < 3; ++a) {
      low[a] = high[a] = first->position[a];
      for (Photon* p = first; p <= last; ++p)
        low[a] = std::min(low[a], p->position[a]), high[a] = std::max(high[a], p->position[a]);
    }
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
    return axis;
  };
  const int axis = longest();
  Photon* const middle = first + (last - first) / 2;
  const auto at = [axis](const Photon* p) { return p->position[axis]; };
  const auto in_order = [&](Photon* a, Photon* b) {
    if (at(a) > at(b)) std::swap(*a, *b);
  };
  Photon *from = first, *to = last;
  while (last - first >= 2 && from < to) {
    std::swap(from[(to - from) / 2], from[1]);
    in_order(from + 1, to), in_order(from, to), in_order(from + 1, from);
    if (to - from == 1) break;
    Photon *i = from + 1, *j = to;
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
      std::vector<Photon> photons(count);
      for (std::size_t i = 0; i < count; ++i) {
        for (float& x : photons[i].position)
          x = static_cast<float>(static_cast<int>(random() % static_cast<unsigned>(kinds)));
        std::memcpy(photons[i].energy.data(), &i, 4);  // tells it apart
      }
      std::vector<Photon> expected = photons;
      sort_slowly(expected.data(), expected.data() + count - 1);
      sort_photons(photons);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(photons[i].energy, expected[i].energy) << count << " photons, " << kinds << " kinds, at " << i;
        ASSERT_EQ(photons[i].axis, expected[i].axis);
      }
    }
  }
}

}  // namespace
}  // namespace verisim::global
