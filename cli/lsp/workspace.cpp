#include "cli/lsp/workspace.h"

#include "cli/describe/including_scene.h"
#include "cli/settings/reading/configuration.h"
#include "parser/source/standard_includes.h"
#include "parser/source/suggest.h"
#include "tracer/base/whole_file.h"

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

constexpr std::size_t kMaxFiles = 200;
constexpr std::uintmax_t kLargestFile = 64u << 20;

std::optional<std::string> read_file(const fs::path& path) {
  std::error_code failed;
  if (fs::file_size(path, failed) > kLargestFile || failed) return std::nullopt;
  return whole_file(path);
}

bool is_include(const fs::path& path) {
  const std::string extension = parser::lowered(path.extension().string());
  return extension == ".inc" || extension == ".mcr" || extension == ".macro";
}

}  // namespace

Document& Workspace::document(const std::string& uri) {
  const auto found = documents_.find(uri);
  if (found == documents_.end()) throw RequestError(kInvalidParams, "this file is not open: " + uri);
  return found->second;
}

std::string Workspace::uri_for(const fs::path& path) const {
  for (const auto& [uri, document] : documents_)
    if (document.path == path) return uri;
  return uri_of(path);
}

std::shared_ptr<const Snapshot> Workspace::snapshot() const {
  auto snapshot = std::make_shared<Snapshot>();
  for (const auto& [uri, document] : documents_)
    if (!document.path.empty()) snapshot->files[document.path] = {document.text, document.version};
  return snapshot;
}

void Workspace::store(std::shared_ptr<const Analysis> analysis) {
  const std::lock_guard lock(mutex_);
  const std::string key = analysis->root.key();
  analyses_[key] = std::move(analysis);
}

void Workspace::drop(const std::string& key) {
  const std::lock_guard lock(mutex_);
  analyses_.erase(key);
}

std::vector<std::shared_ptr<const Analysis>> Workspace::analyses() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::shared_ptr<const Analysis>> all;
  for (const auto& [key, analysis] : analyses_) all.push_back(analysis);
  return all;
}

std::vector<Root> Workspace::roots_of(const Document& document) const {
  if (document.path.empty()) return {{{}, document.uri, document.text, document.version}};
  std::vector<Root> roots;
  if (!is_include(document.path)) roots.push_back({document.path, document.uri, nullptr, 0});
  for (const auto& analysis : analyses())
    if (analysis->root.path != document.path && analysis->files_read.count(document.path))
      roots.push_back(analysis->root);
  if (!roots.empty()) return roots;
  if (const fs::path scene = scene_that_includes(document.path); !scene.empty())
    return {{scene, uri_of(scene), nullptr, 0}};
  return {{document.path, document.uri, nullptr, 0}};
}

std::vector<fs::path> Workspace::library_paths(const fs::path& scene) const { return search_paths(options_, scene); }

const Workspace::Stored* Workspace::stored(const fs::path& path) {
  std::error_code failed;
  const fs::file_time_type time = fs::last_write_time(path, failed);
  if (failed) return nullptr;
  Stored& file = disk_[path];
  if (file.index && file.time == time) return &file;
  const std::optional<std::string> text = read_file(path);
  if (!text) return nullptr;
  file.time = time;
  file.text = std::make_shared<const Text>(*text);
  file.index = std::make_unique<parser::NameIndex>(file.text->str());
  return &file;
}

std::vector<SceneFile> Workspace::files_of(const Document& document) {
  std::vector<SceneFile> files;
  std::set<fs::path> seen;
  const std::vector<fs::path> standard = parser::standard_include_folders();
  const auto add = [&](const fs::path& path) {
    if (!seen.insert(path).second || files.size() >= kMaxFiles) return;
    SceneFile file;
    file.path = path;
    file.uri = uri_for(path);
    const auto open = documents_.find(file.uri);
    if (open != documents_.end()) {
      file.text = open->second.text;
      file.index = &open->second.index();
    } else if (const Stored* on_disk = stored(path)) {
      file.text = on_disk->text;
      file.index = on_disk->index.get();
    } else {
      return;
    }
    for (const fs::path& folder : standard) file.standard |= path.string().starts_with(folder.string());
    files.push_back(std::move(file));
  };
  if (document.path.empty()) {
    files.push_back({{}, document.uri, document.text, &document.index(), false});
  } else {
    for (const Root& root : roots_of(document)) add(root.path);
    add(document.path);
  }
  const fs::path scene = files.empty() ? document.path : files.front().path;
  const parser::FileSearch search(library_paths(scene), scene.parent_path(), {}, {});
  for (std::size_t i = 0; i < files.size(); ++i) {  // grows
    const std::string& text = files[i].text->str();
    std::vector<fs::path> found;
    for (const parser::TextRange& range : files[i].index->includes()) {
      const std::string name = text.substr(range.begin, range.end - range.begin);
      std::error_code failed;
      const fs::path beside = scene.parent_path() / name;
      if (!scene.empty() && fs::is_regular_file(beside, failed))
        found.push_back(normal(beside));
      else if (const auto path = search.find_include(name))
        found.push_back(normal(*path));
    }
    for (const fs::path& path : found) add(path);
  }
  return files;
}

Meaning Workspace::meaning(const std::vector<SceneFile>& files, const Document& document, std::string_view name,
                           std::size_t offset) const {
  const SceneFile* own = nullptr;
  for (const SceneFile& file : files)
    if (file.uri == document.uri) own = &file;
  if (!own) return {};
  // In this file: what the name means here; of several declarations in the same part the last one before.
  if (const parser::NameDeclaration* first = own->index->meaning(name, offset)) {
    const parser::NameDeclaration* best = first;
    for (const parser::NameDeclaration& d : own->index->declarations())
      if (d.name == name && d.scope == first->scope && d.offset <= offset && d.offset >= best->offset) best = &d;
    return {own, best};
  }
  for (const SceneFile& file : files)
    for (const parser::NameDeclaration& d : file.index->declarations())
      if (&file != own && d.global && d.name == name) return {&file, &d};
  return {};
}

std::optional<DeclaredName> Workspace::value_of(const Meaning& meaning) const {
  if (!meaning) return std::nullopt;
  const std::string key = meaning.file->path.empty() ? meaning.file->uri : meaning.file->path.string();
  for (const auto& analysis : analyses()) {
    const auto file = analysis->declared.find(key);
    if (file == analysis->declared.end()) continue;
    const auto name = file->second.find(meaning.declaration->offset);
    if (name != file->second.end()) return name->second;
  }
  return std::nullopt;
}

}  // namespace verisim::cli::lsp
