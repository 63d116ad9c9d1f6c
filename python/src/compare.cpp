// compare(): a scene rendered by POV-Ray and by verisim.
#include "compare/compare.h"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "cli/frame/scene_features.h"
#include "python/src/bindings.h"
#include "python/src/errors.h"
#include "python/src/json.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

// The job's scene as the comparison wants it rendered: from its private copy, as one of several runs.
compare::NativeResult render_copy(const Job& job, const compare::NativeRequest& request, Watch& watch) {
  compare::NativeResult out;
  Job copy = job;
  copy.name = request.scene.string();
  copy.text.reset();
  copy.parse.library_paths.insert(copy.parse.library_paths.end(), request.library_paths.begin(),
                                  request.library_paths.end());
  copy.parse.allow_write.push_back(request.folder);
  copy.render.seed = request.seed.value_or(static_cast<std::uint64_t>(request.run));
  try {
    const Parsed parsed = parse(copy, watch.cancel);
    out.files_read = parsed.result.files_read;
    out.stochastic_features = cli::stochastic_features(*parsed.result.scene, copy.render.quality);
    Picture picture;
    trace(copy, *parsed.result.scene, watch, picture);
    picture.output.bits = 16;  // as POV-Ray's: differences below a code value count, too
    image::write(picture.frame, request.output, picture.output);
    out.seconds = picture.statistics.seconds_compile + picture.statistics.seconds_render;
    out.outcome = compare::NativeResult::Outcome::rendered;
  } catch (const SceneFailure& failure) {
    const parser::Diagnostic& first = failure.diagnostics.at(0);
    if (first.severity == parser::Severity::unsupported) out.outcome = compare::NativeResult::Outcome::unsupported;
    out.message = parser::format(first);
  } catch (const std::exception& error) {
    out.message = error.what();
  }
  return out;
}

PicturePtr read(const std::filesystem::path& path) {
  return path.empty() ? nullptr : picture_of(image::read_picture(path));
}

// (report of the scene, POV-Ray's picture, ours, heat map, page)
py::tuple compare_job(const Job& job, const std::vector<std::string>& switches, bool use_cache,
                      const py::object& cancel) {
  compare::Run result;
  PicturePtr reference, picture, heat_map;
  std::string page;
  run(
      [&](Watch& watch) {
        compare::SceneRequest request;
        request.scene = std::filesystem::absolute(job.name);
        request.name = request.scene.filename().string();
        request.width = job.render.width, request.height = job.render.height;
        request.switches = switches;
        compare::RunOptions options;
        options.native = [&](const compare::NativeRequest& native) { return render_copy(job, native, watch); };
        options.oracle.use_cache = use_cache;
        options.native_version = VERISIM_VERSION;
        options.cancel = &watch.cancel;
        result = compare::run_suite({{request}, {}}, options);
        if (result.cancelled || watch.cancel) throw Cancelled();
        const compare::SceneResult& scene = result.scenes.at(0);
        reference = read(scene.oracle_picture), picture = read(scene.native_picture);
        if (reference && picture) {
          const NamedMemory file;
          compare::write_heat_map(samples_of(*reference), samples_of(*picture), file.path());
          heat_map = read(file.path());
        }
        page = compare::html_report(result);
      },
      job.render.threads, {py::none(), cancel});
  const nlohmann::json report = nlohmann::json::parse(compare::json_report(result));
  return py::make_tuple(to_python(report.at("scenes").at(0)), reference, picture, heat_map, to_text(page));
}

}  // namespace

void bind_compare(py::module_& module) {
  module.def("compare", &compare_job, py::arg("job"), py::arg("switches"), py::arg("use_cache"), py::arg("cancel"));
}

}  // namespace verisim::python
