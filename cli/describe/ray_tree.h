// How one pixel came to be: its rays, what each meets, the lights there. As text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tracer/shading/explain.h"
#include "tracer/shading/tracer.h"

namespace verisim::cli {

// One use for one pixel.
class RayTree : public shading::Observer {
 public:
  const std::string& lines() const { return lines_; }
  // {"rays": [ray ...]}; a ray: {"kind": camera|reflected|refracted|transmitted|gathering, "origin", "direction",
  // "weight", "distance" (null: it sees the sky), "crosses": [{"distance", "object"} ...], "layers": [{"object",
  // "point", "normal", "bumped", "pigment", "filter", "transmit", "above", "own", "reflects", "lights": [{"position",
  // "state": lit|shadow|behind|out of reach, "distance", "arrives", "adds", "blocker", "blocked_at"} ...]} ...],
  // "rays": those it sends out, "color", "see_through"}; or {"kind": "cut off", "reason"}. Colours are linear.
  nlohmann::json json() const { return {{"rays", rays_}}; }

  void scene(const shading::SceneData& data) override { data_ = &data; }
  void ray_started(const shading::RayState& ray, const shapes::Hit* hit) override;
  void ray_ended(const shading::RayState&, const Color& color) override;
  void ray_cut_off(const shading::RayState& ray) override;
  void layer(const shading::SurfaceHit& at, const shading::LayerContext& layer, const Rgb& reflectivity) override;
  void light(const shading::Light& light, const shading::LightDirection& direction, bool tested, const Rgb& arriving,
             const Rgb& added) override;

 private:
  struct Open {  // a ray that has not ended
    nlohmann::json story;
    Vec3 direction, normal;
  };

  void line(const std::string& what);
  const char* kind_of(const shading::RayState& ray) const;
  nlohmann::json crossings(const shading::RayState& ray);
  void put(nlohmann::json ray);

  const shading::SceneData* data_ = nullptr;
  std::string lines_;
  std::vector<Open> open_;
  nlohmann::json rays_ = nlohmann::json::array();
  Vec3 hit_point_;  // of the layer whose lights are told next
};

// Vectors and colours as the tree writes them; what is only rounding of 0 is 0.
std::string text(const Vec3& v);
std::string text(const Rgb& c);

}  // namespace verisim::cli
