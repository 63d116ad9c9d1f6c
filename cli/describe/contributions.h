// What the colour of a pixel is made of, in linear light: each light, highlights, mirrors, what shines through,
// indirect light, air. What two renderers make of a scene can so be told apart term by term.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compare/metrics/blame.h"
#include "tracer/shading/explain.h"

namespace verisim::cli {

// Terms overlap: what a light adds to a surface that is seen in a mirror belongs to the light and to "reflection".
class Contributions : public shading::Observer {
 public:
  explicit Contributions(std::string air) : air_(std::move(air)) {}  // the kind of the term that fog and media add
  void take();                                                       // the pixel is done
  std::vector<compare::PixelTags::Part> parts() const;               // all pixels, in the order they were taken

  void ray_started(const shading::RayState& ray, const shapes::Hit* hit) override;
  void ray_ended(const shading::RayState& ray, const Color& color) override;
  void layer(const shading::SurfaceHit& at, const shading::LayerContext& layer, const Rgb& reflectivity) override;
  void light(const shading::Light& light, const shading::LightDirection& direction, bool tested, const Rgb& arriving,
             const Rgb& added, const Rgb& highlight) override;
  void indirect(const char* effect, const Rgb& light) override;
  void texture_started(float weight) override;
  void texture_ended() override;
  void rays_added(const Rgb& seen) override;
  void air(const Color& without, const Color& with, float passed) override;

 private:
  using Key = std::pair<std::string, std::string>;  // kind and name
  struct Frame {                                    // of a ray
    std::map<Key, Rgb> terms;
    Rgb known, air, color;  // all terms of the surface but its own light; what the air adds; all
    std::vector<float> weights;
    Rgb filter{1};
    bool hit = false, reflected = false, gather = false;
    std::vector<Frame> rays;  // secondary ones, since the last rays_added
  };
  Rgb share(const Rgb& light) const;  // of the latest layer's light that arrives in front of its texture
  void add(const std::string& kind, const std::string& name, const Rgb& light);

  std::string air_;
  std::vector<Frame> open_;
  std::map<Key, Rgb> pixel_;
  std::size_t pixels_ = 0;
  std::map<Key, std::vector<float>> planes_;
};

// "area_light at <0, 5, 0>"
std::string light_name(const shading::Light& light);

}  // namespace verisim::cli
