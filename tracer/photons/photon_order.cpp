#include "tracer/photons/photon_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace verisim::global {
namespace {

struct Range {
  std::size_t first, last;  // inclusive
  std::size_t middle() const { return (first + last) / 2; }
};

// Calls visit(range) for all ranges of at least one photon, larger ones before what is in them.
template <class Visit>
void for_each_range(std::size_t count, Visit&& visit) {
  if (count == 0) return;
  std::vector<Range> stack{{0, count - 1}};
  while (!stack.empty()) {
    const Range r = stack.back();
    stack.pop_back();
    visit(r);
    const std::size_t middle = r.middle();
    if (middle < r.last) stack.push_back({middle + 1, r.last});
    if (middle > r.first) stack.push_back({r.first, middle - 1});
  }
}

// By two words that overlap: through memory, as std::swap has it, the load of the first waits for the stores of both.
void exchange_photons(Photon& a, Photon& b) {
  using Word = std::uint32_t;
  constexpr std::size_t kSecond = sizeof(Photon) - sizeof(Word);
  static_assert(kSecond <= sizeof(Word) && std::is_trivially_copyable_v<Photon>);
  const auto word = [](const Photon& p, std::size_t offset) {
    Word w;
    std::memcpy(&w, reinterpret_cast<const std::byte*>(&p) + offset, sizeof w);
    return w;
  };
  const auto set = [](Photon& p, Word first, Word second) {
    std::memcpy(reinterpret_cast<std::byte*>(&p), &first, sizeof first);
    std::memcpy(reinterpret_cast<std::byte*>(&p) + kSecond, &second, sizeof second);
  };
  const Word a_first = word(a, 0), a_second = word(a, kSecond), b_first = word(b, 0), b_second = word(b, kSecond);
  set(a, b_first, b_second), set(b, a_first, a_second);
}

// Some photons that are put in order.
struct SortedPart {
  PhotonPosition* positions;
  Photon* photons;
  std::size_t size;
  float at(std::size_t i, std::size_t axis) const { return positions[i][axis]; }
  void exchange(std::size_t i, std::size_t j) const {
    std::swap(positions[i], positions[j]), exchange_photons(photons[i], photons[j]);
  }
};

// The coordinate in which the photons lie farthest apart.
std::uint8_t longest_axis(std::span<const PhotonPosition> photons) {
  PhotonPosition low = photons.front(), high = low;
  for (const PhotonPosition& p : photons) {
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  }
  std::uint8_t axis = 0;
  for (std::uint8_t a = 1; a < 3; ++a) {
    if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
  }
  return axis;
}

// Exchanges pairs of photons at the ends of a range that are on the wrong side of the pivot, the outermost first, as
// long as many are left between `i` and `j`, which move towards each other: what lies outside of them is in order.
// Which photons are to be exchanged is found a block at a time, without branches that hang on them (Edelkamp and Weiss,
// "BlockQuicksort", 2016).
void exchange_blocks(const SortedPart& photons, std::size_t axis, float pivot, std::size_t& i, std::size_t& j) {
  constexpr std::size_t kBlock = 64;
  std::array<std::uint8_t, kBlock> low, high;  // of those on the wrong side: how far from the blocks' beginnings
  std::size_t lows = 0, highs = 0, next_low = 0, next_high = 0;
  std::size_t first = i + 1, last = j - 1;  // where the blocks begin
  while (first + 2 * kBlock <= last) {
    if (next_low == lows) {
      lows = next_low = 0;
      for (std::size_t k = 0; k < kBlock; ++k) {
        low[lows] = static_cast<std::uint8_t>(k);
        lows += !(photons.at(first + k, axis) < pivot);
      }
    }
    if (next_high == highs) {
      highs = next_high = 0;
      for (std::size_t k = 0; k < kBlock; ++k) {
        high[highs] = static_cast<std::uint8_t>(k);
        highs += !(photons.at(last - k, axis) > pivot);
      }
    }
    for (; next_low < lows && next_high < highs; ++next_low, ++next_high)
      photons.exchange(first + low[next_low], last - high[next_high]);
    if (next_low == lows) first += kBlock;
    if (next_high == highs) last -= kBlock;
  }
  i = (next_low < lows ? first + low[next_low] : first) - 1;
  j = (next_high < highs ? last - high[next_high] : last) + 1;
}

// Quickselect with the median of three as pivot (Press et al., Numerical Recipes, section 8.5). Where two photons are
// left it puts them in descending order, which is as well as wrong. `photons`: three or more.
void select_middle(const SortedPart& photons, std::size_t axis) {
  const auto at = [&](std::size_t i) { return photons.at(i, axis); };
  const auto sort = [&](std::size_t i, std::size_t j) {
    if (at(i) > at(j)) photons.exchange(i, j);
  };
  const std::size_t middle = (photons.size - 1) / 2;
  std::size_t first = 0, last = photons.size - 1;
  while (first < last) {
    photons.exchange((first + last) / 2, first + 1);
    sort(first + 1, last), sort(first, last), sort(first + 1, first);
    if (last - first == 1) return;
    std::size_t i = first + 1, j = last;
    const float pivot = at(first);
    exchange_blocks(photons, axis, pivot, i, j);
    for (;;) {
      do ++i;
      while (at(i) < pivot);
      do --j;
      while (at(j) > pivot);
      if (j < i) break;
      photons.exchange(i, j);
    }
    photons.exchange(first, j);
    if (middle == j) return;
    if (middle < j) {
      last = j - 1;
    } else {
      first = j + 1;
    }
  }
}

}  // namespace

