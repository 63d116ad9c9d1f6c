#include "tracer/photons/photon_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace verisim::global {

double PhotonSearch::nearest(const PhotonIndex& index, const PhotonCenter& center, double radius, int maximum,
                             std::size_t too_many, double guess, std::vector<std::uint32_t>& out) {
  out.clear();
  if (index.photons.empty() || maximum <= 0 || !(0.3 * radius > 0.0)) return radius;
  index_ = &index, measure_ = {index.photons.positions.data(), center}, radius_ = radius,
  maximum_ = static_cast<std::size_t>(maximum);
  // If the guess holds more than `maximum`, the nearest are among them, whatever the radius. If not, how many it holds
  // says how much more it takes.
  Collected collected = Collected::all;
  for (double within = guess > 0.0 ? guess : 0.3 * radius;;) {
    collected = collect(std::min(within, radius), maximum_, too_many);
    if (collected == Collected::all && found_.size() > maximum_) collected = Collected::nearest;
    if (collected != Collected::all || within >= radius) break;
    const double wanted = 1.2 * static_cast<double>(std::min(maximum_, too_many)),
                 found = static_cast<double>(found_.size());
    within *= std::clamp(std::sqrt(wanted / std::max(found, 1.0)), 1.1, 3.0);
  }
  if (collected == Collected::too_many) return 0.0;
  const PhotonDistances* result = &found_;
  if (collected == Collected::nearest) {
    keep_nearest();
    if (kept_.split() == farthest_ || !drop_overlooked() || kept_.split() == farthest_) collect_in_order();
    radius = std::sqrt(farthest_), result = &kept_;
  }
  out.assign(result->index().begin(), result->index().end());
  return radius;
}

// Collects the photons with flattened distance below `within`, of those that a search within the radius can come upon;
// of many more than `most` the nearest.
Collected PhotonSearch::collect(double within, std::size_t most, std::size_t too_many) {
  limit_ = within * within;
  const WrongPlanes& planes = index_->planes;
  const PhotonQuery query{measure_, most, too_many, planes.hide(within, radius_) ? index_ : nullptr, radius_};
  return kernels_.collect(index_->tree, query, limit_, found_);
}

void PhotonSearch::keep_nearest() {
  farthest_ = limit_;
  kernels_.keep_nearest(found_, measure_, maximum_, farthest_, kept_);
}

// POV-Ray's search narrows its radius once it knows more than the maximum, and then overlooks photons behind planes
// that are beyond. Replaces those that are kept by the next ones. False: it cannot be told without following that
// search.
bool PhotonSearch::drop_overlooked() {
  overlooked_.clear();
  for (double judged = -1.0;;) {
    const std::size_t known = overlooked_.size();
    find_doubts(judged);
    for (const Doubt& doubt : doubts_) {
      const Verdict verdict = judge(doubt);
      if (verdict == Verdict::unknown) return false;
      if (verdict == Verdict::overlooked) forget(doubt.photon), overlooked_.push_back(doubt.photon);
    }
    // The first one too many takes the place of the last one found, even if it is farther away. That shows if those
    // found so far are the nearest of all.
    if (overlooked_.size() == known) return another_was_early();
    judged = farthest_;
    keep_nearest();
  }
}

// Whether one of those that are not kept was found before the last of those that are.
bool PhotonSearch::another_was_early() {
  // Mostly a node on the way to one that is kept.
  const std::uint32_t kept = kept_.index()[kept_.size() / 2];
  std::uint32_t first = 0, end = static_cast<std::uint32_t>(index_->photons.size());
  for (std::uint32_t node; (node = first + (end - 1 - first) / 2) != kept;) {
    const double squared = measure_.squared(node);
    if (squared > farthest_ && squared < radius_ * radius_) return true;
    if (kept < node) {
      end = node;
    } else {
      first = node + 1;
    }
  }
  const auto nobody = [](std::uint32_t) { return false; };
  const float farthest = PhotonDistances::rounded(farthest_);
  for (std::size_t k = 0; k < found_.size(); ++k) {
    const float squared = found_.squared()[k];
    if (squared < farthest || (squared == farthest && measure_.squared(found_.index()[k]) <= farthest_)) continue;
    if (visited_before(index_->photons, measure_.center.point, found_.index()[k], kept_.index(), nobody).count <
        maximum_)
      return true;
  }
  return false;
}

