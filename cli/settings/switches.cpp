#include "cli/settings/switches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

#include "cli/settings/text.h"

namespace verisim::cli {
namespace {

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

// ------------------------------------------------------------------------------------------------ settings with a
// meaning of their own

image::Format to_format(char letter) {
  switch (letter) {
    case 'N':
    case 'n':
      return image::Format::png;
    case 'T':
    case 't':
      return image::Format::tga;
    case 'C':
    case 'c':
      return image::Format::tga_rle;
    case 'P':
    case 'p':
      return image::Format::ppm;
    case 'B':
    case 'b':
      return image::Format::bmp;
    case 'J':
    case 'j':
      return image::Format::jpeg;
    case 'E':
    case 'e':
      return image::Format::exr;
    case 'H':
    case 'h':
      return image::Format::hdr;
    default:
      break;
  }
  throw OptionError(
      fmt::format("Unrecognized output file format '{}' (Output_File_Type, +F): N PNG, T and C Targa, P PPM, B BMP, J "
                  "JPEG, E OpenEXR, H Radiance HDR",
                  letter));
}

void output_file_type(Options& options, std::string_view value) {
  if (value.empty()) throw OptionError("Output_File_Type needs a letter");
  options.format = to_format(value.front());
}

void bits_per_color(Options& options, std::string_view value) {
  options.bits = std::clamp(to_int("Bits_Per_Color", value), 5, 16);
}

// +FN16, +FPg: the letter, then g or the bits. Only the switch reads these; Output_File_Type takes the letter alone.
void output_switch(Options& options, std::string_view value) {
  output_file_type(options, value);
  const std::string_view rest = value.substr(1);
  if (rest.empty()) return;
  if (rest == "g" || rest == "G") {
    if (options.format != image::Format::png && options.format != image::Format::ppm)
      throw OptionError(fmt::format("+F{}: greyscale is for PNG and PPM", value));
    options.greyscale = true;
  } else if (rest.find_first_not_of("0123456789") == std::string_view::npos) {
    bits_per_color(options, rest);
  } else {
    throw OptionError(fmt::format("+F{}: after the letter comes g (greyscale) or the number of bits", value));
  }
}

void dither_method(Options& options, std::string_view value) {
  constexpr std::array<std::pair<std::string_view, image::Dither>, 6> kMethods{
      {{"B2", image::Dither::bayer2},
       {"B3", image::Dither::bayer3},
       {"B4", image::Dither::bayer4},
       {"D1", image::Dither::diffusion1d},
       {"D2", image::Dither::diffusion2d},
       {"FS", image::Dither::floyd_steinberg}}};
  for (const auto& [name, method] : kMethods)
    if (equal_ignoring_case(name, value)) {
      options.dither_method = method;
      return;
    }
  throw OptionError(fmt::format("Dither_Method (+TH) is one of B2 B3 B4 D1 D2 FS, not '{}'", value));
}

void file_gamma(Options& options, std::string_view value) {
  options.file_srgb = equal_ignoring_case(value, "sRGB");
  if (options.file_srgb) return;
  const double gamma = to_number("File_Gamma", value);
  if (!(gamma >= 0.001)) throw OptionError(fmt::format("File_Gamma must be positive, not {}", value));
  options.file_gamma = gamma;
}

// Names keep their first value; numbers pass through float and six digits, and what is no number is 0 (spec 02
// section 9.4).
void declare(Options& options, std::string_view value) {
  const std::size_t equals = value.find('=');
  const std::string name(trim(value.substr(0, equals)));
  const std::string_view text = equals == std::string_view::npos ? std::string_view() : trim(value.substr(equals + 1));
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (name.empty() || !letter(name.front()) ||
      !std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); }))
    throw OptionError(fmt::format("Declare={}: expected NAME=NUMBER or NAME=\"text\"", value));
  for (const auto& [known, unused] : options.declarations)
    if (known == name) return;
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
    options.declarations.emplace_back(name, std::string(text));
  else
    options.declarations.emplace_back(name,
                                      fmt::format("{:.6g}", static_cast<float>(leading_number(text).value_or(0))));
}

void library_path(Options& options, std::string_view value) {
  std::string path(value);
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  if (std::find(options.library_paths.begin(), options.library_paths.end(), path) == options.library_paths.end())
    options.library_paths.push_back(path);
}

// Console switches: the flag and the file of one stream. A word that means "yes" stands for the usual name.
template <TextStream Options::*Stream>
void console(Options& options, std::string_view value) {
  (options.*Stream).console = to_bool(value);
  if constexpr (Stream == &Options::all) options.all_given = true;
}

