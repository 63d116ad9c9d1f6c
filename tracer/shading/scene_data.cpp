#include "tracer/shading/scene_data.h"

namespace verisim::shading {
namespace {

// Lights that only the objects of a light_group see hang on those objects.
template <class Visit>
void visit_group_lights(const scene::Object& object, const Visit& visit) {
  for (const auto& light : object.group_lights) visit(light.get());
  for (const auto& child : scene::children_of(object)) visit_group_lights(*child, visit);
}

}  // namespace

SceneData::SceneData(const scene::Scene& description, const accel::World& geometry, textures::Compiler& compiler,
                     int quality_level, bool output_alpha)
    : scene(description),
      world(geometry),
      quality(std::clamp(quality_level, 0, 9)),
      version(description.version),
      adc_bailout(description.settings.adc_bailout),
      max_trace_level(std::clamp(description.settings.max_trace_level, 1, 256)),
      ambient_light(description.settings.ambient_light),
      sky(description, compiler, output_alpha) {
  if (quality >= 9) {
    // The last one written is worked on first, which shows in the numbers that jitter draws (measured with two
    // overlapping bows).
    for (auto r = description.rainbows.rbegin(); r != description.rainbows.rend(); ++r)
      if (Rainbow bow(*r); bow.active()) rainbows.push_back(bow);
    for (const scene::Fog& f : description.fogs) fog = fog || std::fabs(f.distance) >= kEpsilon;
    if (description.settings.radiosity.enabled && version >= 370) ambient_light = Rgb(0);
  }
  for (const scene::LightSource* source : geometry.lights()) add_light(source);
  global_lights_ = lights_.size();
  for (const auto& object : description.objects)
    visit_group_lights(*object, [this](const scene::LightSource* source) { add_light(source); });
}

void SceneData::add_light(const scene::LightSource* source) {
  if (index_.try_emplace(source, lights_.size()).second) {
    auto projector = source->projected_through ? shapes::compile(*source->projected_through) : nullptr;
    lights_.emplace_back(*source, quality >= 5, std::move(projector));
  }
}

}  // namespace verisim::shading
