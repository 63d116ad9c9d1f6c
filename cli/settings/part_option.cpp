#include "cli/settings/part_option.h"

#include <charconv>

#include <fmt/format.h>

#include "cli/settings/options.h"

namespace verisim::cli {

std::string PartChoice::name() const {
  return prepasses ? "the part with the prepasses" : fmt::format("part {} of {}", number, of);
}

PartChoice part_choice(const std::string& text) {
  constexpr int kMax = 1'000'000;
  PartChoice choice;
  if (text.empty()) return choice;
  choice.any = true;
  if (text == "prepass") {
    choice.prepasses = true;
    return choice;
  }
  const char* const end = text.data() + text.size();
  const auto [slash, bad_number] = std::from_chars(text.data(), end, choice.number);
  bool good = bad_number == std::errc() && slash != end && *slash == '/';
  if (good) {
    const auto [last, bad_count] = std::from_chars(slash + 1, end, choice.of);
    good = bad_count == std::errc() && last == end && choice.number >= 1 && choice.number <= choice.of &&
           choice.of <= kMax;
  }
  if (!good)
    throw OptionError(fmt::format("--part is K/N (part K of N, 1/4 to 4/4 for four parts) or prepass, not '{}'", text));
  return choice;
}

}  // namespace verisim::cli
