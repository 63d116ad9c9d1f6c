#include "cli/settings/reading/switch_help.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "cli/settings/text.h"
#include "cli/settings/values.h"

namespace verisim::cli {
namespace {

const char* title(Topic topic) {
  switch (topic) {
    case Topic::scene:
      return "The scene";
    case Topic::size:
      return "Size and part of the picture";
    case Topic::output:
      return "The picture's file";
    case Topic::quality:
      return "Anti-aliasing and radiosity files";
    case Topic::speed:
      return "Threads and bounding";
    case Topic::animation:
      return "Animation";
    case Topic::messages:
      return "Messages and their files";
    case Topic::commands:
      return "Commands of an INI file (only with --allow-shell)";
    case Topic::ignored:
      return "Accepted without effect";
  }
  return "";
}

// How a switch is written that sets the keyword: "+Wn", or "+A, -A" for one that turns it on and off; empty if it does
// not set it.
std::string spelling(const Switch& entry, const Setting& setting) {
  if (entry.value_key == setting.key) {
    // The digit belongs to the value that is written.
    const bool digit = !entry.name.empty() && entry.name.back() == '0';
    return "+" + std::string(entry.name) + (digit ? "." : "") + std::string(setting.value);
  }
  if (setting.key == "Output_File_Type" && entry.value_key == "+F") return "+Ft";
  if (entry.value_key.empty() && entry.flag_key == setting.key) return fmt::format("+{0} -{0}", entry.name);
  return {};
}

}  // namespace

HelpSection topic_help(Topic topic) {
  HelpSection section{title(topic), {}};
  for (const Setting& setting : settings()) {
    if (setting.topic != topic) continue;
    HelpEntry entry;
    for (const Switch& s : switches())
      if (std::string word = spelling(s, setting); !word.empty()) entry.spellings.push_back(std::move(word));
    entry.spellings.push_back(fmt::format("{}={}", setting.key, setting.value.empty() ? "on|off" : setting.value));
    const auto* none = std::get_if<NoEffect>(&setting.target);
    entry.meaning = setting.meaning.empty() && none ? none->reason : setting.meaning;
    section.entries.push_back(std::move(entry));
  }
  return section;
}

std::string povray_spelling(std::string_view option, std::string_view value) {
  // What other programs call it.
  constexpr auto kOtherNames = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"threads", "Work_Threads"},
      {"include", "Library_Path"},
      {"define", "Declare"},
      {"input", "Input_File_Name"},
      {"format", "Output_File_Type"},
      {"aa", "Antialias"},
      {"alpha", "Output_Alpha"},
      {"frames", "Final_Frame"},
  });
  while (option.starts_with('-')) option.remove_prefix(1);
  std::string name(option);
  std::replace(name.begin(), name.end(), '-', '_');
  for (const auto& [other, key] : kOtherNames)
    if (equal_ignoring_case(name, other)) name = key;
  if (equal_ignoring_case(name, "size") || equal_ignoring_case(name, "resolution")) {
    const std::size_t times = value.find_first_of("xX*,");
    const bool both = times != std::string_view::npos && times > 0;
    return fmt::format("+W{} +H{}", both ? value.substr(0, times) : "640", both ? value.substr(times + 1) : "480");
  }
  for (const Setting& setting : settings()) {
    if (!equal_ignoring_case(setting.key, name)) continue;
    const std::string_view given = !value.empty() ? value : setting.value.empty() ? "on" : setting.value;
    for (const Switch& s : switches())
      if (s.value_key == setting.key && s.name.find('0') == std::string_view::npos)
        return fmt::format("+{}{} or {}={}", s.name, given, setting.key, given);
      else if (s.value_key.empty() && s.flag_key == setting.key)
        return fmt::format("{}{} or {}={}", to_bool(given) ? "+" : "-", s.name, setting.key, given);
    return fmt::format("{}={}", setting.key, given);
  }
  return {};
}

}  // namespace verisim::cli
