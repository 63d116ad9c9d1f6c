// explain(): how one pixel came to be.
#include "tracer/render/explain.h"

#include <pybind11/stl.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/rays/ray_drawing.h"
#include "cli/rays/ray_tree.h"
#include "cli/rays/side_view.h"
#include "python/src/bindings.h"
#include "python/src/errors.h"
#include "python/src/json.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

// Sends the rays of one pixel, and gives the parsed scene and its colour to `then`.
template <class Then>
void ask_pixel(const Job& job, double x, double y, const py::object& cancel, cli::RayTree& tree, const Then& then) {
  run(
      [&](Watch& watch) {
        const Parsed parsed = parse(job, watch.cancel);
        render::Options options = job.render;
        options.cancel = &watch.cancel;
        try {
          then(*parsed.result.scene, render::explain(*parsed.result.scene, options, x, y, tree));
        } catch (const render::Unsupported& missing) {
          throw SceneFailure({unsupported(missing, job.name)});
        } catch (...) {
          if (watch.cancel) throw Cancelled();
          throw;
        }
      },
      job.render.threads, {py::none(), cancel});
}

// (rays, lines of text, linear colour, samples of a file of 8 bits)
py::tuple explain_pixel(const Job& job, double x, double y, const py::object& cancel) {
  cli::RayTree tree;
  Color color;
  image::Quantised stored;
  ask_pixel(job, x, y, cancel, tree, [&](const scene::Scene& scene, const Color& seen) {
    color = seen;
    render::Framebuffer pixel;
    pixel.width = pixel.height = 1;
    pixel.pixels.assign(1, seen);
    stored = image::quantise(pixel, output_options(job, scene));
  });
  return py::make_tuple(to_python(tree.json()["rays"]), to_text(tree.lines()),
                        py::make_tuple(color.r, color.g, color.b), py::tuple(py::cast(stored.samples)));
}

// SVG.
py::object draw_pixel(const Job& job, double x, double y, double azimuth, double elevation, const py::object& cancel) {
  cli::RayTree tree;
  std::string svg;
  ask_pixel(job, x, y, cancel, tree, [&](const scene::Scene& scene, const Color&) {
    const nlohmann::json rays = tree.json()["rays"];
    cli::DrawingStyle style{640, 480, {}, true};
    const cli::Viewpoint view = cli::viewpoint_of(cli::points_of(rays), azimuth, elevation, style.width, style.height);
    cli::Options options;
    options.width = job.render.width, options.height = job.render.height;
    style.picture = cli::data_address(cli::SideView(scene, options, job.render).png(view, style.width, style.height));
    svg = cli::ray_svg(rays, view, style);
  });
  return to_text(svg);
}

}  // namespace

void bind_explain(py::module_& module) {
  module.def("explain", &explain_pixel, py::arg("job"), py::arg("x"), py::arg("y"), py::arg("cancel"));
  module.def("draw", &draw_pixel, py::arg("job"), py::arg("x"), py::arg("y"), py::arg("azimuth"), py::arg("elevation"),
             py::arg("cancel"));
}

}  // namespace verisim::python
