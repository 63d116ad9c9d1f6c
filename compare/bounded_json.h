// JSON that others wrote: messages of clients, reports, parts, lists of pictures.
#pragma once

#include <utility>

#include <nlohmann/json.hpp>

namespace verisim::compare {

// A discarded value where it is no JSON, or nested deeper than anything of ours: values are copied and written by
// recursion, and a stack is not as deep as a file is long.
template <class Json = nlohmann::json, class Input>
Json bounded_json(Input&& input) {
  constexpr int kMaxLevels = 200;
  struct TooDeep {};
  const auto look = [](int depth, typename Json::parse_event_t, Json&) {
    if (depth > kMaxLevels) throw TooDeep();
    return true;
  };
  try {
    return Json::parse(std::forward<Input>(input), look, false);
  } catch (const TooDeep&) {
    return Json(Json::value_t::discarded);
  }
}

}  // namespace verisim::compare
