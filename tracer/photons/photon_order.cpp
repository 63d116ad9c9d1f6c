#include "tracer/photons/photon_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

// The coordinate in which the photons lie farthest apart.
std::uint8_t longest_axis(std::span<const Photon> photons) {
  std::array<float, 3> low = photons.front().position, high = low;
  for (const Photon& p : photons) {
    for (std::size_t a = 0; a < 3; ++a)
      low[a] = std::min(low[a], p.position[a]), high[a] = std::max(high[a], p.position[a]);
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
void exchange_blocks(std::span<Photon> photons, std::size_t axis, float pivot, std::size_t& i, std::size_t& j) {
  constexpr std::size_t kBlock = 64;
  std::array<std::uint8_t, kBlock> low, high;  // of those on the wrong side: how far from the blocks' beginnings
  std::size_t lows = 0, highs = 0, next_low = 0, next_high = 0;
  std::size_t first = i + 1, last = j - 1;  // where the blocks begin
  while (first + 2 * kBlock <= last) {
    if (next_low == lows) {
      lows = next_low = 0;
      for (std::size_t k = 0; k < kBlock; ++k) {
        low[lows] = static_cast<std::uint8_t>(k);
        lows += !(photons[first + k].position[axis] < pivot);
      }
    }
    if (next_high == highs) {
      highs = next_high = 0;
      for (std::size_t k = 0; k < kBlock; ++k) {
        high[highs] = static_cast<std::uint8_t>(k);
        highs += !(photons[last - k].position[axis] > pivot);
      }
    }
    for (; next_low < lows && next_high < highs; ++next_low, ++next_high)
      std::swap(photons[first + low[next_low]], photons[last - high[next_high]]);
    if (next_low == lows) first += kBlock;
    if (next_high == highs) last -= kBlock;
  }
  i = (next_low < lows ? first + low[next_low] : first) - 1;
  j = (next_high < highs ? last - high[next_high] : last) + 1;
}

// Quickselect with the median of three as pivot (Press et al., Numerical Recipes, section 8.5). Where two photons are
// left it puts them in descending order, which is as well as wrong. `photons`: three or more.
void select_middle(std::span<Photon> photons, std::size_t axis) {
  const auto at = [&](std::size_t i) { return photons[i].position[axis]; };
  const auto sort = [&](std::size_t i, std::size_t j) {
    if (at(i) > at(j)) std::swap(photons[i], photons[j]);
  };
  const std::size_t middle = (photons.size() - 1) / 2;
  std::size_t first = 0, last = photons.size() - 1;
  while (first < last) {
    std::swap(photons[(first + last) / 2], photons[first + 1]);
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
      std::swap(photons[i], photons[j]);
    }
    std::swap(photons[first], photons[j]);
    if (middle == j) return;
    if (middle < j) {
      last = j - 1;
    } else {
      first = j + 1;
    }
  }
}

}  // namespace

void sort_photons(std::span<Photon> photons) {
  for_each_range(photons.size(), [&](const Range& r) {
    const std::span<Photon> range(photons.data() + r.first, r.last - r.first + 1);
    const std::uint8_t axis = longest_axis(range);
    if (range.size() > 2) select_middle(range, axis);
    photons[r.middle()].axis = axis;
  });
}

void WrongPlanes::build(std::span<const Photon> sorted) {
  planes_.clear();
  for_each_range(sorted.size(), [&](const Range& r) {
    const std::size_t middle = r.middle();
    const std::uint8_t axis = sorted[middle].axis;
    const float at = sorted[middle].position[axis];
    for (std::size_t i = r.first; i <= r.last; ++i) {
      const float x = sorted[i].position[axis];
      if (i < middle ? x > at : x < at)
        planes_.push_back({static_cast<std::uint32_t>(i), at, static_cast<std::uint32_t>(middle), axis, i > middle});
    }
  });
  std::ranges::stable_sort(planes_, {}, &Plane::photon);
  first_.clear();
  for (std::size_t i = 0, k = 0; i < sorted.size(); i += kBlock) {
    while (k < planes_.size() && planes_[k].photon < i) ++k;
    first_.push_back(static_cast<std::uint32_t>(k));
  }
  overhang_.assign(sorted.size(), -std::numeric_limits<float>::infinity());
  largest_overhang_ = -std::numeric_limits<double>::infinity();
  for (const Plane& plane : planes_) {
    const double overhang = std::fabs(static_cast<double>(sorted[plane.photon].position[plane.axis]) - plane.at);
    overhang_[plane.photon] = std::max(
        overhang_[plane.photon], std::nextafter(static_cast<float>(overhang), std::numeric_limits<float>::infinity()));
    largest_overhang_ = std::max(largest_overhang_, overhang);
  }
}

void WrongPlanes::drop_hidden(const Vec3& p, double radius, std::size_t from, PhotonDistances& list) const {
  thread_local std::vector<std::uint32_t> doubtful;
  doubtful.resize(list.size() + PhotonLeaf::kAtOnce);
  const std::size_t count = photon_kernels().reaching(list, overhang(), radius * (1.0 - kRounding), doubtful.data());
  std::size_t kept = from, next = from;
  const auto keep_until = [&](std::size_t end) {
    if (kept != next) list.move(next, end, kept);
    kept += end - next, next = end;
  };
  for (const std::uint32_t place : std::span(doubtful.data(), count)) {
    if (place < from ||
        for_each_hiding(list.index()[place], p, radius * radius, [](std::uint32_t, double) { return false; }))
      continue;
    keep_until(place);
    ++next;
  }
  keep_until(list.size());
  list.set_size(kept);
}

}  // namespace verisim::global
