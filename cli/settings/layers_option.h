// `--layers beauty,depth,normal,albedo,id`: what an OpenEXR file holds beside the picture.
#pragma once

#include <string>

#include "tracer/render/layers.h"

namespace verisim::cli {

struct LayerChoice {
  bool any = false;     // --layers was given
  bool beauty = false;  // the picture itself
  render::Layers layers;
};
// Throws OptionError for a name that does not exist, with the nearest one.
LayerChoice layer_choice(const std::string& list);

}  // namespace verisim::cli
