// explain(): how one pixel came to be.
#include "tracer/render/explain.h"

#include <pybind11/stl.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/describe/ray_tree.h"
#include "python/src/bindings.h"
#include "python/src/errors.h"
#include "python/src/json.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

// (rays, lines of text, linear colour, samples of a file of 8 bits)
py::tuple explain_pixel(const Job& job, double x, double y, const py::object& cancel) {
  cli::RayTree tree;
  nlohmann::json rays;
  Color color;
  image::Quantised stored;
  run(
      [&](Watch& watch) {
        const Parsed parsed = parse(job, watch.cancel);
        render::Options options = job.render;
        options.cancel = &watch.cancel;
        try {
          color = render::explain(*parsed.result.scene, options, x, y, tree);
        } catch (const render::Unsupported& missing) {
          throw SceneFailure({unsupported(missing, job.name)});
        } catch (...) {
          if (watch.cancel) throw Cancelled();
          throw;
        }
        render::Framebuffer pixel;
        pixel.width = pixel.height = 1;
        pixel.pixels = {color};
        stored = image::quantise(pixel, output_options(job, *parsed.result.scene));
        rays = tree.json()["rays"];
      },
      job.render.threads, {py::none(), cancel});
  return py::make_tuple(to_python(rays), tree.lines(), py::make_tuple(color.r, color.g, color.b),
                        py::tuple(py::cast(stored.samples)));
}

}  // namespace

void bind_explain(py::module_& module) {
  module.def("explain", &explain_pixel, py::arg("job"), py::arg("x"), py::arg("y"), py::arg("cancel"));
}

}  // namespace verisim::python
