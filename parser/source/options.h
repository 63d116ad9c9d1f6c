// What a caller asks of the parser, and what it gets: limits, settings that scenes see, and the result.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/source/declared_value.h"
#include "parser/source/diagnostic.h"
#include "parser/source/memory_file.h"
#include "tracer/scene/scene.h"

namespace verisim::parser {

struct Limits {  // untrusted input: each limit ends parsing with an error that names its switch
  std::size_t max_file_bytes = std::size_t{1} << 31;
  std::size_t max_tokens = std::size_t{1} << 29;  // in all files together
  // Executed tokens; 0: no limit. An endless loop ends after some ten minutes; POV-Ray takes hours for as much.
  std::uint64_t max_steps = 100'000'000'000;
  std::size_t max_memory_bytes = std::size_t{16} << 30;
  int max_depth = 500;  // nested blocks, parentheses and calls; POV-Ray itself stops at 98 calls
};

// What an editor wants to know of the names of a scene while it is read.
class Recorder {
 public:
  virtual ~Recorder() = default;
  // `name` got a value by #declare or #local; `offset`: of the name in `file`; `kind`: "float", "texture" ...; `value`:
  // as SDL writes it, where that is short, else empty. Called again in each pass of a loop.
  virtual void declared(const std::string& file, std::size_t offset, std::string_view name, std::string_view kind,
                        const std::string& value) = 0;
};

class Origins;

struct ParseOptions {
  std::vector<std::filesystem::path> library_paths;  // after the current folder, in order (spec 01 section 17)
  bool standard_includes = true;                     // after the library paths: standard_include_folders()
  std::filesystem::path scene_folder;        // of a scene from memory: where files are looked for last; empty: nowhere
  MemoryFiles files;                         // found before those on disk
  std::vector<std::string> include_headers;  // +HI
  std::vector<std::pair<std::string, std::string>>
      declarations;  // Declare=NAME=VALUE; a value in double quotes is a string
  std::vector<std::pair<std::string, DeclaredValue>> values;  // the same for values of other kinds, as they are
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
  // For editors. The text of a file that is open and not saved; nothing: the file is read.
  std::function<std::optional<std::string>(const std::filesystem::path&)> unsaved;
  // Files that the scene writes go into this folder instead, and are read from there; empty: where the scene wants
  // them.
  std::filesystem::path scratch;
  Recorder* recorder = nullptr;
  Origins* origins = nullptr;  // filled in, for those who explain pictures (parser/source/origins.h)
};

struct ParseResult {
  std::optional<scene::Scene> scene;  // empty when there were errors
  std::vector<Diagnostic> errors;
  std::vector<std::filesystem::path> files_read;  // scene, includes, images, fonts ...: what a cache must hash
  // Of ParseOptions::files, those that the scene may still read while it is rendered (fonts, photon maps).
  std::vector<std::shared_ptr<const MemoryFile>> files_kept;
  int warnings = 0;
  bool whole = true;  // false: reading ended before the end of the scene, so there may be more errors
};

}  // namespace verisim::parser
