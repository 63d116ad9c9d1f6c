// How an object is called in messages.
#pragma once

#include <string>

#include "parser/source/origins.h"
#include "tracer/scene/object.h"

namespace verisim::cli {

// The keyword of its shape: "sphere", "union" ...
const char* object_keyword(const scene::Object& object);
// Its keyword and where it was written: "sphere (scene.pov:12)".
std::string object_name(const scene::Object& object);
// With what tells it from others of the same place, too: "box 'Brick' (scene.pov:12, from line 30)", where the calls
// are those of macros and of object { Brick }.
std::string placed_object_name(const scene::Object& object, const parser::Origins& origins);
// And with its colour: "yellow box 'Brick' (scene.pov:12, from line 30)".
std::string full_object_name(const scene::Object& object, const parser::Origins& origins);
// The name that a person would give an opaque colour of linear light: "dark red".
std::string color_word(const Rgb& color);

}  // namespace verisim::cli
