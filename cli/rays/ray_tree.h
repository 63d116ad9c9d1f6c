// How one pixel came to be: its rays, what each meets, the lights there. As text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "parser/source/origins.h"
#include "tracer/shading/explain.h"
#include "tracer/shading/tracer.h"

namespace verisim::cli {

// One use for one pixel.
class RayTree : public shading::Observer {
 public:
  // Objects are called by their full names where their origins are known; they must outlive this.
  explicit RayTree(const parser::Origins* origins = nullptr) : origins_(origins) {}
  const std::string& lines() const { return lines_; }
  // {"rays": [ray ...]}; a ray: {"kind": camera|reflected|refracted|transmitted|gathering, "origin", "direction",
  // "weight", "distance" (null: it sees the sky), "crosses": [{"distance", "object"} ...], "layers": [{"object",
  // "point", "normal", "bumped", "pigment", "filter", "transmit", "above", "own", "reflects", "lights": [{"position",
  // "state": lit|shadow|behind|out of reach, "distance", "arrives", "adds", "highlight" (a part of what it adds),
  // "blocker", "blocked_at"} ...]} ...], "rays": those it sends out, "sum": [{"what", "adds", "layer" (an index),
  // "rays": [first, end]} ...], "color", "see_through"}; or {"kind": "cut off", "reason"}. Colours are linear. What the
  // terms of "sum" add is the colour.
  nlohmann::json json() const { return {{"rays", rays_}}; }

  void scene(const shading::SceneData& data) override { data_ = &data; }
  void ray_started(const shading::RayState& ray, const shapes::Hit* hit) override;
  void ray_ended(const shading::RayState&, const Color& color) override;
  void ray_cut_off(const shading::RayState& ray) override;
  void layer(const shading::SurfaceHit& at, const shading::LayerContext& layer, const Rgb& reflectivity) override;
  void light(const shading::Light& light, const shading::LightDirection& direction, bool tested, const Rgb& arriving,
             const Rgb& added, const Rgb& highlight) override;
  void indirect(const char* effect, const Rgb& light) override;
  void texture_started(float weight) override;
  void texture_ended() override;
  void rays_added(const Rgb& seen) override;
  void air(const Color& without, const Color& with, float passed) override;

 private:
  struct Open {  // a ray that has not ended
    nlohmann::json story;
    Vec3 direction, normal;
    std::vector<Rgb> weights;    // of textures that have started
    Rgb share;                   // of the latest layer in the ray's colour
    std::size_t rays_added = 0;  // that many of the rays sent out are in the sum
    Rgb sum;

    Rgb weight() const { return weights.empty() ? Rgb(1) : weights.back(); }
  };

  void line(const std::string& what);
  std::string name_of(const shapes::Surface* surface) const;
  const char* kind_of(const shading::RayState& ray) const;
  nlohmann::json crossings(const shading::RayState& ray);
  void put(nlohmann::json ray);
  void layer_term(const std::string& what, const Rgb& light);
  nlohmann::json* term(const std::string& what, const Rgb& adds, bool even_nothing = false);  // null: left out

  const parser::Origins* const origins_;
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
