#include "python/src/values.h"

#include <optional>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "parser/scene/shapes/mesh/mesh_arrays.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

constexpr int kLeastOfVector = 2, kMaxOfVector = 5;

// ---------------------------------------------------------------------------------------------- identifiers

bool is_array(py::handle value) {
  return py::hasattr(value, "__array_interface__") && py::hasattr(value, "ndim") && py::hasattr(value, "tolist");
}

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw py::type_error(fmt::format("declare['{}']: {}", name, why));
}

std::optional<double> number(py::handle value) {
  if (py::isinstance<py::str>(value) || !PyNumber_Check(value.ptr()) || py::hasattr(value, "__len__")) return {};
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred()) throw py::error_already_set();
  return number;
}

parser::DeclaredValue vector_of(const std::string& name, py::handle items) {
  std::vector<double> numbers;
  for (const py::handle item : items) {
    const std::optional<double> n = number(item);
    if (!n) refuse(name, "a vector is a tuple of numbers");
    numbers.push_back(*n);
  }
  if (numbers.size() < kLeastOfVector || numbers.size() > kMaxOfVector)
    refuse(name, fmt::format("a vector has 2 to 5 numbers, not {}; a list is an array", numbers.size()));
  return {std::move(numbers)};
}

// Lists within lists are the dimensions of one array, and must be of one shape.
void append(const std::string& name, py::handle items, std::size_t depth, parser::DeclaredArray& out) {
  const auto size = static_cast<int>(py::len(items));
  if (depth == out.sizes.size()) out.sizes.push_back(size);
  if (out.sizes[depth] != size) refuse(name, "the lists of an array have different lengths");
  for (const py::handle item : items) {
    const bool lists = out.sizes.size() > depth + 1;
    if (py::isinstance<py::list>(item) && (lists || out.elements.empty())) {
      append(name, item, depth + 1, out);
    } else {
      if (lists || py::isinstance<py::list>(item)) refuse(name, "an array holds lists, or values, not both");
      out.elements.push_back(declared_value(name, item));
    }
  }
}

// ---------------------------------------------------------------------------------------------- files

struct Array {
  py::array values;
  std::vector<int> shape;
};

Array array_of(const std::string& name, py::handle content) {
  Array out{py::array::ensure(content, py::array::c_style), {}};
  if (!out.values || out.values.ndim() < 2) {
    PyErr_Clear();
    throw py::type_error(fmt::format("files['{}']: bytes, str or an array of pixels or voxels is expected, not {}",
                                     name, py::str(py::type::of(content)).cast<std::string>()));
  }
  for (py::ssize_t i = 0; i < out.values.ndim(); ++i) {
    if (out.values.shape(i) < 1 || out.values.shape(i) > 1 << 30)
      throw py::value_error(fmt::format("files['{}']: the array has a side of {}", name, out.values.shape(i)));
    out.shape.push_back(static_cast<int>(out.values.shape(i)));
  }
  return out;
}

bool is_of(const py::array& array, char kind, py::ssize_t item) {
  return array.dtype().kind() == kind && array.itemsize() == item;
}

std::shared_ptr<const parser::MemoryFile> pixels(const std::string& name, const Array& array) {
  const std::vector<int>& shape = array.shape;
  const int channels = shape.size() == 2 ? 1 : shape[2];
  if (shape.size() > 3 || channels > 4)
    throw py::value_error(
        fmt::format("files['{}']: pixels have the shape (height, width) or (height, width, 1 to 4); voxels need a name "
                    "ending in .df3",
                    name));
  py::array values = array.values;
  image::SampleType type = image::SampleType::real;
  if (is_of(values, 'u', 1)) {
    type = image::SampleType::byte;
  } else if (is_of(values, 'u', 2)) {
    type = image::SampleType::word;
  } else if (values.dtype().kind() == 'f') {
    values = py::array_t<float, py::array::c_style | py::array::forcecast>(values);
  } else {
    throw py::type_error(
        fmt::format("files['{}']: pixels are uint8, uint16 (as in a PNG file) or floats (linear light), not {}", name,
                    py::str(values.dtype()).cast<std::string>()));
  }
  image::Samples samples(type, static_cast<std::size_t>(values.size()));
  std::memcpy(samples.as<unsigned char>(), values.data(), static_cast<std::size_t>(values.nbytes()));
  return std::make_shared<parser::MemoryFile>(image::PixelArray{shape[1], shape[0], channels, std::move(samples)});
}

std::shared_ptr<const parser::MemoryFile> voxels(const std::string& name, const Array& array) {
  if (array.shape.size() != 3) throw py::value_error(fmt::format("files['{}']: voxels have the shape (z, y, x)", name));
  scene::DensityFileParams out;
  for (int i = 0; i < 3; ++i) out.size[i] = array.shape[static_cast<std::size_t>(2 - i)];
  py::array values = array.values;
  if (values.dtype().kind() == 'f') {  // 0 to 1, as the pattern gives them
    const py::module_ numpy = py::module_::import("numpy");
    values = numpy.attr("rint")(numpy.attr("clip")(values, 0, 1).attr("astype")("float64") * py::float_(4294967295.0));
    out.bytes = 4;
  } else if (is_of(values, 'u', 1) || is_of(values, 'u', 2) || is_of(values, 'u', 4)) {
    out.bytes = static_cast<int>(values.itemsize());
  } else {
    throw py::type_error(fmt::format("files['{}']: voxels are uint8, uint16, uint32 or floats from 0 to 1, not {}",
                                     name, py::str(values.dtype()).cast<std::string>()));
  }
  const Indices numbers(values);
  out.samples = std::make_shared<const std::vector<std::uint32_t>>(numbers.data(), numbers.data() + numbers.size());
  return std::make_shared<parser::MemoryFile>(std::move(out));
}

