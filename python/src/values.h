// Python's values and arrays as what a scene can be given: identifiers, files, meshes.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "parser/source/declared_value.h"
#include "parser/source/memory_file.h"

namespace verisim::python {

// An object of a scene that was made from arrays.
struct Mesh {
  scene::ObjectPtr object;
  std::size_t vertices = 0, faces = 0;
};

// Numbers and booleans are floats; a tuple or an array of 2 to 5 numbers is a vector or a colour; a list is an array,
// and so is an array of n rows of 2 to 5 numbers: of n vectors. Strings are strings, a Mesh is an object. Raises
// TypeError and ValueError that name the identifier.
parser::DeclaredValue declared_value(const std::string& name, pybind11::handle value);
// bytes and strings as they are. Arrays: voxels (z, y, x) for names ending in .df3, else pixels, (height, width) or
// (height, width, 1 to 4), of uint8, uint16 or floats. Raises TypeError and ValueError that name the file.
std::shared_ptr<const parser::MemoryFile> memory_file(const std::string& name, pybind11::handle content);

void bind_values(pybind11::module_& module);

}  // namespace verisim::python
