// Files of fuzzers' bytes.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "tracer/base/descriptor.h"

namespace verisim::fuzz {

namespace fs = std::filesystem;

// Bytes under a name, in memory: /dev/shm where there is one. With an ending for those who go by it. The file of an
// ending stays and is written over: to make and remove a million files would be most of the work.
class NamedBytes {
 public:
  explicit NamedBytes(std::string_view bytes, const std::string& ending = "") : path_(path_of(ending)) {
    const auto size = static_cast<ssize_t>(bytes.size());
    const Descriptor file(::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    if (::ftruncate(file.get(), size) != 0 || ::write(file.get(), bytes.data(), bytes.size()) != size) std::abort();
  }
  const fs::path& path() const { return path_; }

 private:
  static const fs::path& path_of(const std::string& ending) {
    struct Files : std::map<std::string, fs::path> {
      ~Files() {
        for (const auto& [ending, path] : *this) ::unlink(path.c_str());
      }
    };
    static Files files;
    fs::path& path = files[ending];
    std::error_code none;
    if (path.empty())
      path = (fs::is_directory("/dev/shm", none) ? "/dev/shm" : fs::temp_directory_path()) /
             ("verisim-fuzz-" + std::to_string(::getpid()) + ending);
    return path;
  }

  const fs::path& path_;
};

}  // namespace verisim::fuzz
