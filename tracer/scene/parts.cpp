#include "tracer/scene/parts.h"

#include <algorithm>
#include <unordered_map>

namespace verisim::scene {
namespace {

// The list that stands for all copies of `object`; null: there is none, or it belongs to this object alone.
const void* shared_list(const Object& object) {
  const Children* children = nullptr;
  if (const auto* csg = object.as<Csg>()) children = &csg->children;
  if (const auto* group = object.as<LightGroup>()) children = &group->children;
  return children && children->shared() ? &children->declared() : nullptr;
}

class Count {
 public:
  Parts of(const Object& object) {
    Parts total = below(object);
    for (const ObjectPtr& bound : object.bounded_by) add(total, of(*bound));
    if (!object.clip_is_bound)  // else they are the same ones
      for (const ObjectPtr& clip : object.clipped_by) add(total, of(*clip));
    if (const auto* light = object.as<LightSource>()) {
      if (light->looks_like) add(total, of(*light->looks_like));
      if (light->projected_through) add(total, of(*light->projected_through));
    }
    return total;
  }

 private:
  static void add(Parts& total, const Parts& part) {
    total.objects += part.objects;
    total.levels = std::max(total.levels, part.levels + 1);
  }

  Parts below(const Object& object) {
    const void* const list = shared_list(object);
    if (list)
      if (const auto found = known_.find(list); found != known_.end()) return found->second;
    Parts total;
    for (const ObjectPtr& child : declared_children(object)) add(total, of(*child));
    if (list) known_.emplace(list, total);
    return total;
  }

  std::unordered_map<const void*, Parts> known_;  // by shared list
};

}  // namespace

Parts parts_of(const Object& object) { return Count().of(object); }

double objects_of(const std::vector<ObjectPtr>& objects) {
  Count count;
  double total = 0;
  for (const ObjectPtr& object : objects) total += count.of(*object).objects;
  return total;
}

bool SharedLists::first(const Object& parent, bool variant) {
  const void* const list = shared_list(parent);
  return !list || seen_[variant].insert(list).second;
}

}  // namespace verisim::scene
