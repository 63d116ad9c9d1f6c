#include "cli/farm/slurm.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cctype>
#include <cstdlib>
#include <span>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/farm/task_script.h"
#include "cli/settings/options.h"
#include "cli/settings/text.h"
#include "compare/oracle/process.h"

namespace verisim::cli {
namespace {

using ProgramWords = std::vector<std::string>;

constexpr int kArray = 1000;  // tasks of one array
constexpr int kUsualGrace = 90, kShortestGrace = 5;

std::string name_of(const FarmJob& job, const Step& step) {
  return job.key + "-" +
         (step.kind == Step::Kind::task ? std::to_string((step.number - 1) / kArray * kArray) : step.name());
}

// The step behind a name and an array's index; nothing: none of this job.
std::optional<Step> step_of(const FarmJob& job, std::string_view name, std::string_view index) {
  if (!name.starts_with(job.key + "-")) return std::nullopt;
  name.remove_prefix(job.key.size() + 1);
  if (name == "prepass") return Step{Step::Kind::prepass, 0};
  if (name == "merge") return Step{Step::Kind::merge, 0};
  int offset = 0, number = 0;
  const auto is_number = [](std::string_view text, int& value) {
    return std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc();
  };
  if (!is_number(name, offset) || !is_number(index, number)) return std::nullopt;
  return Step{Step::Kind::task, offset + number};
}

EngineStep::State state_of(std::string_view word) {
  using State = EngineStep::State;
  for (const char* waits : {"PENDING", "CONFIGURING", "REQUEUED", "REQUEUE_HOLD", "REQUEUE_FED", "SPECIAL_EXIT"})
    if (word == waits) return State::waiting;
  for (const char* runs : {"RUNNING", "COMPLETING", "SUSPENDED", "SIGNALING", "STAGE_OUT", "STOPPED", "RESIZING"})
    if (word == runs) return State::running;
  return State::ended;
}

compare::ProcessResult call(const ProgramWords& words) {
  constexpr double kPatience = 60;  // seconds
  compare::ProcessRequest request;
  request.arguments = words;
  request.arguments[0] = compare::find_program(words[0]).string();
  if (request.arguments[0].empty())
    throw std::runtime_error(fmt::format(
        "Slurm's {} is not in PATH: call this where jobs are submitted from (or --dry-run, which submits nothing)",
        words[0]));
  for (char** entry = environ; *entry; ++entry) {
    const std::string_view text(*entry);
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos)
      request.environment.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  request.folder = std::filesystem::current_path();
  request.time_limit = kPatience;
  return compare::run_process(request);
}

std::string said(const compare::ProcessResult& result, double patience = 60) {
  const std::string text(trim(result.err));
  return !result.started ? result.start_error : text.empty() ? result.how_it_ended(patience) : text;
}

// One call of sbatch.
struct Batch {
  Step::Kind kind = Step::Kind::task;
  std::string name;
  ProgramWords options, script;
  // What it waits for: batches before it by number, and jobs that are there already; that they end, or end well.
  std::vector<std::size_t> after_any, after_ok;
  ProgramWords any_jobs, ok_jobs;
};

// The call; `ids`: those of the batches before it.
ProgramWords words_of(const Batch& batch, const ProgramWords& ids) {
  std::string dependency;
  const auto add = [&](const char* how, ProgramWords jobs, const std::vector<std::size_t>& batches) {
    for (const std::size_t i : batches) jobs.push_back(ids[i]);
    if (!jobs.empty()) dependency += fmt::format("{}{}:{}", dependency.empty() ? "" : ",", how, fmt::join(jobs, ":"));
  };
  add("afterok", batch.ok_jobs, batch.after_ok);
  add("afterany", batch.any_jobs, batch.after_any);
  ProgramWords words{"sbatch"};
  words.insert(words.end(), batch.options.begin(), batch.options.end());
  if (!dependency.empty()) words.push_back("--dependency=" + dependency);
  words.insert(words.end(), batch.script.begin(), batch.script.end());
  return words;
}

std::string command_line_of(const ProgramWords& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

// Names of Slurm's jobs, as few calls of squeue as its answers allow (we keep 256 KiB of each).
ProgramWords names_for_squeue(const FarmJob& job) {
  ProgramWords lists{fmt::format("{0}-prepass,{0}-merge,{0}-0", job.key)};
  for (int offset = kArray; offset < job.tasks; offset += kArray)
    lists.push_back(fmt::format("{}-{}", job.key, offset));
  return lists;
}

// Lines of NAME|INDEX|STATE|NODE|ID|REASON. Of several jobs for one step the living one counts, then the last.
void read(const FarmJob& job, const std::string& text, EngineSteps& known) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::vector<std::string> fields;
    for (std::size_t from = at; from <= end && fields.size() < 6;) {
      const std::size_t bar = fields.size() == 5 ? end : std::min(text.find('|', from), end);
      fields.push_back(text.substr(from, bar - from));
      from = bar + 1;
    }
    at = end + 1;
    const std::optional<Step> step = fields.size() == 6 ? step_of(job, fields[0], fields[1]) : std::nullopt;
    if (!step) continue;
    EngineStep now{state_of(fields[2]), fields[3], fields[5], fields[4]};
    // What Slurm holds back after a failure never runs by itself.
    if (now.reason.find("launch failed") != std::string::npos)
      now.state = EngineStep::State::ended;
    else if (now.state == EngineStep::State::ended)
      now.reason = lower(fields[2]);
    const auto rank = [](const EngineStep& s) {
      return std::pair(s.state != EngineStep::State::ended, std::atol(s.id.c_str()));
    };
    const auto [entry, fresh] = known.try_emplace(*step, now);
    if (!fresh && rank(now) >= rank(entry->second)) entry->second = now;
  }
}

class Slurm final : public Engine {
 public:
  void require() const override {
    for (const char* program : {"sbatch", "squeue", "scancel"})
      if (compare::find_program(program).empty())
        throw std::runtime_error(fmt::format(
            "Slurm's {} is not in PATH: call this where jobs are submitted from; --dry-run shows what would "
            "be done without it",
            program));
  }

