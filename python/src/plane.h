// Memory of a picture that numpy can look at without a copy.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace verisim::python {

// Read-only, by the buffer protocol and by __array_interface__.
struct Plane {
  std::shared_ptr<const void> owner;
  const void* data = nullptr;
  char kind = 'f';  // as numpy's typestr: f float, u unsigned integer
  pybind11::ssize_t item = 4;
  std::vector<pybind11::ssize_t> shape, strides;  // strides in bytes
};

pybind11::buffer_info buffer_of(const Plane& plane);
pybind11::dict array_interface_of(const Plane& plane);
// A numpy array over the plane's memory.
pybind11::object array_of(Plane plane);

void bind_plane(pybind11::module_& module);

}  // namespace verisim::python
