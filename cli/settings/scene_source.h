// Where a scene comes from: a file, or a stream, which can be read only once.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/settings/options.h"

namespace verisim::cli {

struct SceneSource {
  std::filesystem::path path;       // as messages name it; include files are looked for beside it, too
  std::optional<std::string> text;  // what the stream held; empty: the scene is the file
  bool found() const { return !path.empty(); }
};

// The scene of Input_File_Name: "-" (standard input, called "stdin" or as --stdin-name says), a pipe or a device, or a
// file as find_scene finds it; !found() when there is none. Reads a stream to its end. Throws std::runtime_error when
// it cannot be read or holds more than --max-file-bytes.
SceneSource open_scene(const Options& options);

// True for "-" and for what is there but neither a file nor a folder.
bool is_stream(const std::string& name);

// A folder of its own under the system's for temporary files, in which the text of a stream lies as a scene that other
// programs can read; removed with the object. Throws std::runtime_error.
class SpooledScene {
 public:
  explicit SpooledScene(const SceneSource& source);
  ~SpooledScene();
  SpooledScene(const SpooledScene&) = delete;
  SpooledScene& operator=(const SpooledScene&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace verisim::cli
