// `verisim farm`: renders on the machines of a cluster.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "cli/commands/commands.h"
#include "cli/commands/own_program.h"
#include "cli/farm/engine.h"
#include "cli/farm/status.h"
#include "cli/farm/submit.h"
#include "cli/farm/task_script.h"
#include "cli/farm/wait.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/reading/scene_words.h"
#include "cli/settings/text.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

struct WantedFarm {
  SubmitRequest submit;
  bool dry_run = false, json = false;
};

constexpr std::array kWithValue{"--engine", "--job",  "--nodes", "--frames-per-task", "--parts",  "--partition",
                                "--time",   "--cpus", "--grace", "--engine-option",   "--program"};

void add_farm_options(OwnOptions& own, WantedFarm& wanted) {
  SubmitRequest& s = wanted.submit;
  own.section("Options of submit (and, but for the first five, of resume)");
  own.value("--engine NAME", s.engine, "what runs the tasks: slurm (the one there is)");
  own.value("--job FOLDER", s.folder, "the job folder, to be made; without it one named after the picture, with .farm");
  own.value("--parts N", s.parts, "cut a picture into so many parts; without it as many as docs/farm.md recommends");
  own.value("--frames-per-task N", s.frames_per_task, "frames of an animation that a task renders; likewise");
  own.value("--program FILE", s.program, "verisim as the nodes find it; without it this program's own file");
  own.value("--nodes N", s.engine_options.nodes, "run at most so many tasks at a time, each on one node");
  own.value("--cpus N", s.engine_options.cpus, "processors of a task; without it what the engine gives");
  own.value("--partition NAME", s.engine_options.partition, "Slurm's partition (queue)");
  own.value("--time LIMIT", s.engine_options.time,
            "the time limit of a task, as sbatch takes it; one that needs longer saves its state and is queued again");
  own.value("--grace SECONDS", s.engine_options.grace,
            "how long before the limit it does so (a quarter of the limit, at most 90)");
  own.values("--engine-option OPTION", s.engine_options.extra,
             "an option for sbatch, as --engine-option=--account=films (may be given again)");
  own.flag("--dry-run", wanted.dry_run, "show what would be written and submitted, and do nothing");
  own.section("Options of status");
  own.flag("--json", wanted.json, "print the state of all steps as JSON");
}

// The arguments that are none of this command's own: those of `verisim render`.
std::vector<std::string> render_words(const std::vector<std::string>& arguments) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string name = arguments[i].substr(0, arguments[i].find('='));
    if (name == "--") throw OptionError("every word is taken here as render takes it: leave out --");
    const bool has_value = std::find(kWithValue.begin(), kWithValue.end(), name) != kWithValue.end();
    if (has_value && name.size() == arguments[i].size()) ++i;
    if (!has_value && arguments[i] != "--dry-run") words.push_back(arguments[i]);
  }
  return words;
}

