#include "tracer/effects/scene_effects.h"

#include "tracer/effects/effects_state.h"

namespace verisim::global {
namespace {

// Where POV-Ray takes one sample of a constant, the place does not matter, unless it varies after all.
bool draws_count(const CompiledMedia& media) {
  const scene::Media& m = *media.description;
  return m.method != 3 || m.jitter != 0 || (media.last_density_plain && media.varies);
}

}  // namespace

SceneEffects::SceneEffects(const scene::Scene& scene, textures::Compiler& compiler, int quality) : scene_(scene) {
  if (quality < 9) return;
  for (const auto& object : scene.objects) add_object(*object, compiler);
  media_in_interiors = !interior_media_.empty();
  for (const scene::Media& m : scene.atmosphere) atmosphere_.push_back(compile_media(m, compiler));
  for (const CompiledMedia& m : atmosphere_) {
    atmosphere_list_.push_back(&m);
    air_draws_count |= draws_count(m);
  }
  atmosphere = !atmosphere_.empty();
  if (scene.settings.radiosity.enabled) {
    radiosity = true;
    radiosity_settings_ = std::make_unique<RadiositySettings>(scene.settings.radiosity, scene.camera.location);
    irradiance_ = std::make_unique<IrradianceCache>(radiosity_settings_->empty_cache());
  }
  photons = scene.settings.photons.enabled && scene.settings.photons.gather_max > 0;
  subsurface = scene.settings.subsurface;
  subsurface_settings_ = {scene.settings.subsurface_samples_diffuse, scene.settings.subsurface_samples_single,
                          scene.settings.mm_per_unit, scene.settings.adc_bailout};
}

std::unique_ptr<shading::EffectsState> SceneEffects::make_state() const {
  return std::make_unique<EffectsStateOfScene>();
}

void SceneEffects::add_interior(const scene::Interior* interior, textures::Compiler& compiler) {
  if (!interior || interior->media.empty()) return;
  const auto [entry, fresh] = interior_media_.try_emplace(interior);
  if (!fresh) return;
  for (const scene::Media& m : interior->media)
    interior_draws_count |= draws_count(entry->second.emplace_back(compile_media(m, compiler)));
}

void SceneEffects::add_object(const scene::Object& object, textures::Compiler& compiler) {
  add_interior(object.interior.get(), compiler);
  const scene::Radiosity& settings = scene_.settings.radiosity;
  importance_counts |= settings.enabled && (object.radiosity_importance >= 0 ? object.radiosity_importance < 1
                                                                             : settings.default_importance < 1);
  for (const auto& child : scene::children_of(object)) add_object(*child, compiler);
  if (const auto* light = object.as<scene::LightSource>()) {
    if (light->looks_like) add_object(*light->looks_like, compiler);
  }
}

std::span<const CompiledMedia> SceneEffects::media_of(const scene::Interior* interior) const {
  const auto found = interior_media_.find(interior);
  if (found == interior_media_.end()) return {};
  return found->second;
}

void SceneEffects::collect(std::span<const scene::Interior* const> interiors, MediaList& out) const {
  for (const scene::Interior* interior : interiors)
    for (const CompiledMedia& m : media_of(interior)) out.push_back(&m);
}

}  // namespace verisim::global
