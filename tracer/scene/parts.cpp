#include "tracer/scene/parts.h"

#include <algorithm>

namespace verisim::scene {
namespace {

const Children* children_list(const Object& object) {
  if (const auto* csg = object.as<Csg>()) return &csg->children;
  if (const auto* group = object.as<LightGroup>()) return &group->children;
  return nullptr;
}

// The list that stands for all copies of `object`; null: there is none, or it belongs to this object alone.
const void* shared_list(const Object& object) {
  const Children* const children = children_list(object);
  return children && children->shared() ? &children->declared() : nullptr;
}

void add(Parts& total, const Parts& part) {
  total.objects += part.objects;
  total.levels = std::max(total.levels, part.levels + 1);
}

Parts with_children(const Object& object) {
  const Children* const children = children_list(object);
  if (!children) return {};
  if (children->parts()) return *children->parts();
  Parts total;
  for (const ObjectPtr& child : children->declared()) add(total, parts_of(*child));
  children->set_parts(total);
  return total;
}

}  // namespace

Parts parts_of(const Object& object) {
  Parts total = with_children(object);
  for (const ObjectPtr& bound : object.bounded_by) add(total, parts_of(*bound));
  if (!object.clip_is_bound)  // else they are the same ones
    for (const ObjectPtr& clip : object.clipped_by) add(total, parts_of(*clip));
  if (const auto* light = object.as<LightSource>()) {
    if (light->looks_like) add(total, parts_of(*light->looks_like));
    if (light->projected_through) add(total, parts_of(*light->projected_through));
  }
  return total;
}

double objects_of(const std::vector<ObjectPtr>& objects) {
  double total = 0;
  for (const ObjectPtr& object : objects) total += parts_of(*object).objects;
  return total;
}

bool SharedLists::first(const Object& parent, bool variant) {
  const void* const list = shared_list(parent);
  return !list || seen_[variant].insert(list).second;
}

}  // namespace verisim::scene
