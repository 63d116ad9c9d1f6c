#include "cli/farm/status.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/farm/log_file.h"
#include "cli/frame/state_file.h"
#include "cli/parts/part_file.h"
#include "compare/json_text.h"

namespace fs = std::filesystem;

namespace verisim::cli {
namespace {

using StepState = StepStatus::State;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && fs::file_size(path, ignored) > 0;
}

// The part is there and whole; else `why` says what is wrong with one that is there.
bool is_whole_part(const fs::path& path, bool read_everything, std::string& why) {
  if (!is_file(path)) return false;
  try {
    PartFile part(path);
    if (read_everything) part.check();
    return true;
  } catch (const std::runtime_error& error) {
    return why = error.what(), false;
  }
}

// Of an animation's task: pictures that are there, one with a state file beside it being unfinished.
double frames_done(const FarmJob& job, int task) {
  const std::vector<int> frames = job.frames_of(task);
  const auto done = std::count_if(frames.begin(), frames.end(), [&](int frame) {
    fs::path state = job.picture_of(frame);
    return is_file(state) && !is_state_file(state.replace_extension(".pov-state"));
  });
  return frames.empty() ? 1 : static_cast<double>(done) / static_cast<double>(frames.size());
}

// What the files say alone.
void look_at_files(const FarmJob& job, const StepLog& log, bool read_everything, StepStatus& status) {
  bool done = false;
  if (status.step.kind == Step::Kind::merge) {
    done = is_file(job.picture) && log.exit_status == 0;
  } else if (job.animation) {
    status.fraction = frames_done(job, status.step.number);
    done = status.fraction >= 1;
  } else {
    const fs::path path = status.step.kind == Step::Kind::prepass ? job.prepass_part() : job.part(status.step.number);
    done = is_whole_part(path, read_everything, status.note);
  }
  if (!done && log.begun) {
    status.fraction = std::max(status.fraction, std::min(log.fraction, 0.9999));
    status.node = log.node;
  }
  if (done) status.state = StepState::done, status.fraction = 1, status.note.clear();
}

std::string ended_words(const StepLog& log, const EngineStep* engine) {
  const bool by_engine = engine && engine->state == EngineStep::State::ended && engine->reason != "completed";
  const std::string how = by_engine ? engine->reason : "";
  if (log.exit_status && *log.exit_status != 0)
    return fmt::format("{}{}", log.message.empty() ? fmt::format("exit status {}", *log.exit_status) : log.message,
                       how.empty() || how == "failed" ? "" : " (" + how + ")");
  if (!log.begun) return how.empty() ? "" : how + ", and it said nothing: does its node see the job folder?";
  if (log.exit_status) return "it ended well, but what it made is gone";
  return how.empty() ? "it ended without a word" : how;
}

void look_at_engine(const EngineStep* engine, const StepLog& log, StepStatus& status) {
  if (engine && engine->state == EngineStep::State::running) {
    status.state = StepState::running;
    status.node = engine->node;
    if (!log.exit_status) status.remaining = log.remaining;
    status.note = log.requeued ? "saves its state" : log.stage;
  } else if (engine && engine->state == EngineStep::State::waiting) {
    status.state = StepState::waiting;
    status.note = engine->reason;
  } else {
    const std::string why = ended_words(log, engine);
    const bool failed = log.begun || !why.empty() || !status.note.empty();
    status.state = failed ? StepState::failed : StepState::missing;
    if (!why.empty() && status.note.empty()) status.note = why;
  }
}

// Nobody has to do anything about it.
bool is_usual(const std::string& reason) {
  for (const char* usual : {"", "None", "Priority", "Resources", "Dependency", "BeginTime", "JobArrayTaskLimit"})
    if (reason == usual) return true;
  return false;
}

const char* word_of(StepState state) {
  switch (state) {
    case StepState::missing:
      return "not there, and not in the queue";
    case StepState::failed:
      return "failed";
    case StepState::waiting:
      return "waiting";
    case StepState::running:
      return "running";
    case StepState::unknown:
      return "nobody knows";
    case StepState::done:
      return "done";
  }
  return "";
}

}  // namespace

int JobStatus::count(StepState state) const {
  return static_cast<int>(
      std::count_if(steps.begin(), steps.end(), [state](const StepStatus& s) { return s.state == state; }));
}

