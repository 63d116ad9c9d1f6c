#include "cli/frame/frame.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <map>
#include <memory>
#include <new>
#include <optional>

#include <fmt/format.h>

#include "cli/console/seconds.h"
#include "cli/frame/picture_file.h"
#include "cli/frame/picture_key.h"
#include "cli/frame/scene_features.h"
#include "cli/frame/state_file.h"
#include "cli/frame/statistics.h"
#include "cli/parts/part_file.h"
#include "cli/settings/layers_option.h"
#include "cli/settings/part_option.h"
#include "cli/settings/process_limits.h"
#include "tracer/base/keep_until_exit.h"
#include "tracer/base/output_file.h"
#include "tracer/image/output.h"
#include "tracer/render/render.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// Something went wrong that ends this frame.
struct Failure {
  ExitStatus status;
  std::string message;
};

// An error while rendering, in the words of either style.
void tell(const Job& job, const std::string& message) {
  if (job.console.style() == Style::povray) {
    job.console.always("Fatal error in renderer: " + message);
  } else {
    job.console.line(Stream::fatal, "verisim: error: " + message);
  }
}

parser::ParseResult parse(const Job& job, const Frame& frame, FrameReport& report) {
  const auto start = Clock::now();
  const double cpu = cpu_seconds();
  job.console.parse_progress();
  parser::ParseResult result = parse_scene(job, parse_options(job, frame));
  job.console.end_of_debug();
  job.console.end_progress();
  report.seconds_parse = seconds_since(start);
  report.cpu_parse = cpu_seconds() - cpu;
  report.warnings = result.warnings;
  report.files_read = result.files_read;
  if (job.interrupt.flag()) throw Failure{kInterrupted, "interrupted while parsing"};
  if (result.scene) return result;
  report.status = kSceneErrors;
  for (const parser::Diagnostic& error : result.errors) {
    if (error.severity == parser::Severity::unsupported) report.status = kUnsupported;
    if (report.message.empty())
      report.message = fmt::format("{}:{}:{}: {}", error.file, error.line, error.column, error.message);
  }
  if (job.console.style() == Style::povray) job.console.always("Fatal error in parser: Cannot parse input.");
  return result;
}

// What --prepass names, made for this very picture.
std::string prepasses_for(const PartPicture& picture, const fs::path& path) {
  PartFile file(path);
  std::string bytes = file.prepasses();
  if (const std::string what = difference(file.header().picture, picture); !what.empty())
    throw Failure{kInputOutput, fmt::format("the prepasses in '{}' are those of another picture: they differ in {}",
                                            path.string(), what)};
  return bytes;
}

struct Canvas {
  render::Framebuffer framebuffer;
  std::uint64_t pixels = 0;  // of the region
};

// `places`: where the blocks of a part lie; empty: the whole picture is rendered. `folder`: of the picture's file,
// where the pixels of a large one may lie; nothing: in memory.
Canvas blank(const Options& options, const Region& part, const std::vector<Block>& places,
             const std::optional<fs::path>& folder) {
  Canvas canvas;
  canvas.framebuffer.width = places.empty() ? options.width : 0;
  canvas.framebuffer.height = places.empty() ? options.height : 0;
  for (const Block& place : places) {
    canvas.framebuffer.width = std::max(canvas.framebuffer.width, place.x + place.width);
    canvas.framebuffer.height = std::max(canvas.framebuffer.height, place.y + place.height);
  }
  const std::size_t pixels =
      static_cast<std::size_t>(canvas.framebuffer.width) * static_cast<std::size_t>(canvas.framebuffer.height);
  const bool large =
      pixels * sizeof(render::PixelColor) >> 20 >= static_cast<std::size_t>(std::max(0, options.max_image_buffer));
  if (!large || !folder || !canvas.framebuffer.pixels.assign_in_file(pixels, *folder))
    canvas.framebuffer.pixels.assign(pixels, {});
  canvas.framebuffer.done.assign(pixels, 0);
  if (!part.empty())
    canvas.pixels = static_cast<std::uint64_t>(part.last_column - part.first_column + 1) *
                    static_cast<std::uint64_t>(part.last_row - part.first_row + 1);
  return canvas;
}

std::map<Block, Block> by_block(const std::vector<Block>& blocks, const std::vector<Block>& places) {
  std::map<Block, Block> result;
  for (std::size_t i = 0; i < blocks.size(); ++i) result.emplace(blocks[i], places[i]);
  return result;
}

// Of the passes before the picture: what was made by an earlier render, or where to put it.
struct Prepasses {
  std::optional<std::string> from, to;
};

// A call renders one scene; after its only picture nothing follows.
bool last_of_process(const Job& job) { return job.animation.count() == 1; }

bool too_many(std::uint64_t rays) { return process_limits.max_rays != 0 && rays > process_limits.max_rays; }

