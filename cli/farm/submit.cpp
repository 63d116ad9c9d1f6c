#include "cli/farm/submit.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include "cli/farm/plan.h"
#include "cli/farm/task_script.h"
#include "cli/frame/job.h"
#include "cli/settings/output_name.h"
#include "cli/settings/region.h"
#include "tracer/base/output_file.h"
#include "tracer/film/errors.h"
#include "tracer/render/blocks.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

// Letters and digits of the scene's name, and a random number: what engines know the job by.
std::string new_key(const fs::path& scene) {
  std::string key;
  for (const unsigned char c : scene.stem().string())
    if (key.size() < 24) key += std::isalnum(c) ? static_cast<char>(c) : '_';
  return fmt::format("{}-{:08x}", key, std::random_device()());
}

void refuse_what_no_farm_does(const Options& options) {
  const auto stream = [](const std::string& name) { return name == "-" || name == "stdout" || name == "stderr"; };
  if (is_stream(options.input_file))
    throw OptionError("a farm needs a scene that is a file which all machines can read, not a stream");
  if (!options.output_to_file || stream(options.exact_output) || stream(options.output_file))
    throw OptionError("a farm writes its pictures to files: leave out -F, and name a file with +O or --output");
  if (!options.part.empty() || !options.prepass_file.empty())
    throw OptionError("--part and --prepass are for the tasks, which verisim farm hands out itself");
  if (!options.stats_file.empty() || !options.progress.empty() || !options.create_ini.empty())
    throw OptionError("--stats, --progress and Create_Ini would be written by every task to one file: leave them out");
  if (!options.stdin_name.empty()) throw OptionError("--stdin-name is for scenes from standard input");
}

// Pictures of an earlier render would be taken for whole ones of this job.
void refuse_old_pictures(const FarmJob& job, bool keep) {
  if (keep) return;
  std::vector<fs::path> there;
  for (int task = 1; job.animation && task <= job.tasks; ++task)
    for (const int frame : job.frames_of(task))
      if (fs::exists(job.picture_of(frame))) there.push_back(job.picture_of(frame));
  if (!job.animation && fs::exists(job.picture)) there.push_back(job.picture);
  if (!there.empty())
    throw std::runtime_error(
        fmt::format("'{}' is there already{}: remove it or choose another name{}", there.front().string(),
                    there.size() > 1 ? fmt::format(", and {} more", there.size() - 1) : "",
                    job.animation ? "; +C keeps pictures that are there and renders the others" : ""));
}

struct Parsed {
  parser::ParseResult result;
  double seconds = 0;
};

Parsed parsed_scene(const Job& job) {
  const auto start = std::chrono::steady_clock::now();
  Parsed parsed{parse_scene(job, parse_options(job, job.animation.frame(0))), 0};
  parsed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  job.console.end_of_debug();
  if (job.interrupt.flag()) throw SceneRefused{kInterrupted};
  if (!parsed.result.scene) {
    const bool unsupported = std::any_of(parsed.result.errors.begin(), parsed.result.errors.end(),
                                         [](const auto& e) { return e.severity == parser::Severity::unsupported; });
    throw SceneRefused{unsupported ? kUnsupported : kSceneErrors};
  }
  return parsed;
}

bool has_prepasses(const scene::Scene& scene, const Options& options) {
  return options.quality >= 9 && options.integrator != "path" &&
         (scene.settings.radiosity.enabled || scene.settings.photons.enabled);
}

void plan_still(const SubmitRequest& request, const Job& render, FarmJob& job) {
  const Parsed parsed = parsed_scene(render);
  const render::Options options = render_options(render, region(request.options));
  const auto blocks = static_cast<int>(render::blocks_of(render::render_area(options), options.block_size).size());
  job.prepass = has_prepasses(*parsed.result.scene, request.options);
  job.tasks = request.parts > 0 ? request.parts
                                : parts_for(measure_costs(render, *parsed.result.scene, parsed.seconds), blocks,
                                            request.engine_options.nodes);
  job.picture = fs::absolute(output_name(request.options, render.scene.path, render.animation, {}).path);
}

