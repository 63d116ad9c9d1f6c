// Camera rays of neighbouring pixels, shaded together: what most pixels of most scenes show, an opaque surface of one layer without mirrors, is worked on
// with wide instructions; every other hit takes the common way (Tracer::resolve). Both give the same bits.
#pragma once

#include "tracer/shading/tracer.h"
#include "tracer/shading/wave_kernels.h"

namespace verisim::shading {

class Wave {
 public:
  static constexpr int kMost = WaveLanes::kMost;

  explicit Wave(Tracer& tracer);

  // False: hits of this scene have to be shaded one after another (volumes, random numbers in order, an observer ...).
  bool usable() const { return usable_ && !tracer_.observer_ && !tracer_.pretrace_; }

  // camera.direction is to be filled first.
  WaveLanes& lanes() { return lanes_; }
  // Traces rays from a common origin, with the directions of the first lanes, through pixels (x, y), (x + 1, y) ...: `count` <= kMost colours.
  // Ray i enters the world at entries[i] (null: unknown).
  void trace(const Vec3& origin, double x, double y, int count, const accel::WorldEntry* const* entries, Color* out);

 private:
  // A texture as far as it decides which way its hits take.
  struct Material {
    const textures::CompiledTexture* texture = nullptr;
    const textures::CompiledLayer* layer = nullptr;  // null: the common way
    bool constant = false;                           // the pigment has one colour
    Color color;
    Rgb glow;                                        // ambient and emission
    double exponent = 0, amount = 0, base_limit = 0, phong = 0;
  };

  const Material& material(const textures::CompiledTexture& texture);
  bool add_surface(const shapes::Hit& hit, const Vec3& direction, int pixel);
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
  Material material_;   // the last one asked for
  int count_ = 0;       // of surfaces
  bool any_phong_ = false, any_blinn_ = false, any_metallic_ = false, tinted_ = false;
  WaveLanes lanes_;
  shapes::Hit hits_[kMost];
  bool found_[kMost], asked_[kMost];
  int pixel_[kMost];
  const textures::CompiledLayer* layer_[kMost] = {};  // whose constant numbers stand in the lane; null: those of one point
  const shapes::Surface* surface_[kMost];
  const scene::Finish* finish_[kMost];
};

}  // namespace verisim::shading
