#include "cli/describe/pixel_tags.h"

#include <cmath>
#include <unordered_set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/describe/object_names.h"
#include "tracer/shading/scene_data.h"
#include "tracer/shading/tracer.h"

namespace verisim::cli {
namespace {

using scene::PatternKind;
using WordPairs = std::vector<std::pair<std::string, std::string>>;

bool of_noise(const scene::Pattern& pattern) {
  if (scene::info(pattern.kind).is(scene::PatternInfo::kNoise)) return true;
  if (pattern.turbulence && pattern.turbulence->amount != Vec3(0, 0, 0)) return true;
  for (const scene::Warp& warp : pattern.warps)
    if (std::holds_alternative<scene::TurbulenceWarp>(warp)) return true;
  return false;
}

// The patterns of a texture, however deep in maps.
class Patterns {
 public:
  explicit Patterns(WordPairs& words) : words_(words) {}

  void texture(const scene::TexturePtr& pointer) {
    if (!fresh(pointer.get())) return;
    if (pointer->patterned()) pattern("texture", pointer->pattern);
    if (pointer->texture_map)
      for (const auto& entry : *pointer->texture_map) texture(entry.value);
    for (const scene::TextureLayer& layer : pointer->layers) {
      pigment(layer.pigment);
      normal(layer.normal);
      if (layer.finish->crand != 0) words_.emplace_back("feature", "crand");
      if (layer.finish->subsurface) words_.emplace_back("feature", "subsurface");
      if (layer.finish->irid > 0) words_.emplace_back("feature", "irid");
      if (layer.finish->phong > 0 || layer.finish->specular > 0)
        words_.emplace_back("feature", "highlights (phong, specular)");
    }
  }

 private:
  bool fresh(const void* pointer) { return pointer && seen_.insert(pointer).second; }
  void pigment(const scene::PigmentPtr& pointer) {
    if (!fresh(pointer.get())) return;
    pattern("pigment", pointer->pattern);
    if (pointer->pigment_map)
      for (const auto& entry : *pointer->pigment_map) pigment(entry.value);
  }
  void normal(const scene::NormalPtr& pointer) {
    if (!fresh(pointer.get())) return;
    pattern("normal", pointer->pattern);
    if (pointer->normal_map)
      for (const auto& entry : *pointer->normal_map) normal(entry.value);
  }
  void pattern(const char* what, const scene::Pattern& pattern) {
    if (pattern.kind != PatternKind::none && pattern.kind != PatternKind::plain)
      words_.emplace_back("texture", fmt::format("{} {}", what, pattern_name(pattern.kind)));
    if (of_noise(pattern)) words_.emplace_back("feature", "noise (turbulence and patterns made of it)");
  }