template <TextStream Options::*Stream>
void stream_file(Options& options, std::string_view value) {
  constexpr std::array<std::pair<TextStream Options::*, std::string_view>, 6> kNames{
      {{&Options::all, "alltext.out"},
       {&Options::debug, "debug.out"},
       {&Options::fatal, "fatal.out"},
       {&Options::render, "render.out"},
       {&Options::statistic, "stats.out"},
       {&Options::warning, "warning.out"}}};
  if (value.find('/') != std::string_view::npos)
    throw OptionError(fmt::format(
        "the name of a text stream's file must be without a path (it goes to the folder of the picture), not '{}'",
        value));
  const std::string text = lower(value);
  if (text == "on" || text == "true" || text == "yes" || text == "1") {
    for (const auto& [stream, name] : kNames)
      if (stream == Stream) (options.*Stream).file = name;
  } else if (text == "off" || text == "false" || text == "no" || text == "0") {
    (options.*Stream).file.clear();
  } else {
    (options.*Stream).file = value;
  }
}

template <ShellCommand Options::*Command>
void shell_command(Options& options, std::string_view value) {
  (options.*Command).command = value;
}

template <ShellCommand Options::*Command>
void shell_return(Options& options, std::string_view value) {
  ShellCommand& command = options.*Command;
  command.negated = !value.empty() && (value.front() == '!' || value.front() == '-');
  if (command.negated) value.remove_prefix(1);
  if (!value.empty() && std::string_view("ISAQUF").find(static_cast<char>(
                            std::toupper(static_cast<unsigned char>(value.front())))) != std::string_view::npos)
    command.action = static_cast<char>(std::toupper(static_cast<unsigned char>(value.front())));
  else
    command.action = 'I';
}

template <int Options::*Value, int kLow, int kHigh>
void clipped_int(Options& options, std::string_view value) {
  options.*Value = std::clamp(to_int("the value", value), kLow, kHigh);
}

template <double Options::*Value>
void clipped_fraction(Options& options, std::string_view value) {
  options.*Value = std::clamp(to_number("the value", value), 0.0, 1.0);
}

void bsp_cost(Options& options, std::string_view value) {
  if (leading_number(value).value_or(0) != 0)
    options.notes.push_back("BSP_* settings tune POV-Ray's BSP tree; verisim has its own and ignores them.");
}

void removed(Options& options, std::string_view) {
  options.notes.push_back(
      "Buffer_Output, Buffer_Size, Create_Histogram and Histogram_* no longer exist and are ignored.");
}

constexpr NoEffect kWindow{"there is no preview window"};
constexpr NoEffect kOldBuffers{"POV-Ray 3.7 ignores it, too"};

