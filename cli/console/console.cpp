#include "cli/console/console.h"

#include <unistd.h>

#include <array>
#include <stdexcept>

#include <fmt/format.h>

namespace verisim::cli {
namespace {

const TextStream& settings_of(const Options& options, Stream stream) {
  switch (stream) {
    case Stream::debug:
      return options.debug;
    case Stream::fatal:
      return options.fatal;
    case Stream::render:
      return options.render;
    case Stream::statistic:
      return options.statistic;
    case Stream::warning:
      return options.warning;
  }
  return options.all;
}

std::string as_povray(const parser::Diagnostic& d) {
  std::string kind;
  switch (d.severity) {
    case parser::Severity::warning:
      kind = "Parse Warning";
      break;
    case parser::Severity::possible_error:
      kind = "Possible Parse Error";
      break;
    case parser::Severity::error:
      kind = "Parse Error";
      break;
    case parser::Severity::unsupported:
      kind = "Not supported";
      break;
  }
  std::string text = d.line > 0 ? fmt::format("File '{}' line {}: {}: {}", d.file, d.line, kind, d.message)
                                : fmt::format("{}: {}", kind, d.message);
  if (!d.advice.empty()) text += " (" + d.advice + ")";
  return wrapped(text);
}

}  // namespace

std::string wrapped(std::string_view text) {
  constexpr std::size_t kColumns = 79;
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    while (line.size() > kColumns) {
      std::size_t cut = line.rfind(' ', kColumns);
      if (cut == std::string_view::npos || cut == 0) cut = kColumns;
      result += line.substr(0, cut);
      result += '\n';
      line.remove_prefix(cut);
    }
    result += line;
    if (end < text.size()) result += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

Console::Console(const Options& options, Style style)
    : options_(options),
      style_(style),
      progress_(progress_style(options.progress, isatty(STDERR_FILENO) != 0)),
      lines_(progress_) {
  color_ = (isatty(STDERR_FILENO) != 0 || options.color) && !std::getenv("NO_COLOR");
  // POV-Ray's own line is always there, unless something else was asked for.
  if (style == Style::povray && options.progress.empty())
    progress_ = options.verbose ? ProgressStyle::bar : ProgressStyle::none;
}

Console::~Console() { end_of_debug(); }

void Console::open_files(const std::filesystem::path& folder, bool append) {
  for (const TextStream* stream :
       {&options_.all, &options_.debug, &options_.fatal, &options_.render, &options_.statistic, &options_.warning}) {
    if (stream->file.empty() || files_.contains(stream->file)) continue;
    const std::string path = (folder / stream->file).string();
    std::FILE* file = std::fopen(path.c_str(), append ? "a" : "w");
    if (!file) throw std::runtime_error(fmt::format("cannot write the text file '{}'", path));
    files_[stream->file].reset(file);
  }
}

bool Console::shown(Stream stream) const {
  return options_.all_given ? options_.all.console : settings_of(options_, stream).console;
}

void Console::put(Stream stream, std::string_view text) {
  const std::string whole = std::string(text) + "\n";
  if (shown(stream)) {
    clear_bar();
    std::fwrite(whole.data(), 1, whole.size(), stderr);
  }
  const std::string& own = settings_of(options_, stream).file;
  for (const std::string& name : {own, options_.all.file == own ? std::string() : options_.all.file})
    if (const auto file = files_.find(name); file != files_.end()) {
      std::fwrite(whole.data(), 1, whole.size(), file->second.get());
      std::fflush(file->second.get());
    }
}

void Console::line(Stream stream, std::string_view text) {
  const std::lock_guard lock(mutex_);
  put(stream, text);
}

void Console::always(std::string_view text) {
  const std::lock_guard lock(mutex_);
  clear_bar();
  const std::string whole = std::string(text) + "\n";
  std::fwrite(whole.data(), 1, whole.size(), stderr);
}

void Console::debug(std::string_view text) {
  const std::lock_guard lock(mutex_);
  debug_line_ += text;
  for (std::size_t end = debug_line_.find('\n'); end != std::string::npos; end = debug_line_.find('\n')) {
    put(Stream::debug, std::string_view(debug_line_).substr(0, end));
    debug_line_.erase(0, end + 1);
  }
}

void Console::end_of_debug() {
  const std::lock_guard lock(mutex_);
  if (!debug_line_.empty()) put(Stream::debug, debug_line_);
  debug_line_.clear();
}

void Console::diagnostic(const parser::Diagnostic& d) {
  end_of_debug();
  const std::lock_guard lock(mutex_);
  const bool fatal = d.severity == parser::Severity::error || d.severity == parser::Severity::unsupported;
  std::string text = style_ == Style::povray ? as_povray(d) : parser::format(d, color_);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  put(fatal ? Stream::fatal : Stream::warning, text);
}

void Console::put_lines(const std::string& lines) {
  if (lines.empty()) return;
  std::fwrite(lines.data(), 1, lines.size(), stderr);
  std::fflush(stderr);
}

void Console::begin_progress(const std::filesystem::path& scene, std::size_t frames) {
  const std::lock_guard lock(mutex_);
  put_lines(lines_.begin(scene.string(), options_.width, options_.height, frames));
}

void Console::begin_frame(std::size_t index, int number) {
  const std::lock_guard lock(mutex_);
  lines_.begin_frame(index, number);
  stage_.clear();
}

bool Console::shows_bar(const char* stage, int percent) {
  if (progress_ != ProgressStyle::bar) return false;
  if (stage_ != stage) {
    if (bar_visible_ && style_ == Style::verisim) clear_bar();
    stage_ = stage, stage_start_ = std::chrono::steady_clock::now(), last_percent_ = -1;
    left_.begin(stage_start_);
  }
  if (percent == last_percent_) return false;
  last_percent_ = percent;
  bar_visible_ = true;
  return true;
}

void Console::parse_progress() {
  const std::lock_guard lock(mutex_);
  put_lines(lines_.update("parse", std::nullopt, 0));
  if (style_ == Style::povray || progress_ != ProgressStyle::bar) return;
  if (stage_ != "parse") stage_ = "parse", stage_start_ = std::chrono::steady_clock::now(), last_percent_ = -1;
  const int seconds =
      static_cast<int>(std::chrono::duration<double>(std::chrono::steady_clock::now() - stage_start_).count());
  if (seconds < 1 || !shows_bar("parse", seconds)) return;
  std::fprintf(stderr, "\r\x1b[Kreading the scene: %d s ", seconds);
  std::fflush(stderr);
}

namespace {

std::string time_left(const std::optional<double>& seconds) {
  return seconds && *seconds >= 1 ? fmt::format(", about {:.0f} s left", *seconds) : "";
}

}  // namespace

void Console::progress(double fraction, std::uint64_t pixels, std::uint64_t rays) {
  const std::lock_guard lock(mutex_);
  put_lines(lines_.update("picture", fraction, rays));
  const int percent = static_cast<int>(fraction * 100);
  if (!shows_bar("picture", percent)) return;
  if (style_ == Style::povray) {
    std::fprintf(stderr, "Rendered %llu of %llu pixels (%d%%)\r",
                 static_cast<unsigned long long>(fraction * static_cast<double>(pixels) + 0.5),
                 static_cast<unsigned long long>(pixels), percent);
    return;
  }
  constexpr int kWidth = 40;
  const int full = static_cast<int>(fraction * kWidth);
  std::fprintf(stderr, "\r\x1b[K[%.*s%.*s] %3d%%%s ", full, "========================================", kWidth - full,
               "                                        ", percent,
               time_left(left_.at(fraction, std::chrono::steady_clock::now())).c_str());
  std::fflush(stderr);
}

void Console::pass_progress(const char* pass, double fraction) {
  const std::lock_guard lock(mutex_);
  put_lines(lines_.update(pass, fraction, 0));
  const int percent = static_cast<int>(fraction * 100);
  if (!shows_bar(pass, percent)) return;
  const std::string left = time_left(left_.at(fraction, std::chrono::steady_clock::now()));
  if (style_ == Style::povray) {
    std::fprintf(stderr, "%s: %d%%%s\r", pass, percent, left.c_str());
  } else {
    std::fprintf(stderr, "\r\x1b[K%s: %d%%%s ", pass, percent, left.c_str());
    std::fflush(stderr);
  }
}

void Console::frame_done(const std::filesystem::path& output, bool skipped) {
  const std::lock_guard lock(mutex_);
  put_lines(lines_.frame_done(output.string(), skipped));
}

void Console::end_of_call(int status, std::string_view message) {
  const std::lock_guard lock(mutex_);
  put_lines(lines_.end(status, message));
}

void Console::clear_bar() {
  if (!bar_visible_) return;
  if (style_ == Style::povray)
    std::fputc('\n', stderr);
  else
    std::fputs("\r\x1b[K", stderr);
  bar_visible_ = false;
}

void Console::end_progress() {
  const std::lock_guard lock(mutex_);
  clear_bar();
  last_percent_ = -1;
}

}  // namespace verisim::cli
