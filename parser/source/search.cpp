#include "parser/source/search.h"

#include <algorithm>

#include "parser/source/confinement.h"
#include "parser/source/suggest.h"

namespace verisim::parser {
namespace fs = std::filesystem;
namespace {

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

fs::path real_path(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return path.lexically_normal();
  fs::path result = fs::weakly_canonical(absolute, error);
  return error ? absolute.lexically_normal() : result;
}

bool below(const fs::path& path, const fs::path& folder) {
  const auto [end, at] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end() || (std::next(end) == folder.end() && end->empty());
}

// The file below `folder` that is called `wanted` but for upper and lower case; as it is written there.
std::optional<std::string> in_any_case(const fs::path& folder, const fs::path& wanted) {
  fs::path written;
  for (const fs::path& part : wanted) {
    if (part == "." || part == ".." || part.empty()) {
      written /= part;
      continue;
    }
    std::optional<fs::path> found;
    std::error_code error;
    const std::string lower = lowered(part.string());
    for (fs::directory_iterator i(folder / written, error), end; !error && i != end; i.increment(error))
      if (lowered(i->path().filename().string()) == lower) {
        found = i->path().filename();
        if (*found == part) break;
      }
    if (!found) return std::nullopt;
    written /= *found;
  }
  return written.string();
}

bool has_include_extension(const std::string& name) { return name.ends_with(".inc") || name.ends_with(".INC"); }

}  // namespace

FileSearch::FileSearch(std::vector<fs::path> library_paths, fs::path scene_folder, std::vector<fs::path> allow_read,
                       std::vector<fs::path> allow_write, MemoryFiles files)
    : library_paths_(std::move(library_paths)), scene_folder_(std::move(scene_folder)) {
  for (const fs::path& p : allow_read) readable_.push_back(real_path(p));
  std::error_code error;
  const bool named_only = confinement.writes_named_only;
  if (!named_only) writable_.push_back(real_path(fs::current_path(error)));
  if (!named_only && !scene_folder_.empty()) writable_.push_back(real_path(scene_folder_));
  for (const fs::path& p : allow_write) writable_.push_back(real_path(p));
  for (auto& [name, file] : files) files_[fs::path(name).lexically_normal().string()] = std::move(file);
}

std::shared_ptr<const MemoryFile> FileSearch::memory_file(const fs::path& name) const {
  if (files_.empty()) return nullptr;
  const auto found = files_.find(name.lexically_normal().string());
  return found == files_.end() ? nullptr : found->second;
}

std::optional<fs::path> FileSearch::find_exact(const std::string& name) const {
  if (const auto found = redirected_.find(name); found != redirected_.end()) return found->second;
  // A name that no file system can hold; also keeps NUL bytes out of system calls.
  if (name.empty() || name.size() > 4096 || name.find('\0') != std::string::npos) return std::nullopt;
  const fs::path path = name;
  if (memory_file(path) || is_there(path)) return path;
  if (path.is_absolute()) return std::nullopt;
  for (const fs::path& folder : library_paths_)
    if (is_there(folder / path)) return folder / path;
  if (!scene_folder_.empty() && is_there(scene_folder_ / path)) return scene_folder_ / path;
  return std::nullopt;
}

std::optional<fs::path> FileSearch::find_include(const std::string& name) const {
  if (const auto found = redirected_.find(name); found != redirected_.end()) return found->second;
  std::vector<std::string> candidates{name + ".inc", name + ".INC"};
  candidates.insert(has_include_extension(name) ? candidates.begin() : candidates.end(), name);
  if (name.empty() || name.size() > 4096 || name.find('\0') != std::string::npos) return std::nullopt;
  for (const std::string& candidate : candidates)
    if (memory_file(candidate)) return candidate;
  const bool absolute = fs::path(name).is_absolute();
  for (const std::string& candidate : candidates) {
    if (is_there(candidate)) return candidate;
    if (absolute) continue;
    for (const fs::path& folder : library_paths_)
      if (is_there(folder / candidate)) return folder / candidate;
  }
  // POV-Ray stops here; beside the scene is where its author meant.
  if (!absolute && !scene_folder_.empty())
    for (const std::string& candidate : candidates)
      if (is_there(scene_folder_ / candidate)) return scene_folder_ / candidate;
  return std::nullopt;
}

std::optional<FileSearch::Similar> FileSearch::find_similar(const std::string& name, bool include) const {
  if (name.empty() || name.size() > 4096 || name.find('\0') != std::string::npos) return std::nullopt;
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  std::vector<fs::path> folders{"."};
  folders.insert(folders.end(), library_paths_.begin(), library_paths_.end());
  if (!scene_folder_.empty()) folders.push_back(scene_folder_);
  const fs::path wanted = slashed;
  if (wanted.is_absolute()) return std::nullopt;
  std::vector<std::string> leaves{wanted.filename().string()};
  if (include && !wanted.has_extension()) leaves.insert(leaves.begin(), leaves[0] + ".inc");
  for (const std::string& leaf : leaves)
    for (const fs::path& folder : folders)
      if (const auto there = in_any_case(folder, wanted.parent_path() / leaf)) return Similar{*there, true};
  // Misspelt: among the files of the folder that is meant.
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::path& folder : folders)
    for (fs::directory_iterator i(folder / wanted.parent_path(), error), end; !error && i != end; i.increment(error))
      if (files.size() < 10000 &&
          lowered(i->path().extension().string()) == lowered(fs::path(leaves[0]).extension().string()))
        files.push_back(i->path().filename().string());
  std::vector<std::string_view> candidates(files.begin(), files.end());
  for (const std::string& leaf : leaves)
    if (const std::string_view near = nearest(leaf, candidates); !near.empty())
      return Similar{(wanted.parent_path() / near).string(), false};
  return std::nullopt;
}

fs::path FileSearch::redirect(const std::string& name, const fs::path& scratch) {
  const auto [entry, fresh] = redirected_.emplace(name, fs::path{});
  if (fresh) entry->second = scratch / std::to_string(redirected_.size());
  return entry->second;
}

bool FileSearch::may_read(const fs::path& path) const {
  if (readable_.empty() || memory_file(path)) return true;
  const fs::path real = real_path(path);
  return std::any_of(readable_.begin(), readable_.end(), [&](const fs::path& folder) { return below(real, folder); });
}

bool FileSearch::may_write(const fs::path& path) const {
  if (memory_file(path)) return false;
  const fs::path real = real_path(path);
  return std::any_of(writable_.begin(), writable_.end(), [&](const fs::path& folder) { return below(real, folder); });
}

}  // namespace verisim::parser
