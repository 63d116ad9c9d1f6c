#include "cli/view/live_scene.h"

#include <cmath>
#include <regex>

#include <fmt/format.h>

namespace verisim::cli {

std::vector<Knob> knobs_of(const std::string& text) {
  static const std::regex pattern(R"(#(?:declare|local)[ \t]+([A-Za-z_]\w*)[ \t]*=)"
                                  R"([ \t]*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)[ \t]*;?)"
                                  R"([ \t]*//[ \t]*@range[ \t]+(\S+)[ \t]+(\S+)(?:[ \t]+([\d.eE+-]+))?)");
  std::vector<Knob> result;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::match_results<std::string::const_iterator> match;
    const auto first = text.begin() + static_cast<std::ptrdiff_t>(start);
    const auto last = text.begin() + static_cast<std::ptrdiff_t>(end);
    constexpr std::size_t kLongest = 400;  // std::regex goes deep on long lines
    if (end - start < kLongest && std::regex_search(first, last, match, pattern)) {
      Knob knob;
      knob.name = match[1], knob.value = std::strtod(match[2].str().c_str(), nullptr);
      knob.low = std::strtod(match[3].str().c_str(), nullptr), knob.high = std::strtod(match[4].str().c_str(), nullptr);
      if (match[5].matched) knob.step = std::strtod(match[5].str().c_str(), nullptr);
      knob.begin = start + static_cast<std::size_t>(match.position(2));
      knob.length = static_cast<std::size_t>(match.length(2));
      if (std::isfinite(knob.low) && std::isfinite(knob.high) && knob.low < knob.high) result.push_back(knob);
    }
    start = end + 1;
  }
  return result;
}

std::string turned(const std::string& text, const std::vector<Knob>& knobs,
                   const std::map<std::string, double>& values) {
  std::string result = text;
  for (auto knob = knobs.rbegin(); knob != knobs.rend(); ++knob)  // from the end: places before stay
    if (const auto value = values.find(knob->name); value != values.end())
      result.replace(knob->begin, knob->length,
                     fmt::format("{}", std::min(std::max(value->second, knob->low), knob->high)));
  return result;
}

}  // namespace verisim::cli
