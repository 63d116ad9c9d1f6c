// What a caller asks of the parser, and what it gets: limits, settings that scenes see, and the result.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parser/source/diagnostic.h"
#include "tracer/scene/scene.h"

namespace verisim::parser {

struct Limits {  // untrusted input: each limit ends parsing with an error that names its switch
  std::size_t max_file_bytes = std::size_t{1} << 31;
  std::size_t max_tokens = std::size_t{1} << 29;  // in all files together
  std::uint64_t max_steps = 0;                    // executed tokens; 0: no limit
  std::size_t max_memory_bytes = std::size_t{16} << 30;
  int max_depth = 500;  // nested blocks, parentheses and calls; POV-Ray itself stops at 98 calls
};

struct ParseOptions {
  std::vector<std::filesystem::path> library_paths;  // after the current folder, in order (spec 01 section 17)
  std::vector<std::string> include_headers;          // +HI
  std::vector<std::pair<std::string, std::string>>
      declarations;  // Declare=NAME=VALUE; a value in double quotes is a string
  int width = 160, height = 120;
  double clock = 0;
  bool clock_on = false;
  int frame_number = 0, initial_frame = 0, final_frame = 0;
  double initial_clock = 0, final_clock = 0, clock_delta = 0;
  int version = 0;  // +MV times 100; 0: none
  int quality = 9;
  std::vector<std::filesystem::path> allow_write, allow_read;  // allow_read empty: everything may be read
  Limits limits;
  std::function<void(const std::string&)> debug;   // text of #debug, #render, #statistics
  std::function<void(const Diagnostic&)> message;  // warnings as they come; errors, too
  std::function<bool()> cancelled;                 // polled now and then
};

struct ParseResult {
  std::optional<scene::Scene> scene;  // empty when there were errors
  std::vector<Diagnostic> errors;
  std::vector<std::filesystem::path> files_read;  // scene, includes, images, fonts ...: what a cache must hash
  int warnings = 0;
};

}  // namespace verisim::parser
