#include "cli/settings/frame_list.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "cli/settings/options.h"
#include "cli/settings/text.h"

namespace verisim::cli {
namespace {

// Takes a frame's number from the front of the text; false: there is none.
bool take_number(std::string_view& text, int& value) {
  const auto [end, bad] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (bad != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value >= 0;
}

bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

bool read(std::string_view text, FrameRange& range) {
  if (!take_number(text, range.first)) return false;
  range.last = range.first;
  if (take(text, '-') && !take_number(text, range.last)) return false;
  if (take(text, ':') && !take_number(text, range.step)) return false;
  return text.empty() && range.last >= range.first && range.step >= 1;
}

}  // namespace

std::vector<FrameRange> frame_list(const std::string& text) {
  std::vector<FrameRange> ranges;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    if (!read(trim(std::string_view(text).substr(at, comma - at)), ranges.emplace_back()))
      throw OptionError(
          fmt::format("--frames takes numbers of frames and ranges of them, as in 1-10 or 1-9:2,20; not '{}'", text));
    at = comma + 1;
  }
  return ranges;
}

}  // namespace verisim::cli