double JobStatus::fraction() const {
  double sum = 0;
  int tasks = 0;
  for (const StepStatus& s : steps)
    if (s.step.kind == Step::Kind::task) sum += s.fraction, ++tasks;
  return tasks ? sum / tasks : 0;
}

JobStatus job_status(const FarmJob& job, Engine& engine, bool read_everything) {
  JobStatus result;
  std::optional<EngineSteps> known = engine.steps(job, result.engine_error);
  result.engine_answers = known.has_value();
  if (known) result.engine_steps = std::move(*known);
  for (const Step& step : job.steps()) {
    StepStatus& status = result.steps.emplace_back();
    status.step = step;
    const StepLog log = read_log(job.log(step));
    if (log.begin && (!result.begin || *log.begin < *result.begin)) result.begin = log.begin;
    look_at_files(job, log, read_everything, status);
    if (status.state == StepState::done) continue;
    const auto found = result.engine_steps.find(step);
    const EngineStep* const entry = found == result.engine_steps.end() ? nullptr : &found->second;
    if (result.engine_answers) {
      look_at_engine(entry, log, status);
    } else {
      status.state = StepState::unknown;
      if (log.begun && !log.exit_status) status.note = fmt::format("last heard of {:.0f} s ago", log.age);
      if (log.exit_status && *log.exit_status != 0) status.note = ended_words(log, nullptr);
    }
  }
  // Who has the picture needs its parts no longer.
  if (!job.animation && result.steps.back().state == StepState::done)
    for (StepStatus& s : result.steps)
      if (s.state == StepState::failed || s.state == StepState::missing || s.state == StepState::unknown)
        s.state = StepState::done, s.fraction = 1, s.note.clear();
  return result;
}

std::string as_text(const FarmJob& job, const JobStatus& status, int lines) {
  std::string text;
  int left_out = 0;
  for (const StepStatus& s : status.steps) {
    if (s.state == StepState::done || (s.state == StepState::waiting && s.fraction == 0 && is_usual(s.note))) continue;
    if (lines-- <= 0) {
      ++left_out;
      continue;
    }
    const bool task = s.step.kind == Step::Kind::task;
    text += fmt::format("{}{}: {}", task ? "task " : "", s.step.name(), word_of(s.state));
    if (!s.node.empty() && s.state == StepState::running) text += " on " + s.node;
    if (s.fraction > 0) text += fmt::format(", {:.0f} % done", std::min(100 * s.fraction, 99.0));
    if (s.remaining) text += fmt::format(", about {:.0f} s left", *s.remaining);
    if (!s.note.empty()) text += fmt::format(" ({})", s.note);
    text += '\n';
  }
  if (left_out > 0) text += fmt::format("and {} more\n", left_out);
  const auto add = [&](StepState state, const char* word) {
    const int count = status.count(state);
    return count ? fmt::format(", {} {}", count, word) : "";
  };
  text += fmt::format("{} of {} steps done{}{}{}{}{}\n", status.count(StepState::done), status.steps.size(),
                      add(StepState::running, "running"), add(StepState::waiting, "waiting"),
                      add(StepState::failed, "failed"), add(StepState::missing, "not in the queue"),
                      add(StepState::unknown, "unknown"));
  if (!status.engine_answers)
    text += fmt::format("{} does not answer, so this is from the files alone: {}\n", job.engine, status.engine_error);
  if (!job.animation && status.complete()) text += fmt::format("picture: {}\n", job.picture.string());
  return text;
}

std::string as_json(const FarmJob& job, const JobStatus& status) {
  using nlohmann::ordered_json;
  constexpr const char* kNames[] = {"missing", "failed", "waiting", "running", "unknown", "done"};
  ordered_json steps = ordered_json::array();
  for (const StepStatus& s : status.steps)
    steps.push_back({{"step", s.step.name()},
                     {"state", kNames[static_cast<std::size_t>(s.state)]},
                     {"fraction", s.fraction},
                     {"remaining", s.remaining ? ordered_json(*s.remaining) : ordered_json()},
                     {"node", s.node},
                     {"note", s.note}});
  const ordered_json all{{"job", job.key},
                         {"complete", status.complete()},
                         {"fraction", status.fraction()},
                         {"engine_answers", status.engine_answers},
                         {"engine_error", status.engine_error},
                         {"steps", std::move(steps)}};
  return compare::json_text(all, 2) + "\n";
}

}  // namespace verisim::cli
