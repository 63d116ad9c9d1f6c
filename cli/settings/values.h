// Values of settings as POV-Ray reads them (spec 02 section 9.3).
#pragma once

#include <optional>
#include <string_view>

namespace verisim::cli {

// The leading part that is a number counts, what follows it does not; empty when there is none.
std::optional<double> leading_number(std::string_view value);
// The number of a setting; `key` is named in the OptionError for a value that is none. to_int cuts the fraction off.
double to_number(std::string_view key, std::string_view value);
int to_int(std::string_view key, std::string_view value);
// Agreement with on, true, yes or 1 over the common length.
bool to_bool(std::string_view value);

}  // namespace verisim::cli
