// The extension module verisim._core. What people use is the package around it, python/verisim.
#include <pybind11/pybind11.h>

#include "python/src/bindings.h"
#include "python/src/errors.h"
#include "python/src/plane.h"
#include "python/src/values.h"

PYBIND11_MODULE(_core, module) {
  using namespace verisim::python;
  module.doc() = "verisim's libraries for Python; use the package verisim.";
  module.attr("version") = VERISIM_VERSION;
  bind_errors(module);
  bind_plane(module);
  bind_picture(module);
  bind_values(module);
  bind_job(module);
  bind_render(module);
  bind_check(module);
  bind_explain(module);
  bind_diff(module);
  bind_compare(module);
}