  WordPairs& words_;
  std::unordered_set<const void*> seen_;
};

std::string name_of_air(const scene::Scene& scene) { return scene.fogs.empty() ? "media" : "fog"; }

}  // namespace

TagWitness::TagWitness(const scene::Scene& scene, const parser::Origins& origins)
    : parts_(name_of_air(scene)), origins_(origins) {
  for (const scene::ObjectPtr& object : scene.objects) know_parents(*object);
  const scene::Camera& c = scene.camera;
  const auto text = [](const Vec3& v) { return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", v.x, v.y, v.z); };
  tags_.tags.push_back({"camera", fmt::format("location {}, direction {}, right {}, up {}", text(c.location),
                                              text(c.direction), text(c.right), text(c.up))});
}

// Copies of one object have one name; where they were called and where they are tells them apart
// (compare/causes/objects.cpp reads it again).
std::string TagWitness::with_place(const scene::Object& object) const {
  const auto& [low, size] = object.bounds;
  constexpr float kEndless = 1e6f;
  const std::string name = placed_object_name(object, origins_);
  if (std::max({size[0], size[1], size[2]}) > kEndless) return name;
  return fmt::format("{} at <{:.4g}, {:.4g}, {:.4g}>, size <{:.4g}, {:.4g}, {:.4g}>", name, low[0] + size[0] / 2,
                     low[1] + size[1] / 2, low[2] + size[2] / 2, size[0], size[1], size[2]);
}

void TagWitness::know_parents(const scene::Object& parent) {
  for (const scene::ObjectPtr& child : scene::children_of(parent)) {
    parent_.emplace(child.get(), &parent);
    know_parents(*child);
  }
}

int TagWitness::take() {
  const auto [it, added] = set_index_.try_emplace(now_, static_cast<int>(tags_.sets.size()));
  if (added) tags_.sets.emplace_back(now_.begin(), now_.end());
  parts_.take();
  const auto append = [](std::vector<float>& list, double x, double y, double z) {
    list.insert(list.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
  };
  const Surface s = seen_.value_or(Surface());
  append(tags_.surfaces.point, s.point.x, s.point.y, s.point.z);
  append(tags_.surfaces.normal, s.normal.x, s.normal.y, s.normal.z);
  append(tags_.surfaces.diffuse, s.diffuse.r, s.diffuse.g, s.diffuse.b);
  seen_.reset();
  now_.clear();
  depth_ = gathering_ = 0;
  return it->second;
}

void TagWitness::add(const std::string& kind, const std::string& name) {
  const auto [it, added] = index_.try_emplace({kind, name}, static_cast<int>(tags_.tags.size()));
  if (added) tags_.tags.push_back({kind, name});
  now_.insert(it->second);
}

void TagWitness::describe(const scene::Object& object, bool seen_directly, const shading::RayState& ray) {
  const std::string name = object_name(object);
  if (!seen_directly) {
    add("secondary object",
        with_place(object) + (ray.reflected ? ", in a reflection" : ", through something transparent"));
    return;
  }
  auto [found, added] = words_.try_emplace(&object);
  if (added) {
    WordPairs& words = found->second;
    words.emplace_back("object", name);
    words.emplace_back("copy", with_place(object));
    for (auto it = parent_.find(&object); it != parent_.end(); it = parent_.find(it->second))
      if (!std::holds_alternative<scene::LightGroup>(it->second->shape))
        words.emplace_back("parent", with_place(*it->second));
    words.emplace_back("shape", name.substr(0, name.find(' ')));
    Patterns(words).texture(object.texture);
    if (object.interior && !object.interior->media.empty()) words.emplace_back("feature", "media in the object");
    if (object.double_illuminate) words.emplace_back("feature", "double_illuminate");
    if (object.uv_mapping) words.emplace_back("feature", "uv_mapping");
    if (!object.clipped_by.empty()) words.emplace_back("feature", "clipped_by");
  }
  for (const auto& [kind, word] : found->second) add(kind, word);
}

void TagWitness::scene(const shading::SceneData& scene) { world_ = &scene.world; }

// Which of several surfaces in one place shows hangs on the order in which they are asked.
void TagWitness::describe_coincidence(const shading::RayState& ray, double t) {
  const std::vector<const scene::Object*> objects = world_->coincident(ray.ray, ray.kind(), t);
  if (objects.size() < 2) return;
  std::set<std::string> names;
  for (const scene::Object* object : objects) names.insert(placed_object_name(*object, origins_));
  add("coincidence", names.size() > 1 ? fmt::format("{}", fmt::join(names, " and ")) : "copies of " + *names.begin());
}

// What stands between the point that is seen and a light, nearest to the point, be it opaque or not.
void TagWitness::describe_caster(const shading::LightDirection& to_light) {
  constexpr double kNearest = 1e-3;
  if (!world_ || !seen_) return;
  shapes::Hit hit;
  const Ray ray{seen_->point, to_light.towards};
  if (!world_->intersect(ray, shapes::RayKind::shadow, kNearest, std::fabs(to_light.distance), hit)) return;
  if (hit.shape->surface && hit.shape->surface->object)
    add("caster", placed_object_name(*hit.shape->surface->object, origins_));
}

void TagWitness::ray_started(const shading::RayState& ray, const shapes::Hit* hit) {
  parts_.ray_started(ray, hit);
  ++depth_;
  if (ray.gather && gathering_ == 0) gathering_ = depth_;
  if (gathering_) return;
  const scene::Object* const seen = hit && hit->shape->surface ? hit->shape->surface->object : nullptr;
  if (depth_ == 1 && world_)
    for (const scene::Object* object : world_->passed(ray.ray, ray.kind(), hit ? hit->t : HUGE_VAL))
      add("passed object", with_place(*object));
  if (depth_ > 1) add("feature", ray.reflected ? "reflection" : "transparency and refraction");
  if (!hit) {
    add(depth_ == 1 ? "object" : "secondary object",
        depth_ == 1 ? "sky, background or nothing" : "sky or background by a secondary ray");
    return;
  }
  if (world_) describe_coincidence(ray, hit->t);
  if (seen) describe(*seen, depth_ == 1, ray);
}

void TagWitness::ray_ended(const shading::RayState& ray, const Color& color) {
  parts_.ray_ended(ray, color);
  if (gathering_ == depth_) gathering_ = 0;
  --depth_;
}

void TagWitness::layer(const shading::SurfaceHit& at, const shading::LayerContext& layer, const Rgb& reflectivity) {
  parts_.layer(at, layer, reflectivity);
  if (gathering_ || depth_ != 1) return;
  if (at.inside_hit) add("feature", "a surface seen from inside");
  if (!seen_) seen_ = Surface{at.hit.point, layer.normal, {}};
  seen_->diffuse += layer.filter * layer.pigment.rgb() * (layer.opacity * layer.layer.finish.diffuse);
}

void TagWitness::indirect(const char* effect, const Rgb& light) {
  parts_.indirect(effect, light);
  if (!gathering_ && light.max_abs() > 0) add("effect", effect);
}

void TagWitness::light(const shading::Light& light, const shading::LightDirection& direction, bool tested,
                       const Rgb& arriving, const Rgb& added, const Rgb& highlight) {
  parts_.light(light, direction, tested, arriving, added, highlight);
  if (gathering_ || depth_ != 1) return;
  if (tested) describe_caster(direction);
  const std::string name = light_name(light);
  if (added.max_abs() > 0)
    add("light", "lit by the " + name);
  else if (tested && arriving.max_abs() == 0)
    add("light", "in the shadow of the " + name);
}

}  // namespace verisim::cli
