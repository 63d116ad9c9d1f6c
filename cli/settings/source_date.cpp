#include "cli/settings/source_date.h"

#include <cerrno>
#include <cstdlib>

#include <fmt/format.h>

#include "cli/settings/options.h"

namespace verisim::cli {

std::optional<std::int64_t> source_date() {
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
  if (!epoch || !*epoch) return std::nullopt;
  constexpr std::int64_t kLatest = 253402300799;  // the end of the year 9999
  char* end = nullptr;
  errno = 0;
  const std::int64_t seconds = std::strtoll(epoch, &end, 10);
  if (errno != 0 || *end || seconds < 0 || seconds > kLatest)
    throw OptionError(fmt::format("SOURCE_DATE_EPOCH is to be seconds since 1970, not '{}'", epoch));
  return seconds;
}

}  // namespace verisim::cli