void plan_animation(const SubmitRequest& request, const Job& render, FarmJob& job) {
  const Parsed parsed = parsed_scene(render);
  const Animation& animation = render.animation;
  const auto frames = static_cast<int>(animation.count());
  if (frames == 0) throw OptionError("there is no frame to render");
  job.animation = true;
  job.first = animation.first, job.last = animation.last, job.step = animation.step;
  job.frames_per_task = request.frames_per_task > 0
                            ? request.frames_per_task
                            : frames_per_task_for(measure_costs(render, *parsed.result.scene, parsed.seconds), frames,
                                                  request.engine_options.nodes);
  job.tasks = (frames + job.frames_per_task - 1) / job.frames_per_task;
  const fs::path first =
      fs::absolute(output_name(request.options, render.scene.path, animation, animation.frame(0)).path);
  const std::string stem = first.stem().string(), number = fmt::format("{:0{}}", animation.first, animation.digits);
  job.before_number = first.parent_path() / stem.substr(0, stem.size() - number.size());
  job.digits = animation.digits, job.after_number = first.extension().string();
}

}  // namespace

FarmJob plan_job(const SubmitRequest& request) {
  const Options& options = request.options;
  refuse_what_no_farm_does(options);
  const SceneSource scene = open_scene(options);
  if (!scene.found()) throw std::runtime_error(fmt::format("cannot find the scene '{}'", options.input_file));
  Console console(options, Style::verisim);
  Interrupt interrupt(watch(options, console));
  const Job render{options, console, interrupt, scene, animation(options), nullptr};
  FarmJob job;
  job.key = new_key(scene.path);
  job.version = VERISIM_VERSION, job.program = request.program;
  job.engine = request.engine, job.engine_options = request.engine_options;
  job.directory = fs::current_path();
  job.scene = scene.path.string(), job.words = request.words;
  if (render.animation.on && request.parts > 0)
    throw OptionError("--parts is for one picture; the frames of an animation are shared out by --frames-per-task");
  if (!render.animation.on && request.frames_per_task > 0)
    throw OptionError("--frames-per-task is for animations (+KFFn); one picture is cut by --parts");
  try {
    render.animation.on ? plan_animation(request, render, job) : plan_still(request, render, job);
  } catch (const render::Unsupported& missing) {
    console.line(Stream::fatal,
                 fmt::format("verisim: {}:{}: not supported: {}", missing.place.file ? *missing.place.file : job.scene,
                             missing.place.line, missing.what()));
    throw SceneRefused{kUnsupported};
  }
  const std::string name = job.animation ? job.before_number.filename().string() : job.picture.stem().string();
  job.folder =
      fs::absolute(request.folder.empty() ? fs::path((name.empty() ? scene.path.stem().string() : name) + ".farm")
                                          : fs::path(request.folder))
          .lexically_normal();
  if (!job.folder.has_filename()) job.folder = job.folder.parent_path();
  if (fs::exists(job.folder))
    throw std::runtime_error(fmt::format(
        "'{}' is there already: `verisim farm resume` goes on with a job; or choose another folder with --job",
        job.folder.string()));
  refuse_old_pictures(job, options.continue_trace);
  return job;
}

void make_folder(const FarmJob& job) {
  std::error_code error;
  fs::create_directories(job.folder.parent_path(), error);
  if (!error && !fs::create_directory(job.folder, error) && !error)
    error = std::make_error_code(std::errc::file_exists);
  if (error)
    throw std::runtime_error(
        fmt::format("cannot make the job folder '{}': {}; it must lie where this user may write and "
                    "all nodes can see it",
                    job.folder.string(), error.message()));
  try {
    fs::create_directory(job.folder / "logs");
    if (!job.animation) fs::create_directory(job.folder / "parts");
    write_text_file(job.script(), task_script(job));
    fs::permissions(job.script(), fs::perms::owner_exec | fs::perms::group_exec, fs::perm_options::add);
    write_manifest(job);
    require_writable(job.animation ? job.picture_of(job.first) : job.picture);
  } catch (...) {
    fs::remove_all(job.folder, error);
    throw;
  }
}

}  // namespace verisim::cli
