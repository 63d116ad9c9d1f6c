// Where files are looked for, and which of them a scene may read and write.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parser/source/memory_file.h"

namespace verisim::parser {

class FileSearch {
 public:
  // `scene_folder` may be empty (a scene from memory). allow_read empty: everything may be read.
  FileSearch(std::vector<std::filesystem::path> library_paths, std::filesystem::path scene_folder,
             std::vector<std::filesystem::path> allow_read, std::vector<std::filesystem::path> allow_write,
             MemoryFiles files = {});

  // What the program gave under this name; null: nothing. The look-ups below find it first, by the same name.
  std::shared_ptr<const MemoryFile> memory_file(const std::filesystem::path& name) const;

  // As #include looks (spec 01 section 17): each of the candidate names in the current folder, then in every library
  // path, then beside the scene.
  std::optional<std::filesystem::path> find_include(const std::string& name) const;
  // The exact name only: #fopen read, file_exists, images and fonts.
  std::optional<std::filesystem::path> find_exact(const std::string& name) const;
  // A file that is there under nearly this name: written with the other kind of slash, or in other case (`certain`), or
  // misspelt. As the scene should write it.
  struct Similar {
    std::string name;
    bool certain = false;
  };
  std::optional<Similar> find_similar(const std::string& name, bool include) const;
  // Where a file that the scene writes really goes (ParseOptions::scratch); found under its own name from now on.
  std::filesystem::path redirect(const std::string& name, const std::filesystem::path& scratch);

  bool may_read(const std::filesystem::path& path) const;
  // Below the current folder, the scene's folder, or what allow_write names. Symbolic links are resolved first.
  bool may_write(const std::filesystem::path& path) const;

  const std::vector<std::filesystem::path>& library_paths() const { return library_paths_; }

 private:
  std::vector<std::filesystem::path> library_paths_;
  std::filesystem::path scene_folder_;
  std::vector<std::filesystem::path> readable_, writable_;  // canonical
  std::map<std::string, std::filesystem::path> redirected_;
  MemoryFiles files_;  // by normal names
};

}  // namespace verisim::parser
