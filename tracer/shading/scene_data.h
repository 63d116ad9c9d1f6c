// Everything immutable that all threads share while a scene is shaded.
#pragma once

#include <unordered_map>

#include "tracer/world/world.h"
#include "tracer/shading/effects.h"
#include "tracer/shading/atmosphere/rainbow.h"
#include "tracer/shading/atmosphere/sky.h"

namespace verisim::shading {

class SceneData {
 public:
  SceneData(const scene::Scene& description, const accel::World& geometry, textures::Compiler& compiler,
            int quality_level, bool output_alpha);

  const scene::Scene& scene;
  const accel::World& world;
  int quality;  // 0..9
  int version;  // decides opacity and ambient rules (spec 06 section 13)
  float adc_bailout;
  int max_trace_level;
  Rgb ambient_light;  // zero when radiosity replaces it
  Sky sky;
  std::vector<Rainbow> rainbows;
  bool fog = false;
  const Effects* effects = nullptr;  // set by render() when the scene uses any
  bool air_shows() const { return fog || !rainbows.empty() || (effects && effects->atmosphere); }
  bool any_media() const { return effects && (effects->media_in_interiors || effects->atmosphere); }

  // Global lights first, in file order; then those of light groups.
  const std::vector<Light>& lights() const { return lights_; }
  std::size_t global_lights() const { return global_lights_; }
  const Light& light_of(const scene::LightSource* source) const { return lights_[index_.at(source)]; }

 private:
  void add_light(const scene::LightSource* source);
  std::vector<Light> lights_;
  std::size_t global_lights_ = 0;
  std::unordered_map<const scene::LightSource*, std::size_t> index_;
};

}  // namespace verisim::shading
