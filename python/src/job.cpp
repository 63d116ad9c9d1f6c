#include "python/src/job.h"

#include <filesystem>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/src/errors.h"
#include "python/src/values.h"
#include "tracer/base/resident_memory.h"
#include "tracer/image/in_memory.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

// A property of the job that is a field of one of its groups.
template <class Group, class Value>
void field(py::class_<Job>& job, const char* name, Group Job::*group, Value Group::*member) {
  job.def_property(
      name, [=](const Job& j) { return j.*group.*member; },
      [=](Job& j, Value value) { (j.*group).*member = std::move(value); });
}
template <class Value>
void limit(py::class_<Job>& job, const char* name, Value parser::Limits::*member) {
  job.def_property(
      name, [=](const Job& j) { return j.parse.limits.*member; },
      [=](Job& j, Value value) { j.parse.limits.*member = value; });
}

}  // namespace

Parsed parse(const Job& job, const std::atomic<bool>& cancel) {
  Parsed out;
  parser::ParseOptions options = job.parse;
  options.width = job.render.width, options.height = job.render.height;
  options.quality = job.render.quality;
  options.limits.max_memory_bytes += resident_memory();  // what the program around it has is not the scene's
  options.debug = [&](const std::string& text) { out.debug += text; };
  options.message = [&](const parser::Diagnostic& d) {
    if (d.severity == parser::Severity::warning || d.severity == parser::Severity::possible_error)
      out.warnings.push_back(d);
  };
  options.cancelled = [&] { return cancel.load(std::memory_order_relaxed); };
  out.result = job.text ? parser::parse_text(*job.text, job.name, options) : parser::parse_file(job.name, options);
  if (cancel) throw Cancelled();
  if (!out.result.scene) throw SceneFailure(std::move(out.result.errors));
  return out;
}

image::OutputOptions output_options(const Job& job, const scene::Scene& scene) {
  const std::string title = std::filesystem::path(job.name).filename().string();
  image::OutputOptions output = image::output_options(scene);
  output.alpha = job.render.output_alpha;
  output.metadata["Software"] = "verisim " VERISIM_VERSION;
  output.metadata["Comment"] = "Rendered from " + title;
  output.metadata["Title"] = title;
  output.metadata["Switches"] = job.settings;
  return output;
}

void bind_job(py::module_& module) {
  py::class_<Job> job(module, "Job", "What is asked of the library.");
  job.def(py::init<>())
      .def_readwrite("name", &Job::name)
      .def_property(
          "text", [](const Job& j) { return j.text ? py::object(py::bytes(*j.text)) : py::none(); },
          [](Job& j, const py::bytes& text) { j.text = text; })
      .def_readwrite("settings", &Job::settings)
      .def("declare", [](Job& j, const std::string& name,
                         py::handle value) { j.parse.values.emplace_back(name, declared_value(name, value)); })
      .def("add_file", [](Job& j, const std::string& name, py::handle content) {
        j.parse.files[name] = memory_file(name, content);
      });
  field(job, "width", &Job::render, &render::Options::width);
  field(job, "height", &Job::render, &render::Options::height);
  field(job, "antialias", &Job::render, &render::Options::antialias);
  field(job, "antialias_threshold", &Job::render, &render::Options::antialias_threshold);
  field(job, "antialias_depth", &Job::render, &render::Options::antialias_depth);
  field(job, "antialias_method", &Job::render, &render::Options::sampling_method);
  field(job, "quality", &Job::render, &render::Options::quality);
  field(job, "alpha", &Job::render, &render::Options::output_alpha);
  field(job, "threads", &Job::render, &render::Options::threads);
  field(job, "seed", &Job::render, &render::Options::seed);
  field(job, "replay", &Job::render, &render::Options::replay);
  field(job, "path_samples", &Job::render, &render::Options::path_samples);
  job.def_property(
      "adaptive", [](const Job& j) { return j.render.sampler == render::Sampler::adaptive; },
      [](Job& j, bool adaptive) {
        j.render.sampler = adaptive ? render::Sampler::adaptive : render::Sampler::povray;
        j.render.block_size = adaptive ? 64 : 32;  // it looks at the pixels around a block: larger ones are cheaper
      });
  field(job, "include_path", &Job::parse, &parser::ParseOptions::library_paths);
  field(job, "folder", &Job::parse, &parser::ParseOptions::scene_folder);
  field(job, "allow_read", &Job::parse, &parser::ParseOptions::allow_read);
  field(job, "allow_write", &Job::parse, &parser::ParseOptions::allow_write);
  field(job, "clock", &Job::parse, &parser::ParseOptions::clock);
  field(job, "clock_on", &Job::parse, &parser::ParseOptions::clock_on);
  field(job, "frame", &Job::parse, &parser::ParseOptions::frame_number);
  field(job, "initial_frame", &Job::parse, &parser::ParseOptions::initial_frame);
  field(job, "final_frame", &Job::parse, &parser::ParseOptions::final_frame);
  field(job, "initial_clock", &Job::parse, &parser::ParseOptions::initial_clock);
  field(job, "final_clock", &Job::parse, &parser::ParseOptions::final_clock);
  field(job, "clock_delta", &Job::parse, &parser::ParseOptions::clock_delta);
  limit(job, "max_steps", &parser::Limits::max_steps);
  limit(job, "max_tokens", &parser::Limits::max_tokens);
  limit(job, "max_depth", &parser::Limits::max_depth);
  limit(job, "max_file_bytes", &parser::Limits::max_file_bytes);
  limit(job, "max_memory_bytes", &parser::Limits::max_memory_bytes);
}

}  // namespace verisim::python
