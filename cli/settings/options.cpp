#include "cli/settings/options.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "cli/settings/animation.h"
#include "cli/settings/layers_option.h"
#include "cli/settings/part_option.h"

namespace verisim::cli {

namespace {

void validate_part(const Options& options) {
  if (options.radiosity_to_file && (part_choice(options.part).any || !options.prepass_file.empty()))
    throw OptionError("+RFO is for renders of whole pictures: a part makes a part of the radiosity samples alone");
  if (options.replay && (part_choice(options.part).any || !options.prepass_file.empty()))
    throw OptionError("--replay follows POV-Ray from the first block to the last: it cannot render parts");
  if (!part_choice(options.part).any) return;
  if (options.exact_output.empty() || options.exact_output == "-" || !options.output_to_file)
    throw OptionError("name the file of the part: --part " + options.part + " --output FILE.vsp");
  if (part_choice(options.part).prepasses && !options.prepass_file.empty())
    throw OptionError("--part prepass makes what --prepass reads: give one of them");
  if (animation(options).count() > 1)
    throw OptionError("a part is of one picture: choose a frame of the animation with +SF and +EF");
}

}  // namespace

void validate(const Options& options) {
  validate_part(options);
  if (options.width < 1 || options.height < 1)
    throw OptionError(fmt::format("the picture needs a width and a height of at least 1, not {} by {} (Width, Height)",
                                  options.width, options.height));
  const std::uint64_t pixels = std::uint64_t(options.width) * std::uint64_t(options.height);
  if (pixels > options.max_pixels)
    throw OptionError(fmt::format("{} by {} are {} pixels, more than the limit of {} (--max-pixels)", options.width,
                                  options.height, pixels, options.max_pixels));
  if (options.block_size < 4)
    throw OptionError("Specified block size is too small (Render_Block_Size, +BS: at least 4)");
  if (options.greyscale && options.format != image::Format::png && options.format != image::Format::ppm)
    throw OptionError("Unsupported combination of options: Grayscale_Output is for PNG and PPM");
  if (options.sampler != "povray" && options.sampler != "adaptive")
    throw OptionError(fmt::format("--sampler is povray or adaptive, not '{}'", options.sampler));
  if (options.sampler == "adaptive" && options.replay)
    throw OptionError("--sampler adaptive is not how POV-Ray samples: it cannot be combined with --replay");
  if (layer_choice(options.layers).any && options.format != image::Format::exr && options.part.empty())
    throw OptionError("--layers is for OpenEXR files: name the picture with .exr, or give +FE");
  if (options.real_time)
    throw OptionError("Real_Time_Raytracing (+RTR) draws into a window and writes no file; verisim has no window");
}

std::optional<image::Format> format_of_extension(const std::string& text) {
  std::string lower = text;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (lower == ".jpeg") return image::Format::jpeg;
  if (lower == ".tiff") return image::Format::tiff;
  for (image::Format format : {image::Format::png, image::Format::tga, image::Format::ppm, image::Format::bmp,
                               image::Format::jpeg, image::Format::exr, image::Format::hdr, image::Format::tiff})
    if (lower == image::extension_of(format)) return format;
  return std::nullopt;
}

}  // namespace verisim::cli
