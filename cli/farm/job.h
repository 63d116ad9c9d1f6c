// A job of a farm: one picture in parts, or the frames of an animation, with all that is about it in one folder that
// every machine sees:
//
//   manifest.json   what is asked, written once by `verisim farm submit`
//   task.sh         what a task does on a node (task_script.h); people may change it
//   parts/          K.vsp and prepass.vsp of a picture in parts
//   logs/           K.log, prepass.log, merge.log: what each step said (log_file.h); what the engine said
#pragma once

#include <compare>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace verisim::cli {

// What the engine is asked for; empty or 0: what is usual there.
struct EngineOptions {
  std::string partition, time;     // the time limit of a task, in the engine's spelling
  int nodes = 0;                   // so many tasks at a time at most, each on one node
  int cpus = 0;                    // of a task
  int grace = 0;                   // seconds before the time limit in which a task saves its state
  std::vector<std::string> extra;  // options of the engine's own
};

// One thing to be run on a node: "prepass", "merge", or the number of a task, from 1.
struct Step {
  enum class Kind { prepass, task, merge } kind = Kind::task;
  int number = 0;
  std::string name() const;
  friend auto operator<=>(const Step&, const Step&) = default;
};

struct FarmJob {
  std::filesystem::path folder;  // absolute; not in the manifest
  std::string key;               // of this job among all: engines know it by this name
  std::string version, program;  // of verisim; the file of the program
  std::string engine;
  EngineOptions engine_options;
  std::filesystem::path directory;  // where names in `words` begin
  std::string scene;
  std::vector<std::string> words;  // of `verisim render`
  int tasks = 0;
  // A picture in parts, one a task.
  bool prepass = false;
  std::filesystem::path picture;
  // An animation: numbers of frames, and how many a task renders.
  bool animation = false;
  int first = 0, last = 0, step = 1, frames_per_task = 1;
  std::filesystem::path before_number;  // the file of frame 7 is this, 007, and that
  int digits = 0;
  std::string after_number;

  std::filesystem::path manifest() const { return folder / "manifest.json"; }
  std::filesystem::path script() const { return folder / "task.sh"; }
  std::filesystem::path part(int task) const { return folder / "parts" / (std::to_string(task) + ".vsp"); }
  std::filesystem::path prepass_part() const { return folder / "parts" / "prepass.vsp"; }
  std::filesystem::path log(const Step& which) const { return folder / "logs" / (which.name() + ".log"); }
  std::vector<Step> steps() const;             // in the order in which they can run
  std::vector<int> frames_of(int task) const;  // numbers; of an animation
  std::filesystem::path picture_of(int frame) const;
};

// Throw std::runtime_error naming the file and the reason.
void write_manifest(const FarmJob& job);
FarmJob read_job(const std::filesystem::path& folder);

}  // namespace verisim::cli
