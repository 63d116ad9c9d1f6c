#include "cli/settings/reading/switches.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "cli/settings/text.h"
#include "cli/settings/values.h"

namespace verisim::cli {
namespace {

// In POV-Ray's order of search (spec 02 section 9.6). "+F" is no INI keyword: see output_switch.
constexpr std::string_view kOutputSwitch = "+F";
constexpr auto kSwitches = std::to_array<Switch>({
    {"AG", "Antialias_Gamma", ""},
    {"AM", "Sampling_Method", ""},
    {"A0", "Antialias_Threshold", "Antialias"},
    {"A", "", "Antialias"},
    {"BM", "Bounding_Method", ""},
    {"BS", "Render_Block_Size", ""},
    {"B", "", "Bounding"},
    {"C", "", "Continue_Trace"},
    {"D", "Video_Mode", "Display"},
    {"D", "", "Display"},
    {"EC", "End_Column", ""},
    {"ER", "End_Row", ""},
    {"EF0", "Subset_End_Frame", ""},
    {"EF", "Subset_End_Frame", ""},
    {"EP", "Preview_End_Size", ""},
    {"F", kOutputSwitch, "Output_To_File"},
    {"F", "", "Output_To_File"},
    {"GA", "All_File", "All_Console"},
    {"GA", "", "All_Console"},
    {"GD", "Debug_File", "Debug_Console"},
    {"GD", "", "Debug_Console"},
    {"GF", "Fatal_File", "Fatal_Console"},
    {"GF", "", "Fatal_Console"},
    {"GI", "Create_Ini", ""},
    {"GP", "", "Append_File"},
    {"GR", "Render_File", "Render_Console"},
    {"GR", "", "Render_Console"},
    {"GS", "Statistic_File", "Statistic_Console"},
    {"GS", "", "Statistic_Console"},
    {"GW", "Warning_File", "Warning_Console"},
    {"GW", "", "Warning_Console"},
    {"HI", "Include_Header", ""},
    {"HR", "", "High_Reproducibility"},
    {"H", "Height", ""},
    {"I", "Input_File_Name", ""},
    {"J", "Jitter_Amount", "Jitter"},
    {"J", "", "Jitter"},
    {"KC", "", "Cyclic_Animation"},
    {"KI", "Initial_Clock", ""},
    {"KFF", "Final_Frame", ""},
    {"KFI", "Initial_Frame", ""},
    {"KF", "Final_Clock", ""},
    {"KLA", "", "Clockless_Animation"},
    {"K", "Clock", ""},
    {"L", "Library_Path", ""},
    {"MB", "Bounding_Threshold", "Bounding"},
    {"MB", "", "Bounding"},
    {"MI", "Max_Image_Buffer_Memory", ""},
    {"MV", "Version", ""},
    {"O", "Output_File_Name", ""},
    {"P", "", "Pause_When_Done"},
    {"Q", "Quality", ""},
    {"RFI", "", "Radiosity_From_File"},
    {"RFO", "", "Radiosity_To_File"},
    {"RF", "Radiosity_File_Name", ""},
    {"RVP", "", "Radiosity_Vain_Pretrace"},
    {"RS", "Render_Block_Step", ""},
    {"RP", "Render_Pattern", ""},
    {"RTR", "", "Real_Time_Raytracing"},
    {"R", "Antialias_Depth", ""},
    {"SC", "Start_Column", ""},
    {"SR", "Start_Row", ""},
    {"SF0", "Subset_Start_Frame", ""},
    {"SF", "Subset_Start_Frame", ""},
    {"SP", "Preview_Start_Size", ""},
    {"STP", "Frame_Step", ""},
    {"SU", "", "Split_Unions"},
    {"TH", "Dither_Method", "Dither"},
    {"TH", "", "Dither"},
    {"UA", "", "Output_Alpha"},
    {"UR", "", "Remove_Bounds"},
    {"UD", "", "Draw_Vistas"},
    {"UF", "", "Field_Render"},
    {"UL", "", "Light_Buffer"},
    {"UO", "", "Odd_Field"},
    {"UV", "", "Vista_Buffer"},
    {"V", "", "Verbose"},
    {"WL", "Warning_Level", ""},
    {"WT", "Work_Threads", ""},
    {"W", "Width", ""},
    {"X", "Test_Abort_Count", "Test_Abort"},
    {"X", "", "Test_Abort"},
});

const Setting* find_setting(std::string_view key) {
  const auto found = std::find_if(settings().begin(), settings().end(),
                                  [&](const Setting& s) { return equal_ignoring_case(s.key, key); });
  return found == settings().end() ? nullptr : &*found;
}

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

}  // namespace

std::span<const Switch> switches() { return kSwitches; }
bool is_setting(std::string_view key) { return find_setting(key) != nullptr; }

bool decides_picture(std::string_view key) {
  constexpr std::array kAside{"Append_File",    "Continue_Trace",         "Create_Ini",         "Display",
                              "Output_To_File", "Preview_End_Size",       "Preview_Start_Size", "Verbose",
                              "Frame_Step",     "Pause_When_Done",        "Subset_Start_Frame", "Subset_End_Frame",
                              "Work_Threads",   "Max_Image_Buffer_Memory"};
  const Setting* setting = find_setting(key);
  if (!setting || std::holds_alternative<NoEffect>(setting->target)) return false;
  const std::string_view name = setting->key;
  for (const std::string_view ending : {"_Console", "_File", "_Command", "_Return"})
    if (name.ends_with(ending) && !name.starts_with("Radiosity_")) return false;
  return std::find(kAside.begin(), kAside.end(), name) == kAside.end();
}

void set(Options& options, std::string_view key, std::string_view value) {
  if (key == kOutputSwitch) {
    output_switch(options, value);
    options.given.emplace_back("Output_File_Type", std::string(value.substr(0, 1)));
    return;
  }
  const Setting* setting = find_setting(key);
  if (!setting) {
    std::vector<std::string_view> keys;
    for (const Setting& s : settings()) keys.push_back(s.key);
    const std::string advice = nearest(key, keys);
    throw OptionError(
        fmt::format("unknown setting '{}'{}", key, advice.empty() ? "" : "; did you mean " + advice + "?"));
  }
  const std::string_view name = setting->key;
  try {
    std::visit(Overloaded{[&](bool Options::*p) { options.*p = to_bool(value); },
                          [&](int Options::*p) { options.*p = to_int(name, value); },
                          [&](double Options::*p) { options.*p = to_number(name, value); },
                          [&](std::string Options::*p) { options.*p = value; },
                          [&](std::optional<int> Options::*p) { options.*p = to_int(name, value); },
                          [&](std::optional<double> Options::*p) { options.*p = to_number(name, value); },
                          [&](Handler handler) { handler(options, value); }, [](const NoEffect&) {}},
               setting->target);
  } catch (const OptionError& error) {
    const std::string text = error.what();
    if (text.find(name) != std::string::npos) throw;
    throw OptionError(fmt::format("{}: {}", name, text));
  }
  options.given.emplace_back(name, value);
}

void apply_switch(Options& options, std::string_view word) {
  const bool on = word.front() == '+';
  const std::string_view body = word.substr(1);
  for (const Switch& entry : kSwitches) {
    if (!starts_with_ignoring_case(body, entry.name)) continue;
    const std::string_view rest = body.substr(entry.name.size());
    if (rest.empty() != entry.value_key.empty()) continue;
    if (!entry.flag_key.empty()) set(options, entry.flag_key, on ? "on" : "off");
    if (!entry.value_key.empty()) set(options, entry.value_key, rest);
    return;
  }
  std::vector<std::string_view> names;
  for (const Switch& entry : kSwitches) names.push_back(entry.name);
  const std::string letters(body.substr(0, std::min(body.find_first_of("0123456789.="), body.size())));
  std::string advice;
  if (starts_with_ignoring_case(body, "A") && body.size() > 1 &&
      (std::isdigit(static_cast<unsigned char>(body[1])) || body[1] == '.'))
    advice = "; a threshold is written with a leading zero, as in +A0.3";
  else if (const std::string name = letters.size() > 1 ? nearest(letters, names) : ""; !name.empty())
    advice = fmt::format("; did you mean {}{}?", word.front(), name);
  throw OptionError(fmt::format("unknown or incomplete switch '{}'{}", word, advice));
}

}  // namespace verisim::cli
