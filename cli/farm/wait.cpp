#include "cli/farm/wait.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include <fmt/format.h>

#include "cli/console/progress.h"
#include "cli/farm/status.h"

namespace verisim::cli {
namespace {

using Clock = std::chrono::steady_clock;

// Seconds until all tasks are done, as fast as they were since this looks at them, or since the first of them began.
class JobTimeLeft {
 public:
  std::optional<double> at(const JobStatus& status) {
    constexpr double kEnough = 0.02;  // of the job, to tell a speed
    const double fraction = status.fraction();
    const Clock::time_point now = Clock::now();
    if (!first_) first_ = {fraction, now};
    const double done = fraction - first_->first;
    if (done >= kEnough) return std::chrono::duration<double>(now - first_->second).count() * (1 - fraction) / done;
    const auto today =
        std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch());
    if (!status.begin || fraction <= 0) return std::nullopt;
    return static_cast<double>(today.count() - *status.begin) * (1 - fraction) / fraction;
  }

 private:
  std::optional<std::pair<double, Clock::time_point>> first_;
};

std::string time_words(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  return seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

std::string sums(const JobStatus& status, const std::optional<double>& left) {
  using State = StepStatus::State;
  std::string text = fmt::format("{} of {} steps done, {} running", status.count(State::done), status.steps.size(),
                                 status.count(State::running));
  if (const int failed = status.count(State::failed) + status.count(State::missing))
    text += fmt::format(", {} failed", failed);
  if (!status.engine_answers) text += ", the engine does not answer";
  if (left && status.fraction() < 1) text += fmt::format(", about {} left", time_words(*left));
  return text;
}

void show_bar(const JobStatus& status, const std::string& words) {
  constexpr int kWidth = 30;
  const int full = std::clamp(static_cast<int>(status.fraction() * kWidth), 0, kWidth);
  std::fprintf(stderr, "\r\x1b[K[%s%s] %3d%% %s ", std::string(static_cast<std::size_t>(full), '=').c_str(),
               std::string(static_cast<std::size_t>(kWidth - full), ' ').c_str(),
               static_cast<int>(100 * status.fraction()), words.c_str());
  std::fflush(stderr);
}

// How the job ended; nothing: it goes on. What a node has written may be seen a little later here, so nothing is lost
// before it was seen twice.
class End {
 public:
  std::optional<ExitStatus> of(const JobStatus& status) {
    if (status.complete()) return kOk;
    still_ = status.engine_answers && !status.moving() ? still_ + 1 : 0;
    return still_ >= 2 ? std::optional(kInputOutput) : std::nullopt;
  }

 private:
  int still_ = 0;
};

}  // namespace

ExitStatus wait_for(const FarmJob& job, Engine& engine, const std::string& progress) {
  constexpr std::chrono::milliseconds kShortest(1500);
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  const ProgressStyle style = progress_style(progress, terminal);
  ProgressLines lines(style);
  const auto put = [](const std::string& text) { std::fputs(text.c_str(), stderr), std::fflush(stderr); };
  put(lines.begin(job.scene, 0, 0, 1));
  JobTimeLeft time_left;
  End end;
  while (true) {
    const Clock::time_point begin = Clock::now();
    const JobStatus status = job_status(job, engine);
    put(lines.update("picture", status.fraction(), 0));
    if (style == ProgressStyle::bar) show_bar(status, sums(status, time_left.at(status)));
    if (const std::optional<ExitStatus> ended = end.of(status)) {
      if (style == ProgressStyle::bar) put("\r\x1b[K");
      std::fputs(as_text(job, status).c_str(), stdout);
      const std::string advice =
          *ended == kOk ? ""
                        : fmt::format("not all is done, and nothing runs: verisim farm resume {}", job.folder.string());
      put(lines.end(*ended, advice));
      if (!advice.empty()) put(advice + "\n");
      return *ended;
    }
    // Large jobs have many files: looking at them is to be a tenth of the time.
    std::this_thread::sleep_for(std::max<Clock::duration>(kShortest, 9 * (Clock::now() - begin)));
  }
}

}  // namespace verisim::cli
