// What a step of a job said in its log: its own lines ({"event":"start"}, "requeue", "exit": task_script.h) and those
// of `verisim render --progress json`, with messages of any kind between.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace verisim::cli {

struct StepLog {
  bool begun = false;
  std::optional<std::int64_t> begin;  // of the first attempt, in seconds since 1970
  std::string node;                   // of the last attempt
  std::optional<int> exit_status;     // of the last attempt, if it came to an end
  bool requeued = false;              // and wanted to go on later
  std::string stage;
  double fraction = 0;              // of the step, as last said
  std::optional<double> remaining;  // seconds, likewise
  std::string message;              // of an error
  double age = 0;                   // seconds since something was said
};

// Reads the beginning and the end; a log that is not there says nothing.
StepLog read_log(const std::filesystem::path& path);

}  // namespace verisim::cli
