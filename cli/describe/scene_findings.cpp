#include "cli/describe/scene_findings.h"

#include <algorithm>
#include <unordered_set>

#include "tracer/query.h"
#include "tracer/scene/textures_of.h"

namespace verisim::cli {
namespace {

// Looks for anything that gives light, below every object once.
class Shining {
 public:
  bool lights = false;            // a light_source, wherever it is
  bool surfaces = false;          // more ambient than the default, emission, or media
  std::vector<Vec3> positions{};  // of the lights

  void object(const scene::ObjectPtr& pointer) {
    if (!pointer || seen_before(pointer)) return;
    const scene::Object& o = *pointer;
    if (const auto* light = o.as<scene::LightSource>()) {
      lights = true;
      positions.push_back(light->position);
      object(light->looks_like);
    }
    for (const auto& child : scene::children_of(o)) object(child);
    scene::visit_textures(o, [this](const scene::TexturePtr& t) { texture(t); });
    surfaces |= o.interior && !o.interior->media.empty();
  }

 private:
  // What only one thing refers to need not be remembered.
  template <class T>
  bool seen_before(const std::shared_ptr<T>& pointer) {
    return pointer.use_count() > 1 && !seen_.insert(pointer.get()).second;
  }

  void texture(const scene::TexturePtr& pointer) {
    if (!pointer || seen_before(pointer)) return;
    for (const scene::TextureLayer& layer : pointer->layers) {
      const scene::Finish& finish = *layer.finish;
      const auto largest = [](const Rgb& c) { return std::max({c.r, c.g, c.b}); };
      surfaces |= largest(finish.ambient) > 0.1f || largest(finish.emission) > 0;
    }
    if (pointer->texture_map)
      for (const auto& entry : *pointer->texture_map) texture(entry.value);
  }

  std::unordered_set<const void*> seen_;
};

parser::Diagnostic finding(parser::Code code, const scene::SourceLocation& place, std::string message,
                           std::string advice) {
  parser::Diagnostic d;
  d.severity = parser::Severity::warning;
  d.code = code;
  if (place.file) d.file = *place.file;
  d.line = place.line;
  d.column = place.column;
  d.message = std::move(message);
  d.advice = std::move(advice);
  return d;
}

// One layer of a plain colour that nothing shows through and that does not shine.
bool is_plain_and_opaque(const scene::Object& object) {
  if (!object.texture || object.texture->layers.size() != 1 || object.interior_texture) return false;
  const scene::TextureLayer& layer = object.texture->layers.front();
  const scene::Pigment& pigment = *layer.pigment;
  return pigment.pattern.kind <= scene::PatternKind::plain && !pigment.color_map && !pigment.pigment_map &&
         pigment.color.f == 0 && pigment.color.t == 0;
}

}  // namespace

std::vector<parser::Diagnostic> scene_findings(const scene::Scene& scene) {
  std::vector<parser::Diagnostic> findings;
  if (scene.objects.empty()) return findings;  // the parser says so
  const scene::SourceLocation whole{std::make_shared<const std::string>(scene.source_name), 0, 0};
  if (!scene.camera_given)
    findings.push_back(finding(parser::Code::no_camera, whole,
                               "The scene has no camera: it is seen from the origin along z.",
                               "camera { location <0, 2, -8> look_at 0 } looks at the origin from in front of it."));
  Shining shining;
  for (const scene::ObjectPtr& object : scene.objects) shining.object(object);
  const bool radiosity = scene.settings.radiosity.enabled;
  if (!shining.lights && !shining.surfaces && !radiosity && scene.atmosphere.empty())
    findings.push_back(
        finding(parser::Code::no_light, whole,
                "The scene has no light_source, and nothing in it shines: its objects stay nearly black.",
                "light_source { <20, 30, -40>, rgb 1 } lights it from the upper right."));
  if (!scene.camera_given || scene.camera.kind == scene::CameraKind::mesh_camera || radiosity || shining.surfaces)
    return findings;
  for (const scene::ObjectPtr& object : scene.objects) {
    if (object->no_image || object->is_hollow() || !is_plain_and_opaque(*object)) continue;
    if (object->as<scene::LightSource>() || object->as<scene::LightGroup>() || object->as<scene::Csg>()) continue;
    const query::Target solid(object);
    if (!solid.has_inside() || !solid.inside(scene.camera.location)) continue;
    if (std::any_of(shining.positions.begin(), shining.positions.end(), [&](const Vec3& p) { return solid.inside(p); }))
      continue;
    findings.push_back(finding(parser::Code::camera_inside, object->place,
                               "The camera is inside this opaque object, and no light is: it sees a dark inside.",
                               "Move the camera's location out of it."));
  }
  return findings;
}

}  // namespace verisim::cli
