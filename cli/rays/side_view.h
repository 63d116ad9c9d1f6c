// A quick picture of a scene from anywhere, to lie behind the rays of a pixel: without shadows and reflections.
#pragma once

#include <memory>
#include <string>

#include "cli/rays/viewpoint.h"
#include "cli/settings/options.h"
#include "tracer/render/prepared_scene.h"

namespace verisim::cli {

class SideView {
 public:
  // The scene is copied (its parts are shared). `render` as for its picture. Throws render::Unsupported.
  SideView(const scene::Scene& scene, const Options& options, const render::Options& render);
  // A PNG file of the scene as seen from `view`, what is before its near plane cut away.
  std::string png(const Viewpoint& view, int width, int height);

 private:
  scene::Scene scene_;
  Options options_;
  render::Options render_;
  std::unique_ptr<render::PreparedScene> prepared_;
};

// `data:image/png;base64,...`
std::string data_address(const std::string& png);

}  // namespace verisim::cli