// Doubts about photons that are kept and farther away than `judged`, squared: planes that are beyond all that are kept.
void PhotonSearch::find_doubts(double judged) {
  doubts_.clear();
  places_.resize(kept_.size() + kPhotonsAtOnce);
  const std::size_t count = kernels_.reaching(kept_, index_->planes.overhangs(),
                                              std::sqrt(farthest_) * (1.0 - WrongPlanes::kRounding), places_.data());
  for (const std::uint32_t place : std::span(places_.data(), count)) {
    const std::uint32_t photon = kept_.index()[place];
    if (judged >= 0.0 && measure_.squared(photon) <= judged) continue;
    index_->planes.for_each_hiding(index_->photons, photon, measure_.center.point, farthest_,
                                   [&](std::uint32_t node, double squared) {
                                     doubts_.push_back({photon, node, squared});
                                     return true;
                                   });
  }
}

// A photon behind a plane is overlooked if more than the maximum that are nearer than the plane were found before; or
// as many, and another one that was dropped for the last of them. Those that may be overlooked themselves are no proof.
PhotonSearch::Verdict PhotonSearch::judge(const Doubt& doubt) {
  const Verdict verdict = judge_by_found(doubt);
  // Photons nearer than the plane that are not found yet could only be more proof.
  if (verdict == Verdict::overlooked || doubt.squared < limit_) return verdict;
  look_around(doubt.squared);
  return judge_by_found(doubt);
}

PhotonSearch::Verdict PhotonSearch::judge_by_found(const Doubt& doubt) {
  kernels_.keep_within(found_, measure_, doubt.squared, nearer_);
  if (nearer_.size() <= maximum_) return Verdict::found;  // with the doubtful one
  const auto found_before = [&](auto&& is_other) {
    return visited_before(index_->photons, measure_.center.point, doubt.node, nearer_.index(), is_other);
  };
  if (found_before([](std::uint32_t) { return false; }).count < maximum_) return Verdict::found;
  index_->planes.drop_hidden(index_->photons, measure_.center.point,
                             std::sqrt(farthest_) * (1.0 - WrongPlanes::kRounding), 0, nearer_);
  const VisitedBefore certain = found_before([&](std::uint32_t photon) {
    const double squared = measure_.squared(photon);
    return squared > doubt.squared && squared < radius_ * radius_;
  });
  return certain.count + certain.after_another > maximum_ ? Verdict::overlooked : Verdict::unknown;
}

// Makes `found_` hold all photons up to a squared distance.
void PhotonSearch::look_around(double squared) {
  collect(std::sqrt(squared) * (1.0 + 1e-9), kAnyNumber, kAnyNumber);
  for (const std::uint32_t photon : overlooked_) forget(photon);
}

void PhotonSearch::forget(std::uint32_t photon) {
  const auto numbers = found_.index();
  const auto at = std::ranges::lower_bound(numbers, photon);
  if (at != numbers.end() && *at == photon) found_.erase(static_cast<std::size_t>(at - numbers.begin()));
}

// As POV-Ray does: of photons that are equally far, as those of blended textures are, those stay that its heap happens
// to keep, in which a new one rises above its equals and sinks no lower than they are (measured).
void PhotonSearch::collect_in_order() {
  heap_.clear();
  double limit = radius_ * radius_;
  visit_in_order(index_->photons, measure_.center.point, limit, [&](std::uint32_t i) {
    const double squared = measure_.squared(i);
    if (!(squared < limit)) return;
    if (heap_.size() < maximum_) return add_to_heap({squared, i});
    replace_farthest({squared, i});
    limit = heap_.front().squared;
  });
  farthest_ = limit;
  std::ranges::sort(heap_, {}, &Found::index);
  kept_.clear();
  for (const Found& f : heap_) kept_.add(f.index, f.squared);
}

void PhotonSearch::add_to_heap(const Found& found) {
  std::size_t place = heap_.size();
  heap_.push_back(found);
  for (; place > 0 && heap_[(place - 1) / 2].squared <= found.squared; place = (place - 1) / 2)
    heap_[place] = heap_[(place - 1) / 2];
  heap_[place] = found;
}

void PhotonSearch::replace_farthest(const Found& found) {
  std::size_t place = 0;
  for (std::size_t child; (child = 2 * place + 1) < heap_.size(); place = child) {
    if (child + 1 < heap_.size() && heap_[child].squared < heap_[child + 1].squared) ++child;
    if (found.squared >= heap_[child].squared) break;
    heap_[place] = heap_[child];
  }
  heap_[place] = found;
}

}  // namespace verisim::global
