#include "python/src/errors.h"

#include <nlohmann/json.hpp>

#include "cli/describe/diagnostics_json.h"
#include "compare/compare.h"
#include "python/src/json.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

py::object classes() { return py::module_::import("verisim.errors"); }

void raise(const char* class_name, const py::object& error) {
  PyErr_SetObject(classes().attr(class_name).ptr(), error.ptr());
}

void raise_scene_error(const SceneFailure& failure) {
  bool all_unsupported = true;
  for (const parser::Diagnostic& d : failure.diagnostics)
    all_unsupported &= d.severity == parser::Severity::unsupported;
  const char* name = all_unsupported ? "Unsupported" : "SceneError";
  raise(name, classes().attr(name)(diagnostics(failure.diagnostics)));
}

void raise_text(const char* name, const std::exception& error) { raise(name, classes().attr(name)(error.what())); }

}  // namespace

parser::Diagnostic unsupported(const render::Unsupported& missing, const std::string& scene_name) {
  parser::Diagnostic d;
  d.severity = parser::Severity::unsupported;
  d.code = parser::Code::unsupported;
  d.file = missing.place.file ? *missing.place.file : scene_name;
  d.line = missing.place.line, d.column = missing.place.column;
  d.message = missing.what();
  return d;
}

py::list diagnostics(const std::vector<parser::Diagnostic>& diagnostics) {
  py::list out;
  const py::object make = classes().attr("Diagnostic");
  for (const parser::Diagnostic& d : diagnostics)
    out.append(make(to_python(cli::as_json(d)), to_text(parser::format(d))));
  return out;
}

void bind_errors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      std::rethrow_exception(pointer);
    } catch (const SceneFailure& failure) {
      raise_scene_error(failure);
    } catch (const Cancelled& stopped) {
      raise("Cancelled", classes().attr("Cancelled")(stopped.picture));
    } catch (const render::LimitExceeded& error) {
      raise_text("LimitExceeded", error);
    } catch (const compare::OracleMissing& error) {
      raise_text("OracleMissing", error);
    } catch (const compare::PictureMismatch& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}

}  // namespace verisim::python
