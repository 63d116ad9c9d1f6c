// check(): what `verisim check --dump` tells.
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "cli/describe/dump.h"
#include "cli/describe/scene_findings.h"
#include "python/src/bindings.h"
#include "python/src/errors.h"
#include "python/src/json.h"
#include "tracer/render/requirements.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

// (number of objects, warnings, text of #debug, files that were read)
py::tuple check_job(const Job& job, const py::object& cancel) {
  Parsed parsed;
  run(
      [&](Watch& watch) {
        parsed = parse(job, watch.cancel);
        for (parser::Diagnostic& d : cli::scene_findings(*parsed.result.scene)) parsed.warnings.push_back(std::move(d));
        try {
          render::check_supported(*parsed.result.scene, job.render);
        } catch (const render::Unsupported& missing) {
          throw SceneFailure({unsupported(missing, job.name)});
        }
      },
      job.render.threads, {py::none(), cancel});
  std::vector<std::string> files;
  for (const auto& file : parsed.result.files_read) files.push_back(file.string());
  return py::make_tuple(parsed.result.scene->objects.size(), diagnostics(parsed.warnings), to_text(parsed.debug),
                        files);
}

// All that the scene describes, which may be much more than its text.
py::object tree_of_job(const Job& job) {
  cli::SceneDump::Json tree;
  run([&](Watch& watch) { tree = cli::SceneDump().scene(*parse(job, watch.cancel).result.scene); }, job.render.threads,
      {py::none(), py::none()});
  return to_python(tree);
}

}  // namespace

void bind_check(py::module_& module) {
  module.def("check", &check_job, py::arg("job"), py::arg("cancel"));
  module.def("tree", &tree_of_job, py::arg("job"));
}

}  // namespace verisim::python
