// What the server knows: the open files, the scenes they belong to, and the names of all files of a scene.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "cli/lsp/analysis.h"
#include "cli/lsp/document.h"
#include "parser/source/search.h"

namespace verisim::cli::lsp {

// A file of a scene, open or on disk.
struct SceneFile {
  std::filesystem::path path;
  std::string uri;
  std::shared_ptr<const Text> text;
  const parser::NameIndex* index = nullptr;  // lives as long as nothing changes
  bool standard = false;                     // of the library paths: not the user's own
};

// A declaration, with the file that it is in.
struct Meaning {
  const SceneFile* file = nullptr;
  const parser::NameDeclaration* declaration = nullptr;
  explicit operator bool() const { return declaration != nullptr; }
};

class Workspace {
 public:
  Workspace(const Options& options, Columns columns) : options_(options), columns_(columns) {}

  Columns columns() const { return columns_; }
  void set_columns(Columns columns) { columns_ = columns; }
  const Options& options() const { return options_; }

  std::map<std::string, Document>& documents() { return documents_; }
  // Throws RequestError when it is not open.
  Document& document(const std::string& uri);
  std::string uri_for(const std::filesystem::path& path) const;  // as the client names it, if it is open
  std::shared_ptr<const Snapshot> snapshot() const;

  // The scenes that a file is part of: itself, or those that are known to read it, or one beside it that includes it.
  std::vector<Root> roots_of(const Document& document) const;
  // The scene a file is read as for questions about names; the first of them.
  std::vector<SceneFile> files_of(const Document& document);
  Meaning meaning(const std::vector<SceneFile>& files, const Document& document, std::string_view name,
                  std::size_t offset) const;
  // What a declaration was worth when the scene was read last; null: it was not.
  std::optional<DeclaredName> value_of(const Meaning& meaning) const;

  void store(std::shared_ptr<const Analysis> analysis);
  void drop(const std::string& key);
  std::vector<std::shared_ptr<const Analysis>> analyses() const;

  std::vector<std::filesystem::path> library_paths(const std::filesystem::path& scene) const;

 private:
  struct Stored {
    std::filesystem::file_time_type time;
    std::shared_ptr<const Text> text;
    std::unique_ptr<parser::NameIndex> index;
  };
  const Stored* stored(const std::filesystem::path& path);

  const Options& options_;
  Columns columns_;
  std::map<std::string, Document> documents_;  // by URI
  std::map<std::filesystem::path, Stored> disk_;
  mutable std::mutex mutex_;  // of the analyses, which another thread stores
  std::map<std::string, std::shared_ptr<const Analysis>> analyses_;
};

}  // namespace verisim::cli::lsp
