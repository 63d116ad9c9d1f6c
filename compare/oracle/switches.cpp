#include "compare/oracle/switches.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "compare/compare.h"

namespace verisim::compare {
namespace {

std::string lower(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return std::tolower(c); });
  return s;
}

// "Key=Value" with the given key (lower case): its value.
std::optional<std::string> ini_value(const std::string& option, const std::string& key) {
  const auto equals = option.find('=');
  if (equals == std::string::npos || lower(option.substr(0, equals)) != key) return std::nullopt;
  return lower(option.substr(equals + 1));
}

bool is_switch(const std::string& s) {
  return s.size() > 1 && (s[0] == '+' || s[0] == '-') && s.find('=') == std::string::npos;
}

// True when the value and one of on, true, yes, 1 agree over their common length (spec 02 section 9.4).
bool truth(const std::string& value) {
  for (const std::string word : {"on", "true", "yes", "1"})
    if (const auto n = std::min(word.size(), value.size()); word.compare(0, n, value, 0, n) == 0) return true;
  return false;
}

}  // namespace

bool switch_on(const std::vector<std::string>& switches, char letter, const std::string& ini_key) {
  bool on = false;
  for (const std::string& s : switches) {
    if (const auto value = ini_value(s, ini_key)) on = truth(*value);
    // The letter alone or with a number: +A and +A0.3, not +AM2.
    if (is_switch(s) && std::toupper(static_cast<unsigned char>(s[1])) == letter &&
        (s.size() == 2 || std::isdigit(static_cast<unsigned char>(s[2]))))
      on = s[0] == '+';
  }
  return on;
}

bool alpha_on(const std::vector<std::string>& switches) {
  bool on = false;
  for (const std::string& s : switches) {
    if (const auto value = ini_value(s, "output_alpha")) on = truth(*value);
    if (is_switch(s) && lower(s.substr(1)) == "ua") on = s[0] == '+';
  }
  return on;
}

std::optional<char> output_type(const std::vector<std::string>& switches) {
  std::optional<char> type;
  for (const std::string& s : switches) {
    if (const auto value = ini_value(s, "output_file_type"); value && !value->empty())
      type = static_cast<char>(std::toupper((*value)[0]));
    if (is_switch(s) && std::toupper(static_cast<unsigned char>(s[1])) == 'F' && s.size() > 2)
      type = static_cast<char>(std::toupper(static_cast<unsigned char>(s[2])));
  }
  return type;
}

std::string output_extension(const std::vector<std::string>& switches) {
  switch (output_type(switches).value_or('N')) {
    case 'T':
    case 'C':
      return ".tga";
    case 'P':
      return ".ppm";
    case 'B':
      return ".bmp";
    case 'J':
      return ".jpg";
    case 'E':
      return ".exr";
    case 'H':
      return ".hdr";
    default:
      return ".png";
  }
}

std::vector<std::string> split_switches(const std::string& line) {
  std::vector<std::string> out;
  std::string word;
  char quote = 0;
  bool in_word = false;
  for (char c : line) {
    if (quote) {
      if (c == quote)
        quote = 0;
      else
        word += c;
    } else if (c == '"' || c == '\'') {
      quote = c, in_word = true;
    } else if (std::isspace(static_cast<unsigned char>(c))) {
      if (in_word) out.push_back(word);
      word.clear(), in_word = false;
    } else {
      word += c, in_word = true;
    }
  }
  if (quote) throw std::invalid_argument("a quote is left open in the switches: " + line);
  if (in_word) out.push_back(word);
  return out;
}

bool SceneRequest::antialiased() const { return switch_on(switches, 'A', "antialias"); }
bool SceneRequest::alpha() const { return alpha_on(switches); }

}  // namespace verisim::compare
