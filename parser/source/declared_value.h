// Values that a program gives to identifiers of a scene before it is read.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "tracer/scene/scene.h"

namespace verisim::parser {

struct DeclaredValue;

// An array of 1 to 5 dimensions; elements row by row, all of one kind.
struct DeclaredArray {
  std::vector<int> sizes;
  std::vector<DeclaredValue> elements;
};

// A float, a vector of 2 to 4 numbers or a colour of 5 (red, green, blue, filter, transmit), a string (UTF-8), an
// object (object_of_mesh, or one of another scene), or an array.
struct DeclaredValue {
  std::variant<double, std::vector<double>, std::string, scene::ObjectPtr, DeclaredArray> value;
};

}  // namespace verisim::parser
