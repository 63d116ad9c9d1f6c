// The date of builds that are to be reproduced: SOURCE_DATE_EPOCH of reproducible-builds.org.
#pragma once

#include <cstdint>
#include <optional>

namespace verisim::cli {

// Seconds since 1970; nothing where the environment names none. Throws OptionError when it is no date.
std::optional<std::int64_t> source_date();

}  // namespace verisim::cli
