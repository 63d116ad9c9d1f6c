// Everything beyond surfaces that a scene uses, behind the one seam that shading knows (tracer/shading/effects.h).
#pragma once

#include <boost/container/small_vector.hpp>
#include <memory>
#include <unordered_map>
#include <vector>

#include "tracer/media/media.h"
#include "tracer/photons/photon_map.h"
#include "tracer/radiosity/radiosity.h"
#include "tracer/subsurface/subsurface.h"
#include "tracer/shading/effects.h"

namespace verisim::global {

// Media active on one interval; rarely more than a few.
using MediaList = boost::container::small_vector<const CompiledMedia*, 16>;

class SceneEffects : public shading::Effects {
 public:
  // `quality` below 9 switches everything off. The scene and the compiler must outlive this.
  SceneEffects(const scene::Scene& scene, textures::Compiler& compiler, int quality);

  bool any() const { return media_in_interiors || atmosphere || radiosity || photons || subsurface; }

  std::unique_ptr<shading::EffectsState> make_state() const override;
  void container_media(shading::Tracer&, const shading::RayState&, double length, const shapes::Surface& end,
                       Color&) const override;
  void container_media(shading::Tracer&, const shading::RayState& common,
                       std::span<const shading::MediaSegment>) const override;
  void atmosphere_media(shading::Tracer&, const shading::RayState&, double length, const shapes::Surface* end,
                        Color&) const override;
  void atmosphere_media(shading::Tracer&, const shading::RayState& common,
                        std::span<const shading::MediaSegment>) const override;
  void shadow_media(shading::Tracer&, const shading::RayState&, double length, bool container, bool atmosphere,
                    Rgb&) const override;
  // Of what a ray of radiosity hits, or of nothing.
  float importance_of(const shapes::Hit* hit) const;
  bool unimportant(const shapes::Hit* hit, shading::FinalGatherNotes& notes) const override;
  Rgb indirect_light(shading::Tracer&, const shading::RayState&, shading::SurfaceHit&,
                     const shading::LayerContext&) const override;
  Rgb photon_light(shading::Tracer&, const shading::RayState&, shading::SurfaceHit&,
                   const shading::LayerContext&) const override;
  bool photons_block(const shapes::Surface* lit, const shapes::Surface& occluder,
                     const shading::Light& light) const override;
  Rgb subsurface_light(shading::Tracer&, const shading::RayState&, shading::SurfaceHit&,
                       const shading::LayerContext&) const override;

  // Irradiance at any point, without a layer that asks for it (subsurface { radiosity on }); false: radiosity is not in
  // use here.
  bool raw_irradiance(shading::Tracer&, const shading::RayState&, const Vec3& point, const Vec3& normal,
                      Rgb& light) const;

  // ---- The passes that come before the picture; driven by render().
  const RadiositySettings* radiosity_settings() const { return radiosity_settings_.get(); }
  IrradianceCache& irradiance() { return *irradiance_; }
  // What blocks of the final trace add to it, when they are to be saved; by number of the block.
  std::vector<std::vector<IrradianceSample>>& block_samples() { return block_samples_; }
  PhotonMap& surface_photons() { return surface_photons_; }
  PhotonMap& media_photons() { return media_photons_; }
  const PhotonMap& media_photons() const { return media_photons_; }
  const scene::Scene& scene() const { return scene_; }
  std::span<const CompiledMedia* const> atmosphere_list() const { return atmosphere_list_; }

  // Media of an interior; empty if it has none.
  std::span<const CompiledMedia> media_of(const scene::Interior* interior) const;
  // All media active on an interval inside these interiors.
  void collect(std::span<const scene::Interior* const> interiors, MediaList& out) const;

 private:
  friend class EffectsStateOfScene;
  void add_object(const scene::Object& object, textures::Compiler& compiler);
  void add_interior(const scene::Interior* interior, textures::Compiler& compiler);
  const PhotonMap* photons_in_media(const shading::RayState& ray) const;
  void apply(shading::Tracer& tracer, const shading::RayState& ray, double length, const shapes::Surface* end,
             std::span<const CompiledMedia* const> media, Color& color) const;
  void apply(shading::Tracer& tracer, const shading::RayState& common, std::span<const shading::MediaSegment> segments,
             std::span<const CompiledMedia* const> media) const;

  const scene::Scene& scene_;
  std::unordered_map<const scene::Interior*, std::vector<CompiledMedia>> interior_media_;
  std::vector<CompiledMedia> atmosphere_;
  std::vector<const CompiledMedia*> atmosphere_list_;
  std::unique_ptr<RadiositySettings> radiosity_settings_;
  std::unique_ptr<IrradianceCache> irradiance_;
  std::vector<std::vector<IrradianceSample>> block_samples_;
  PhotonMap surface_photons_, media_photons_;
  SubsurfaceSettings subsurface_settings_;
};

}  // namespace verisim::global
