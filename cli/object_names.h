// How an object is called in messages.
#pragma once

#include <string>

#include "tracer/scene/object.h"

namespace verisim::cli {

// Its keyword and where it was written: "sphere (scene.pov:12)".
std::string object_name(const scene::Object& object);

}  // namespace verisim::cli