  void check(EngineOptions& options) const override {
    if (!options.time.empty() && options.time != "UNLIMITED") {
      const std::optional<long> seconds = slurm_seconds(options.time);
      if (!seconds || *seconds < 60)
        throw OptionError(
            fmt::format("--time is the limit of one task, at least a minute: minutes, hours:minutes:seconds or "
                        "days-hours, not '{}'",
                        options.time));
      if (options.grace == 0)
        options.grace = static_cast<int>(std::clamp<long>(*seconds / 4, kShortestGrace, kUsualGrace));
      if (options.grace * 2L > *seconds)
        throw OptionError(fmt::format("--grace {} leaves a task less than half of its time (--time {})", options.grace,
                                      options.time));
    }
    if (options.grace == 0) options.grace = kUsualGrace;
    if (options.nodes < 0 || options.cpus < 0 || options.grace < 0)
      throw OptionError("--nodes, --cpus and --grace are numbers above 0");
  }

  std::string submit(const FarmJob& job, const std::vector<Step>& steps, const EngineSteps& alive) override {
    std::vector<Batch> batches = batches_of(job, steps, alive);
    ProgramWords ids;
    for (const Batch& batch : batches) {
      const ProgramWords words = words_of(batch, ids);
      const compare::ProcessResult result = call(words);
      std::string id(trim(result.out));
      id.resize(std::min(id.find(';'), id.size()));  // ;cluster
      const bool number =
          !id.empty() && std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isdigit(c); });
      if (!result.succeeded() || !number) {
        for (const std::string& submitted : ids) call({"scancel", submitted});
        throw std::runtime_error(fmt::format("sbatch refused {}: {}\nnothing is submitted; this was the call:\n{}",
                                             batch.name, said(result), command_line_of(words)));
      }
      ids.push_back(id);
    }
    return fmt::format("{} steps submitted as {}", steps.size(), fmt::join(ids, ", "));
  }

  std::string rehearse(const FarmJob& job, const std::vector<Step>& steps, const EngineSteps& alive) const override {
    ProgramWords ids;
    std::string text;
    for (const Batch& batch : batches_of(job, steps, alive)) {
      text += command_line_of(words_of(batch, ids)) + "\n";
      ids.push_back(fmt::format("<{}>", batch.name));
    }
    return text;
  }

  std::optional<EngineSteps> steps(const FarmJob& job, std::string& why) override {
    EngineSteps known;
    for (const std::string& names : names_for_squeue(job)) {
      try {
        const compare::ProcessResult result =
            call({"squeue", "--noheader", "--array", "--states=all", "--name=" + names, "--format=%j|%K|%T|%N|%F|%r"});
        if (!result.succeeded()) return why = "squeue: " + said(result), std::nullopt;
        read(job, result.out, known);
      } catch (const std::runtime_error& error) {
        return why = error.what(), std::nullopt;
      }
    }
    add_accounted(job, known);
    return known;
  }

  void cancel(const FarmJob& job, std::optional<Step> step) override {
    std::vector<std::string> names;
    for (const Step& each : step ? std::vector<Step>{*step} : job.steps())
      if (const std::string name = name_of(job, each); names.empty() || names.back() != name) names.push_back(name);
    for (const std::string& name : names)
      if (const compare::ProcessResult result = call({"scancel", "--name=" + name}); !result.succeeded())
        throw std::runtime_error("scancel: " + said(result));
  }

 private:
  // The steps as batches, each with what it waits for.
  static std::vector<Batch> batches_of(const FarmJob& job, const std::vector<Step>& steps, const EngineSteps& alive) {
    std::vector<Batch> batches;
    for (std::size_t i = 0; i < steps.size();) {
      std::size_t end = i + 1;
      while (end < steps.size() && steps[end].kind == Step::Kind::task &&
             name_of(job, steps[end]) == name_of(job, steps[i]))
        ++end;
      Batch batch = batch_of(job, std::span(steps).subspan(i, end - i));
      for (std::size_t k = 0; k < batches.size(); ++k) {
        if (batch.kind == Step::Kind::task && batches[k].kind == Step::Kind::prepass) batch.after_ok.push_back(k);
        // Whatever became of the parts: merging names those that are missing.
        if (batch.kind == Step::Kind::merge) batch.after_any.push_back(k);
        // One array after the other, or each would take so many nodes.
        const bool previous = batches[k].kind == Step::Kind::task && k + 1 == batches.size();
        if (batch.kind == Step::Kind::task && previous && job.engine_options.nodes > 0) batch.after_any.push_back(k);
      }
      for (const auto& [step, state] : alive) {
        ProgramWords* const jobs = step.kind == Step::Kind::prepass && batch.kind == Step::Kind::task ? &batch.ok_jobs
                                   : step.kind == Step::Kind::task && batch.kind == Step::Kind::merge ? &batch.any_jobs
                                                                                                      : nullptr;
        if (jobs && std::find(jobs->begin(), jobs->end(), state.id) == jobs->end()) jobs->push_back(state.id);
      }
      batches.push_back(std::move(batch));
      i = end;
    }
    return batches;
  }

  // Of one step, or of tasks of one array.
  static Batch batch_of(const FarmJob& job, std::span<const Step> steps) {
    const EngineOptions& o = job.engine_options;
    Batch batch{steps[0].kind, name_of(job, steps[0]), {}, {}, {}, {}, {}, {}};
    batch.options = {"--parsable",
                     "--requeue",
                     "--open-mode=append",
                     "--nodes=1",
                     "--ntasks=1",
                     "--kill-on-invalid-dep=yes",
                     "--chdir=" + job.folder.string(),
                     "--job-name=" + batch.name};
    if (!o.partition.empty()) batch.options.push_back("--partition=" + o.partition);
    if (!o.time.empty()) batch.options.push_back("--time=" + o.time);
    if (o.cpus > 0) batch.options.push_back(fmt::format("--cpus-per-task={}", o.cpus));
    batch.options.push_back(fmt::format("--signal=B:USR1@{}", o.grace));
    if (batch.kind == Step::Kind::task) {
      const int offset = (steps[0].number - 1) / kArray * kArray;
      std::vector<int> indices;
      for (const Step& step : steps) indices.push_back(step.number - offset);
      batch.options.push_back(
          fmt::format("--array={}{}", slurm_ranges(indices), o.nodes > 0 ? fmt::format("%{}", o.nodes) : ""));
      batch.options.push_back(output_of(job, "%A-%a"));
      batch.script = {job.script().string(), "array", std::to_string(offset)};
    } else {
      batch.options.push_back(output_of(job, "%j"));
      batch.script = {job.script().string(), steps[0].name()};
    }
    batch.options.insert(batch.options.end(), o.extra.begin(), o.extra.end());
    return batch;
  }

  // Slurm looks for its patterns in the whole path.
  static std::string output_of(const FarmJob& job, const char* pattern) {
    return job.folder.string().find('%') != std::string::npos ? "--output=/dev/null"
                                                              : fmt::format("--output=logs/slurm-{}.out", pattern);
  }

  // What Slurm forgets after some minutes (MinJobAge) its accounting may know, where there is one.
  void add_accounted(const FarmJob& job, EngineSteps& known) {
    if (no_accounting_ || compare::find_program("sacct").empty()) return no_accounting_ = true, void();
    EngineSteps more;
    for (const std::string& names : names_for_squeue(job)) {
      const compare::ProcessResult result =
          call({"sacct", "--noheader", "--parsable2", "--allocations", "--starttime=now-60days", "--name=" + names,
                "--format=JobName,JobID,State,NodeList"});
      if (!result.succeeded()) return no_accounting_ = true, void();
      std::string lines;
      for (std::size_t at = 0; at < result.out.size();) {  // NAME|ID_INDEX|STATE|NODE, to the shape of squeue's
        const std::size_t end = std::min(result.out.find('\n', at), result.out.size());
        std::string line = result.out.substr(at, end - at);
        at = end + 1;
        const std::size_t bar = line.find('|'), next = line.find('|', bar + 1), last = line.rfind('|');
        if (bar == std::string::npos || next == std::string::npos || last <= next) continue;
        const std::string id = line.substr(bar + 1, next - bar - 1), state = line.substr(next + 1, last - next - 1);
        const std::size_t underscore = id.find('_');
        lines += fmt::format("{}|{}|{}|{}|{}|\n", line.substr(0, bar),
                             underscore == std::string::npos ? "" : id.substr(underscore + 1),
                             state.substr(0, state.find(' ')), line.substr(last + 1), id.substr(0, underscore));
      }
      read(job, lines, more);
    }
    for (const auto& [step, state] : more) known.try_emplace(step, state);
  }

  bool no_accounting_ = false;
};

}  // namespace

