// Rays through the same media, side by side (spec 07 section 4.6). What one ray wants to know of densities and lights
// hangs on what it was told before; of many rays enough is evaluated at a time for whole batches.
#pragma once

#include "tracer/media/media_mixture.h"
#include "tracer/media/media_refinement.h"
#include "tracer/shading/tracer.h"

namespace verisim::global {

class MediaBatch {
 public:
  static constexpr std::size_t kMaxRays = RayBatch::kMax;

  // `common`: the rays but for their ways and weights. The environment is asked for photons only.
  MediaBatch(shading::Tracer& tracer, const shading::RayState& common, std::span<const CompiledMedia* const> media,
             MediaEnvironment& environment);

  // Whether the samples of these media draw no numbers and may be taken in any order.
  bool possible() const;
  // The results of at most kMaxRays rays, as integrate() gives them one by one. False in `done`: not found, because
  // numbers are drawn on the way to a light, or there were too many places to look at.
  void integrate(std::span<const shading::MediaSegment> rays, MediaResult* results, bool* done);

 private:
  struct Workspace;
  struct Question;

  void divide(std::span<const shading::MediaSegment> rays);
  void look_along();
  void refine();
  void ask(std::span<const Question> questions, MediaSample* samples);
  void find_scatterers(std::span<const Question> questions);
  void add_light(std::size_t number, std::span<const Question> questions);
  Rgb light_alone(const shading::Light& light, int lane, std::uint32_t ray, const Rgb& color);
  MediaSample refine_alone(std::uint32_t interval, const MediaSample& s1, double d1, const MediaSample& s3, double d3,
                           int level);
  MediaResult result(std::uint32_t ray);

  shading::Tracer& tracer_;
  const shading::RayState& common_;
  MediaMixture mixture_;
  MediaEnvironment& environment_;
  Workspace& workspace_;
};

}  // namespace verisim::global
