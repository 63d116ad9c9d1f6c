// Transformations of an object reach its texture: copies of what a transformation changes, everything else stays shared
// (spec 05 section 2).
#include "tracer/scene/texture.h"

namespace verisim::scene {

namespace {

template <class T>
std::shared_ptr<const T> with_transforms(const std::shared_ptr<const T>& description, Transforms steps) {
  auto result = std::make_shared<T>(*description);
  result->pattern.prepend(steps);
  return result;
}

// A solid colour looks the same everywhere.
bool is_solid(const Pattern& pattern) {
  return pattern.kind == PatternKind::plain || pattern.kind == PatternKind::none;
}

}  // namespace

PigmentPtr moved(const PigmentPtr& pigment, const Transform& t) {
  const Transform* const one = &t;
  return with_transforms(pigment, {&one, 1});
}

bool ends_in_solid_color(const Texture& texture) {
  return !texture.patterned() && is_solid(texture.layers.back().pigment->pattern);
}

PigmentPtr transformed(const PigmentPtr& pigment, Transforms steps) {
  if (!pigment || is_solid(pigment->pattern)) return pigment;
  return with_transforms(pigment, steps);
}

NormalPtr transformed(const NormalPtr& normal, Transforms steps) {
  if (!normal) return normal;
  return with_transforms(normal, steps);
}

TexturePtr transformed(const TexturePtr& texture, Transforms steps) {
  if (!texture) return texture;
  if (texture->patterned()) return with_transforms(texture, steps);
  bool changes = false;
  for (const TextureLayer& layer : texture->layers)
    changes = changes || layer.normal || !is_solid(layer.pigment->pattern);
  if (!changes) return texture;
  auto result = std::make_shared<Texture>(*texture);
  for (TextureLayer& layer : result->layers) {
    layer.pigment = transformed(layer.pigment, steps);
    layer.normal = transformed(layer.normal, steps);
  }
  return result;
}

}  // namespace verisim::scene
