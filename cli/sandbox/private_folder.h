// A folder of this process alone, for what is not kept.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace verisim::cli {

// Below the system's folder for temporary files. A process that does nothing else removes it when this one ends,
// however it ends: in the sandbox it could not do that itself. Make it before there are threads. Throws
// std::runtime_error.
class PrivateFolder {
 public:
  explicit PrivateFolder(const std::string& name);  // begins with this
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void remove_at_end() const;

  std::filesystem::path path_;
  int alive_[2] = {-1, -1};  // a pipe that closes when this process ends
  pid_t keeper_ = -1;
};

}  // namespace verisim::cli