// ---------------------------------------------------------------------------------------------- meshes

template <class Array>
auto rows_of(const Array& array, py::ssize_t each, const char* what) {
  if (array.ndim() != 2 || array.shape(1) != each)
    throw py::value_error(fmt::format("{} have the shape (n, {})", what, each));
  return std::span(array.data(), static_cast<std::size_t>(array.size()));
}

Mesh make_mesh(const Doubles& vertices, const Indices& faces, const std::optional<Doubles>& normals,
               const std::optional<Doubles>& uvs, const std::optional<Indices>& normal_faces,
               const std::optional<Indices>& uv_faces, const std::optional<std::array<double, 3>>& inside) {
  parser::MeshArrays arrays{rows_of(vertices, 3, "vertices"), rows_of(faces, 3, "faces")};
  if (normals) arrays.normals = rows_of(*normals, 3, "normals");
  if (uvs) arrays.uvs = rows_of(*uvs, 2, "uvs");
  if (normal_faces) arrays.normal_indices = rows_of(*normal_faces, 3, "normal_faces");
  if (uv_faces) arrays.uv_indices = rows_of(*uv_faces, 3, "uv_faces");
  std::optional<Vec3> inside_vector;
  if (inside) arrays.inside_vector = &inside_vector.emplace((*inside)[0], (*inside)[1], (*inside)[2]);
  const py::gil_scoped_release working;
  return {parser::object_of_mesh(arrays), arrays.vertices.size() / 3, arrays.faces.size() / 3};
}

}  // namespace

parser::DeclaredValue declared_value(const std::string& name, py::handle value) {
  if (py::isinstance<Mesh>(value)) return {value.cast<const Mesh&>().object};
  if (py::isinstance<py::str>(value)) return {value.cast<std::string>()};
  if (is_array(value)) {
    const auto dimensions = value.attr("ndim").cast<int>();
    if (dimensions == 1) return vector_of(name, value.attr("tolist")());
    if (dimensions > 2)
      refuse(name, "of arrays, those of one dimension are vectors and those of two are arrays of vectors");
    if (dimensions == 2) {
      parser::DeclaredArray rows;
      for (const py::handle row : value.attr("tolist")()) rows.elements.push_back(vector_of(name, row));
      rows.sizes = {static_cast<int>(rows.elements.size())};
      return {std::move(rows)};
    }
  }
  if (const std::optional<double> n = number(value)) return {*n};
  if (py::isinstance<py::tuple>(value)) return vector_of(name, value);
  if (py::isinstance<py::list>(value)) {
    parser::DeclaredArray array;
    append(name, value, 0, array);
    return {std::move(array)};
  }
  refuse(name,
         fmt::format(
             "a number, a string, a tuple (vector), a list (array), an array or a verisim.Mesh is expected, not {}",
             py::str(py::type::of(value)).cast<std::string>()));
}

std::shared_ptr<const parser::MemoryFile> memory_file(const std::string& name, py::handle content) {
  if (py::isinstance<py::bytes>(content) || py::isinstance<py::str>(content))
    return std::make_shared<parser::MemoryFile>(content.cast<std::string>());
  if (py::isinstance<py::bytearray>(content) || PyMemoryView_Check(content.ptr()))
    return std::make_shared<parser::MemoryFile>(
        py::bytes(py::reinterpret_steal<py::object>(PyBytes_FromObject(content.ptr()))));
  const Array array = array_of(name, content);
  return name.ends_with(".df3") ? voxels(name, array) : pixels(name, array);
}

void bind_values(py::module_& module) {
  py::class_<Mesh>(
      module, "Mesh",
      "An object that `mesh2 { ... }` of these arrays would be, for declare={NAME: mesh}; the scene writes `object "
      "{ NAME texture { ... } }`.")
      .def(py::init(&make_mesh), py::arg("vertices"), py::arg("faces"), py::kw_only(), py::arg("normals") = py::none(),
           py::arg("uvs") = py::none(), py::arg("normal_faces") = py::none(), py::arg("uv_faces") = py::none(),
           py::arg("inside") = py::none(),
           "vertices (n, 3); faces (m, 3), indices of vertices; normals (n, 3) and uvs (n, 2), of the vertices unless "
           "normal_faces and uv_faces (m, 3) say otherwise; inside: a vector, for a solid in CSG. Float64 and uint32 "
           "arrays are "
           "taken as they are, others are converted. Raises ValueError for wrong shapes and indices.")
      .def("__repr__", [](const Mesh& mesh) { return fmt::format("<verisim.Mesh of {} faces>", mesh.faces); })
      .def_readonly("vertices", &Mesh::vertices, "How many there are.")
      .def_readonly("faces", &Mesh::faces, "How many there are.");
}

}  // namespace verisim::python
