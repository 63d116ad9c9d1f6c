// Equal textures that objects are given are one. People and programs write the same texture in every pass of a loop:
// what is one here is moved, compiled and remembered once.
#pragma once

#include <vector>

#include "tracer/scene/texture.h"

namespace verisim::textures {

class TexturePool {
 public:
  // The texture, or one of the last few hundred that looks the same everywhere. Null stays null.
  scene::TexturePtr one(scene::TexturePtr texture);

 private:
  std::vector<scene::TexturePtr> last_;  // each in the place that its hash names
};

}  // namespace verisim::textures
