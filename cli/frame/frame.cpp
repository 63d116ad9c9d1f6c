#include "cli/frame/frame.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <new>

#include <fmt/format.h>

#include "cli/settings/configuration.h"
#include "cli/settings/layers_option.h"
#include "cli/settings/region.h"
#include "cli/settings/switches.h"
#include "cli/frame/scene_features.h"
#include "cli/frame/state_file.h"
#include "cli/frame/statistics.h"
#include "cli/parts/fingerprint.h"
#include "cli/parts/part_file.h"
#include "cli/settings/part_option.h"
#include "cli/settings/scene_words.h"
#include "cli/settings/source_date.h"
#include "tracer/base/huge_pages.h"
#include "tracer/image/layers_file.h"
#include "tracer/image/output.h"
#include "tracer/image/in_memory.h"
#include "tracer/base/output_file.h"
#include "tracer/render/render.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

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

// ------------------------------------------------------------------------------------------------ parsing

parser::ParseResult parse(const Job& job, const Frame& frame, FrameReport& report) {
  const auto start = Clock::now();
  const double cpu = cpu_seconds();
  job.console.parse_progress();
  parser::ParseResult result = parse_scene(job, parse_options(job, frame));
  job.console.end_of_debug();
  job.console.end_progress();
  report.seconds_parse = since(start);
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

// ------------------------------------------------------------------------------------------------ where the picture
// goes

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

// ------------------------------------------------------------------------------------------------ rendering

// Everything the pixels depend on, for continue-trace and for parts of a picture.
std::uint64_t picture_key(const Job& job, const Frame& frame, const Region& part, const std::vector<fs::path>& files) {
  const Options& o = job.options;
  Fingerprint key;
  key.add(VERISIM_VERSION);
  for (const double value : {double(o.width),
                             double(o.height),
                             double(part.first_column),
                             double(part.last_column),
                             double(part.first_row),
                             double(part.last_row),
                             double(o.antialias),
                             double(o.sampling_method),
                             double(o.antialias_depth),
                             o.antialias_threshold,
                             o.antialias_gamma,
                             double(o.jitter),
                             o.jitter_amount,
                             double(o.quality),
                             double(o.block_size),
                             double(o.output_alpha),
                             double(o.split_unions),
                             double(o.remove_bounds),
                             double(o.objects_for_hierarchy()),
                             double(o.seed),
                             o.version,
                             frame.clock,
                             double(frame.number),
                             double(job.animation.final_frame),
                             double(job.animation.initial_frame)})
    key.add(value);
  key.add(o.sampler);
  if (o.integrator == "path") key.add("path " + std::to_string(o.path_samples) + " " + std::to_string(o.path_bounces));
  for (const auto& [name, value] : o.declarations) key.add(name + "=" + value);
  for (const fs::path& file : files) key.add_file(file);
  if (job.scene.text) key.add(*job.scene.text);
  if (o.radiosity_from_file) key.add_file(o.radiosity_file);
  return key.value();
}

// The state of a part is not that of another one.
std::uint64_t key_of_part(std::uint64_t picture, const PartChoice& part) {
  if (!part.any) return picture;
  Fingerprint key;
  key.add(static_cast<double>(picture >> 32));
  key.add(static_cast<double>(picture & 0xffffffffu));
  key.add(part.name());
  return key.value();
}

PartPicture part_picture(const Job& job, const Region& region, std::uint64_t key, const image::OutputOptions& output,
                         const std::vector<fs::path>& files) {
  const Options& options = job.options;
  PartPicture picture;
  picture.version = VERISIM_VERSION;
  picture.scene = job.scene.path.filename().string();
  for (const fs::path& file : files) {
    Fingerprint content;
    content.add_file(file);
    std::string& known = picture.files[file.filename().string()];  // files in different folders may share a name
    known += fmt::format("{}{:016x}", known.empty() ? "" : " ", content.value());
  }
  picture.key = key;
  picture.width = options.width, picture.height = options.height;
  picture.region = region;
  picture.block_size = render_options(job, region).block_size;
  picture.layers = options.layers;
  picture.format_chosen = format_chosen(options);
  picture.stamp = options.stamp;
  picture.output = output;
  return picture;
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

Canvas blank(const Options& options, const Region& part) {
  Canvas canvas;
  const std::size_t pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  canvas.framebuffer.width = options.width;
  canvas.framebuffer.height = options.height;
  canvas.framebuffer.pixels.reserve(pixels);
  fill_by_huge_pages(canvas.framebuffer.pixels.data(), pixels * sizeof(Color));
  canvas.framebuffer.pixels.assign(pixels, Color());
  canvas.framebuffer.done.assign(pixels, 0);
  if (!part.empty())
    canvas.pixels = static_cast<std::uint64_t>(part.last_column - part.first_column + 1) *
                    static_cast<std::uint64_t>(part.last_row - part.first_row + 1);
  return canvas;
}

// Of the passes before the picture: what was made by an earlier render, or where to put it.
struct Prepasses {
  std::optional<std::string> from, to;
};

// Renders into the canvas, with the state file where there is one.
void trace(const Job& job, const scene::Scene& scene, const Region& part, Canvas& canvas, StateFile* state,
           LayerChoice& choice, Prepasses& prepasses, FrameReport& report) {
  // +WT0 and an empty region trace nothing and still make a picture.
  if (part.empty() || job.options.threads.value_or(1) <= 0)
    return render::resize_layers(choice.layers, job.options.width, job.options.height);
  render::Options options = render_options(job, part);
  if (choice.any) options.layers = &choice.layers;
  if (prepasses.from) options.prepasses_from = &*prepasses.from;
  if (prepasses.to) options.prepasses_to = &*prepasses.to;
  std::atomic<std::uint64_t> rays{0};
  options.rays = &rays;
  options.progress = [&](double fraction) { job.console.progress(fraction, canvas.pixels, rays); };
  options.pass_progress = [&](const char* pass, double fraction) { job.console.pass_progress(pass, fraction); };
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
}

void write(const Job& job, const Canvas& canvas, const LayerChoice& choice, const OutputName& name,
           const image::OutputOptions& output, FrameReport& report) {
  if (!job.options.output_to_file) return;
  const auto start = Clock::now();
  const auto write_picture = [&](const fs::path& path) {
    if (choice.any)
      image::write_layers(canvas.framebuffer, choice.layers, choice.beauty, path, output);
    else
      image::write(canvas.framebuffer, path, output);
  };
  if (name.standard_output || name.standard_error) {
    write_to_stream(name.standard_error, write_picture);
  } else {
    write_picture(name.path);
    report.output = name.path;
  }
  report.seconds_write = since(start);
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
  report.seconds_write = since(start);
}

bool is_whole_part(const fs::path& path, const PartHeader& header) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  try {
    PartFile file(path);
    const PartChoice &there = file.header().part, &wanted = header.part;
    if (there.name() != wanted.name() || !difference(file.header().picture, header.picture).empty()) return false;
    file.check();
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

// As POV-Ray ends a render of an isosurface whose max_gradient does not fit.
void warn_of_object(const Job& job, const scene::Place& place, const std::string& text) {
  const std::string file = place.file ? *place.file : std::string();
  const bool povray = job.console.style() == Style::povray;
  job.console.line(Stream::warning,
                   povray ? wrapped(fmt::format("File: {}  Line: {}\nShutdown Warning: {}", file, place.line, text))
                          : wrapped(fmt::format("{}:{}: warning: {}", file, place.line, text)));
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

  Canvas canvas = blank(options, part);
  std::unique_ptr<StateFile> state;
  if (to_file && !options.replay && !which.prepasses) {
    state = std::make_unique<StateFile>(name.state_path, key_of_part(key, which));
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
    report.message =
        fmt::format("{}:{}:{}: {}", diagnostic.file, diagnostic.line, diagnostic.column, diagnostic.message);
    return;
  }
  report.seconds_render = since(start);
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

parser::ParseOptions parse_options(const Job& job, const Frame& frame) {
  const Options& options = job.options;
  parser::ParseOptions result;
  result.library_paths = search_paths(options, job.scene.path);
  result.standard_includes = false;  // they are among those
  result.tune_heap = true;
  if (!options.include_header.empty()) result.include_headers.push_back(options.include_header);
  result.declarations = options.declarations;
  result.width = options.width;
  result.height = options.height;
  result.clock = frame.clock;
  result.clock_on = job.animation.clock_on;
  result.frame_number = frame.number;
  result.initial_frame = job.animation.initial_frame;
  result.final_frame = job.animation.final_frame;
  result.initial_clock = job.animation.initial_clock;
  result.final_clock = job.animation.final_clock;
  result.clock_delta = job.animation.clock_delta;
  result.version = static_cast<int>(options.version * 100 + 0.5);
  result.quality = options.quality;
  result.allow_read = options.allow_read;
  result.allow_write = options.allow_write;
  result.limits = options.limits;
  result.debug = [&console = job.console](const std::string& text) { console.debug(text); };
  result.message = [&console = job.console](const parser::Diagnostic& d) { console.diagnostic(d); };
  result.cancelled = [&interrupt = job.interrupt, &console = job.console] {
    console.parse_progress();
    return interrupt.flag().load();
  };
  return result;
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
    parser::ParseResult own;
    const bool reuse = job.shared && job.shared->result.scene.has_value();
    if (!reuse) own = parse(job, frame, report);
    if (!reuse && !own.scene) return report;
    if (!reuse && job.shared && job.animation.count() > 1 && own.warnings == 0 &&
        !depends_on_frame(own.files_read, job.scene.text))
      job.shared->result = std::move(own);
    const parser::ParseResult& parsed = job.shared && job.shared->result.scene ? job.shared->result : own;
    report.scene_reused = reuse;
    report.files_read = parsed.files_read;
    report.stochastic_features = stochastic_features(*parsed.scene, job.options.quality);
    if (job.console.style() == Style::povray)
      job.console.line(Stream::statistic, parser_statistics(*parsed.scene, report));
    render_parsed(job, frame, *parsed.scene, name, report);
    if (report.status == kOk && job.console.style() == Style::povray)
      job.console.line(Stream::statistic, render_statistics(job.options, *parsed.scene, report));
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
