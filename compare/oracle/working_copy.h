// A private copy of a scene's folder: what a scene writes stays in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace verisim::compare {

// A temporary folder, removed with everything in it at the end. What a killed process left behind is removed by the
// next one that makes such a folder: a folder in use is locked.
class TemporaryFolder {
 public:
  TemporaryFolder();  // throws std::filesystem::filesystem_error
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

// The files below a folder, but not those in hidden folders below it, which belong to programs and not to scenes. At
// most 20,000 files and folders are looked at; `all`: there are no more.
struct FilesBelow {
  std::vector<std::filesystem::path> files;
  bool all = true;
};
FilesBelow files_below(const std::filesystem::path& folder);

class FolderCopy;  // working_copy.cpp

// Holds home/ (empty), out/ (empty) and the copy of the scene's folder with its subfolders, hidden ones apart. Beside
// the copy stand links to the folder's neighbours, so that
// "../textures/wood.inc" is found. From 256 MiB on files are linked, not copied; a folder of more than 20,000 files and
// folders is copied without its subfolders. A copy that is no longer used waits for the next scene of the same folder,
// and is made equal to the original again before it is used; on Linux only the files that changed meanwhile are looked
// at, so that a run takes time in proportion to its scenes.
class WorkingCopy {
 public:
  explicit WorkingCopy(const std::filesystem::path& scene);  // throws std::filesystem::filesystem_error
  ~WorkingCopy();
  WorkingCopy(const WorkingCopy&) = delete;
  WorkingCopy& operator=(const WorkingCopy&) = delete;
  std::filesystem::path home() const;
  std::filesystem::path out() const;
  const std::filesystem::path& folder() const;
  std::filesystem::path scene() const { return folder() / name_; }

 private:
  std::unique_ptr<FolderCopy> copy_;
  std::filesystem::path name_;
};

}  // namespace verisim::compare
