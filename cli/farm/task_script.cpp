#include "cli/farm/task_script.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

constexpr std::string_view kHead = R"sh(#!/bin/sh
# One step of this job, on a node of the cluster:
#
#   sh task.sh 3          task 3; prepass and merge are the other steps
#   sh task.sh array 1000   task 1000 + SLURM_ARRAY_TASK_ID
#
# Written by `verisim farm submit`, and yours to change: `verisim farm resume` submits it as it is then. By hand it
# does the same without a cluster. What it says goes to logs/STEP.log: lines of JSON about the task, and verisim's own
# (docs/progress.md).
set -u
)sh";

constexpr std::string_view kTools = R"sh(
say() {
  printf '{"event":"%s","step":"%s","node":"%s","time":%s%s}\n' \
    "$1" "$step" "$(hostname)" "$(date +%s)" "${2:-}" >>"$log"
}

# The signal that comes before the time limit: verisim saves its state, and the task goes back into the queue, from
# where it goes on.
before_the_limit() {
  trap '' USR1
  stop_render
  [ "$status" -ne 0 ] || finish 0
  say requeue
  for again in 1 2 3 4 5 6; do
    scontrol requeue "${SLURM_JOB_ID:-none}" && sleep 120
    sleep 5
  done
  finish 75
}
stop_render() {
  status=130
  [ -z "$child" ] || { kill -TERM "$child" 2>/dev/null; wait "$child"; status=$?; }
}
finish() {
  say exit ",\"status\":$1"
  exit "$1"
}

# verisim "$@"; a render that something killed goes on from its state, up to five times.
run() {
  attempt=1
  while :; do
    say start ",\"attempt\":$attempt"
    "$verisim" "$@" >>"$log" 2>&1 &
    child=$!
    wait "$child"
    status=$?
    child=
    [ "$status" -gt 130 ] && [ "$attempt" -lt 5 ] || finish "$status"
    attempt=$((attempt + 1))
  done
}
render() { run render "+WT${SLURM_CPUS_PER_TASK:-${SLURM_CPUS_ON_NODE:-$(nproc)}}" "$@" +C --progress json; }

step=$1 child=
[ "$step" != array ] || step=$(($2 + SLURM_ARRAY_TASK_ID))
log=$job/logs/$step.log
cd "$directory" && [ -d "$job/logs" ] && [ -x "$verisim" ] || {
  echo "$(hostname): '$directory', '$job' or '$verisim' is not there: all nodes must share the file system" >&2
  exit 5
}
trap before_the_limit USR1
trap 'stop_render; finish 143' TERM INT
)sh";

std::string settings(const FarmJob& job) {
  return fmt::format("job={}\ndirectory={}\nverisim={}\n", shell_word(job.folder.string()),
                     shell_word(job.directory.string()), shell_word(job.program));
}

std::string words(const FarmJob& job) {
  std::string text;
  for (const std::string& word : job.words) text += " " + shell_word(word);
  return text;
}

std::string still(const FarmJob& job) {
  const std::string prepass = job.prepass ? " --prepass \"$job/parts/prepass.vsp\"" : "";
  std::string text = "case $step in\n";
  if (job.prepass)
    text += fmt::format("prepass) render{} --part prepass --output \"$job/parts/prepass.vsp\" ;;\n", words(job));
  text += fmt::format("merge) run merge \"$job/parts\" --output {} ;;\n", shell_word(job.picture.string()));
  text += fmt::format("*) render{}{} --part \"$step/{}\" --output \"$job/parts/$step.vsp\" ;;\nesac\n", words(job),
                      prepass, job.tasks);
  return text;
}

std::string animation(const FarmJob& job) {
  const long stride = static_cast<long>(job.frames_per_task) * job.step;
  return fmt::format("first=$(({} + (step - 1) * {}))\nrender{} --frames \"$first-$((first + {}))\"\n", job.first,
                     stride, words(job), stride - 1);
}

}  // namespace

std::string shell_word(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_-+=./:,@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string task_script(const FarmJob& job) {
  return std::string(kHead) + settings(job) + std::string(kTools) + (job.animation ? animation(job) : still(job));
}

}  // namespace verisim::cli
