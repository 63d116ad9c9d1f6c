// Pigment maps that objects before had, which decides what POV-Ray knows of images in them.
#pragma once

#include <unordered_set>

#include "tracer/textures/texture.h"

namespace verisim::textures {

// POV-Ray finds out that an image in an entry of a map filters when an object with the map is ready, after it has
// flagged that object: so it counts for the flags of all objects after it that share the map (spec 06 9.3).
class ReadyMaps {
 public:
  // Whether a texture that seems opaque loses the flag by such images. Not asked for textures without any.
  bool reveal(const scene::TexturePtr& texture, Compiler& compiler) const;
  // That of an object that is ready; or null.
  void add(const scene::TexturePtr& texture, Compiler& compiler);

 private:
  void add(const scene::Texture& texture);
  void add(const scene::Pigment& pigment);
  bool reveal(const scene::Pigment& pigment, Compiler& compiler) const;

  std::unordered_set<const void*> maps_;
};

}  // namespace verisim::textures
