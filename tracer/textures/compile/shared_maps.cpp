#include "tracer/textures/compile/shared_maps.h"

#include "tracer/scene/textures_of.h"

namespace verisim::textures {

MapsWithoutBumpScale::MapsWithoutBumpScale(const scene::Scene& scene) {
  if (!scene.settings.no_bump_scale) return;
  for (const scene::ObjectPtr& object : scene.objects) add(*object);
  for (auto& seen : seen_) seen.clear();
}

void MapsWithoutBumpScale::add(const scene::Object& object) {
  scene::visit_textures(object, [this](const scene::TexturePtr& texture) {
    if (texture) add(*texture, false);
  });
  for (const auto& child : scene::children_of(object)) add(*child);
  if (const auto* light = object.as<scene::LightSource>(); light && light->looks_like) add(*light->looks_like);
}

void MapsWithoutBumpScale::add(const scene::Texture& texture, bool flagged) {
  if (!seen_[flagged].insert(&texture).second) return;
  flagged |= texture.no_bump_scale;
  for (const scene::TextureLayer& layer : texture.layers)
    if (layer.normal) add(*layer.normal, flagged);
  if (!texture.texture_map) return;
  if (flagged) maps_.insert(texture.texture_map.get());
  for (const auto& entry : *texture.texture_map) add(*entry.value, flagged);
}

void MapsWithoutBumpScale::add(const scene::Normal& normal, bool flagged) {
  if (!seen_[flagged].insert(&normal).second) return;
  flagged |= normal.no_bump_scale;
  if (!normal.normal_map) return;
  if (flagged) maps_.insert(normal.normal_map.get());
  for (const auto& entry : *normal.normal_map) add(*entry.value, flagged);
}

}  // namespace verisim::textures
