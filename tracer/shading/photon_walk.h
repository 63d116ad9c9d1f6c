// The way of one photon through the scene (spec 07 sections 3.6 to 3.8).
#pragma once

#include <unordered_set>

#include "tracer/shading/tracer.h"

namespace verisim::shading {

// What a photon leaves behind; `energy` as the map stores it.
struct StoredPhoton {
  Vec3 point, towards_light;
  Rgb energy;
  bool media = false;
};

// Everything that is the same for all photons of one light and target.
struct PhotonShot {
  const scene::LightSource* light = nullptr;
  const std::unordered_set<const scene::Object*>* target = nullptr;  // the primitives of the target object
  double sigma = 0;  // spacing per unit of path length (parallel lights: absolute)
  int max_trace_level = 5;
  float adc_bailout = 0;
  // Flux through the area a photon stands for, at this path length from the light, as a factor of its colour (spec
  // 07 3.7).
  double area_factor(double path) const;
};

// Media on a photon's segment; implemented by tracer/global.
class PhotonMedia {
 public:
  virtual ~PhotonMedia() = default;
  // Multiplies the packet by the segment's transmittance and, if it has reached its target, deposits photons along it.
  // `path`: length before the segment.
  virtual void segment(Tracer& tracer, const RayState& ray, double length, double path, bool deposit,
                       const PhotonShot& shot, Rgb& packet, std::vector<StoredPhoton>& stored) const = 0;
};

class PhotonWalk {
 public:
  PhotonWalk(Tracer& tracer, const PhotonShot& shot, const PhotonMedia* media)
      : tracer_(tracer), shot_(shot), media_(media) {}
  // Follows a packet of this colour; `first`: what it meets first, or null; `around`: the interiors where it starts.
  // Appends to `stored`. Returns whether it hit the target.
  bool run(const Ray& start, const shapes::Hit* first, std::span<const scene::Interior* const> around, const Rgb& color,
           std::vector<StoredPhoton>& stored);
  // How near to its start a photon meets nothing.
  static constexpr double kNearestHit = 1e-4;

 private:
  struct Packet {
    RayState ray;
    Rgb color;
    double path = 0;       // length since the light
    bool reached = false;  // the target
    bool passed = false;   // directly after a pass_through object
  };
  struct Layer {
    Vec3 normal;
    Rgb reflectivity;
    float exponent, weight;  // `weight`: of what is reflected
  };
  // What becomes of a packet at a surface. Beyond the first segment every hit on an object that collects is stored,
  // before the surface filters the packet.
  struct Encounter {
    bool stores = false, refracts = false, reflects = false;
    bool scatters() const { return refracts || reflects; }
  };
  // What gets through a surface. Shares of textures do not count in weights.
  struct Passage {
    Rgb filter;  // with `share`
    float share, weight;
  };

  // Whether it goes on at all: if so, it is counted.
  bool goes_on(const Packet& packet);
  void follow(const Packet& packet);
  void meet(Packet packet, const shapes::Hit& hit);
  // Each of the textures that are blended there stores a photon of its share, and scatters one.
  void meet_texture(const Packet& packet, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p,
                    TextureFrames* frames, float share, const Encounter& what);
  void store(const Packet& packet, const Vec3& point, float share);
  // By the layers of a texture that is no pattern of others.
  void scatter(const Packet& packet, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p,
               TextureFrames* frames, float share, const Encounter& what);
  // These two return whether all or some of it was reflected totally.
  bool refract(const Packet& packet, SurfaceHit& at, const Vec3& normal, const Passage& through);
  bool bend(const Packet& packet, SurfaceHit& at, const Vec3& normal, const Passage& through,
            const Tracer::Refraction& refraction, double ratio, float wavelength);
  void reflect(const Packet& packet, SurfaceHit& at, const Vec3& normal, const Rgb& color, float weight);
  // A copy of the packet that starts at the hit in this direction, with its colour and weight reduced.
  static Packet child_of(const Packet& packet, const SurfaceHit& at, const Vec3& direction, const Rgb& color,
                         float weight);

  Tracer& tracer_;
  const PhotonShot& shot_;
  const PhotonMedia* media_;
  std::vector<StoredPhoton>* stored_ = nullptr;
  bool hit_target_ = false;
  int nesting_ = 0;
};

}  // namespace verisim::shading
