#include "cli/console/progress.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/settings/options.h"
#include "cli/settings/text.h"
#include "compare/json_text.h"

namespace verisim::cli {
namespace {

using nlohmann::ordered_json;

constexpr double kBetweenLines = 0.5;  // seconds

std::string line_of(const ordered_json& json) { return compare::json_text(json) + "\n"; }

double rounded(double seconds) { return std::round(seconds * 1000) / 1000; }

// OpenJD's messages are one line each.
std::string one_line(std::string_view text) {
  std::string result(text);
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return c < 32; }, ' ');
  return result;
}

}  // namespace

ProgressStyle progress_style(const std::string& name, bool terminal) {
  if (name.empty()) return terminal ? ProgressStyle::bar : ProgressStyle::none;
  if (name == "bar") return ProgressStyle::bar;
  if (name == "json") return ProgressStyle::json;
  if (name == "openjd") return ProgressStyle::openjd;
  if (name == "none") return ProgressStyle::none;
  const std::string advice = nearest(name, {"bar", "json", "openjd", "none"});
  throw OptionError(fmt::format("--progress is bar, json, openjd or none, not '{}'{}", name,
                                advice.empty() ? "" : "; did you mean " + advice + "?"));
}

std::optional<double> TimeLeft::at(double fraction, Clock::time_point now) {
  if (!first_) first_ = fraction;
  const double gone = std::chrono::duration<double>(now - start_).count(), done = fraction - *first_;
  if (fraction >= 1) return 0;
  if (gone < 0.2 || done <= 0) return std::nullopt;
  return gone * (1 - fraction) / done;
}

std::string ProgressLines::begin(std::string_view scene, int width, int height, std::size_t frames) {
  frames_ = std::max<std::size_t>(frames, 1);
  if (style_ != ProgressStyle::json) return "";
  return line_of({{"event", "begin"},
                  {"verisim", VERISIM_VERSION},
                  {"scene", scene},
                  {"width", width},
                  {"height", height},
                  {"frames", frames}});
}

std::string ProgressLines::update(std::string_view stage, std::optional<double> fraction, std::uint64_t rays) {
  if (style_ != ProgressStyle::json && style_ != ProgressStyle::openjd) return "";
  const auto now = Clock::now();
  const bool fresh = stage != stage_, complete = fraction && *fraction >= 1;
  if (fresh) stage_ = stage, left_.begin(now);
  const std::optional<double> left = fraction ? left_.at(*fraction, now) : std::nullopt;
  if (!fresh && !complete && std::chrono::duration<double>(now - last_line_).count() < kBetweenLines) return "";
  last_line_ = now;
  const double of_frame = stage == "picture" ? fraction.value_or(0) : 0;
  const double overall = (static_cast<double>(frame_) + of_frame) / static_cast<double>(frames_);
  if (style_ == ProgressStyle::openjd) {
    std::string text = fmt::format("openjd_progress: {:.1f}\n", 100 * overall);
    if (fresh || left) {
      const std::string frame = frames_ > 1 ? fmt::format("frame {} ({} of {}), ", number_, frame_ + 1, frames_) : "";
      text += fmt::format("openjd_status: {}{}{}\n", frame, stage,
                          left && *left > 0 ? fmt::format(", about {:.0f} s left", *left) : "");
    }
    return text;
  }
  ordered_json json{{"event", "progress"},
                    {"stage", stage},
                    {"fraction", fraction ? ordered_json(std::round(*fraction * 1e4) / 1e4) : ordered_json()},
                    {"frame", number_},
                    {"overall", std::round(overall * 1e4) / 1e4},
                    {"rays", rays},
                    {"elapsed", rounded(elapsed(now))},
                    {"remaining", left ? ordered_json(rounded(*left)) : ordered_json()}};
  return line_of(json);
}

std::string ProgressLines::frame_done(std::string_view output, bool skipped) {
  const double overall = static_cast<double>(frame_ + 1) / static_cast<double>(frames_);
  if (style_ == ProgressStyle::openjd) return fmt::format("openjd_progress: {:.1f}\n", 100 * overall);
  if (style_ != ProgressStyle::json) return "";
  return line_of({{"event", "frame"},
                  {"frame", number_},
                  {"output", output.empty() ? ordered_json() : ordered_json(output)},
                  {"skipped", skipped},
                  {"elapsed", rounded(elapsed(Clock::now()))}});
}

std::string ProgressLines::end(int status, std::string_view message) {
  if (style_ == ProgressStyle::openjd)
    return status == 0 ? "openjd_status: done\n"
                       : fmt::format("openjd_fail: {}\n",
                                     message.empty() ? fmt::format("exit status {}", status) : one_line(message));
  if (style_ != ProgressStyle::json) return "";
  return line_of({{"event", "end"},
                  {"status", status},
                  {"message", message.empty() ? ordered_json() : ordered_json(message)},
                  {"elapsed", rounded(elapsed(Clock::now()))}});
}

}  // namespace verisim::cli
