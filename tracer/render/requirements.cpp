#include "tracer/render/requirements.h"

namespace verisim::render {
namespace {

constexpr int kMaxBlurSamples = 1 << 20;
constexpr std::int64_t kMaxAreaLightSamples = std::int64_t{1} << 24;

void check_texture(const scene::Texture& texture, const scene::Settings& settings) {
  for (const auto& layer : texture.layers)
    if (layer.finish.subsurface && settings.subsurface) throw Unsupported("subsurface light transport", layer.finish.place);
  if (texture.texture_map)
    for (const auto& entry : *texture.texture_map)
      if (entry.value) check_texture(*entry.value, settings);
}

void check_light(const scene::LightSource& light, const scene::Place& place) {
  if (light.area && static_cast<std::int64_t>(light.size1) * light.size2 > kMaxAreaLightSamples)
    throw Unsupported("area_light with more than 16777216 samples", place);
}

void check_object(const scene::Object& object, const scene::Settings& settings) {
  for (const auto& texture : {object.texture, object.interior_texture})
    if (texture) check_texture(*texture, settings);
  if (object.interior && !object.interior->media.empty()) throw Unsupported("media", object.interior->media.front().place);
  if (const auto* light = object.as<scene::LightSource>()) {
    check_light(*light, object.place);
    if (light->looks_like) check_object(*light->looks_like, settings);
  }
  if (const auto* csg = object.as<scene::Csg>())
    for (const auto& child : csg->children) check_object(*child, settings);
  if (const auto* group = object.as<scene::LightGroup>())
    for (const auto& child : group->children) check_object(*child, settings);
}

}  // namespace

void check_supported(const scene::Scene& scene, const Options& options) {
  if (scene.camera.blur_samples > kMaxBlurSamples) throw Unsupported("more than 1048576 blur_samples", {});
  if (options.quality < 9) return;
  if (!scene.atmosphere.empty()) throw Unsupported("media", scene.atmosphere.front().place);
  if (scene.settings.radiosity.enabled) throw Unsupported("radiosity", scene.settings.radiosity.place);
  if (scene.settings.photons.enabled) throw Unsupported("photons", scene.settings.photons.place);
  for (const auto& object : scene.objects) check_object(*object, scene.settings);
}

}  // namespace verisim::render