void sort_photons(PhotonList& photons) {
  for_each_range(photons.size(), [&](const Range& r) {
    const SortedPart part{photons.positions.data() + r.first, photons.photons.data() + r.first, r.last - r.first + 1};
    const std::uint8_t axis = longest_axis({part.positions, part.size});
    if (part.size > 2) select_middle(part, axis);
    photons.photons[r.middle()].axis = axis;
  });
}

void WrongPlanes::build(const PhotonList& sorted) {
  planes_ = {};
  first_.clear(), first_.reserve((sorted.size() + kBlock - 1) / kBlock);
  // One photon after another, with the nodes above it.
  struct Above {
    std::uint32_t node, axis;
    float at;
  };
  std::vector<Above> above;
  const auto walk = [&](const auto& again, std::size_t first, std::size_t end) -> void {
    if (first == end) return;
    const std::size_t middle = (first + end - 1) / 2;
    const PhotonPosition& here = sorted.positions[middle];
    const std::uint32_t axis = sorted.photons[middle].axis;
    above.push_back({static_cast<std::uint32_t>(middle), axis, here[axis]});
    again(again, first, middle);
    if (middle % kBlock == 0) first_.push_back(static_cast<std::uint32_t>(planes_.size()));
    for (const Above& a : std::span(above).first(above.size() - 1)) {
      if (middle < a.node ? here[a.axis] > a.at : here[a.axis] < a.at)
        planes_.push_back({static_cast<std::uint32_t>(middle), a.node});
    }
    again(again, middle + 1, end);
    above.pop_back();
  };
  walk(walk, 0, sorted.size());
  planes_.set_capacity(planes_.size());
  note_overhangs(sorted);
}

void WrongPlanes::note_overhangs(const PhotonList& sorted) {
  const auto overhang = [&sorted](const Plane& plane) {
    const std::uint8_t axis = sorted.photons[plane.node].axis;
    return std::fabs(static_cast<double>(sorted.positions[plane.photon][axis]) - sorted.positions[plane.node][axis]);
  };
  // The upper bits of the next larger float that has no others.
  const auto rounded_up = [](double x) {
    constexpr auto kInfinity = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
    return std::min(std::bit_cast<std::uint32_t>(static_cast<float>(x)) >> PhotonOverhangs::kShift,
                    (kInfinity >> PhotonOverhangs::kShift) - 1) +
           1;
  };
  largest_overhang_ = -std::numeric_limits<double>::infinity();
  for (const Plane& plane : planes_) largest_overhang_ = std::max(largest_overhang_, overhang(plane));
  const std::uint32_t largest = planes_.empty() ? 0 : rounded_up(largest_overhang_);
  overhangs_.base = largest - std::min(largest, 255u);
  overhangs_.levels.assign(sorted.size() + 3, 0);
  for (const Plane& plane : planes_) {
    const std::uint32_t bits = rounded_up(overhang(plane));
    std::uint8_t& level = overhangs_.levels[plane.photon];
    level = std::max(level, static_cast<std::uint8_t>(bits > overhangs_.base ? bits - overhangs_.base : 1));
  }
}

void WrongPlanes::drop_hidden(const PhotonList& sorted, const Vec3& p, double radius, std::size_t from,
                              PhotonDistances& list) const {
  thread_local std::vector<std::uint32_t> doubtful;
  doubtful.resize(list.size() + kPhotonsAtOnce);
  const std::size_t count = photon_kernels().reaching(list, overhangs_, radius * (1.0 - kRounding), doubtful.data());
  std::size_t kept = from, next = from;
  const auto keep_until = [&](std::size_t end) {
    if (kept != next) list.move(next, end, kept);
    kept += end - next, next = end;
  };
  for (const std::uint32_t place : std::span(doubtful.data(), count)) {
    if (place < from ||
        for_each_hiding(sorted, list.index()[place], p, radius * radius, [](std::uint32_t, double) { return false; }))
      continue;
    keep_until(place);
    ++next;
  }
  keep_until(list.size());
  list.set_size(kept);
}

}  // namespace verisim::global
