// The INI keywords that POV-Ray accepts, and what each does to the options.
#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "cli/settings/reading/switches.h"
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
constexpr NoEffect kFields{"POV-Ray 3.7 renders whole frames, too"};
constexpr NoEffect kOrder{"the order of blocks does not change the picture"};

constexpr auto kSettings = std::to_array<Setting>({
    {"Input_File_Name", &Options::input_file, Topic::scene, "FILE",
     "the scene; .pov is added where it is missing; - reads standard input"},
    {"Include_Header", &Options::include_header, Topic::scene, "FILE",
     "a file that is read before the scene, as if it began with #include"},
    {"Library_Path", library_path, Topic::scene, "PATH",
     "a folder to look for scenes, include files and images in; may be given again"},
    {"Declare", declare, Topic::scene, "NAME=VALUE",
     "a number, or a text in double quotes, that the scene knows by this name"},
    {"Version", &Options::version, Topic::scene, "x",
     "the version of the language until the scene says #version, as 3.7"},
    {"Quality", clipped_int<&Options::quality, 0, 9>, Topic::scene, "n",
     "what is computed, 0 to 9 (9): 0 and 1 colours alone, 2 and 3 light, 4 shadows, 5 area lights, 6 and 7 "
     "transparency, 8 reflection and normals, 9 fog, media, photons, radiosity and light below surfaces"},
    {"Width", &Options::width, Topic::size, "n", "columns of the picture (160)"},
    {"Height", &Options::height, Topic::size, "n", "rows of the picture (120)"},
    {"Start_Column", &Options::start_column, Topic::size, "x",
     "first column to render, from 1; below 1: a fraction of the width"},
    {"Start_Row", &Options::start_row, Topic::size, "x",
     "first row to render, from 1; below 1: a fraction of the height"},
    {"End_Column", &Options::end_column, Topic::size, "x", "last column to render; up to 1: a fraction of the width"},
    {"End_Row", &Options::end_row, Topic::size, "x", "last row to render; up to 1: a fraction of the height"},
    {"Output_File_Name", &Options::output_file, Topic::output, "FILE",
     "the picture (the scene's name with another ending); a folder ends with /; - writes to standard output"},
    {"Output_To_File", &Options::output_to_file, Topic::output, "", "whether a picture is written at all (on)"},
    {"Output_File_Type", output_file_type, Topic::output, "t",
     "N PNG (default), E OpenEXR, H Radiance HDR, P PPM, T Targa, C Targa with run lengths, B BMP, J JPEG; the switch "
     "also takes the bits, as +FN16, or g for grey, as +FNg"},
    {"Bits_Per_Color", bits_per_color, Topic::output, "n", "bits of a channel in PNG and PPM, 5 to 16 (8)"},
    {"Bits_Per_Colour", bits_per_color, Topic::output, "n", "the same"},
    {"Output_Alpha", &Options::output_alpha, Topic::output, "", "store how transparent each pixel is (off)"},
    {"Grayscale_Output", &Options::greyscale, Topic::output, "", "one channel of grey, in PNG and PPM (off)"},
    {"Compression", &Options::compression, Topic::output, "n", "quality of a JPEG, 2 to 100 (85)"},
    {"File_Gamma", file_gamma, Topic::output, "g",
     "how values are encoded: sRGB (default), or a number, the exponent of a power law"},
    {"Dither", &Options::dither, Topic::output, "", "hide the steps between colours of few bits (off)"},
    {"Dither_Method", dither_method, Topic::output, "m",
     "FS Floyd-Steinberg (default), D1, D2 simpler diffusions of the error, B2, B3, B4 ordered patterns"},
    {"Continue_Trace", &Options::continue_trace, Topic::output, "",
     "go on with a render that was broken off; finished pictures are left alone (off)"},
    {"Create_Ini", &Options::create_ini, Topic::output, "FILE", "write the settings of this call into an INI file"},
    {"Antialias", &Options::antialias, Topic::quality, "", "more than one ray for pixels at edges (off)"},
    {"Antialias_Threshold", clipped_fraction<&Options::antialias_threshold>, Topic::quality, "x",
     "neighbours that differ by more are sampled again, 0 to 1 (0.3); the switch needs the zero: +A0.1"},
    {"Antialias_Depth", clipped_int<&Options::antialias_depth, 1, 9>, Topic::quality, "n",
     "n by n rays for such a pixel, or by method 2 up to 4^n, 1 to 9 (3)"},
    {"Sampling_Method", clipped_int<&Options::sampling_method, 0, 2>, Topic::quality, "n",
     "1 a fixed grid (default), 2 adaptive and recursive, 0 none"},
    {"Antialias_Gamma", &Options::antialias_gamma, Topic::quality, "x",
     "the exponent by which neighbours are compared (2.5)"},
    {"Jitter", &Options::jitter, Topic::quality, "", "move the rays of anti-aliasing a little (on)"},
    {"Jitter_Amount", clipped_fraction<&Options::jitter_amount>, Topic::quality, "x", "how far, 0 to 1 (1)"},
    {"Radiosity_To_File", &Options::radiosity_to_file, Topic::quality, "",
     "keep the radiosity samples in a file (off)"},
    {"Radiosity_From_File", &Options::radiosity_from_file, Topic::quality, "",
     "begin with the radiosity samples of a file (off)"},
    {"Radiosity_File_Name", &Options::radiosity_file, Topic::quality, "FILE", "that file (object.rca)"},
    {"Work_Threads", &Options::threads, Topic::speed, "n",
     "threads (one for each core); the picture is the same for any number"},
    {"Render_Block_Size", &Options::block_size, Topic::speed, "n",
     "side of the squares that threads take in turn, from 4 on (32)"},
    {"Bounding", &Options::bounding, Topic::speed, "",
     "a hierarchy of boxes around the objects (on); it only costs time to do without"},
    {"Bounding_Threshold", &Options::bounding_threshold, Topic::speed, "n", "objects from which on there is one (3)"},
    {"Bounding_Method", clipped_int<&Options::bounding_method, 1, 2>, Topic::speed, "n",
     "POV-Ray's boxes (1) or BSP tree (2); verisim takes a tree of its own for both"},
    {"Remove_Bounds", &Options::remove_bounds, Topic::speed, "", "drop bounded_by where the own box is as good (on)"},
    {"Split_Unions", &Options::split_unions, Topic::speed, "", "drop bounded_by of unions, too (off)"},
    {"Clock", &Options::clock, Topic::animation, "x", "the value of clock in a single picture (0)"},
    {"Initial_Frame", &Options::initial_frame, Topic::animation, "n", "number of the first frame (1)"},
    {"Final_Frame", &Options::final_frame, Topic::animation, "n",
     "number of the last frame; more than 1 makes an animation"},
    {"Initial_Clock", &Options::initial_clock, Topic::animation, "x", "clock of the first frame (0)"},
    {"Final_Clock", &Options::final_clock, Topic::animation, "x", "clock of the last frame (1)"},
    {"Subset_Start_Frame", &Options::subset_start, Topic::animation, "x",
     "the first frame to render; between 0 and 1: a fraction of all"},
    {"Subset_End_Frame", &Options::subset_end, Topic::animation, "x",
     "the last frame to render; between 0 and 1: a fraction of all"},
    {"Frame_Step", clipped_int<&Options::frame_step, 1, 1 << 30>, Topic::animation, "n",
     "render only every n-th frame (1)"},
    {"Cyclic_Animation", &Options::cyclic, Topic::animation, "",
     "the last frame comes just before the first again (off)"},
    {"Clockless_Animation", &Options::clockless, Topic::animation, "", "the frames do not differ by their clock (off)"},
    {"Verbose", &Options::verbose, Topic::messages, "", "tell more while rendering (on)"},
    {"All_Console", console<&Options::all>, Topic::messages, "", "show all kinds of messages (on)"},
    {"All_File", stream_file<&Options::all>, Topic::messages, "FILE",
     "write all kinds of messages into a file; on: alltext.out"},
    {"Debug_Console", console<&Options::debug>, Topic::messages, "", "show what #debug says (on)"},
    {"Debug_File", stream_file<&Options::debug>, Topic::messages, "FILE", "write it into a file; on: debug.out"},
    {"Fatal_Console", console<&Options::fatal>, Topic::messages, "", "show errors (on)"},
    {"Fatal_File", stream_file<&Options::fatal>, Topic::messages, "FILE", "write them into a file; on: fatal.out"},
    {"Render_Console", console<&Options::render>, Topic::messages, "", "show settings and what #render says (on)"},
    {"Render_File", stream_file<&Options::render>, Topic::messages, "FILE", "write them into a file; on: render.out"},
    {"Statistic_Console", console<&Options::statistic>, Topic::messages, "",
     "show statistics and what #statistics says (on)"},
    {"Statistic_File", stream_file<&Options::statistic>, Topic::messages, "FILE",
     "write them into a file; on: stats.out"},
    {"Warning_Console", console<&Options::warning>, Topic::messages, "", "show warnings (on)"},
    {"Warning_File", stream_file<&Options::warning>, Topic::messages, "FILE",
     "write them into a file; on: warning.out"},
    {"Append_File", &Options::append_files, Topic::messages, "",
     "add to such files instead of beginning them anew (off)"},
    {"Pre_Scene_Command", shell_command<&Options::pre_scene>, Topic::commands, "TEXT",
     "run before the first frame; %o picture, %s scene, %n frame, %k clock, %w width, %h height"},
    {"Pre_Scene_Return", shell_return<&Options::pre_scene>, Topic::commands, "r",
     "what then happens: I nothing, S skip, A skip all, Q quit, U as an interrupt, F as an error; ! before the letter: "
     "only when it succeeded"},
    {"Pre_Frame_Command", shell_command<&Options::pre_frame>, Topic::commands, "TEXT", "run before every frame"},
    {"Pre_Frame_Return", shell_return<&Options::pre_frame>, Topic::commands, "r", "what then happens, as above"},
    {"Post_Frame_Command", shell_command<&Options::post_frame>, Topic::commands, "TEXT", "run after every frame"},
    {"Post_Frame_Return", shell_return<&Options::post_frame>, Topic::commands, "r", "what then happens, as above"},
    {"Post_Scene_Command", shell_command<&Options::post_scene>, Topic::commands, "TEXT", "run after the last frame"},
    {"Post_Scene_Return", shell_return<&Options::post_scene>, Topic::commands, "r", "what then happens, as above"},
    {"User_Abort_Command", shell_command<&Options::user_abort>, Topic::commands, "TEXT", "run after an interrupt"},
    {"User_Abort_Return", shell_return<&Options::user_abort>, Topic::commands, "r", "what then happens, as above"},
    {"Fatal_Error_Command", shell_command<&Options::fatal_error>, Topic::commands, "TEXT", "run after an error"},
    {"Fatal_Error_Return", shell_return<&Options::fatal_error>, Topic::commands, "r", "what then happens, as above"},
    {"Display", &Options::display, Topic::ignored, "", "there is no preview window"},
    {"Video_Mode", kWindow, Topic::ignored, "c", ""},
    {"Display_Gamma", kWindow, Topic::ignored, "x", ""},
    {"Palette", kWindow, Topic::ignored, "c", ""},
    {"Pause_When_Done", &Options::pause, Topic::ignored, "", "there is no preview window"},
    {"Preview_Start_Size", &Options::preview_start, Topic::ignored, "n", "there is no preview window"},
    {"Preview_End_Size", &Options::preview_end, Topic::ignored, "n", "there is no preview window"},
    {"Real_Time_Raytracing", &Options::real_time, Topic::ignored, "",
     "refused when on: it draws into a window and writes no file"},
    {"High_Reproducibility", NoEffect{"every render is reproducible"}, Topic::ignored, "", ""},
    {"Max_Image_Buffer_Memory", &Options::max_image_buffer, Topic::speed, "n",
     "megabytes of pixels in memory; those of a larger picture lie in a file without a name beside it (128)"},
    {"Radiosity_Vain_Pretrace",
     NoEffect{"it shows POV-Ray's pretrace in the preview window; with focal blur, radiosity is that of on"},
     Topic::ignored, "", ""},
    {"Render_Block_Step", kOrder, Topic::ignored, "n", ""},
    {"Render_Pattern", kOrder, Topic::ignored, "n", ""},
    {"Warning_Level", NoEffect{"POV-Ray 3.7 shows all warnings at every level, too"}, Topic::ignored, "n", ""},
    {"Draw_Vistas", kOldBuffers, Topic::ignored, "", ""},
    {"Light_Buffer", kOldBuffers, Topic::ignored, "", ""},
    {"Vista_Buffer", kOldBuffers, Topic::ignored, "", ""},
    {"Test_Abort", kOldBuffers, Topic::ignored, "", ""},
    {"Test_Abort_Count", kOldBuffers, Topic::ignored, "n", ""},
    {"Field_Render", kFields, Topic::ignored, "", ""},
    {"Odd_Field", kFields, Topic::ignored, "", ""},
    {"BSP_BaseAccessCost", bsp_cost, Topic::ignored, "x", "it tunes POV-Ray's BSP tree"},
    {"BSP_ChildAccessCost", bsp_cost, Topic::ignored, "x", "it tunes POV-Ray's BSP tree"},
    {"BSP_ISectCost", bsp_cost, Topic::ignored, "x", "it tunes POV-Ray's BSP tree"},
    {"BSP_MissChance", bsp_cost, Topic::ignored, "x", "it tunes POV-Ray's BSP tree"},
    {"BSP_MaxDepth", bsp_cost, Topic::ignored, "n", "it tunes POV-Ray's BSP tree"},
    {"Buffer_Output", removed, Topic::ignored, "", "it no longer exists in POV-Ray 3.7"},
    {"Buffer_Size", removed, Topic::ignored, "n", "it no longer exists in POV-Ray 3.7"},
    {"Create_Histogram", removed, Topic::ignored, "", "it no longer exists in POV-Ray 3.7"},
    {"Histogram_Grid_Size", removed, Topic::ignored, "n", "it no longer exists in POV-Ray 3.7"},
    {"Histogram_Name", removed, Topic::ignored, "FILE", "it no longer exists in POV-Ray 3.7"},
    {"Histogram_Type", removed, Topic::ignored, "t", "it no longer exists in POV-Ray 3.7"},
});

}  // namespace

std::span<const Setting> settings() { return kSettings; }

}  // namespace verisim::cli
