// A private copy of a scene's folder: what a scene writes stays in it.
#pragma once

#include <cstdint>
#include <filesystem>

namespace verisim::compare {

// A temporary folder, removed with everything in it at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();  // throws std::filesystem::filesystem_error
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Holds home/ (empty), out/ (empty) and the copy of the scene's folder with its subfolders. Beside the copy stand links to the folder's neighbours, so that
// "../textures/wood.inc" is found. From 256 MiB on files are linked, not copied; a folder of more than 20,000 files is copied without its subfolders.
class WorkingCopy {
 public:
  explicit WorkingCopy(const std::filesystem::path& scene);  // throws std::filesystem::filesystem_error
  std::filesystem::path home() const { return root_.path() / "home"; }
  std::filesystem::path out() const { return root_.path() / "out"; }
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path scene() const { return folder_ / name_; }

 private:
  TemporaryFolder root_;
  std::filesystem::path folder_, name_;
};

}  // namespace verisim::compare
