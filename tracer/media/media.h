// Participating media along one ray segment (spec 07 section 4).
//
// POV-Ray's estimators are biased at their defaults, and the bias is part of the picture: methods 1, 2 and 3 are
// followed step by step. With jitter 0, methods 2 and 3 are pure functions of the ray; the others draw from the
// environment's random stream in POV-Ray's order.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tracer/photons/photon.h"
#include "tracer/scene/texture.h"
#include "tracer/scene/light.h"
#include "tracer/textures/point_batch.h"
#include "tracer/textures/texture.h"

namespace verisim::global {

// One media{} statement, ready for sampling.
struct CompiledMedia {
  const scene::Media* description = nullptr;
  std::vector<const textures::CompiledPigment*> densities;  // empty: constant 1
  // The densities in the order they are asked for, what costs little first: where one is zero, the others need not be
  // known.
  std::vector<std::size_t> by_cost;
  Rgb extinction;                  // absorption + extinction factor * scattering, per scene unit
  bool varies = false;             // some density is not a plain colour
  bool last_density_plain = true;  // what POV-Ray looks at to call a medium constant on shadow rays (spec 07 4.6)
  bool emits = false, scatters = false;
  double density_bound = 1;  // no channel of the density is larger, as far as its maps tell
};
CompiledMedia compile_media(const scene::Media& description, textures::Compiler& compiler);
// The product of the medium's densities at p.
Rgb media_density(const CompiledMedia& media, const Vec3& p);
// The same at the first `count` points of a batch that is filled up.
void media_densities(const CompiledMedia& media, int count, const textures::PointBatch& points,
                     textures::RgbBatch& densities);

struct MediaMixture;

// Photons near a point in a medium; their colours are to be multiplied by `share`, one by the volume of the sphere that
// holds them.
struct NearbyPhotons {
  SomePhotons photons;
  float share = 0;
  // Adds what the media send of them along a view ray.
  void add_scattered(const MediaMixture& mixture, const Rgb& scattering, const Vec3& view, Rgb& sum) const;
};

// Whether media scatter the light of this source.
inline bool shines_on_media(const scene::LightSource& source) {
  return source.media_interaction && source.kind != scene::LightKind::shadowless;
}

// What the integrator asks of the tracer.
class MediaEnvironment {
 public:
  virtual ~MediaEnvironment() = default;
  virtual double random() = 0;  // the next number of the media stream, [0, 1)
  // POV-Ray's draws in POV-Ray's order: shadow rays are followed also where they cannot matter.
  virtual bool replay() const { return false; }
  // The lights that take part: media_interaction on, not shadowless; global ones unless the object at the segment's end
  // ignores them, then its group's.
  virtual std::span<const scene::LightSource* const> lights() = 0;
  // Light of number `light` that arrives at p after shadows; sets the unit direction towards it.
  virtual Rgb illumination(std::size_t light, const Vec3& p, Vec3& to_light) = 0;
  virtual NearbyPhotons photons(const Vec3& p) {
    (void)p;
    return {};
  }
};

struct MediaResult {
  Rgb emission;             // light added over the segment, already attenuated by what lies before it
  Rgb transmittance{1.0f};  // exp(-optical depth)
};

// All `media` act together over ray.at(0) .. ray.at(length), |direction| = 1. `shadow`: attenuation only, by the rules
// of shadow rays.
MediaResult integrate(std::span<const CompiledMedia* const> media, const Ray& ray, double length, bool shadow,
                      MediaEnvironment& environment);

// The interval of the segment [0, length] inside the light's cone or cylinder (spec 07 4.5); false: none.
bool lit_range(const scene::LightSource& light, const Ray& ray, double length, double& first, double& last);

// Phase function value for the cosine between the direction to the light and the view ray's direction (spec 07 4.4; no
// 1/(4 pi)).
double phase(const scene::Media& media, double cosine);
bool phase_is_constant(const scene::Media& media);  // it is 1

}  // namespace verisim::global
