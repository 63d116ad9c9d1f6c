// Which interiors a point lies in: where camera rays start, and lights that shoot photons (spec 06 2.1).
#include <algorithm>

#include "tracer/world/world_impl.h"

namespace verisim::accel {

const std::vector<std::uint32_t>& World::Impl::ranks() const {
  std::call_once(ranks_made, [this] {
    made_ranks.resize(entries.size());
    const std::vector<std::uint32_t> in_turn = hierarchy().in_turn();
    for (std::uint32_t i = 0; i < in_turn.size(); ++i) made_ranks[in_turn[i]] = i;
  });
  return made_ranks;
}

void World::interiors_at(const Vec3& p, std::vector<const scene::Interior*>& interiors) const {
  const Impl& w = *impl_;
  interiors.clear();
  if (!w.interiors) return;  // lens rays ask again and again
  thread_local std::vector<std::uint32_t> around;
  around.assign(w.unbounded.begin(), w.unbounded.end());
  for (const Surrounding& s : w.around) around.push_back(s.entry);
  w.tree.any_around(p, [&](std::uint32_t i) {
    around.push_back(w.bounded[i].entry);
    return false;
  });
  w.deep_tree.any_around(p, [&](std::uint32_t i) {
    around.push_back(w.deep[i]);
    return false;
  });
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  interiors_at(p, around, interiors);
}

void World::interiors_at(const Vec3& p, std::span<const std::uint32_t> holders,
                         std::vector<const scene::Interior*>& interiors) const {
  const Impl& w = *impl_;
  thread_local std::vector<std::uint32_t> inside;
  inside.clear();
  for (const std::uint32_t index : holders) {
    const Entry& e = w.entries[index];
    if (e.object->interior && contains(e.box(), p) && e.shape->inside_unclipped(p)) inside.push_back(index);
  }
  if (!w.in_order && inside.size() > 1) {
    const std::vector<std::uint32_t>& ranks = w.ranks();
    std::ranges::sort(inside, {}, [&](std::uint32_t index) { return ranks[index]; });
  }
  interiors.clear();
  for (const std::uint32_t index : inside) interiors.push_back(w.entries[index].object->interior.get());
}

std::vector<std::uint32_t> World::holders(const Box3& box) const {
  std::vector<std::uint32_t> result;
  if (!impl_->interiors) return result;
  for (std::uint32_t i = 0; i < impl_->entries.size(); ++i) {
    const Entry& e = impl_->entries[i];
    if (e.object->interior && e.box().intersects(box)) result.push_back(i);
  }
  return result;
}

std::vector<std::uint32_t> World::photon_holders(const Box3& box) const {
  std::vector<std::uint32_t> result;
  if (!impl_->interiors) return result;
  for (std::uint32_t i = 0; i < impl_->entries.size(); ++i) {
    const Entry& e = impl_->entries[i];
    if (!e.object->interior) continue;
    const shapes::SolidExtent solid = e.shape->solid_extent();  // what clips leave of it
    if (solid.outside || !e.object->clipped_by.empty() || solid.box.intersects(box)) result.push_back(i);
  }
  return result;
}

void World::interiors_of_photon(const Vec3& p, std::span<const std::uint32_t> holders,
                                std::vector<const scene::Interior*>& interiors) const {
  interiors.clear();
  for (const std::uint32_t i : holders) {
    const Entry& e = impl_->entries[i];
    if (e.shape->inside_unclipped(p)) interiors.push_back(e.object->interior.get());
  }
}

}  // namespace verisim::accel
