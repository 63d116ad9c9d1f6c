#include "cli/frame/picture_file.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "cli/settings/source_date.h"
#include "cli/settings/reading/switches.h"
#include "tracer/image/formats/layers_file.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// All settings of the call that decide the picture as Key=Value, on one line; local paths stay out of what a picture
// tells to others.
std::string given_settings(const Options& options) {
  std::string text;
  for (const auto& [key, value] : options.given) {
    if (!decides_picture(key) || key == "Library_Path" || key == "Input_File_Name" || key == "Output_File_Name" ||
        key == "Include_Header" || key == "Radiosity_File_Name")
      continue;
    text += (text.empty() ? "" : " ") + key + "=" + value;
  }
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return text;
}

// Lets `write` write to "-", standard output, or to standard error.
void write_to_stream(bool to_stderr, const std::function<void(const fs::path&)>& write) {
  if (!to_stderr) return write("-");
  // The writer knows standard output alone; for a moment that is standard error.
  std::fflush(stdout);
  const int saved = ::dup(STDOUT_FILENO);
  if (saved < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) throw std::runtime_error("cannot write to standard error");
  const auto restore = [saved] {
    std::fflush(stdout);
    ::dup2(saved, STDOUT_FILENO);
    ::close(saved);
  };
  try {
    write("-");
  } catch (...) {
    restore();
    throw;
  }
  restore();
}

}  // namespace

image::OutputOptions output_options(const Job& job, const scene::Scene& scene) {
  const Options& options = job.options;
  image::OutputOptions output = image::output_options(scene);
  output.format = options.format;
  output.bits = options.bits;
  output.alpha = options.output_alpha;
  output.greyscale = options.greyscale;
  if (output.working == scene::Gamma::none && options.version >= 3.7) {  // spec 02 4.1, last row
    output.working = scene::Gamma::power;
    output.working_gamma = 1;
    job.console.line(
        Stream::warning,
        wrapped(
            "Warning: assumed_gamma is not specified, and Version is 3.7 or later: rendering in linear colour space."));
  }
  output.file_srgb = options.file_srgb;
  output.file_gamma = options.file_gamma;
  if (options.dither) output.dither = options.dither_method;
  output.compression = options.compression;
  output.metadata["Software"] = "verisim " VERISIM_VERSION;
  output.metadata["Comment"] = "Rendered from " + job.scene.path.filename().string();
  output.metadata["Title"] = job.scene.path.filename().string();
  output.metadata["Switches"] = given_settings(options);
  if (options.stamp) output.time = source_date();
  return output;
}

void write_picture(const OutputName& name, const render::Framebuffer& framebuffer, const LayerChoice& choice,
                   const image::OutputOptions& output) {
  const auto write = [&](const fs::path& path) {
    if (choice.any)
      image::write_layers(framebuffer, choice.layers, choice.beauty, path, output);
    else
      image::write(framebuffer, path, output);
  };
  if (name.standard_output || name.standard_error)
    write_to_stream(name.standard_error, write);
  else
    write(name.path);
}

}  // namespace verisim::cli
