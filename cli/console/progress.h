// How far a call is, as lines for programs (--progress json and openjd; docs/progress.md). The bar for people is the
// console's.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace verisim::cli {

enum class ProgressStyle { none, bar, json, openjd };

// "" is a bar on a terminal and nothing elsewhere. Throws OptionError.
ProgressStyle progress_style(const std::string& name, bool terminal);

// The time a stage will still take, from how it went so far; what was there at its beginning (+C) took none.
class TimeLeft {
 public:
  using Clock = std::chrono::steady_clock;
  void begin(Clock::time_point now) { start_ = now, first_.reset(); }
  // Seconds; nothing while too little is known.
  std::optional<double> at(double fraction, Clock::time_point now);

 private:
  Clock::time_point start_;
  std::optional<double> first_;
};

// Makes the lines; each ends with a line end. An empty string: nothing is to be said now.
class ProgressLines {
 public:
  using Clock = std::chrono::steady_clock;
  explicit ProgressLines(ProgressStyle style) : style_(style) {}

  std::string begin(std::string_view scene, int width, int height, std::size_t frames);
  void begin_frame(std::size_t index, int number) { frame_ = index, number_ = number, stage_.clear(); }
  // `fraction` of the stage; nothing: nobody knows. `rays`: of the frame so far.
  std::string update(std::string_view stage, std::optional<double> fraction, std::uint64_t rays);
  // A frame is done, or was there already.
  std::string frame_done(std::string_view output, bool skipped);
  // The call ends with an exit status; `message`: why, if not well.
  std::string end(int status, std::string_view message);

 private:
  double elapsed(Clock::time_point now) const { return std::chrono::duration<double>(now - start_).count(); }

  ProgressStyle style_;
  Clock::time_point start_ = Clock::now(), last_line_;
  std::size_t frames_ = 1, frame_ = 0;
  int number_ = 0;
  std::string stage_;
  TimeLeft left_;
};

}  // namespace verisim::cli
