// How errors of the libraries reach Python: as the classes of verisim/errors.py.
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "parser/source/diagnostic.h"
#include "python/src/picture.h"
#include "tracer/film/errors.h"

namespace verisim::python {

// A scene that cannot be rendered: raised as SceneError, or Unsupported where that is all that is wrong.
struct SceneFailure : std::exception {
  explicit SceneFailure(std::vector<parser::Diagnostic> what_is_wrong) : diagnostics(std::move(what_is_wrong)) {}
  const char* what() const noexcept override { return "the scene has errors"; }
  std::vector<parser::Diagnostic> diagnostics;
};

// Somebody asked to stop: raised as Cancelled with what there is of the picture, or None.
struct Cancelled : std::exception {
  explicit Cancelled(PicturePtr what_is_done = nullptr) : picture(std::move(what_is_done)) {}
  const char* what() const noexcept override { return "cancelled"; }
  PicturePtr picture;
};

parser::Diagnostic unsupported(const render::Unsupported& missing, const std::string& scene_name);
// A list of verisim.Diagnostic.
pybind11::list diagnostics(const std::vector<parser::Diagnostic>& diagnostics);

void bind_errors(pybind11::module_& module);

}  // namespace verisim::python
