// The seam between surface shading and what happens beyond surfaces: participating media, radiosity, photon maps,
// subsurface scattering.
//
// tracer/global implements it. A render has one Effects object, shared and immutable while tiles are rendered; whatever
// changes per thread lives in the state it makes for each Tracer. Shading asks only for what SceneData says is in use,
// so a scene without these features never comes here.
#pragma once

#include <memory>
#include <span>

#include "tracer/lights/light.h"
#include "tracer/shading/random.h"
#include "tracer/textures/texture.h"

namespace verisim::shading {

class Tracer;
struct RayState;
struct FinalGatherNotes;
struct SurfaceHit;

// One layer while it is being shaded.
struct LayerContext {
  const textures::CompiledLayer& layer;
  Color pigment;
  Vec3 normal;     // perturbed, towards the viewer or as the normal pattern made it
  double opacity;  // a_i of spec 06 3.3
  Rgb filter;      // F_i: what the layers above let through
};

// A ray on its way through media, up to a surface or, where `end` is null, for ever.
struct MediaSegment {
  Ray ray;
  double length;
  const shapes::Surface* end;
  RandomSource::Key key;  // of what it draws
  Color* color;           // seen at its end; then seen through the media
};

class EffectsState {
 public:
  virtual ~EffectsState() = default;
};

class Effects {
 public:
  virtual ~Effects() = default;
  virtual std::unique_ptr<EffectsState> make_state() const { return nullptr; }

  // Which hooks are in use.
  bool media_in_interiors = false, atmosphere = false, radiosity = false, photons = false, subsurface = false;
  bool importance_counts = false;  // radiosity, and something is of less importance than 1
  // What media of interiors, or of the air, do hangs on the random numbers that they draw.
  bool interior_draws_count = false, air_draws_count = false;

  // Media of the interiors the ray is inside, over its segment [0, length] that ends at a surface; changes r, g, b and
  // see-through (spec 07 4.2).
  virtual void container_media(Tracer&, const RayState&, double /*length*/, const shapes::Surface& /*end*/,
                               Color&) const {}
  // The same for several rays that are like `common` but for their ways and weights.
  virtual void container_media(Tracer&, const RayState& /*common*/, std::span<const MediaSegment>) const {}
  // Atmospheric media over any segment of a hollow ray; `end` is null when it hits nothing.
  virtual void atmosphere_media(Tracer&, const RayState&, double /*length*/, const shapes::Surface* /*end*/,
                                Color&) const {}
  // The same for several rays that are like `common` but for their ways and weights.
  virtual void atmosphere_media(Tracer&, const RayState& /*common*/, std::span<const MediaSegment>) const {}
  // The same on a shadow ray: attenuation only. `container`/`atmosphere`: which of the two act here.
  virtual void shadow_media(Tracer&, const RayState& /*shadow_ray*/, double /*length*/, bool /*container*/,
                            bool /*atmosphere*/, Rgb&) const {}

  // Indirect light to add to a layer: pigment, opacity and diffuse included, F_i not (spec 07 2.4). Called for every
  // layer from the top.
  virtual Rgb indirect_light(Tracer&, const RayState&, SurfaceHit&, const LayerContext&) const { return {}; }
  // Whether what a ray hits, or null, is of too little importance for a ray whose notes ask for some; they learn it.
  virtual bool unimportant(const shapes::Hit* /*hit*/, FinalGatherNotes&) const { return false; }
  // Light of stored photons on a layer (spec 07 3.10), F_i not included.
  virtual Rgb photon_light(Tracer&, const RayState&, SurfaceHit&, const LayerContext&) const { return {}; }
  // A shadow ray from an object that collects photons hits a photon target: true if the map replaces that light, so it
  // is blocked (spec 07 3.11).
  virtual bool photons_block(const shapes::Surface* /*lit*/, const shapes::Surface& /*occluder*/, const Light&) const {
    return false;
  }
  // Whether a finish's diffuse part is replaced, and by what (spec 07 5.2); F_i not included.
  virtual Rgb subsurface_light(Tracer&, const RayState&, SurfaceHit&, const LayerContext&) const { return {}; }
};

}  // namespace verisim::shading