constexpr auto kSettings = std::to_array<Setting>({
    {"All_Console", console<&Options::all>},
    {"All_File", stream_file<&Options::all>},
    {"Antialias", &Options::antialias},
    {"Antialias_Depth", clipped_int<&Options::antialias_depth, 1, 9>},
    {"Antialias_Gamma", &Options::antialias_gamma},
    {"Antialias_Threshold", clipped_fraction<&Options::antialias_threshold>},
    {"Append_File", &Options::append_files},
    {"Bits_Per_Color", bits_per_color},
    {"Bits_Per_Colour", bits_per_color},
    {"Bounding", &Options::bounding},
    {"Bounding_Method", clipped_int<&Options::bounding_method, 1, 2>},
    {"Bounding_Threshold", &Options::bounding_threshold},
    {"BSP_BaseAccessCost", bsp_cost},
    {"BSP_ChildAccessCost", bsp_cost},
    {"BSP_ISectCost", bsp_cost},
    {"BSP_MaxDepth", bsp_cost},
    {"BSP_MissChance", bsp_cost},
    {"Buffer_Output", removed},
    {"Buffer_Size", removed},
    {"Clock", &Options::clock},
    {"Clockless_Animation", &Options::clockless},
    {"Compression", &Options::compression},
    {"Continue_Trace", &Options::continue_trace},
    {"Create_Histogram", removed},
    {"Create_Ini", &Options::create_ini},
    {"Cyclic_Animation", &Options::cyclic},
    {"Debug_Console", console<&Options::debug>},
    {"Debug_File", stream_file<&Options::debug>},
    {"Declare", declare},
    {"Display", &Options::display},
    {"Display_Gamma", kWindow},
    {"Dither", &Options::dither},
    {"Dither_Method", dither_method},
    {"Draw_Vistas", kOldBuffers},
    {"End_Column", &Options::end_column},
    {"End_Row", &Options::end_row},
    {"Fatal_Console", console<&Options::fatal>},
    {"Fatal_Error_Command", shell_command<&Options::fatal_error>},
    {"Fatal_Error_Return", shell_return<&Options::fatal_error>},
    {"Fatal_File", stream_file<&Options::fatal>},
    {"Field_Render", NoEffect{"POV-Ray 3.7 renders whole frames, too"}},
    {"File_Gamma", file_gamma},
    {"Final_Clock", &Options::final_clock},
    {"Final_Frame", &Options::final_frame},
    {"Frame_Step", clipped_int<&Options::frame_step, 1, 1 << 30>},
    {"Grayscale_Output", &Options::greyscale},
    {"Height", &Options::height},
    {"High_Reproducibility", NoEffect{"every render is reproducible"}},
    {"Histogram_Grid_Size", removed},
    {"Histogram_Name", removed},
    {"Histogram_Type", removed},
    {"Include_Header", &Options::include_header},
    {"Initial_Clock", &Options::initial_clock},
    {"Initial_Frame", &Options::initial_frame},
    {"Input_File_Name", &Options::input_file},
    {"Jitter", &Options::jitter},
    {"Jitter_Amount", clipped_fraction<&Options::jitter_amount>},
    {"Library_Path", library_path},
    {"Light_Buffer", kOldBuffers},
    {"Max_Image_Buffer_Memory", NoEffect{"pictures are kept in memory; --max-pixels limits their size"}},
    {"Odd_Field", NoEffect{"POV-Ray 3.7 renders whole frames, too"}},
    {"Output_Alpha", &Options::output_alpha},
    {"Output_File_Name", &Options::output_file},
    {"Output_File_Type", output_file_type},
    {"Output_To_File", &Options::output_to_file},
    {"Palette", kWindow},
    {"Pause_When_Done", &Options::pause},
    {"Post_Frame_Command", shell_command<&Options::post_frame>},
    {"Post_Frame_Return", shell_return<&Options::post_frame>},
    {"Post_Scene_Command", shell_command<&Options::post_scene>},
    {"Post_Scene_Return", shell_return<&Options::post_scene>},
    {"Pre_Frame_Command", shell_command<&Options::pre_frame>},
    {"Pre_Frame_Return", shell_return<&Options::pre_frame>},
    {"Pre_Scene_Command", shell_command<&Options::pre_scene>},
    {"Pre_Scene_Return", shell_return<&Options::pre_scene>},
    {"Preview_End_Size", &Options::preview_end},
    {"Preview_Start_Size", &Options::preview_start},
    {"Quality", clipped_int<&Options::quality, 0, 9>},
    {"Radiosity_File_Name", &Options::radiosity_file},
    {"Radiosity_From_File", &Options::radiosity_from_file},
    {"Radiosity_To_File", &Options::radiosity_to_file},
    {"Radiosity_Vain_Pretrace", NoEffect{"it only shows POV-Ray's pretrace in the preview window"}},
    {"Real_Time_Raytracing", &Options::real_time},
    {"Remove_Bounds", &Options::remove_bounds},
    {"Render_Block_Size", &Options::block_size},
    {"Render_Block_Step", NoEffect{"the order of blocks does not change the picture"}},
    {"Render_Console", console<&Options::render>},
    {"Render_File", stream_file<&Options::render>},
    {"Render_Pattern", NoEffect{"the order of blocks does not change the picture"}},
    {"Sampling_Method", clipped_int<&Options::sampling_method, 0, 2>},
    {"Split_Unions", &Options::split_unions},
    {"Start_Column", &Options::start_column},
    {"Start_Row", &Options::start_row},
    {"Statistic_Console", console<&Options::statistic>},
    {"Statistic_File", stream_file<&Options::statistic>},
    {"Subset_End_Frame", &Options::subset_end},
    {"Subset_Start_Frame", &Options::subset_start},
    {"Test_Abort", kOldBuffers},
    {"Test_Abort_Count", kOldBuffers},
    {"User_Abort_Command", shell_command<&Options::user_abort>},
    {"User_Abort_Return", shell_return<&Options::user_abort>},
    {"Verbose", &Options::verbose},
    {"Version", &Options::version},
    {"Video_Mode", kWindow},
    {"Vista_Buffer", kOldBuffers},
    {"Warning_Console", console<&Options::warning>},
    {"Warning_File", stream_file<&Options::warning>},
    {"Warning_Level", NoEffect{"POV-Ray 3.7 shows all warnings at every level, too"}},
    {"Width", &Options::width},
    {"Work_Threads", &Options::threads},
});

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
  const auto found = std::find_if(kSettings.begin(), kSettings.end(),
                                  [&](const Setting& s) { return equal_ignoring_case(s.key, key); });
  return found == kSettings.end() ? nullptr : &*found;
}

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

}  // namespace

std::span<const Setting> settings() { return kSettings; }
std::span<const Switch> switches() { return kSwitches; }
bool is_setting(std::string_view key) { return find_setting(key) != nullptr; }

bool to_bool(std::string_view value) {
  for (std::string_view word : {"on", "true", "yes", "1"}) {
    const std::size_t common = std::min(word.size(), value.size());
    if (equal_ignoring_case(word.substr(0, common), value.substr(0, common))) return true;
  }
  return false;
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
    for (const Setting& s : kSettings) keys.push_back(s.key);
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
