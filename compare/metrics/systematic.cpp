#include "compare/metrics/systematic.h"

#include <map>
#include <numeric>

#include "compare/metrics/patches.h"

namespace verisim::compare {
namespace {

using Channels = std::array<SignTest, 3>;

// Objects, by their tags, with what their pixels say.
std::map<int, Channels> signs_of_objects(const Values& a, const Values& b, const PixelTags& tags) {
  std::map<int, Channels> out;
  std::size_t at = 0;
  for (int y = 0; y < tags.height; y += tags.step)
    for (int x = 0; x < tags.width; x += tags.step, ++at) {
      const int set = tags.set_of[at];
      if (set < 0 || static_cast<std::size_t>(set) >= tags.sets.size() || !a.finite(x, y) || !b.finite(x, y)) continue;
      const Rgb d = told_difference(a, b, x, y);
      for (const int tag : tags.sets[static_cast<std::size_t>(set)])
        if (tag >= 0 && static_cast<std::size_t>(tag) < tags.tags.size() &&
            tags.tags[static_cast<std::size_t>(tag)].kind == "object")
          for (std::size_t c = 0; c < 3; ++c) out[tag][c].add(d[c]);
    }
  return out;
}

}  // namespace

std::size_t OneSidedGroups::root(std::size_t group) const {
  while (parents_[group] != group) group = parents_[group];
  return group;
}

void OneSidedGroups::join(std::size_t a, std::size_t b) {
  const std::size_t p = root(a), q = root(b);
  if (p == q) return;
  parents_[q] = p;
  groups_[p].pixels += groups_[q].pixels, groups_[p].contacts += groups_[q].contacts;
}

// A pixel and a neighbour that was there before it.
void OneSidedGroups::meet(std::size_t own, int side, const std::vector<signed char>& sides,
                          const std::vector<std::size_t>& groups, int x) {
  if (x < 0 || static_cast<std::size_t>(x) >= sides.size()) return;
  const auto at = static_cast<std::size_t>(x);
  if (sides[at] == side) join(groups[at], own);
  if (sides[at] == -side) touch(groups[at], own);
}

void OneSidedGroups::add_row(const std::vector<signed char>& sides) {
  std::vector<std::size_t> of_pixel(sides.size());
  for (std::size_t at = 0; at < sides.size(); ++at) {
    if (!sides[at]) continue;
    const int x = static_cast<int>(at);
    const std::size_t own = of_pixel[at] = groups_.size();
    groups_.push_back({1, 0, x, y_}), parents_.push_back(own);
    meet(own, sides[at], sides, of_pixel, x - 1);
    for (int i = x - 1; i <= x + 1; ++i) meet(own, sides[at], above_, of_pixel_, i);
  }
  above_ = sides, ++y_;
  forget_finished(of_pixel);
  of_pixel_ = std::move(of_pixel);
}

// Keeps the groups of the newest row alone, under new numbers.
void OneSidedGroups::forget_finished(std::vector<std::size_t>& of_pixel) {
  std::map<std::size_t, std::size_t> kept;
  std::vector<Group> groups;
  for (std::size_t at = 0; at < of_pixel.size(); ++at) {
    if (!above_[at]) continue;
    const auto [number, fresh] = kept.emplace(root(of_pixel[at]), groups.size());
    if (fresh) groups.push_back(groups_[number->first]);
    of_pixel[at] = number->second;
  }
  for (std::size_t group = 0; group < groups_.size(); ++group)
    if (parents_[group] == group && !kept.contains(group) && groups_[group].size() > finished_.size())
      finished_ = groups_[group];
  groups_ = std::move(groups);
  parents_.resize(groups_.size());
  std::iota(parents_.begin(), parents_.end(), std::size_t{0});
}

OneSidedGroups::Group OneSidedGroups::largest() const {
  Group out = finished_;
  for (const Group& group : groups_)
    if (group.size() > out.size()) out = group;
  return out;
}

std::optional<LeaningObject> leaning_object(const Picture& reference, const Picture& test, const PixelTags& tags,
                                            double limit) {
  require_same_size(reference, test);
  const Values a(reference), b(test);
  require_fitting(tags, a.width(), a.height());
  std::optional<LeaningObject> out;
  for (const auto& [tag, channels] : signs_of_objects(a, b, tags))
    for (const SignTest& signs : channels)
      if (signs.leans(limit) && (!out || signs.share() > out->signs.share()))
        out = LeaningObject{tags.tags[static_cast<std::size_t>(tag)].name, signs};
  return out;
}

}  // namespace verisim::compare