// Renders into the canvas, with the state file where there is one.
void trace(const Job& job, const scene::Scene& scene, const Region& part, Canvas& canvas, StateFile* state,
           LayerChoice& choice, Prepasses& prepasses, FrameReport& report) {
  // +WT0 and an empty region trace nothing and still make a picture.
  if (part.empty() || job.options.threads.value_or(1) <= 0)
    return render::resize_layers(choice.layers, job.options.width, job.options.height);
  render::Options options = render_options(job, part);
  options.last_of_process = last_of_process(job);
  if (choice.any) options.layers = &choice.layers;
  if (prepasses.from) options.prepasses_from = &*prepasses.from;
  if (prepasses.to) options.prepasses_to = &*prepasses.to;
  std::atomic<std::uint64_t> rays{0};
  options.rays = &rays;
  const auto limit = [&] {
    if (too_many(rays)) job.interrupt.flag() = true;
  };
  options.progress = [&](double fraction) {
    job.console.progress(fraction, canvas.pixels, rays);
    limit();
  };
  options.pass_progress = [&](const char* pass, double fraction) {
    job.console.pass_progress(pass, fraction);
    limit();
  };
  if (job.options.radiosity_from_file) options.radiosity_from = job.options.radiosity_file;
  if (job.options.radiosity_to_file) options.radiosity_to = job.options.radiosity_file;
  if (state) {
    options.block_known = [state](int x, int y, int w, int h) { return state->known({x, y, w, h}); };
    options.block_done = [state, &canvas](int x, int y, int w, int h) {
      if (!state->known({x, y, w, h})) state->finished({x, y, w, h}, canvas.framebuffer);
    };
  }
  report.statistics = render::render(scene, options, canvas.framebuffer);
  job.console.end_progress();
  if (too_many(rays)) tell(job, fmt::format("--max-rays {} is reached", process_limits.max_rays));
}

void write(const Job& job, const Canvas& canvas, const LayerChoice& choice, const OutputName& name,
           const image::OutputOptions& output, FrameReport& report) {
  if (!job.options.output_to_file) return;
  const auto start = Clock::now();
  write_picture(name, canvas.framebuffer, choice, output);
  if (!name.standard_output && !name.standard_error) report.output = name.path;
  report.seconds_write = seconds_since(start);
}

// A part is whole or it is not there: what was rendered of it until an interruption is in the state file.
void write_part(const Canvas& canvas, const LayerChoice& choice, const Prepasses& prepasses, const OutputName& name,
                const PartHeader& header, FrameReport& report) {
  const auto start = Clock::now();
  if (prepasses.to)
    write_prepass_part(name.path, header, *prepasses.to);
  else
    cli::write_part(name.path, header, canvas.framebuffer, choice.layers);
  report.output = name.path;
  report.seconds_write = seconds_since(start);
}

// As POV-Ray ends a render of an isosurface whose max_gradient does not fit.
void warn_of_object(const Job& job, const scene::SourceLocation& place, const std::string& text) {
  const std::string file = place.file ? *place.file : std::string();
  const bool povray = job.console.style() == Style::povray;
  job.console.line(Stream::warning,
                   povray ? wrapped(fmt::format("File: {}  Line: {}\nShutdown Warning: {}", file, place.line, text))
                          : wrapped(fmt::format("{}:{}: warning: {}", file, place.line, text)));
}

void report_unsupported(const Job& job, const render::Unsupported& missing, FrameReport& report) {
  job.console.end_progress();
  parser::Diagnostic diagnostic;
  diagnostic.severity = parser::Severity::unsupported;
  diagnostic.code = parser::Code::unsupported;
  if (missing.place.file) diagnostic.file = *missing.place.file;
  diagnostic.line = missing.place.line;
  diagnostic.column = missing.place.column;
  diagnostic.message = missing.what();
  job.console.diagnostic(diagnostic);
  report.status = kUnsupported;
  report.message = fmt::format("{}:{}:{}: {}", diagnostic.file, diagnostic.line, diagnostic.column, diagnostic.message);
}

