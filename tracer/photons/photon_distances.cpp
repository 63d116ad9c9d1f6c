#include "tracer/photons/photon_distances.h"

#include <utility>

namespace verisim::global {
namespace {

// Where distances are equal when rounded they are measured again: places in a list with squared distances.
using Equals = std::vector<std::pair<double, std::size_t>>;
void find_equals(const PhotonDistances& list, float rounded, const PhotonMeasure& measure, Equals& equals) {
  equals.clear();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list.squared()[i] == rounded) equals.emplace_back(measure.squared(list.index()[i]), i);
  }
}

// `places`: in ascending order.
void drop(PhotonDistances& list, std::span<const std::pair<double, std::size_t>> places) {
  if (places.empty()) return;
  std::size_t kept = places.front().second;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t from = places[k].second + 1, end = k + 1 < places.size() ? places[k + 1].second : list.size();
    list.move(from, end, kept);
    kept += end - from;
  }
  list.set_size(kept);
}

}  // namespace

void drop_farther(PhotonDistances& list, const PhotonMeasure& measure, double limit) {
  Equals equals;
  find_equals(list, PhotonDistances::rounded(limit), measure, equals);
  std::erase_if(equals, [limit](const auto& e) { return e.first <= limit; });
  drop(list, equals);
}

double drop_farthest(PhotonDistances& list, float last, const PhotonMeasure& measure, std::size_t wanted) {
  Equals equals;
  find_equals(list, last, measure, equals);
  std::ranges::sort(equals);
  const std::size_t kept = equals.size() - (list.size() - wanted);
  const double limit = equals[kept - 1].first;
  if (kept < equals.size() && equals[kept].first == limit) list.set_split(limit);
  equals.erase(equals.begin(), equals.begin() + static_cast<std::ptrdiff_t>(kept));
  std::ranges::sort(equals, {}, &Equals::value_type::second);
  drop(list, equals);
  return limit;
}

void PhotonDistances::grow(std::size_t size) {
  const std::size_t workspace = size + size / 2 + 4 * kRoom;
  squared_.resize(workspace), index_.resize(workspace);
}

void PhotonDistances::erase(std::size_t i) {
  move(i + 1, size_, i);
  --size_;
}

void PhotonDistances::move(std::size_t from, std::size_t end, std::size_t to) {
  std::copy(squared_.data() + from, squared_.data() + end, squared_.data() + to);
  std::copy(index_.data() + from, index_.data() + end, index_.data() + to);
}

}  // namespace verisim::global
