#include "tracer/world/frame_list.h"

#include <algorithm>

namespace verisim::accel {
namespace {

using scene::Object;
using scene::ObjectPtr;

bool is_dissolved(const Object& object, bool split_unions) {
  if (object.as<scene::LightGroup>()) return true;
  const auto* csg = object.as<scene::Csg>();
  if (!csg || csg->kind != scene::CsgKind::union_ || !object.clipped_by.empty() || !object.split_union) return false;
  if (object.bounded_by.empty()) return true;
  if (!split_unions) return false;
  const std::vector<ObjectPtr>& children = scene::children_of(object);
  return std::none_of(children.begin(), children.end(),
                      [](const ObjectPtr& child) { return scene::is_infinite(*child); });
}

// Lights that are direct children of a light_group belong to it alone (spec 06 10.1).
void collect_lights(const Object& object, bool in_group, std::vector<const scene::LightSource*>& lights) {
  if (const auto* light = object.as<scene::LightSource>()) {
    if (!in_group) lights.push_back(light);
  } else {
    for (const ObjectPtr& child : scene::children_of(object))
      collect_lights(*child, object.as<scene::LightGroup>() != nullptr, lights);
  }
}

void collect_objects(const Object& object, bool split_unions, bool copied, FrameList& list) {
  copied = copied || object.copied;
  if (is_dissolved(object, split_unions)) {
    for (const ObjectPtr& child : scene::children_of(object)) collect_objects(*child, split_unions, copied, list);
    return;
  }
  ++list.entries;
  if (const auto* light = object.as<scene::LightSource>()) {
    if (!light->looks_like) return;
  }
  list.objects.push_back(&object);
  list.copied.push_back(copied);
}

}  // namespace

FrameList frame_list(const scene::Scene& scene, bool split_unions) {
  FrameList list;
  for (const ObjectPtr& object : scene.objects) {
    collect_objects(*object, split_unions, false, list);
    collect_lights(*object, false, list.lights);
  }
  return list;
}

}  // namespace verisim::accel
