#include "cli/frame/statistics.h"

#include <sys/resource.h>

#include <map>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/settings/region.h"
#include "cli/frame/scene_features.h"
#include "cli/settings/output_name.h"
#include "compare/json_text.h"

namespace verisim::cli {
namespace {

const std::string kRule(76, '-');

const char* on_off(bool on) { return on ? "On " : "Off"; }

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(seconds);
  return fmt::format("{:3} hours {:2} minutes {:2} seconds ({:.3f} seconds)", whole / 3600, whole / 60 % 60, whole % 60,
                     seconds);
}

std::string dither_name(const Options& options) {
  if (!options.dither) return "Off";
  switch (options.dither_method) {
    case image::Dither::none:
      return "Off";
    case image::Dither::bayer2:
      return "2x2 Bayer pattern";
    case image::Dither::bayer3:
      return "3x3 Bayer pattern";
    case image::Dither::bayer4:
      return "4x4 Bayer pattern";
    case image::Dither::diffusion1d:
      return "Simple 1-D error diffusion";
    case image::Dither::diffusion2d:
      return "Simple 2-D error diffusion (Sierra Lite)";
    case image::Dither::floyd_steinberg:
      return "Floyd-Steinberg error diffusion";
  }
  return "";
}

std::string type_name(const Options& options) {
  const int bpp = options.bits * (options.output_alpha ? 4 : 3);
  const std::string depth = options.greyscale ? std::string("grayscale") : fmt::format("{} bpp", bpp);
  switch (options.format) {
    case image::Format::png:
      return depth + " PNG";
    case image::Format::tga:
      return "24 bpp uncompressed TGA";
    case image::Format::tga_rle:
      return "24 bpp compressed TGA";
    case image::Format::ppm:
      return depth + " PPM";
    case image::Format::bmp:
      return "24 bpp BMP";
    case image::Format::jpeg:
      return "JPEG";
    case image::Format::exr:
      return "OpenEXR";
    case image::Format::hdr:
      return "Radiance HDR";
    case image::Format::tiff:
      return "TIFF";
  }
  return depth;
}

std::size_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

std::string banner() {
  return "verisim " VERISIM_VERSION
         ", a native ray tracer for scenes of\n"
         "Persistence of Vision(tm) Ray Tracer Version 3.7\n"
         "It is independent of POV-Ray: not made or supported by the POV-Ray Team.\n";
}

std::string section_bar(const std::string& title) { return fmt::format("{:=<76}", "==== " + title + " "); }

std::string option_text(const Job& job, const Frame& frame) {
  const Options& o = job.options;
  std::string text = fmt::format(
      "Parser Options\n  Input file: {}\n  Remove bounds........{}\n  Split unions.........{}\n  Library paths:\n",
      job.scene.path.string(), on_off(o.remove_bounds), on_off(o.split_unions));
  for (const std::string& path : o.library_paths) text += fmt::format("    {}\n", path);
  if (job.animation.on) {
    text += fmt::format(
        "Animation Options\n  Initial Frame: {:8}  Final Frame: {:8}\n  Frame Step:    {:8}\n  Initial Clock: {:8.3f}  "
        "Final Clock: {:8.3f}\n"
        "  Cyclic Animation.....{}  Field render.........Off  Odd lines/frames.....Off\n",
        job.animation.initial_frame, job.animation.final_frame, job.animation.step, job.animation.initial_clock,
        job.animation.final_clock, on_off(o.cyclic));
  } else {
    text += fmt::format("  Clock value: {:8.3f}  (Animation off)\n", frame.clock);
  }
  const OutputName name = output_name(o, job.scene.path, job.animation, frame);
  std::string rows;
  try {
    const Region part = region(o);
    rows = fmt::format(" (rows {} to {}, columns {} to {})", part.first_row + 1, part.last_row + 1,
                       part.first_column + 1, part.last_column + 1);
  } catch (const OptionError&) {  // reported when the picture is rendered
  }
  text += fmt::format("Image Output Options\n  Image resolution.....{} by {}{}.\n", o.width, o.height, rows);
  if (o.output_to_file)
    text += fmt::format("  Output file..........{}, {}\n",
                        name.standard_output  ? "stdout"
                        : name.standard_error ? "stderr"
                                              : name.path.string(),
                        type_name(o));
  else
    text += "  Output file..........Off\n";
  text += fmt::format(
      "  Dithering............{}\n  Graphic display......Off\n  Mosaic preview.......Off\n  Continued trace......{}\n",
      dither_name(o), on_off(o.continue_trace));
  text += fmt::format(
      "Information Output Options\n  All Streams to console..........{}\n  Debug Stream to console.........{}\n  Fatal "
      "Stream to console.........{}\n"
      "  Render Stream to console........{}\n  Statistics Stream to console....{}\n  Warning Stream to "
      "console.......{}",
      on_off(o.all.console), on_off(o.debug.console), on_off(o.fatal.console), on_off(o.render.console),
      on_off(o.statistic.console), on_off(o.warning.console));
  return text;
}

std::string render_option_text(const Options& o) {
  std::string text = fmt::format("Render Options\n  Quality: {:2}\n  Bounding boxes.......{}  Bounding threshold: {}\n",
                                 o.quality, on_off(o.bounding), o.bounding_threshold);
  if (o.antialias && o.sampling_method != 0)
    text += fmt::format(
        "  Antialiasing.........On  (Method {}, Threshold {:.3f}, Depth {}, Jitter {:.2f}, Gamma {:.2f})",
        o.sampling_method, o.antialias_threshold, o.antialias_depth, o.jitter ? o.jitter_amount : 0, o.antialias_gamma);
  else
    text += "  Antialiasing.........Off";
  return text;
}

std::string parser_statistics(const scene::Scene& scene, const FrameReport& report) {
  const ObjectCount count = count_objects(scene);
  return fmt::format(
      "{0}\nParser Statistics\n{0}\nFinite Objects:   {1:10}\nInfinite Objects: {2:10}\nLight Sources:    "
      "{3:10}\nTotal:            {4:10}\n{0}\n"
      "Parser Time\n  Parse Time:     {5}\n              using 1 thread(s) with {6:.3f} CPU-seconds total\n{0}",
      kRule, count.finite, count.infinite, count.lights, count.finite + count.infinite + count.lights,
      duration(report.seconds_parse), report.cpu_parse);
}

std::string render_statistics(const Options& options, const scene::Scene&, const FrameReport& report) {
  const render::Statistics& s = report.statistics;
  const double per_pixel = s.pixels ? static_cast<double>(s.samples) / static_cast<double>(s.pixels) : 0;
  std::string text = fmt::format(
      "{0}\nRender Statistics\nImage Resolution {1} x {2}\n{0}\nPixels: {3:16}   Samples: {4:15}   Smpls/Pxl: {5:.2f}\n"
      "Rays:   {6:16}   Saved:  {7:16}\n{0}\nCamera Rays:      {8:15}\nReflected Rays:   {9:15}\nRefracted Rays:   "
      "{10:15}\nTransmitted Rays: {11:15}\n"
      "Shadow Ray Tests: {12:15}\n",
      kRule, options.width, options.height, s.pixels, s.samples, per_pixel,
      s.camera_rays + s.reflected_rays + s.refracted_rays + s.transmitted_rays, 0, s.camera_rays, s.reflected_rays,
      s.refracted_rays, s.transmitted_rays, s.shadow_rays);
  text += fmt::format(
      "{0}\nRender Time:\n  Trace Time:     {1}\n              using {2} thread(s) with {3:.3f} CPU-seconds total",
      kRule, duration(report.seconds_render),
      options.replay                    ? 1
      : options.threads.value_or(0) > 0 ? *options.threads
                                        : static_cast<int>(std::thread::hardware_concurrency()),
      report.cpu_render);
  return text;
}

std::string statistics_json(const Job& job, const std::vector<FrameReport>& frames) {
  using Json = nlohmann::json;
  Json all;
  all["scene"] = job.scene.path.string();
  all["width"] = job.options.width;
  all["height"] = job.options.height;
  all["version"] = VERISIM_VERSION;
  all["peak_bytes"] = peak_bytes();
  all["cpu_seconds"] = cpu_seconds();
  double seconds = 0;
  std::map<std::string, std::uint64_t> rays;
  std::set<std::string> features, files;
  Json list = Json::array();
  for (const FrameReport& f : frames) {
    seconds += f.seconds_parse + f.seconds_render + f.seconds_write;
    const render::Statistics& s = f.statistics;
    const std::map<std::string, std::uint64_t> own{{"camera", s.camera_rays},
                                                   {"reflected", s.reflected_rays},
                                                   {"refracted", s.refracted_rays},
                                                   {"transmitted", s.transmitted_rays},
                                                   {"shadow", s.shadow_rays}};
    for (const auto& [kind, count] : own) rays[kind] += count;
    features.insert(f.stochastic_features.begin(), f.stochastic_features.end());
    for (const auto& file : f.files_read) files.insert(file.string());
    list.push_back({{"output", f.output.string()},
                    {"status", static_cast<int>(f.status)},
                    {"message", f.message},
                    {"warnings", f.warnings},
                    {"pixels", s.pixels},
                    {"samples", s.samples},
                    {"rays", own},
                    {"seconds",
                     {{"parse", f.seconds_parse},
                      {"compile", s.seconds_compile},
                      {"render", f.seconds_render},
                      {"write", f.seconds_write}}}});
  }
  all["seconds"] = seconds;
  all["rays"] = rays;
  all["stochastic_features"] = features;
  all["files_read"] = files;
  all["frames"] = list;
  // Scene texts may hold any bytes.
  return compare::json_text(all, 2) + "\n";
}

}  // namespace verisim::cli
