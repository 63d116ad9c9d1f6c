// Every setting of a render as POV-Ray's switches and INI keywords (spec 02 section 9.6) and verisim's own `--` options
// give it.
//
// The values are as the user gave them, with POV-Ray's defaults; what they mean for a picture (region, frames, file
// names) is worked out in region.h, animation.h and output_name.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "parser/parse.h"
#include "tracer/image/output.h"

namespace verisim::cli {

// A setting that cannot be understood or makes no sense; the message names it.
struct OptionError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// One of POV-Ray's text streams: shown on the console, written to a file, or both.
struct TextStream {
  bool console = true;
  std::string file;  // empty: none
};

// A shell-out and what happens after it (spec 02 section 11).
struct ShellCommand {
  std::string command;
  char action = 'I';     // I ignore, S skip, A all skip, Q quit, U user abort, F fatal
  bool negated = false;  // `!` or `-` before the letter: only when the command succeeded
};

struct Options {
  // The scene.
  std::string input_file, include_header;
  std::vector<std::string> library_paths;                         // in order of search
  std::vector<std::pair<std::string, std::string>> declarations;  // values as SDL text; the first of a name counts
  double version = 0;                                             // 3.7; 0: not given
  bool split_unions = false, remove_bounds = true, bounding = true;
  int bounding_method = 1, bounding_threshold = 3;
  // -MB: no hierarchy, however many objects there are.
  int objects_for_hierarchy() const { return bounding ? bounding_threshold : std::numeric_limits<int>::max(); }

  // The picture and its file.
  int width = 160, height = 120;
  std::optional<double> start_column, end_column, start_row, end_row;
  std::string output_file;
  bool output_to_file = true, output_alpha = false, greyscale = false, dither = false;
  image::Format format = image::Format::png;
  int bits = 8, compression = 0;
  image::Dither dither_method = image::Dither::floyd_steinberg;
  bool file_srgb = true;
  double file_gamma = 1;

  // How it is traced.
  bool antialias = false, jitter = true;
  int sampling_method = 1, antialias_depth = 3, quality = 9;
  double antialias_threshold = 0.3, antialias_gamma = 2.5, jitter_amount = 1;
  int block_size = 32, preview_start = 1, preview_end = 1;
  std::optional<int> threads;
  bool continue_trace = false;
  bool radiosity_from_file = false, radiosity_to_file = false, real_time = false;
  std::string radiosity_file = "object.rca";
  std::string integrator = "povray";  // or "path"
  int path_samples = 64, path_bounces = 64;

  // Animation (spec 02 section 10).
  std::optional<int> initial_frame, final_frame;
  double initial_clock = 0, final_clock = 1;
  std::optional<double> clock, subset_start, subset_end;
  int frame_step = 1;
  bool cyclic = false, clockless = false;

  // Messages.
  TextStream debug, fatal, render, statistic, warning, all;
  bool all_given = false;  // then the single console switches do not count
  bool append_files = false, verbose = true;
  bool display = true, pause = false;
  std::string create_ini;

  // Shell-outs.
  ShellCommand pre_scene, pre_frame, post_frame, post_scene, user_abort, fatal_error;

  // verisim's own.
  bool replay = false, allow_shell = false, color = false;
  std::string progress;  // bar, json, openjd or none; empty: a bar on a terminal
  std::uint64_t seed = 0;
  std::string sampler = "povray";  // or adaptive
  std::string layers;              // of an EXR file, as the user listed them
  std::string part;                // K/N or prepass (part_option.h); empty: the whole picture
  std::string prepass_file;        // of --part prepass, to be read; empty: none
  bool stamp = false;              // date and render time in the picture's file
  std::vector<std::filesystem::path> allow_write, allow_read;
  parser::Limits limits;
  std::uint64_t max_pixels = std::uint64_t{1} << 28;  // of one picture: 20 bytes each
  double max_seconds = 0, max_cpu_seconds = 0;        // of one command; 0: no limit
  int max_image_buffer = 128;                         // megabytes of pixels in memory; more lie in a file
  std::string stdin_name;                             // of a scene from standard input
  std::string exact_output;                           // --output: the name as it is, the type by its extension
  std::string stats_file;

  // Everything that was set, by INI keyword, in order; for Create_Ini.
  std::vector<std::pair<std::string, std::string>> given;
  // Remarks for the user about settings that were accepted without effect.
  std::vector<std::string> notes;
};

// Throws OptionError when settings contradict each other or ask for what verisim does not have.
void validate(const Options& options);

// The format an extension stands for (with its dot, any case).
std::optional<image::Format> format_of_extension(const std::string& extension);

}  // namespace verisim::cli
