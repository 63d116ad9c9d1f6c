#include "python/src/plane.h"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace verisim::python {
namespace {

std::string format_of(const Plane& plane) {
  if (plane.kind == 'f')
    return plane.item == 8 ? py::format_descriptor<double>::format() : py::format_descriptor<float>::format();
  return plane.item == 1 ? py::format_descriptor<std::uint8_t>::format()
                         : py::format_descriptor<std::uint32_t>::format();
}

}  // namespace

py::buffer_info buffer_of(const Plane& plane) {
  return {const_cast<void*>(plane.data),
          plane.item,
          format_of(plane),
          static_cast<py::ssize_t>(plane.shape.size()),
          plane.shape,
          plane.strides,
          true};
}

py::dict array_interface_of(const Plane& plane) {
  py::dict out;
  out["version"] = 3;
  out["shape"] = py::tuple(py::cast(plane.shape));
  out["strides"] = py::tuple(py::cast(plane.strides));
  out["typestr"] = (plane.item == 1 ? "|" : "<") + std::string(1, plane.kind) + std::to_string(plane.item);
  out["data"] = py::make_tuple(reinterpret_cast<std::uintptr_t>(plane.data), true);
  return out;
}

py::object array_of(Plane plane) { return py::module_::import("numpy").attr("asarray")(py::cast(std::move(plane))); }

void bind_plane(py::module_& module) {
  py::class_<Plane>(module, "Plane", py::buffer_protocol(), "Samples of a picture, by the buffer protocol.")
      .def_buffer([](Plane& plane) { return buffer_of(plane); })
      .def_property_readonly("__array_interface__", &array_interface_of);
}

}  // namespace verisim::python