// What only one call at a time may do with a job.
class Lock {
 public:
  explicit Lock(const FarmJob& job) : file_(::open(job.manifest().c_str(), O_RDONLY | O_CLOEXEC)) {
    if (file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(file_);
      throw std::runtime_error(fmt::format("another `verisim farm` is at work on '{}'", job.folder.string()));
    }
  }
  ~Lock() {
    if (file_ >= 0) ::close(file_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

void say(const std::string& text) { std::fputs(text.c_str(), stdout); }

std::string plan_words(const FarmJob& job) {
  const auto plural = [](int count, const char* word) {
    return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
  };
  if (job.animation) return fmt::format("{} of {}", plural(job.tasks, "task"), plural(job.frames_per_task, "frame"));
  return plural(job.tasks, "part") + (job.prepass ? ", passes before the picture" : "");
}

int submit(WantedFarm& wanted, const std::vector<std::string>& arguments, const std::vector<std::string>& words) {
  SubmitRequest& request = wanted.submit;
  request.words = render_words(arguments);
  const std::vector<std::string> files = apply_words(request.options, words);
  if (files.size() > 1) throw OptionError(fmt::format("one scene at a time: '{}' and '{}'", files[0], files[1]));
  if (!files.empty()) request.options.input_file = files[0];
  if (request.options.input_file.empty()) throw OptionError("no scene: verisim farm submit SCENE [switches]");
  if (request.parts < 0 || request.frames_per_task < 0 || request.parts > 1'000'000)
    throw OptionError("--parts and --frames-per-task are numbers above 0, at most a million");
  choose_format(request.options);
  validate(request.options);
  if (request.engine.empty()) request.engine = "slurm";
  if (request.program.empty()) request.program = own_program().string();
  const std::unique_ptr<Engine> engine = engine_named(request.engine);
  engine->check(request.engine_options);
  if (!wanted.dry_run) engine->require();
  FarmJob job;
  try {
    job = plan_job(request);
  } catch (const SceneRefused& refused) {
    return refused.status;
  }
  const std::string plan = plan_words(job);
  if (wanted.dry_run) {
    say(fmt::format("# {}: {}\n# {}:\n{}\n# and these calls, from any folder:\n{}", job.folder.string(), plan,
                    job.script().string(), task_script(job), engine->rehearse(job, job.steps(), {})));
    return kOk;
  }
  make_folder(job);
  try {
    const Lock lock(job);
    const std::string said = engine->submit(job, job.steps(), {});
    say(fmt::format("{}: {}, {}\n`verisim farm wait {}` shows how far it is\n", job.folder.string(), plan, said,
                    shell_word(fs::proximate(job.folder).string())));
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(job.folder, ignored);
    throw;
  }
  return kOk;
}

// What was given now counts instead of what was given to submit.
void change(EngineOptions& options, const EngineOptions& given) {
  if (!given.partition.empty()) options.partition = given.partition;
  if (!given.time.empty()) options.time = given.time, options.grace = 0;
  if (given.grace > 0) options.grace = given.grace;
  if (given.nodes != 0) options.nodes = given.nodes;
  if (given.cpus != 0) options.cpus = given.cpus;
  if (!given.extra.empty()) options.extra = given.extra;
}

int resume(FarmJob job, Engine& engine, const WantedFarm& wanted) {
  using State = StepStatus::State;
  const Lock lock(job);
  change(job.engine_options, wanted.submit.engine_options);
  engine.check(job.engine_options);
  JobStatus status = job_status(job, engine, true);
  if (!status.engine_answers)
    throw std::runtime_error(
        fmt::format("nobody knows what is still running, so nothing is submitted: {}", status.engine_error));
  if (status.complete()) return say(fmt::format("{}: all is done\n", job.folder.string())), kOk;
  std::vector<Step> steps;
  bool tasks = false;
  for (const StepStatus& s : status.steps)
    if (s.state == State::failed || s.state == State::missing)
      steps.push_back(s.step), tasks |= s.step.kind == Step::Kind::task;
  // Passes before the picture are for parts.
  if (!tasks && !steps.empty() && steps.front().kind == Step::Kind::prepass) steps.erase(steps.begin());
  const Step merge{Step::Kind::merge, 0};
  const bool merge_waits = !job.animation && status.steps.back().state == State::waiting;
  if (tasks && merge_waits) steps.push_back(merge);  // for these, too
  if (steps.empty())
    return say(fmt::format("{}: nothing is missing that is not in the queue\n", job.folder.string())), kOk;
  EngineSteps alive;
  for (const auto& [step, state] : status.engine_steps)
    if (state.state != EngineStep::State::ended) alive.emplace(step, state);
  if (wanted.dry_run) return say(engine.rehearse(job, steps, alive)), kOk;
  write_manifest(job);
  if (tasks && merge_waits) engine.cancel(job, merge);
  say(fmt::format("{}: {}\n", job.folder.string(), engine.submit(job, steps, alive)));
  return kOk;
}

int cancel(const FarmJob& job, Engine& engine) {
  const Lock lock(job);
  engine.cancel(job);
  say(fmt::format("{}: taken out of the queue; `verisim farm resume` goes on with what is missing\n",
                  job.folder.string()));
  return kOk;
}

}  // namespace

int command_farm(const std::vector<std::string>& arguments) {
  WantedFarm wanted;
  OwnOptions own("farm",
                 "Renders on the machines of a cluster: an animation by its frames, a picture by its parts. What comes "
                 "out is what `verisim render` would have written, to the byte, whatever died on the way. `submit` "
                 "makes a job folder, which all nodes must see, and hands its tasks to the engine (Slurm); `status` "
                 "tells how far they are, `wait` waits for them, `cancel` ends them, and `resume` submits what is "
                 "missing. Switches of POV-Ray's and options of render are those of the picture.");
  own.synopsis("submit SCENE|INI [options] [switches] | status|wait|cancel|resume FOLDER")
      .summary("render on many machines")
      .example("verisim farm submit scene.pov +W8000 +H6000 +A0.1 --partition render", "parts, and their merging")
      .example("verisim farm submit film.pov +KFF240 +Oframes/ --frames-per-task 10 --time 30", "240 frames")
      .example("verisim farm wait scene.farm", "a bar over all tasks, with the time left");
  add_farm_options(own, wanted);
  add_render_options(own, wanted.submit.options);
  const std::vector<std::string> words = own.parse(arguments);
  const std::vector<std::string_view> actions{"submit", "status", "wait", "cancel", "resume"};
  if (words.empty() || std::find(actions.begin(), actions.end(), words[0]) == actions.end()) {
    const std::string advice = words.empty() ? "" : nearest(words[0], actions);
    throw OptionError(fmt::format("what is to be done: submit, status, wait, cancel or resume{}",
                                  advice.empty() ? "" : fmt::format("? '{}' may be {}", words[0], advice)));
  }
  const std::string& action = words[0];
  if (action == "submit") {
    std::vector<std::string> rest = arguments;
    rest.erase(std::find(rest.begin(), rest.end(), action));
    return submit(wanted, rest, {words.begin() + 1, words.end()});
  }
  if (words.size() != 2) throw OptionError(fmt::format("name one job folder: verisim farm {} FOLDER", action));
  const FarmJob job = read_job(words[1]);
  const std::unique_ptr<Engine> engine = engine_named(job.engine);
  if (action == "status") {
    const JobStatus status = job_status(job, *engine);
    return say(wanted.json ? as_json(job, status) : as_text(job, status)), kOk;
  }
  if (action == "wait") return wait_for(job, *engine, wanted.submit.options.progress);
  engine->require();
  return action == "cancel" ? cancel(job, *engine) : resume(job, *engine, wanted);
}

}  // namespace verisim::cli
