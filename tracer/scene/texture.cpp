// Transformations of an object reach its texture: copies of what a transformation changes, everything else stays shared
// (spec 05 section 2).
#include "tracer/scene/texture.h"

namespace verisim::scene {

namespace {

template <class T>
std::shared_ptr<const T> with_transform(const std::shared_ptr<const T>& description, const Transform& t) {
  auto result = std::make_shared<T>(*description);
  result->pattern.prepend(t);
  return result;
}

// A solid colour looks the same everywhere.
bool is_solid(const Pattern& pattern) {
  return pattern.kind == PatternKind::plain || pattern.kind == PatternKind::none;
}

}  // namespace

PigmentPtr moved(const PigmentPtr& pigment, const Transform& t) { return with_transform(pigment, t); }

bool ends_in_solid_color(const Texture& texture) {
  return !texture.patterned() && is_solid(texture.layers.back().pigment->pattern);
}

PigmentPtr transformed(const PigmentPtr& pigment, const Transform& t) {
  if (!pigment || is_solid(pigment->pattern)) return pigment;
  return with_transform(pigment, t);
}

NormalPtr transformed(const NormalPtr& normal, const Transform& t) {
  if (!normal) return normal;
  return with_transform(normal, t);
}

TexturePtr transformed(const TexturePtr& texture, const Transform& t) {
  if (!texture) return texture;
  if (texture->patterned()) return with_transform(texture, t);
  bool changes = false;
  for (const TextureLayer& layer : texture->layers)
    changes = changes || layer.normal || !is_solid(layer.pigment->pattern);
  if (!changes) return texture;
  auto result = std::make_shared<Texture>(*texture);
  for (TextureLayer& layer : result->layers) {
    layer.pigment = transformed(layer.pigment, t);
    layer.normal = transformed(layer.normal, t);
  }
  return result;
}

}  // namespace verisim::scene
