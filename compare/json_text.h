// JSON as text, and JSON that others wrote: messages of clients, reports, parts, lists of pictures. What that takes of
// the library is compiled in one place: elsewhere each file that wrote or read any took a second or two more.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace verisim::compare {

// On one line, or by lines that are indented by so many blanks a level. Names and messages may hold any bytes: what is
// no UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::json& json, int indent = -1);
std::string json_text(const nlohmann::ordered_json& json, int indent = -1);
// The same of what has to be read again as it is. Throws nlohmann::json::type_error where it is no UTF-8.
std::string exact_json_text(const nlohmann::ordered_json& json, int indent);

// A discarded value where it is no JSON, or nested deeper than anything of ours: values are copied and written by
// recursion, and a stack is not as deep as a file is long.
nlohmann::json parse_json(std::string_view text);
nlohmann::json parse_json(std::istream& in);  // all that is left in it
nlohmann::ordered_json parse_ordered_json(std::string_view text);
nlohmann::ordered_json parse_ordered_json(std::istream& in);

}  // namespace verisim::compare
