// diff(): how far one picture is from another.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "python/src/bindings.h"
#include "python/src/json.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

// Any of: a Picture, the name of a file, an array of uint8, uint16 or floats (linear light).
image::Picture samples(py::handle source) {
  if (py::isinstance<Picture>(source)) return samples_of(source.cast<const Picture&>());
  if (py::isinstance<py::str>(source) || py::hasattr(source, "__fspath__")) {
    const auto path = source.cast<std::filesystem::path>();
    const py::gil_scoped_release reading;
    return image::read_picture(path);
  }
  const auto array = py::array::ensure(source, py::array::c_style);
  if (!array) throw py::error_already_set();
  if (array.ndim() != 2 && array.ndim() != 3)
    throw py::value_error("a picture is an array of the shape (height, width) or (height, width, channels)");
  const char kind = array.dtype().kind();
  if (kind != 'f' && !(kind == 'u' && array.itemsize() <= 2))
    throw py::type_error("a picture is an array of uint8, uint16 or floats");
  image::Picture out{static_cast<int>(array.shape(1)),
                     static_cast<int>(array.shape(0)),
                     array.ndim() == 2 ? 1 : static_cast<int>(array.shape(2)),
                     kind == 'f',
                     array.itemsize() == 1 ? 8 : 16,
                     {}};
  if (out.channels < 1 || out.channels > 4) throw py::value_error("a picture has 1 to 4 channels");
  const py::array_t<float, py::array::c_style | py::array::forcecast> values(array);
  out.samples.assign(values.data(), values.data() + values.size());
  const float scale = out.is_float ? 1 : out.bits == 8 ? 1.0f / 255 : 1.0f / 65535;
  for (float& v : out.samples) v *= scale;
  return out;
}

// (figures, status, reason, heat map)
py::tuple diff(py::handle reference, py::handle test, bool antialiased, const compare::Thresholds& thresholds,
               double gain) {
  const image::Picture a = samples(reference), b = samples(test);
  compare::Metrics metrics;
  compare::Verdict verdict;
  PicturePtr heat_map;
  run(
      [&](Watch&) {
        metrics = compare::measure(a, b);
        verdict = thresholds.empty() ? compare::judge_deterministic(metrics, antialiased)
                                     : compare::judge_thresholds(metrics, thresholds);
        const NamedMemory file;
        compare::write_heat_map(a, b, file.path(), gain);
        heat_map = picture_of(image::read_picture(file.path()));
      },
      0, {py::none(), py::none()});
  return py::make_tuple(to_python(nlohmann::json::parse(compare::metrics_json(metrics))),
                        compare::to_string(verdict.status), verdict.reason, heat_map);
}

}  // namespace

void bind_diff(py::module_& module) {
  module.def("diff", &diff, py::arg("reference"), py::arg("picture"), py::arg("antialiased"), py::arg("thresholds"),
             py::arg("gain"));
}

}  // namespace verisim::python
