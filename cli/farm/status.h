// How far a job is: what its files say, and what the engine says, as one truth.
//
// Files count most: a part that is whole is done, whatever anybody says of its task. Of what is not done the engine
// knows whether it runs or waits; where it does not answer, nobody knows, and that is said.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/farm/engine.h"
#include "cli/farm/job.h"

namespace verisim::cli {

struct StepStatus {
  // missing: not done, and the engine has nothing to do with it; failed: likewise, and the log says why
  enum class State { missing, failed, waiting, running, unknown, done };
  Step step;
  State state = State::missing;
  double fraction = 0;              // done of it
  std::optional<double> remaining;  // seconds, of what runs
  std::string node, note;
};

struct JobStatus {
  std::vector<StepStatus> steps;
  bool engine_answers = true;
  std::string engine_error;           // why not
  std::optional<std::int64_t> begin;  // of the first step, in seconds since 1970
  EngineSteps engine_steps;
  int count(StepStatus::State state) const;
  bool complete() const { return count(StepStatus::State::done) == static_cast<int>(steps.size()); }
  bool moving() const { return count(StepStatus::State::waiting) + count(StepStatus::State::running) > 0; }
  // Of the tasks: 0 to 1. The prepasses and the merge are not counted.
  double fraction() const;
};

// `read_everything`: parts are read to their last byte, not only measured.
JobStatus job_status(const FarmJob& job, Engine& engine, bool read_everything = false);

// For people: a line for every step that is neither done nor waiting in the queue (at most so many), and sums.
std::string as_text(const FarmJob& job, const JobStatus& status, int lines = 40);
std::string as_json(const FarmJob& job, const JobStatus& status);

}  // namespace verisim::cli
