#include "tracer/textures/compile/ready_maps.h"

#include <algorithm>

namespace verisim::textures {

bool ReadyMaps::reveal(const scene::TexturePtr& texture, Compiler& compiler) const {
  const CompiledTexture& compiled = *compiler.texture(texture);
  if (!compiled.images_filter) return false;
  if (compiled.patterned())
    return std::ranges::any_of(*texture->texture_map, [&](const auto& entry) { return reveal(entry.value, compiler); });
  // One layer that stays flagged is enough.
  return std::ranges::none_of(texture->layers, [&](const scene::TextureLayer& layer) {
    return flagged_opaque(*layer.pigment, *compiler.pigment(layer.pigment)) && !reveal(*layer.pigment, compiler);
  });
}

bool ReadyMaps::reveal(const scene::Pigment& pigment, Compiler& compiler) const {
  if (!pigment.pigment_map) return false;
  const bool ready = maps_.contains(pigment.pigment_map.get());
  return std::ranges::any_of(*pigment.pigment_map, [&](const auto& entry) {
    return (ready && image_filters(*entry.value, *compiler.pigment(entry.value))) || reveal(*entry.value, compiler);
  });
}

void ReadyMaps::add(const scene::TexturePtr& texture, Compiler& compiler) {
  if (texture && compiler.texture(texture)->images_filter) add(*texture);
}

void ReadyMaps::add(const scene::Texture& texture) {
  for (const scene::TextureLayer& layer : texture.layers) add(*layer.pigment);
  if (!texture.texture_map) return;
  for (const auto& entry : *texture.texture_map) add(*entry.value);
}

void ReadyMaps::add(const scene::Pigment& pigment) {
  if (!pigment.pigment_map || !maps_.insert(pigment.pigment_map.get()).second) return;
  for (const auto& entry : *pigment.pigment_map) add(*entry.value);
}

}  // namespace verisim::textures
