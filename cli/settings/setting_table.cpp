// The INI keywords that POV-Ray accepts, and what each does to the options.
#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "cli/settings/switches.h"
#include "cli/settings/text.h"
#include "cli/settings/values.h"

namespace verisim::cli {
namespace {

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

}  // namespace

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

namespace {

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

}  // namespace

std::span<const Setting> settings() { return kSettings; }

}  // namespace verisim::cli