void render_parsed(const Job& job, const Frame& frame, const scene::Scene& scene, const OutputName& name,
                   FrameReport& report) {
  const Options& options = job.options;
  const Region part = region(options);
  const bool to_file = options.output_to_file && !name.standard_output && !name.standard_error;
  image::OutputOptions output = output_options(job, scene);
  LayerChoice choice = layer_choice(options.layers);
  const PartChoice which = part_choice(options.part);
  if (to_file) require_writable(name.path);

  const std::uint64_t key = picture_key(job, frame, part, report.files_read);
  PartHeader header;
  Prepasses prepasses;
  if (which.any || !options.prepass_file.empty())
    header = {part_picture(job, part, key, output, report.files_read), which};
  if (which.any && options.continue_trace && is_whole_part(name.path, header)) {
    job.console.always("Part already rendered and continue requested; skipping.");
    report.skipped = true;
    return;
  }
  if (!options.prepass_file.empty()) prepasses.from = prepasses_for(header.picture, options.prepass_file);
  if (which.prepasses) prepasses.to.emplace();

  const bool strip = which.of > 1;
  const std::vector<Block> places = strip ? part_places(header) : std::vector<Block>();
  // The prepasses have no pixels, nor has a part that is one too many for the blocks.
  const auto folder = to_file ? std::optional(behind_links(name.path).parent_path()) : std::nullopt;
  Canvas canvas = which.prepasses || (strip && places.empty()) ? Canvas() : blank(options, part, places, folder);
  std::unique_ptr<StateFile> state;
  if (to_file && !options.replay && !which.prepasses) {
    state = std::make_unique<StateFile>(name.state_path, key_of_part(key, which));
    if (strip) state->set_part(by_block(part_blocks(header), places), options.width, options.height);
    if (options.continue_trace && state->resume(canvas.framebuffer) == StateFile::Found::other_render)
      job.console.line(
          Stream::warning,
          wrapped(fmt::format(
              "The state file '{}' belongs to another scene or other settings: starting from the beginning.",
              name.state_path.string())));
  }
  if (to_file) {  // the picture of an earlier run would be taken for this one's by +C
    std::error_code ignored;
    if (fs::is_regular_file(name.path, ignored)) fs::remove(behind_links(name.path), ignored);
  }

  if (job.console.style() == Style::povray) job.console.line(Stream::render, render_option_text(options));
  if (job.console.style() == Style::povray) job.console.always(section_bar("[Rendering...]"));
  const auto start = Clock::now();
  const double cpu = cpu_seconds();
  try {
    trace(job, scene, part, canvas, state.get(), choice, prepasses, report);
  } catch (const render::Unsupported& missing) {
    return report_unsupported(job, missing, report);
  }
  report.seconds_render = seconds_since(start);
  report.cpu_render = cpu_seconds() - cpu;

  for (const auto& [place, text] : report.statistics.findings) warn_of_object(job, place, text);
  if (state && !state->failure().empty()) job.console.line(Stream::warning, wrapped("Warning: " + state->failure()));
  const bool interrupted = report.statistics.cancelled;
  if (interrupted) job.interrupt.orderly_end();
  if (interrupted && state) state->flush(canvas.framebuffer);
  if (options.stamp && !output.time) {
    output.time = std::time(nullptr);
    output.metadata["Render Time"] = fmt::format("{:.3f} s", report.seconds_render);
  }
  if (!which.any)
    write(job, canvas, choice, name, output, report);
  else if (!interrupted)
    write_part(canvas, choice, prepasses, name, header, report);
  if (interrupted) throw Failure{kInterrupted, job.interrupt.limit_reached() ? "a limit is reached" : "interrupted"};
  if (state) state->remove();
}

}  // namespace

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

FrameReport render_frame(const Job& job, const Frame& frame) {
  FrameReport report;
  const OutputName name = output_name(job.options, job.scene.path, job.animation, frame);
  try {
    std::error_code ignored;
    if (job.options.continue_trace && job.options.output_to_file && job.options.part.empty() && !name.path.empty() &&
        fs::is_regular_file(name.path, ignored) && fs::file_size(name.path, ignored) > 0 &&
        !is_state_file(name.state_path)) {
      job.console.always("File already rendered and continue requested; skipping.");
      report.skipped = true;
      return report;
    }
    if (job.console.style() == Style::povray) job.console.always(section_bar("[Parsing...]"));
    auto own = std::make_unique<parser::ParseResult>();
    const bool reuse = job.shared && job.shared->result.scene.has_value();
    if (!reuse) *own = parse(job, frame, report);
    if (!reuse && !own->scene) return report;
    if (!reuse && job.shared && job.animation.count() > 1 && own->warnings == 0 &&
        !depends_on_frame(own->files_read, job.scene.text))
      job.shared->result = std::move(*own);
    const parser::ParseResult& parsed = job.shared && job.shared->result.scene ? job.shared->result : *own;
    report.files_read = parsed.files_read;
    report.stochastic_features = stochastic_features(*parsed.scene, job.options.quality);
    if (job.console.style() == Style::povray)
      job.console.line(Stream::statistic, parser_statistics(*parsed.scene, report));
    render_parsed(job, frame, *parsed.scene, name, report);
    if (report.status == kOk && job.console.style() == Style::povray)
      job.console.line(Stream::statistic, render_statistics(job.options, *parsed.scene, report));
    if (last_of_process(job)) keep_until_exit(std::move(own));
  } catch (const Failure& failure) {
    job.console.end_progress();
    report.status = failure.status;
    report.message = failure.message;
    if (failure.status != kInterrupted) tell(job, failure.message);
  } catch (const OptionError& error) {
    report.status = kUsage;
    report.message = error.what();
    tell(job, report.message);
  } catch (const std::bad_alloc&) {
    job.console.end_progress();
    report.status = kInputOutput;
    report.message = "there is not enough memory for this scene and picture, or --max-memory does not allow it";
    tell(job, report.message);
  } catch (const std::exception& error) {
    job.console.end_progress();
    report.status = kInputOutput;
    report.message = error.what();
    tell(job, report.message);
  }
  return report;
}

}  // namespace verisim::cli
