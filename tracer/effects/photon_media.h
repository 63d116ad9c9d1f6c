// Media on the way of photons: attenuation, and photons left in scattering media (spec 07 section 3.8).
#pragma once

#include "tracer/effects/scene_effects.h"
#include "tracer/shading/photon_walk.h"

namespace verisim::global {

class ScenePhotonMedia : public shading::PhotonMedia {
 public:
  explicit ScenePhotonMedia(const SceneEffects& effects) : effects_(effects) {}
  void segment(shading::Tracer& tracer, const shading::RayState& ray, double length, double path, bool deposit,
               const shading::PhotonShot& shot, Rgb& packet, std::vector<shading::StoredPhoton>& stored) const override;

 private:
  // Leaves photons in `media` along the segment; returns what of the packet passes.
  Rgb deposit_along(shading::Tracer& tracer, std::span<const CompiledMedia* const> media, const Ray& ray, double length,
                    double path, const shading::PhotonShot& shot, const Rgb& packet,
                    std::vector<shading::StoredPhoton>& stored) const;

  const SceneEffects& effects_;
};

}  // namespace verisim::global
