// Files that are read once and shared by all who use them at the same time.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace verisim::image {

// What names a state of a file: its path, size and time of change. Empty when it cannot be asked for: then nothing is
// shared.
inline std::string file_state(const std::filesystem::path& path) {
  std::error_code failed;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(path, failed);
  if (failed) return {};
  const auto size = std::filesystem::file_size(whole, failed);
  if (failed) return {};
  const auto time = std::filesystem::last_write_time(whole, failed);
  if (failed) return {};
  return whole.string() + '\n' + std::to_string(size) + '\n' + std::to_string(time.time_since_epoch().count());
}

// Values are kept no longer than somebody uses them.
template <class Value>
class SharedFiles {
 public:
  // `make` reads the file; it may throw. `how` tells apart readings of the same file.
  template <class Make>
  std::shared_ptr<const Value> get(const std::filesystem::path& path, const std::string& how, Make make) {
    const std::string state = file_state(path);
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
