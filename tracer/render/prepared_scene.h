// A scene made ready once, to be rendered several times: at other sizes, in other windows, pixel by pixel.
#pragma once

#include "tracer/path/path_tracer.h"
#include "tracer/render/prepasses.h"
#include "tracer/render/render.h"

namespace verisim::render {

// What a render shows of a larger picture.
struct Window {
  int width = 0, height = 0;              // of the whole picture; 0: that of the options
  int left = 0, top = 0;                  // where the pixel (0, 0) of the options lies in it
  int focus_column = -1, focus_row = -1;  // the blocks nearest to this pixel come first; below 0: from the top
};

// What render() makes of a scene before it shoots rays. The scene must outlive it. Not for two threads at once.
class PreparedScene {
 public:
  // Of the options only those count that no picture of it may change: quality, output_alpha, bounding, path_samples
  // and path_bounces. Throws Unsupported.
  PreparedScene(const scene::Scene& scene, const Options& options);

  // As render::render(), of a picture or a window of one. The passes before the picture (photons, radiosity) are made
  // by the first call and serve all later ones.
  Statistics render(const Options& options, Framebuffer& frame, const Window& window = {});
  CameraModel camera(const Options& options, const Window& window = {});
  // The passes before the picture, if they are still to be made. `camera` is that of the picture.
  void run_prepasses(const CameraModel& camera, const Options& options, int threads);
  // A render was cancelled in the midst of the passes before the picture: no other may follow.
  bool spoilt() const { return passes_ == Passes::begun; }

  const shading::SceneData& data() const { return data_; }
  global::SceneEffects& effects() { return effects_; }
  textures::Compiler& compiler() { return compiler_; }

 private:
  enum class Passes : unsigned char { none, begun, done };

  textures::Compiler compiler_;
  accel::World world_;
  shading::SceneData data_;
  global::SceneEffects effects_;
  std::optional<path::PathScene> paths_;
  Passes passes_ = Passes::none;
};

}  // namespace verisim::render
