// render(): from a job to a picture.
#include "tracer/render/render.h"

#include <pybind11/stl.h>

#include "python/src/bindings.h"
#include "python/src/errors.h"
#include "python/src/job.h"
#include "python/src/picture.h"
#include "python/src/run.h"

namespace py = pybind11;

namespace verisim::python {

void trace(const Job& job, const scene::Scene& scene, Watch& watch, Picture& picture) {
  render::Options options = job.render;
  options.cancel = &watch.cancel;
  options.layers = &picture.layers;
  options.progress = [&](double done) { watch.progress = done; };
  try {
    picture.statistics = render::render(scene, options, picture.frame);
  } catch (const render::Unsupported& missing) {
    throw SceneFailure({unsupported(missing, job.name)});
  }
  picture.output = output_options(job, scene);
  quantise(picture);
}

namespace {

PicturePtr render_job(const Job& job, const std::vector<std::string>& layers, const py::object& on_progress,
                      const py::object& cancel) {
  auto picture = std::make_shared<Picture>();
  for (const std::string& layer : layers)
    (layer == "depth"    ? picture->layers.depth
     : layer == "normal" ? picture->layers.normal
     : layer == "albedo" ? picture->layers.albedo
                         : picture->layers.id) = true;
  picture->frame_number = job.parse.frame_number, picture->clock = job.parse.clock;
  run(
      [&](Watch& watch) {
        Parsed parsed = parse(job, watch.cancel);
        picture->warnings = std::move(parsed.warnings), picture->debug = std::move(parsed.debug);
        trace(job, *parsed.result.scene, watch, *picture);
        if (picture->statistics.cancelled) throw Cancelled(picture);
      },
      job.render.threads, {on_progress, cancel});
  return picture;
}

}  // namespace

void bind_render(py::module_& module) {
  module.def("render", &render_job, py::arg("job"), py::arg("layers"), py::arg("on_progress"), py::arg("cancel"));
}

}  // namespace verisim::python
