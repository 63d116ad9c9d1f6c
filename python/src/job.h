// What Python asks for: a scene, what it is given, and how it is rendered.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "parser/parse.h"
#include "tracer/film/options.h"
#include "tracer/image/output.h"

namespace verisim::python {

struct Job {
  std::string name;                 // as messages call the scene; its file, where there is no text
  std::optional<std::string> text;  // bytes of the scene
  parser::ParseOptions parse;
  render::Options render;
  std::string settings;  // of a picture's file: what the program would have been called with
};

struct Parsed {
  parser::ParseResult result;
  std::vector<parser::Diagnostic> warnings;
  std::string debug;
};
// Throws SceneFailure, Cancelled.
Parsed parse(const Job& job, const std::atomic<bool>& cancel);
// How its pictures are written, if nothing else is asked.
image::OutputOptions output_options(const Job& job, const scene::Scene& scene);

void bind_job(pybind11::module_& module);

}  // namespace verisim::python
