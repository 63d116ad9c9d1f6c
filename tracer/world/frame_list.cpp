#include "tracer/world/frame_list.h"

#include <algorithm>

#include "tracer/scene/bounds.h"
#include "tracer/scene/extents.h"

namespace verisim::accel {
namespace {

using scene::Object;
using scene::ObjectPtr;

bool is_split(const Object& object) { return object.clipped_by.empty() && object.split_union; }

bool is_dissolved(const Object& object, bool split_unions) {
  if (object.as<scene::LightGroup>()) return true;
  const auto* csg = object.as<scene::Csg>();
  if (!csg || csg->kind != scene::CsgKind::union_ || !is_split(object)) return false;
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

// A text is the union of its letters (spec 04 section 9). Where nothing hangs on it, one object stands for all.
bool is_union_of_letters(const Object& object) {
  const auto* text = object.as<std::shared_ptr<const scene::Text>>();
  if (!text || object.inverted || !object.clipped_by.empty()) return false;
  return (*text)->text.size() > 1 || !object.bounded_by.empty();
}

std::vector<ObjectPtr> letters_of(const Object& object) {
  const scene::Text& text = **object.as<std::shared_ptr<const scene::Text>>();
  std::vector<ObjectPtr> letters;
  for (const auto& [box, place] : shapes::letter_boxes(text)) {
    scene::Text letter = text;
    letter.text = text.text.substr(letters.size(), 1), letter.place = place;
    auto copy = std::make_shared<Object>(object);
    copy->bounded_by.clear();
    const Transform placed = Transform::translation({place.x, place.y, 0}).then(*object.transform);
    copy->bounds = scene::transformed(scene::make_bounds(box.min, box.max), placed);
    copy->shape = std::make_shared<const scene::Text>(std::move(letter));
    letters.push_back(std::move(copy));
  }
  return letters;
}

ObjectPtr union_of_letters(const Object& object) {
  scene::Csg letters;
  for (ObjectPtr& letter : letters_of(object)) letters.children.push_back(std::move(letter));
  auto whole = std::make_shared<Object>(object);
  whole->shape = std::move(letters);
  return whole;
}

// `whole`: the dissolved union around the object that has a texture.
void collect_objects(const Object& object, bool split_unions, bool copied, const Object* whole, FrameList& list) {
  copied = copied || object.copied;
  const bool handed_down = whole && object.texture == whole->texture;
  if (is_dissolved(object, split_unions)) {
    if (object.texture && !handed_down) whole = &object;
    for (const ObjectPtr& child : scene::children_of(object))
      collect_objects(*child, split_unions, copied, whole, list);
    return;
  }
  if (is_union_of_letters(object)) {
    list.texts.push_back(union_of_letters(object));
    collect_objects(*list.texts.back(), split_unions, copied, whole, list);
    return;
  }
  ++list.entries;
  if (const auto* light = object.as<scene::LightSource>()) {
    if (!light->looks_like) return;
  }
  list.objects.push_back(&object);
  list.copied.push_back(copied);
  list.whole.push_back(handed_down ? whole : nullptr);
}

}  // namespace

FrameList frame_list(const scene::Scene& scene, bool split_unions) {
  FrameList list;
  for (const ObjectPtr& object : scene.objects) {
    collect_objects(*object, split_unions, false, nullptr, list);
    collect_lights(*object, false, list.lights);
  }
  return list;
}

}  // namespace verisim::accel
