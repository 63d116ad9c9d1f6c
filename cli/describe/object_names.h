// How an object is called in messages.
#pragma once

#include <string>

#include "tracer/scene/object.h"

namespace verisim::cli {

// The keyword of its shape: "sphere", "union" ...
const char* object_keyword(const scene::Object& object);
// Its keyword and where it was written: "sphere (scene.pov:12)".
std::string object_name(const scene::Object& object);

}  // namespace verisim::cli