std::unique_ptr<Engine> slurm_engine() { return std::make_unique<Slurm>(); }

std::unique_ptr<Engine> engine_named(const std::string& name) {
  if (name == "slurm") return slurm_engine();
  throw OptionError(fmt::format("--engine is slurm, not '{}' (docs/farm.md tells of OpenJD, too)", name));
}

std::optional<long> slurm_seconds(const std::string& text) {
  std::vector<long> numbers;
  std::string seconds = text;
  const std::size_t dash = text.find('-');
  const auto take = [&](std::string_view part) {
    long value = 0;
    const auto [end, bad] = std::from_chars(part.data(), part.data() + part.size(), value);
    const bool good =
        bad == std::errc() && end == part.data() + part.size() && value >= 0 && value < 1'000'000 && part[0] != '+';
    if (good) numbers.push_back(value);
    return good;
  };
  long days = 0;
  if (dash != std::string::npos) {
    if (!take(std::string_view(text).substr(0, dash))) return std::nullopt;
    days = numbers[0];
    numbers.clear();
    seconds = text.substr(dash + 1);
  }
  for (std::size_t at = 0; at <= seconds.size();) {
    const std::size_t colon = std::min(seconds.find(':', at), seconds.size());
    if (colon == at || !take(std::string_view(seconds).substr(at, colon - at))) return std::nullopt;
    at = colon + 1;
  }
  if (numbers.size() > 3) return std::nullopt;
  numbers.resize(3, 0);
  // With days the first number is hours; else one or two numbers begin with minutes.
  const bool hours = dash != std::string::npos || std::count(seconds.begin(), seconds.end(), ':') == 2;
  return hours ? days * 86400 + numbers[0] * 3600 + numbers[1] * 60 + numbers[2] : numbers[0] * 60 + numbers[1];
}

std::string slurm_ranges(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
    if (end > i + 1) text += fmt::format("-{}", numbers[end - 1]);
    i = end;
  }
  return text;
}

}  // namespace verisim::cli
