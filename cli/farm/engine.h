// What runs the steps of a job on other machines: the seam between jobs and Slurm, the one engine there is.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/farm/job.h"

namespace verisim::cli {

// What an engine knows of a step.
struct EngineStep {
  enum class State { ended, waiting, running } state = State::ended;
  std::string node;
  std::string reason;  // why it waits, or how it ended
  std::string id;      // the engine's own
};
using EngineSteps = std::map<Step, EngineStep>;

class Engine {
 public:
  virtual ~Engine() = default;
  // Throws std::runtime_error when this machine cannot submit.
  virtual void require() const = 0;
  // Throws OptionError for options it cannot understand; fills in what follows from others.
  virtual void check(EngineOptions& options) const = 0;
  // Hands steps over, so that each runs when those before it in FarmJob::steps() that it needs have ended: these and
  // `alive` ones. All or nothing; throws std::runtime_error with what the engine says. Returns a line for the user.
  virtual std::string submit(const FarmJob& job, const std::vector<Step>& steps, const EngineSteps& alive) = 0;
  // The same as the commands that it would run, one a line.
  virtual std::string rehearse(const FarmJob& job, const std::vector<Step>& steps, const EngineSteps& alive) const = 0;
  // What it knows of the job's steps; nothing when it does not answer, and then `why`.
  virtual std::optional<EngineSteps> steps(const FarmJob& job, std::string& why) = 0;
  // Ends all steps, or only that one. Throws std::runtime_error.
  virtual void cancel(const FarmJob& job, std::optional<Step> step = {}) = 0;
};

// Throws OptionError for a name that is none.
std::unique_ptr<Engine> engine_named(const std::string& name);

}  // namespace verisim::cli
