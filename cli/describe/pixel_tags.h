// What a pixel shows, in words: the objects, patterns, lights and features that its rays meet. The comparison looks for
// those that wrong pixels have in common.
#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>

#include "compare/metrics/blame.h"
#include "tracer/shading/explain.h"

namespace verisim::cli {

class TagWitness : public shading::Observer {
 public:
  // Between two calls belongs to one pixel. Returns an index of PixelTags::sets.
  int take();
  compare::PixelTags& tags() { return tags_; }

  void ray_started(const shading::RayState& ray, const shapes::Hit* hit) override;
  void ray_ended(const shading::RayState& ray, const Color&) override;
  void layer(const shading::SurfaceHit& at, const shading::LayerContext& layer, const Rgb& reflectivity) override;
  void light(const shading::Light& light, const shading::LightDirection& direction, bool tested, const Rgb& arriving,
             const Rgb& added, const Rgb& highlight) override;

 private:
  void add(const std::string& kind, const std::string& name);
  void describe(const scene::Object& object, bool seen_directly, const shading::RayState& ray);

  compare::PixelTags tags_;
  std::map<std::pair<std::string, std::string>, int> index_;
  std::map<std::set<int>, int> set_index_;
  std::unordered_map<const scene::Object*, std::vector<std::pair<std::string, std::string>>>
      words_;  // of objects met before
  std::set<int> now_;
  int depth_ = 0, gathering_ = 0;
};

}  // namespace verisim::cli
