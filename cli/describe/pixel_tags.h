// What a pixel shows, in words: the objects, patterns, lights and features that its rays meet. The comparison looks for
// those that wrong pixels have in common.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>

#include "cli/describe/contributions.h"
#include "compare/metrics/blame.h"
#include "parser/source/origins.h"
#include "tracer/scene/scene.h"
#include "tracer/shading/explain.h"
#include "tracer/world/world.h"

namespace verisim::cli {

class TagWitness : public shading::Observer {
 public:
  TagWitness(const scene::Scene& scene, const parser::Origins& origins);
  // What happened between two calls belongs to one pixel. Returns an index of PixelTags::sets.
  int take();
  compare::PixelTags& tags() { return tags_; }

  void scene(const shading::SceneData& scene) override;
  void ray_started(const shading::RayState& ray, const shapes::Hit* hit) override;
  void ray_ended(const shading::RayState& ray, const Color&) override;
  void layer(const shading::SurfaceHit& at, const shading::LayerContext& layer, const Rgb& reflectivity) override;
  void light(const shading::Light& light, const shading::LightDirection& direction, bool tested, const Rgb& arriving,
             const Rgb& added, const Rgb& highlight) override;
  void indirect(const char* effect, const Rgb& light) override;
  void texture_started(float weight) override { parts_.texture_started(weight); }
  void texture_ended() override { parts_.texture_ended(); }
  void rays_added(const Rgb& seen) override { parts_.rays_added(seen); }
  void air(const Color& without, const Color& with, float passed) override { parts_.air(without, with, passed); }
  std::vector<compare::PixelTags::Part> parts() const { return parts_.parts(); }

 private:
  void add(const std::string& kind, const std::string& name);
  void describe(const scene::Object& object, bool seen_directly, const shading::RayState& ray);

  void describe_coincidence(const shading::RayState& ray, double t);
  void describe_caster(const shading::LightDirection& to_light);
  void know_parents(const scene::Object& parent);
  std::string with_place(const scene::Object& object) const;

  compare::PixelTags tags_;
  Contributions parts_;
  const parser::Origins& origins_;
  const accel::World* world_ = nullptr;
  std::unordered_map<const scene::Object*, const scene::Object*> parent_;
  std::map<std::pair<std::string, std::string>, int> index_;
  std::map<std::set<int>, int> set_index_;
  std::unordered_map<const scene::Object*, std::vector<std::pair<std::string, std::string>>>
      words_;  // of objects met before
  std::set<int> now_;
  struct Surface {
    Vec3 point{0.0}, normal{0.0};
    Rgb diffuse;
  };
  std::optional<Surface> seen_;  // of this pixel, by the camera's ray
  int depth_ = 0, gathering_ = 0;
};

}  // namespace verisim::cli
