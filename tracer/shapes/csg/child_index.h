// Some children of a CSG object, by index, found by their boxes.
#pragma once

#include <algorithm>
#include <bit>
#include <memory>

#include "tracer/bvh/bvh.h"
#include "tracer/shapes/quadrics/box_set.h"
#include "tracer/shapes/scratch.h"

namespace verisim::shapes {

class ChildIndex {
 public:
  // In their order.
  void add(std::uint32_t child, const Box3& box) {
    if (accel::is_empty(box)) return;
    if (accel::is_finite(box)) {
      boxes_.push_back(box);
      children_.push_back(child);
    } else {
      unbounded_.push_back(child);
    }
  }
  void build() {
    leave_out_outsized();
    few_ = boxes_.size() + unbounded_.size() <= BoxSet::kMax;
    if (few_)
      take_few();
    else
      tree_ = std::make_unique<const accel::Bvh>(boxes_);
    boxes_ = std::vector<Box3>();
  }
  // Calls visit(child, t_max) -> t_max for every child whose box the ray meets.
  template <class Visit>
  void along(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
    for (const std::uint32_t child : unbounded_) t_max = visit(child, t_max);
    if (!few_)
      return tree_->traverse(ray, t_min, t_max,
                             [&](std::uint32_t i, double limit) { return visit(children_[i], limit); });
    for (std::uint32_t places = always_; places != 0; places &= places - 1) t_max = visit(first_of(places), t_max);
    set_.traverse(ray, t_min, t_max,
                  [&](std::uint32_t i, double limit) { return visit(children_[places_[i]], limit); });
  }
  // Calls visit(child) for every child whose box the ray meets, in order of declaration.
  template <class Visit>
  void in_order(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
    if (few_) {
      for (std::uint32_t met = met_by(ray, t_min, t_max); met != 0; met &= met - 1) visit(first_of(met));
      return;
    }
    struct ChildTag;
    Scratch<std::uint32_t, ChildTag> found;
    along(ray, t_min, t_max, [&](std::uint32_t i, double limit) {
      found.add(i);
      return limit;
    });
    found.sort();
    for (std::size_t k = 0; k < found.size(); ++k) visit(found[k]);
  }
  // Calls visit(child) for every child whose box contains p until one returns true.
  template <class Visit>
  bool any_around(const Vec3& p, Visit&& visit) const {
    for (const std::uint32_t child : unbounded_)
      if (visit(child)) return true;
    if (!few_) return tree_->any_around(p, [&](std::uint32_t i) { return visit(children_[i]); });
    for (std::uint32_t here = placed(set_.empty() ? 0 : set_.around(p)); here != 0; here &= here - 1)
      if (visit(first_of(here))) return true;
    return false;
  }

 private:
  // All in one list, those without a box among them.
  void take_few() {
    set_ = BoxSet(boxes_);
    std::vector<std::uint32_t> all(children_);
    all.insert(all.end(), unbounded_.begin(), unbounded_.end());
    std::sort(all.begin(), all.end());
    const auto place = [&](std::uint32_t child) {
      return static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), child) - all.begin());
    };
    for (const std::uint32_t child : children_) places_.push_back(place(child));
    for (const std::uint32_t child : unbounded_) always_ |= std::uint32_t{1} << place(child);
    children_ = std::move(all);
    unbounded_.clear();
  }
  // Of few: the places in the list of the boxes that are found, and of those that always are.
  std::uint32_t placed(std::uint32_t found) const {
    if (always_ == 0) return found;  // places_[i] is i
    std::uint32_t places = always_;
    for (; found != 0; found &= found - 1)
      places |= std::uint32_t{1} << places_[static_cast<std::size_t>(std::countr_zero(found))];
    return places;
  }
  std::uint32_t met_by(const Ray& ray, double t_min, double t_max) const {
    return placed(set_.empty() ? 0 : set_.meet(ray, t_min, t_max));
  }
  std::uint32_t first_of(std::uint32_t places) const {
    return children_[static_cast<std::size_t>(std::countr_zero(places))];
  }

  // The digits of a tree's boxes are relative to the largest of them: a few that are huge beside the others would spoil
  // all.
  void leave_out_outsized() {
    constexpr double kOutsized = 1e4;
    constexpr std::size_t kFew = 4;
    std::vector<double> sizes;
    for (const Box3& box : boxes_) sizes.push_back(length(box.max - box.min));
    std::vector<double> sorted = sizes;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() < 2 * kFew) return;
    const double most = kOutsized * sorted[sorted.size() / 2];
    if (!(sorted.back() > most) || sorted[sorted.size() - 1 - kFew] > most) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (sizes[i] > most) {
        unbounded_.push_back(children_[i]);
      } else {
        boxes_[kept] = boxes_[i];
        children_[kept++] = children_[i];
      }
    }
    boxes_.resize(kept);
    children_.resize(kept);
  }

  std::vector<Box3> boxes_;
  std::vector<std::uint32_t> children_, unbounded_;
  bool few_ = true;
  BoxSet set_;                         // of few
  std::vector<std::uint32_t> places_;  // of its boxes
  std::uint32_t always_ = 0;
  std::unique_ptr<const accel::Bvh> tree_;  // of many
};

}  // namespace verisim::shapes
