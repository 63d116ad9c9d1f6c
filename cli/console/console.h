// What a command tells its user: POV-Ray's five text streams, on standard error and into files (spec 02 section 12).
// Standard output is for pictures.
#pragma once

#include <cstdio>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "cli/console/progress.h"
#include "cli/settings/options.h"
#include "parser/source/diagnostic.h"

namespace verisim::cli {

enum class Stream { debug, fatal, render, statistic, warning };

// How messages look: as POV-Ray's, or `file:line:column: severity: text` with the line and a caret.
enum class Style { verisim, povray };

class Console {
 public:
  Console(const Options& options, Style style);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  Style style() const { return style_; }
  bool color() const { return color_; }

  // The text files of +GD and its like lie in the folder of the picture. Throws std::runtime_error.
  void open_files(const std::filesystem::path& folder, bool append);

  void line(Stream stream, std::string_view text);  // whole lines; a line end is added
  void always(std::string_view text);               // cannot be switched off
  void debug(std::string_view text);                // of #debug: a line is shown when it is complete
  void diagnostic(const parser::Diagnostic& diagnostic);
  void end_of_debug();  // shows an unfinished line

  // How far the call is: a bar over itself on one line, POV-Ray's "Rendered n of m pixels", or lines for programs
  // (--progress; docs/progress.md). What stands on the line of a bar ends with end_progress.
  void begin_progress(const std::filesystem::path& scene, std::size_t frames);
  void begin_frame(std::size_t index, int number);
  void parse_progress();                                  // asked now and then while a scene is read
  void pass_progress(const char* pass, double fraction);  // a pass before the picture
  void progress(double fraction, std::uint64_t pixels, std::uint64_t rays);
  void end_progress();
  void frame_done(const std::filesystem::path& output, bool skipped);
  void end_of_call(int status, std::string_view message);

 private:
  bool shown(Stream stream) const;
  void put(Stream stream, std::string_view text);  // mutex held
  void clear_bar();

  const Options& options_;
  Style style_;
  void put_lines(const std::string& lines);  // of programs; mutex held
  // Whether a stage's progress is to be shown on a terminal's line now; mutex held.
  bool shows_bar(const char* stage, int percent);

  bool color_ = false, bar_visible_ = false;
  ProgressStyle progress_;
  ProgressLines lines_;
  int last_percent_ = -1;
  std::string stage_;  // whose progress was shown last, and since when it runs
  std::chrono::steady_clock::time_point stage_start_;
  TimeLeft left_;
  std::string debug_line_;
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::map<std::string, std::unique_ptr<std::FILE, Closer>> files_;
  std::mutex mutex_;
};

// Breaks a line as POV-Ray does: at the last space before column 80, which begins the next line.
std::string wrapped(std::string_view text);

}  // namespace verisim::cli
