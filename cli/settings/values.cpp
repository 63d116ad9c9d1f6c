// Values of settings as POV-Ray reads them.
#include "cli/settings/values.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "cli/settings/options.h"
#include "cli/settings/text.h"

namespace verisim::cli {

// The leading part that is a number counts, what follows it does not (spec 02 section 9.3).
std::optional<double> leading_number(std::string_view value) {
  const std::string text(value.substr(0, 400));
  const char* begin = text.c_str();
  while (*begin == ' ') ++begin;
  // strtod would also take inf, nan and hexadecimal numbers.
  const char* digits = begin + (*begin == '+' || *begin == '-');
  if (!((*digits >= '0' && *digits <= '9') || (*digits == '.' && digits[1] >= '0' && digits[1] <= '9')))
    return std::nullopt;
  if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) return 0.0;
  return std::strtod(begin, nullptr);
}

double to_number(std::string_view key, std::string_view value) {
  if (const auto number = leading_number(value)) return *number;
  throw OptionError(fmt::format("{} needs a number, not '{}'", key, value));
}

int to_int(std::string_view key, std::string_view value) {
  const double number = std::trunc(to_number(key, value));
  if (!(std::fabs(number) <= std::numeric_limits<int>::max()))
    throw OptionError(fmt::format("{}={} is out of range", key, value));
  return static_cast<int>(number);
}
bool to_bool(std::string_view value) {
  for (std::string_view word : {"on", "true", "yes", "1"}) {
    const std::size_t common = std::min(word.size(), value.size());
    if (equal_ignoring_case(word.substr(0, common), value.substr(0, common))) return true;
  }
  return false;
}

}  // namespace verisim::cli
