// Members of a description in the scene dump, under the names that its fields() gives them.
#pragma once

#include <type_traits>

#include <nlohmann/json.hpp>

#include "cli/describe/dump.h"
#include "tracer/base/fields.h"

namespace verisim::cli {

// `convert` makes JSON of a member; several that SDL writes as one item become an array.
template <class Description, class Convert>
void add_fields(SceneDump::Json& out, const Description& description, const Convert& convert) {
  description.fields([&](auto name, const auto&... members) {
    if constexpr (std::is_same_v<decltype(name), Unnamed>)
      return;
    else if constexpr (sizeof...(members) == 1)
      out[name] = (convert(members), ...);
    else
      out[name] = SceneDump::Json::array({convert(members)...});
  });
}

}  // namespace verisim::cli
