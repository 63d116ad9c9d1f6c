// Maps of normals and textures whose entries have `no_bump_scale`, though only another user of the map says so.
#pragma once

#include <unordered_set>

#include "tracer/scene/scene.h"

namespace verisim::textures {

// POV-Ray hands the flag down to the entries of maps, which all copies of what declares them share: it holds for all of
// them if one of them, in an object of the scene, has it (spec 05 10.1).
class MapsWithoutBumpScale {
 public:
  MapsWithoutBumpScale() = default;
  explicit MapsWithoutBumpScale(const scene::Scene& scene);
  template <class Map>
  bool contains(const std::shared_ptr<const Map>& map) const {
    return maps_.contains(map.get());
  }

 private:
  void add(const scene::Object& object);
  void add(const scene::Texture& texture, bool flagged);
  void add(const scene::Normal& normal, bool flagged);

  std::unordered_set<const void*> maps_;
  std::unordered_set<const void*> seen_[2];  // textures and normals, by whether what holds them has the flag
};

}  // namespace verisim::textures
