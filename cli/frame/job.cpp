#include "cli/frame/job.h"

#include <algorithm>

#include "cli/settings/reading/configuration.h"
#include "cli/settings/part_option.h"
#include "cli/settings/process_limits.h"
#include "cli/settings/reading/switches.h"
#include "parser/source/confinement.h"

namespace verisim::cli {

Watch watch(const Options& options, const Console& console) {
  Watch result;
  result.seconds = options.max_seconds;
  result.cpu_seconds = options.max_cpu_seconds;
  result.memory = options.limits.max_memory_bytes;
  if (console.style() == Style::povray) result.status = 2;
  return result;
}

render::Options render_options(const Job& job, const Region& part) {
  const Options& options = job.options;
  render::Options result;
  result.width = options.width;
  result.height = options.height;
  result.first_column = part.first_column;
  result.last_column = part.last_column;
  result.first_row = part.first_row;
  result.last_row = part.last_row;
  result.antialias = options.antialias && options.sampling_method != 0;
  result.sampling_method = options.sampling_method;
  if (options.integrator == "path") {
    if (options.path_samples < 1 || options.path_bounces < 1)
      throw OptionError("--path-samples and --path-bounces must be at least 1");
    if (options.replay)
      throw OptionError("--replay follows POV-Ray's algorithms: it cannot be combined with --integrator path");
    result.path_samples = options.path_samples;
    result.path_bounces = options.path_bounces;
  } else if (options.integrator != "povray") {
    throw OptionError("--integrator is `povray` or `path`, not `" + options.integrator + "`");
  }
  result.antialias_depth = options.antialias_depth;
  result.antialias_threshold = static_cast<float>(options.antialias_threshold);
  result.antialias_gamma = options.antialias_gamma;
  result.sampler = options.sampler == "adaptive" ? render::Sampler::adaptive : render::Sampler::povray;
  result.jitter = options.jitter;
  result.jitter_amount = options.jitter_amount;
  result.quality = options.quality;
  result.block_size = options.block_size;
  // Adaptive sampling looks at the pixels around a block, so larger blocks are cheaper; +BS still decides when it is
  // given.
  const auto given = [&](std::string_view key) {
    return std::any_of(options.given.begin(), options.given.end(), [&](const auto& g) { return g.first == key; });
  };
  if (result.antialias && result.sampler == render::Sampler::adaptive && !given("Render_Block_Size"))
    result.block_size = 64;
  constexpr int kMaxThreads = 1024;
  result.threads = std::min(options.threads.value_or(0), kMaxThreads);
  const PartChoice choice = part_choice(options.part);
  result.part = choice.number - 1;
  result.parts = choice.of;
  result.output_alpha = options.output_alpha;
  result.split_unions = options.split_unions;
  result.remove_bounds = options.remove_bounds;
  result.bounding_threshold = options.objects_for_hierarchy();
  result.replay = options.replay;
  result.seed = options.seed;
  result.cancel = &job.interrupt.flag();
  return result;
}

parser::ParseResult parse_scene(const Job& job, const parser::ParseOptions& options) {
  return job.scene.text ? parser::parse_text(*job.scene.text, job.scene.path.string(), options)
                        : parser::parse_file(job.scene.path, options);
}

parser::ParseOptions parse_options(const Options& options, const std::filesystem::path& scene,
                                   const Animation& animation, const Frame& frame) {
  parser::ParseOptions result;
  result.library_paths = search_paths(options, scene);
  result.standard_includes = false;  // they are among those
  if (!options.include_header.empty()) result.include_headers.push_back(options.include_header);
  result.declarations = options.declarations;
  result.width = options.width;
  result.height = options.height;
  result.clock = frame.clock;
  result.clock_on = animation.clock_on;
  result.frame_number = frame.number;
  result.initial_frame = animation.initial_frame;
  result.final_frame = animation.final_frame;
  result.initial_clock = animation.initial_clock;
  result.final_clock = animation.final_clock;
  result.clock_delta = animation.clock_delta;
  result.version = static_cast<int>(options.version * 100 + 0.5);
  result.quality = options.quality;
  result.allow_read = options.allow_read;
  result.allow_write = options.allow_write;
  result.limits = options.limits;
  parser::confinement.output_limit = process_limits.max_output_bytes;
  return result;
}

parser::ParseOptions parse_options(const Job& job, const Frame& frame) {
  parser::ParseOptions result = parse_options(job.options, job.scene.path, job.animation, frame);
  result.debug = [&console = job.console](const std::string& text) { console.debug(text); };
  result.message = [&console = job.console](const parser::Diagnostic& d) { console.diagnostic(d); };
  result.cancelled = [&interrupt = job.interrupt, &console = job.console] {
    console.parse_progress();
    return interrupt.flag().load();
  };
  return result;
}

}  // namespace verisim::cli
