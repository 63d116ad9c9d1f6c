// Notices when files are saved: written in place, replaced by another of their name, or there again.
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace verisim::cli {

class FileWatch {
 public:
  // `changed` is called from a thread of this object. Throws std::runtime_error if the system has no inotify left.
  explicit FileWatch(std::function<void()> changed);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  // In the place of those watched so far. Files that are not there yet are noticed when they come.
  void watch(const std::vector<std::filesystem::path>& files);

 private:
  void run();

  std::function<void()> changed_;
  int notify_ = -1, wake_[2] = {-1, -1};
  std::mutex mutex_;
  std::set<std::pair<int, std::string>> names_;  // number of the folder's watch, name in it
  std::set<int> folders_;
  std::thread thread_;
};

}  // namespace verisim::cli
