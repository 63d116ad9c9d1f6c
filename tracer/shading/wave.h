// Camera rays of neighbouring pixels, shaded together: what most pixels of most scenes show, an opaque surface of one layer without mirrors, is worked on
// with wide instructions; every other hit takes the common way (Tracer::resolve). Both give the same bits.
#pragma once

#include <optional>
#include <unordered_map>

#include "tracer/shading/tracer.h"
#include "tracer/shading/wave_kernels.h"
#include "tracer/textures/point_row.h"

namespace verisim::shading {

class Wave {
 public:
  static constexpr int kMost = WaveLanes::kMost;

  explicit Wave(Tracer& tracer);

  // False: hits of this scene have to be shaded one after another (volumes, random numbers in order, an observer ...).
  bool usable() const { return usable_ && !tracer_.observer_ && !tracer_.pretrace_; }

  // `camera` is to be filled first.
  WaveLanes& lanes() { return lanes_; }
  // Traces the rays of the first lanes, which go through pixels (x, y), (x + 1, y) ...: `count` <= kMost colours. The same objects are around all their origins.
  // Ray i enters the world at entries[i] (null: unknown).
  void trace(double x, double y, int count, const accel::WorldEntry* const* entries, Color* out);

 private:
  // A texture as far as it decides which way its hits take.
  struct Material {
    explicit Material(const textures::CompiledTexture& texture, const SceneData& scene);

    const textures::CompiledLayer* layer = nullptr;  // null: the common way
    bool constant = false;                           // the pigment has one colour
    Color color;
    Rgb glow;                                        // ambient and emission
    double exponent = 0, amount = 0, base_limit = 0, phong = 0;
  };

  // What a ray has met.
  struct Met {
    const Material* material;      // null: the common way
    std::optional<SurfaceHit> at;  // where the surface varies
    Vec3 normal;                   // the one to shade with
    Color color;
    bool colored;
  };

  const Material& material(const textures::CompiledTexture& texture);
  void meet(int i);
  void find_colors(int count);
  bool add_surface(int i);
  void light(const Light& light, const RayState& ray);
  void aim(const Light& light);
  bool reach(const Light& light, const RayState& ray);
  void cast_shadows(const Light& light, const RayState& ray);
  void respond();

  Tracer& tracer_;
  const SceneData& scene_;
  const WaveKernels& kernels_;
  bool usable_;
  Color sky_;           // where there is no sky_sphere
  bool plain_sky_;
  std::unordered_map<const textures::CompiledTexture*, Material> materials_;
  std::pair<const textures::CompiledTexture*, const Material*> last_material_{};
  int count_ = 0;       // of surfaces
  bool any_phong_ = false, any_blinn_ = false, any_metallic_ = false, tinted_ = false;
  WaveLanes lanes_;
  shapes::Hit hits_[kMost];
  Met met_[kMost];
  bool found_[kMost], asked_[kMost];
  int pixel_[kMost];
  const textures::CompiledLayer* layer_[kMost] = {};  // whose constant numbers stand in the lane; null: those of one point
  const shapes::Surface* surface_[kMost];
  const scene::Finish* finish_[kMost];
};

}  // namespace verisim::shading
