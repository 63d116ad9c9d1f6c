// What one thread's Tracer keeps for the global effects: scratch lists, the radiosity task, sequences of subsurface
// scattering.
#pragma once

#include <array>
#include <optional>

#include "tracer/effects/scene_effects.h"
#include "tracer/shading/wavefront/wavefront.h"

namespace verisim::global {

class EffectsStateOfScene : public shading::EffectsState {
 public:
  // Radiosity of the tile or phase being rendered; null: queries give nothing (photon shooting).
  std::optional<RadiosityTask> radiosity;
  std::array<std::unique_ptr<shading::Wavefront>, kMaxRadiosityDepth + 1>
      gather_wavefronts;                       // by gather_depth; made when they are needed
  std::optional<IrradianceCache> own_samples;  // of this tile, where the shared cache is read only

  // Photons around the hit that is being shaded, shared by its layers, and the hit they belong to.
  PhotonMap::Gathered gathered, gathered_in_media;
  const shading::SurfaceHit* gathered_for = nullptr;

  // Subsurface: one pair of cursors per nesting level (spec 07 5.3).
  struct SubsurfaceSequence {
    std::uint32_t halton = 0, stream = 0;
  };
  std::array<SubsurfaceSequence, kMaxSubsurfaceLevel + 1> subsurface;
  int subsurface_level = 0;

  static EffectsStateOfScene& of(shading::Tracer& tracer) {
    return static_cast<EffectsStateOfScene&>(*tracer.effects_state());
  }
};

}  // namespace verisim::global
