// Unbiased path tracing of a POV-Ray scene: the converged picture that radiosity, photons and media with many samples
// would approach. What a finish means as a scattering function is in docs/path-tracing.md.
#pragma once

#include <boost/container/small_vector.hpp>

#include "tracer/effects/scene_effects.h"
#include "tracer/path/emitters.h"
#include "tracer/path/sequence.h"
#include "tracer/shading/tracer.h"

namespace verisim::path {

// What all threads share.
struct PathScene {
  PathScene(const shading::SceneData& d, const global::SceneEffects& e, int most_bounces)
      : data(d), effects(e), emitters(d.scene), bounces(most_bounces) {}
  const shading::SceneData& data;
  const global::SceneEffects& effects;
  Emitters emitters;
  int bounces;
};

// One thread's paths. Befriended by shading::Tracer, whose rules for crossing surfaces and for shadows it shares.
class PathTracer {
 public:
  PathTracer(const PathScene& scene, shading::Tracer& tracer) : scene_(scene), tracer_(tracer) {}

  // The radiance of one path that starts with this camera ray (unit direction); t is 1 if it left the scene without
  // meeting anything.
  Color radiance(const Ray& ray, Sequence& sequence);

 private:
  // One layer of a hit, as the compositing equation weighs it (spec 06 3.3).
  struct Layer {
    const textures::CompiledLayer* layer;
    Color pigment;
    Vec3 normal;
    Rgb filter;  // of the layers above
    float opacity;
    Rgb reflectivity;  // of its mirror
    // Chances of the broad lobes: diffuse to the front and to the back, phong, specular.
    std::array<double, 4> share{};
  };
  using Layers = boost::container::small_vector<Layer, 4>;
  // The vertex a path continues from: what the next surface needs to weigh what it emits.
  struct Origin {
    bool direct = true;   // camera or mirror-like: emission counts in full
    double density = 0;   // of the direction that was taken, per solid angle
    double distance = 0;  // since that vertex
  };
  struct Walk {
    shading::RayState ray;
    Rgb weight{1};
    Origin origin;
    bool seen_directly = true;  // only mirrors and clear surfaces since the camera: fog and rainbows are seen
  };

  // Everything that happens between the ray's start and its end; false: the light was scattered, and the walk continues
  // from there.
  bool through_media(Walk& walk, double length, Sequence& sequence, Rgb& sum);
  void atmosphere(const Walk& walk, double length, Rgb& factor, Rgb& added);
  // Gathers the layers; returns what they emit, and in `through` what they let pass.
  Rgb layers_of(const shading::RayState& ray, shading::SurfaceHit& at, double choice, Layers& layers, Rgb& through);
  void gather_layers(const shading::RayState& ray, shading::SurfaceHit& at, const textures::CompiledTexture& texture,
                     const Vec3& p, shading::TextureFrames* frames, double choice, Layers& layers, Rgb& emitted,
                     Rgb& through);
  Rgb direct_light(const Walk& walk, shading::SurfaceHit& at, const Layers& layers, Sequence& sequence);
  Rgb light_source(const Walk& walk, shading::SurfaceHit& at, const Layers& layers, const shading::Light& light,
                   Sequence& sequence);
  Rgb emitter(const Walk& walk, shading::SurfaceHit& at, const Layers& layers, Sequence& sequence);
  // Radiance that reaches `from` from a chosen point of an emitter, over its density; `scattered(direction, density of
  // it as a continuation)` is asked for the share that goes on along the path.
  template <class Scattered>
  Rgb from_emitter(const shading::RayState& state, const Vec3& from, Sequence& sequence, Scattered&& scattered);
  // Chooses how the path goes on; false: it ends.
  bool scatter(Walk& walk, shading::SurfaceHit& at, const Layers& layers, const Rgb& through, Sequence& sequence);
  bool pass_through(Walk& walk, shading::SurfaceHit& at, const Layer& top, Sequence& sequence);
  void mirror(Walk& walk, const shading::SurfaceHit& at, const Layer& layer);
  // Reflected radiance over arriving radiance and solid angle, cosine included; and the density with which scatter()
  // takes the direction.
  Rgb response(const shading::RayState& ray, const shading::SurfaceHit& at, const Layers& layers,
               const Vec3& direction);
  static double density(const Vec3& view, const Layers& layers, const Vec3& direction);
  static double broad_share(const Layers& layers);

  // Visibility of a light source along a straight ray; media by ratio tracking.
  Rgb visible(const shading::RayState& eye, const shapes::Surface* lit, const shading::Light& light, const Vec3& p,
              const Vec3& towards, double distance, Rgb color, Sequence& sequence);

  const PathScene& scene_;
  shading::Tracer& tracer_;
};

// Throws render::Unsupported for what has no meaning as light transport (named, with its place).
void check_supported(const scene::Scene& scene);

}  // namespace verisim::path
