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

void sort_photons(std::vector<Photon>& photons) {
  for_each_range(photons.size(), [&](const Range& r) {
    const std::span<Photon> range(photons.data() + r.first, r.last - r.first + 1);
    const std::uint8_t axis = longest_axis(range);
    if (range.size() > 2) select_middle(range, axis);
    photons[r.middle()].axis = axis;
  });
}

void WrongPlanes::build(std::span<const Photon> sorted) {
  std::vector<std::pair<std::uint32_t, Plane>> found;
  for_each_range(sorted.size(), [&](const Range& r) {
    const std::size_t middle = r.middle();
    const std::uint8_t axis = sorted[middle].axis;
    const float at = sorted[middle].position[axis];
    for (std::size_t i = r.first; i <= r.last; ++i) {
      const float x = sorted[i].position[axis];
      if (i < middle ? x > at : x < at)
        found.push_back({static_cast<std::uint32_t>(i), {at, static_cast<std::uint32_t>(middle), axis, i > middle}});
    }
  });
  std::ranges::stable_sort(found, {}, [](const auto& f) { return f.first; });
  first_.assign(sorted.size() + 1, 0);
  planes_.clear();
  overhang_.assign(sorted.size(), -std::numeric_limits<float>::infinity());
  largest_overhang_ = -std::numeric_limits<double>::infinity();
  for (const auto& [i, plane] : found) {
    ++first_[i + 1], planes_.push_back(plane);
    const double overhang = std::fabs(static_cast<double>(sorted[i].position[plane.axis]) - plane.at);
    overhang_[i] =
        std::max(overhang_[i], std::nextafter(static_cast<float>(overhang), std::numeric_limits<float>::infinity()));
    largest_overhang_ = std::max(largest_overhang_, overhang);
  }
  for (std::size_t i = 0; i < sorted.size(); ++i) first_[i + 1] += first_[i];
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
