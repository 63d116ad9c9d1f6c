#include "tracer/global/photon_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace verisim::global {
namespace {

constexpr auto kAny = std::numeric_limits<std::size_t>::max();

}  // namespace

double PhotonSearch::nearest(const PhotonIndex& index, const PhotonCenter& center, double radius, int maximum, std::size_t too_many, double guess,
                             std::vector<const Photon*>& out) {
  out.clear();
  if (index.photons.empty() || maximum <= 0 || !(0.3 * radius > 0.0)) return radius;
  index_ = &index, center_ = center, radius_ = radius, maximum_ = static_cast<std::size_t>(maximum);
  // If the guess holds more than `maximum`, the nearest are among them, whatever the radius. If not, how many it holds says how much more it takes.
  Collected collected = Collected::all;
  for (double within = guess > 0.0 ? guess : 0.3 * radius;;) {
    collected = collect(std::min(within, radius), maximum_, too_many);
    if (collected == Collected::all && found_.size() > maximum_) collected = Collected::nearest;
    if (collected != Collected::all || within >= radius) break;
    const double wanted = 1.2 * static_cast<double>(std::min(maximum_, too_many)), found = static_cast<double>(found_.size());
    within *= std::clamp(std::sqrt(wanted / std::max(found, 1.0)), 1.1, 3.0);
  }
  if (collected == Collected::too_many) return 0.0;
  const PhotonDistances* result = &found_;
  if (collected == Collected::nearest) {
    keep_nearest();
    if (!drop_overlooked()) collect_in_order();
    radius = std::sqrt(farthest_), result = &kept_;
  }
  out.resize(result->size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = &index.photons[result->index()[i]];
  return radius;
}

// Collects the photons with flattened distance below `within`, of those that a search within the radius can come upon; of many more than `most` the nearest.
Collected PhotonSearch::collect(double within, std::size_t most, std::size_t too_many) {
  limit_ = within * within;
  const WrongPlanes& planes = index_->planes;
  const PhotonQuery query{center_, most, too_many, planes.hide(within, radius_) ? &planes : nullptr, radius_ * radius_};
  return kernels_.collect(index_->tree, query, limit_, found_);
}

void PhotonSearch::keep_nearest() {
  farthest_ = limit_;
  kernels_.keep_nearest(found_, maximum_, farthest_, kept_);
}

// POV-Ray's search narrows its radius once it knows more than the maximum, and then overlooks photons behind planes that are beyond. Replaces those that are kept by the next ones.
// False: it cannot be told without following that search.
bool PhotonSearch::drop_overlooked() {
  overlooked_.clear();
  for (double judged = -1.0;;) {
    // The first one too many takes the place of the last one kept, even if it is farther away. That shows only where few are too many.
    if (farthest_ > 0.9 * radius_ * radius_) return false;
    const std::size_t known = overlooked_.size();
    find_doubts(judged);
    for (const Doubt& doubt : doubts_) {
      const Verdict verdict = judge(doubt);
      if (verdict == Verdict::unknown) return false;
      if (verdict == Verdict::overlooked) forget(doubt.photon), overlooked_.push_back(doubt.photon);
    }
    if (overlooked_.size() == known) return true;
    judged = farthest_;
    keep_nearest();
  }
}

// Doubts about photons that are kept and farther away than `judged`, squared: planes that are beyond all that are kept.
void PhotonSearch::find_doubts(double judged) {
  doubts_.clear();
  places_.resize(kept_.size() + PhotonPositions::kAtOnce);
  const std::size_t count = kernels_.reaching(kept_, index_->planes.overhang(), std::sqrt(farthest_) * (1.0 - WrongPlanes::kRounding), places_.data());
  for (const std::uint32_t place : std::span(places_.data(), count)) {
    if (kept_.squared()[place] <= judged) continue;
    const std::uint32_t photon = kept_.index()[place];
    index_->planes.for_each_hiding(photon, center_.point, farthest_, [&](std::uint32_t node, double squared) {
      doubts_.push_back({photon, node, squared});
      return true;
    });
  }
}

// A photon behind a plane is overlooked if more than the maximum that are nearer than the plane were found before. Those that may be overlooked themselves are no proof.
PhotonSearch::Verdict PhotonSearch::judge(const Doubt& doubt) {
  look_around(doubt.squared);
  kernels_.keep_within(found_, doubt.squared, nearer_);
  if (nearer_.size() <= maximum_) return Verdict::found;  // with the doubtful one
  const auto found_before = [&] { return count_visited_before(index_->photons, center_.point, doubt.node, nearer_.index()); };
  const std::size_t most = found_before();
  if (most < maximum_) return Verdict::found;
  index_->planes.drop_hidden(center_.point, farthest_, 0, nearer_);
  return found_before() > maximum_ ? Verdict::overlooked : Verdict::unknown;
}

// Makes `found_` hold all photons up to a squared distance.
void PhotonSearch::look_around(double squared) {
  if (squared < limit_) return;
  collect(std::sqrt(squared) * (1.0 + 1e-9), kAny, kAny);
  for (const std::uint32_t photon : overlooked_) forget(photon);
}

void PhotonSearch::forget(std::uint32_t photon) {
  const auto numbers = found_.index();
  const auto at = std::ranges::lower_bound(numbers, photon);
  if (at != numbers.end() && *at == photon) found_.erase(static_cast<std::size_t>(at - numbers.begin()));
}

void PhotonSearch::collect_in_order() {
  heap_.clear();
  const auto nearer = [](const Found& a, const Found& b) { return a.squared < b.squared; };
  double limit = radius_ * radius_;
  const auto look_at = [&](std::uint32_t first, std::uint32_t count, double* squared) {
    return kernels_.near(index_->tree.positions(), first, center_, limit, squared) & ((1u << count) - 1);
  };
  visit_in_order(index_->photons, center_.point, limit, look_at, [&](std::uint32_t i, double squared) {
    const bool full = heap_.size() == maximum_;
    if (full) std::ranges::pop_heap(heap_, nearer), heap_.pop_back();
    heap_.push_back({squared, i});
    std::ranges::push_heap(heap_, nearer);
    if (full) limit = heap_.front().squared;
  });
  farthest_ = limit;
  std::ranges::sort(heap_, {}, &Found::index);
  kept_.clear();
  for (const Found& f : heap_) kept_.add(f.index, f.squared);
}

}  // namespace verisim::global
