// JSON of the program's reports as Python's dicts and lists.
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string_view>

namespace verisim::python {

// A scene's bytes need not be UTF-8.
inline pybind11::object to_text(std::string_view text) {
  return pybind11::reinterpret_steal<pybind11::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

template <class Json>
pybind11::object to_python(const Json& json) {
  namespace py = pybind11;
  switch (json.type()) {
    case Json::value_t::object: {
      py::dict out;
      for (const auto& [key, value] : json.items()) out[py::str(key)] = to_python(value);
      return out;
    }
    case Json::value_t::array: {
      py::list out;
      for (const auto& value : json) out.append(to_python(value));
      return out;
    }
    case Json::value_t::string:
      return to_text(json.template get_ref<const std::string&>());
    case Json::value_t::boolean:
      return py::bool_(json.template get<bool>());
    case Json::value_t::number_integer:
      return py::int_(json.template get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return py::int_(json.template get<std::uint64_t>());
    case Json::value_t::number_float:
      return py::float_(json.template get<double>());
    default:
      return py::none();
  }
}

}  // namespace verisim::python
