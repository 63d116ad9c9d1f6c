// What the module is made of: one function a subject.
#pragma once

#include <pybind11/pybind11.h>

#include "python/src/job.h"
#include "python/src/picture.h"
#include "python/src/run.h"

namespace verisim::python {

// Renders a parsed scene into the picture, whose layers say what is wanted. Throws SceneFailure and what
// render::render() does. Cancelled: Statistics::cancelled.
void trace(const Job& job, const scene::Scene& scene, Watch& watch, Picture& picture);

void bind_render(pybind11::module_& module);
void bind_check(pybind11::module_& module);
void bind_explain(pybind11::module_& module);
void bind_diff(pybind11::module_& module);
void bind_compare(pybind11::module_& module);

}  // namespace verisim::python
