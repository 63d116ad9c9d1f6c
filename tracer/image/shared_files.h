// Files that are read once and shared by all who use them at the same time.
#pragma once

#include <sys/stat.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace verisim::image {

// What names a state of a file, whichever of its names it is asked by. Empty when it is none of a regular file: then
// nothing is shared. One system call: a scene may ask for its font thousands of times.
inline std::string file_state(const char* path) {
  struct stat file {};
  if (::stat(path, &file) != 0 || !S_ISREG(file.st_mode)) return {};
  const std::array<std::intmax_t, 7> parts{
      static_cast<std::intmax_t>(file.st_dev),          static_cast<std::intmax_t>(file.st_ino),
      static_cast<std::intmax_t>(file.st_size),         static_cast<std::intmax_t>(file.st_mtim.tv_sec),
      static_cast<std::intmax_t>(file.st_mtim.tv_nsec), static_cast<std::intmax_t>(file.st_ctim.tv_sec),
      static_cast<std::intmax_t>(file.st_ctim.tv_nsec)};
  return {reinterpret_cast<const char*>(parts.data()), sizeof parts};  // compared only
}

// Values are kept no longer than somebody uses them.
template <class Value>
class SharedFiles {
 public:
  // `make` reads the file; it may throw. `how` tells apart readings of the same file.
  template <class Make>
  std::shared_ptr<const Value> get(const std::filesystem::path& path, const std::string& how, Make make) {
    const std::string state = file_state(path.c_str());
    if (state.empty()) return make();
    const std::string key = state + '\n' + how;
    const std::lock_guard lock(mutex_);
    std::weak_ptr<const Value>& known = known_[key];
    if (auto value = known.lock()) return value;
    std::erase_if(known_, [&](const auto& entry) { return entry.first != key && entry.second.expired(); });
    std::shared_ptr<const Value> value = make();
    known_[key] = value;
    return value;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::weak_ptr<const Value>> known_;
};

}  // namespace verisim::image
