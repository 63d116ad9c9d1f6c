// What changed in a folder since it was last asked for, so that nobody has to look at every file again.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace verisim::compare {

// Linux's inotify on a folder and its subfolders (hidden ones and links to folders are passed over). Writing through a
// memory map is not seen.
class FolderWatch {
 public:
  FolderWatch() = default;
  FolderWatch(const std::filesystem::path& folder, bool subfolders);
  ~FolderWatch();
  FolderWatch(FolderWatch&& other) noexcept;
  FolderWatch& operator=(FolderWatch&& other) noexcept;

  // Files that were made, written or removed since the last call, as paths below the folder. Empty when that is not
  // known: the system watches no more folders, too much happened, or subfolders came and went. From then on it stays
  // unknown.
  std::optional<std::set<std::filesystem::path>> changes();

 private:
  void watch(const std::filesystem::path& folder, const std::filesystem::path& below, bool subfolders);
  int fd_ = -1;
  std::map<int, std::filesystem::path> folders_;  // by watch descriptor, relative to the folder
};

}  // namespace verisim::compare
