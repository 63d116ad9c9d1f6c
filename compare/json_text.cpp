#include "compare/json_text.h"

#include <istream>
#include <iterator>

#include <nlohmann/json.hpp>

namespace verisim::compare {
namespace {

template <class Json>
std::string text_of(const Json& json, int indent, typename Json::error_handler_t handler) {
  return json.dump(indent, ' ', false, handler);
}

template <class Json>
Json bounded(std::string_view text) {
  constexpr int kMaxLevels = 200;
  struct TooDeep {};
  const typename Json::parser_callback_t look = [](int depth, typename Json::parse_event_t, Json&) {
    if (depth > kMaxLevels) throw TooDeep();
    return true;
  };
  try {
    return Json::parse(text, look, false);
  } catch (const TooDeep&) {
    return Json(Json::value_t::discarded);
  }
}

std::string rest_of(std::istream& in) { return {std::istreambuf_iterator<char>(in), {}}; }

}  // namespace

std::string json_text(const nlohmann::json& json, int indent) {
  return text_of(json, indent, nlohmann::json::error_handler_t::replace);
}
std::string json_text(const nlohmann::ordered_json& json, int indent) {
  return text_of(json, indent, nlohmann::ordered_json::error_handler_t::replace);
}
std::string exact_json_text(const nlohmann::ordered_json& json, int indent) {
  return text_of(json, indent, nlohmann::ordered_json::error_handler_t::strict);
}

nlohmann::json parse_json(std::string_view text) { return bounded<nlohmann::json>(text); }
nlohmann::json parse_json(std::istream& in) { return parse_json(rest_of(in)); }
nlohmann::ordered_json parse_ordered_json(std::string_view text) { return bounded<nlohmann::ordered_json>(text); }
nlohmann::ordered_json parse_ordered_json(std::istream& in) { return parse_ordered_json(rest_of(in)); }

}  // namespace verisim::compare
