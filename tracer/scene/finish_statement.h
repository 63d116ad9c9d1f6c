// The part of finish_statement that concerns what is below an object whose own part is done: for children that were
// postponed (children.h).
#pragma once

#include "tracer/scene/object.h"

namespace verisim::scene {

void finish_children(Object& parent, const TexturePtr& default_texture);

}  // namespace verisim::scene
