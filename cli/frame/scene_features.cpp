#include "cli/frame/scene_features.h"

#include <set>
#include <unordered_set>

#include "tracer/scene/textures_of.h"

namespace verisim::cli {
namespace {

class Walk {
 public:
  explicit Walk(int quality) : quality_(quality) {}

  std::set<std::string> found;

  void object(const scene::ObjectPtr& pointer) {
    if (!pointer || seen_before(pointer)) return;
    const scene::Object& o = *pointer;
    if (const auto* light = o.as<scene::LightSource>()) this->light(*light);
    for (const auto& child : scene::children_of(o)) object(child);
    scene::visit_textures(o, [this](const scene::TexturePtr& t) { texture(t); });
    if (o.interior)
      for (const scene::Media& m : o.interior->media) media(m);
  }

  // Methods 2 and 3 without jitter repeat exactly when they take the fixed number of samples.
  void media(const scene::Media& m) {
    if (quality_ < 9) return;
    if (m.method == 1) found.insert("media method 1");
    if (m.jitter != 0) found.insert("media jitter");
    if (m.method == 2 && m.samples_max > m.samples_min) found.insert("media with extra samples");
  }

 private:
  // What only one thing refers to need not be remembered.
  template <class T>
  bool seen_before(const std::shared_ptr<T>& pointer) {
    return pointer.use_count() > 1 && !seen_.insert(pointer.get()).second;
  }

  void light(const scene::LightSource& l) {
    if (l.area && l.jitter && (l.size1 > 1 || l.size2 > 1) && quality_ >= 5) found.insert("area_light jitter");
    object(l.looks_like);
    object(l.projected_through);
  }

  void texture(const scene::TexturePtr& pointer) {
    if (!pointer || seen_before(pointer)) return;
    for (const scene::TextureLayer& layer : pointer->layers) {
      if (layer.finish->crand != 0 && quality_ >= 2) found.insert("crand");
      if (layer.finish->subsurface && quality_ >= 9) subsurface = true;
    }
    if (pointer->texture_map)
      for (const auto& entry : *pointer->texture_map) texture(entry.value);
  }

  int quality_;
  std::unordered_set<const void*> seen_;

 public:
  bool subsurface = false;
};

void count(const scene::ObjectPtr& pointer, ObjectCount& result) {
  if (!pointer) return;
  if (pointer->as<scene::LightSource>()) {
    ++result.lights;
  } else if (pointer->as<scene::LightGroup>()) {
    for (const auto& child : scene::children_of(*pointer)) count(child, result);
  } else {
    ++(scene::is_infinite(*pointer) ? result.infinite : result.finite);
  }
}

}  // namespace

std::vector<std::string> stochastic_features(const scene::Scene& scene, int quality) {
  Walk walk(quality);
  for (const scene::ObjectPtr& object : scene.objects) walk.object(object);
  for (const scene::Media& media : scene.atmosphere) walk.media(media);
  if (walk.subsurface && scene.settings.subsurface) walk.found.insert("subsurface");
  if (quality >= 9) {
    if (scene.settings.radiosity.enabled) walk.found.insert("radiosity");
    if (scene.settings.photons.enabled) walk.found.insert("photons");
    for (const scene::Rainbow& rainbow : scene.rainbows)
      if (rainbow.jitter != 0) walk.found.insert("rainbow jitter");
  }
  return {walk.found.begin(), walk.found.end()};
}

ObjectCount count_objects(const scene::Scene& scene) {
  ObjectCount result;
  for (const scene::ObjectPtr& object : scene.objects) count(object, result);
  return result;
}

}  // namespace verisim::cli
