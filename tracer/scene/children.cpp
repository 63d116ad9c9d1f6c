#include "tracer/scene/children.h"

#include <utility>

#include "tracer/scene/finish_statement.h"
#include "tracer/scene/transform_steps.h"
#include "tracer/scene/scene.h"

namespace verisim::scene {
namespace {

Postponed::Motion note(const TransformStep& move) {
  return {move.step, move.v, move.step == TransformStep::Step::matrix ? Rare<Transform>(move.t) : Rare<Transform>()};
}

void add(TransformSteps& steps, const Postponed::Motion& motion) {
  switch (motion.step) {
    case TransformStep::Step::translate:
      steps.translate(motion.v);
      break;
    case TransformStep::Step::scale:
      steps.scale(motion.v);
      break;
    case TransformStep::Step::rotate:
      steps.rotate(motion.v);
      break;
    case TransformStep::Step::matrix:
      steps.transform(motion.matrix);
      break;
  }
}

// The order of moves counts, not how they were grouped.
void catch_up(std::vector<ObjectPtr>& objects, const std::vector<Postponed::Motion>& motions) {
  for (std::size_t i = 0; i < motions.size();) {
    TransformSteps steps;
    for (; i < motions.size() && !steps.full(); ++i) add(steps, motions[i]);
    for (ObjectPtr& object : objects) apply(const_cast<Object&>(*object), steps);
  }
}

Children* list_of(Object& object) {
  if (auto* csg = std::get_if<Csg>(&object.shape)) return &csg->children;
  if (auto* group = std::get_if<LightGroup>(&object.shape)) return &group->children;
  return nullptr;
}

}  // namespace

void Children::push_back(ObjectPtr child) {
  if (!objects_) objects_ = std::make_shared<std::vector<ObjectPtr>>();
  objects_->push_back(std::move(child));
  parts_.reset();
}

const std::vector<ObjectPtr>& Children::declared() const {
  static const std::vector<ObjectPtr> none;
  return objects_ ? *objects_ : none;
}

void Children::postpone(const TransformSteps& steps) {
  Postponed& work = postponed_.edit();
  work.motions.reserve(work.motions.size() + steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) work.motions.push_back(note(steps[i]));
}

void Children::postpone_end(const TexturePtr& default_texture) { postponed_.edit().default_texture = default_texture; }

std::vector<ObjectPtr>& Children::own(Object& parent) {
  if (!objects_) objects_ = std::make_shared<std::vector<ObjectPtr>>();
  if (shared()) {
    auto mine = std::make_shared<std::vector<ObjectPtr>>();
    mine->reserve(objects_->size());
    for (const ObjectPtr& original : *objects_) mine->push_back(copy(*original));
    objects_ = std::move(mine);
  }
  if (postponed_) {
    const Postponed work = std::exchange(postponed_, Rare<Postponed>());
    catch_up(*objects_, work.motions);
    if (work.default_texture) finish_children(parent, work.default_texture);
  }
  return *objects_;
}

std::vector<ObjectPtr>& own_children(Object& object) {
  static std::vector<ObjectPtr> none;
  Children* const list = list_of(object);
  return list ? list->own(object) : none;
}

const std::vector<ObjectPtr>& children_of(const Object& object) {
  auto& same = const_cast<Object&>(object);  // its value does not change
  Children* const list = list_of(same);
  return list && list->postponed() ? list->own(same) : declared_children(object);
}

const std::vector<ObjectPtr>& declared_children(const Object& object) {
  static const std::vector<ObjectPtr> none;
  const Children* const list = list_of(const_cast<Object&>(object));
  return list ? list->declared() : none;
}

void complete(const Object& object) {
  for (const ObjectPtr& child : children_of(object)) complete(*child);
  for (const ObjectPtr& bound : object.bounded_by) complete(*bound);
  for (const ObjectPtr& clip : object.clipped_by) complete(*clip);
  if (const auto* light = object.as<LightSource>()) {
    if (light->looks_like) complete(*light->looks_like);
    if (light->projected_through) complete(*light->projected_through);
  }
}

void complete(const Scene& scene) {
  for (const ObjectPtr& object : scene.objects) complete(*object);
}

}  // namespace verisim::scene
