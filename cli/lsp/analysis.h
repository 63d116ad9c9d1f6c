// Reads scenes in the background while they are edited: what is wrong with them, and what their names mean.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include "cli/lints/lints.h"
#include "cli/lsp/document.h"
#include "cli/settings/options.h"
#include "parser/parse.h"

namespace verisim::cli::lsp {

// The files that are open, as they are at one moment; by their normal paths.
struct Snapshot {
  struct File {
    std::shared_ptr<const Text> text;
    int version = 0;
  };
  std::map<std::filesystem::path, File> files;
};

// What a scene is read from: its file, or for one without a file the text and its URI.
struct Root {
  std::filesystem::path path;
  std::string uri;
  std::shared_ptr<const Text> text;  // only without a path
  int version = 0;                   // of the text
  const std::string key() const { return path.empty() ? uri : path.string(); }
};

struct DeclaredName {
  std::string kind, value;  // "float", "2.5"; the value as it was last
};

struct Analysis {
  Root root;
  std::shared_ptr<const Snapshot> snapshot;
  std::vector<parser::Diagnostic> diagnostics;
  bool stopped = false;  // by the limit of time, steps or memory
  std::set<std::filesystem::path> files_read;
  // By file and offset of the name.
  std::unordered_map<std::string, std::unordered_map<std::size_t, DeclaredName>> declared;
  std::optional<scene::Scene> scene;  // only where it was asked for
  // The text of a file as it was read, and its version if it was open.
  Snapshot::File file(const std::filesystem::path& path) const;
};

// Absolute and without dots; what names a file here.
std::filesystem::path normal(const std::filesystem::path& path);

struct AnalysisSettings {
  double seconds = 10;
  std::chrono::milliseconds delay{40};  // after the last change
  std::set<std::string_view> lints{};   // that are looked for
};

// Reads a scene now. Nothing is written beside the scene: what it writes goes to `scratch`. `cancelled` is polled by
// the thread that calls.
std::shared_ptr<Analysis> analyse(const Options& options, const Root& root, std::shared_ptr<const Snapshot> snapshot,
                                  const std::filesystem::path& scratch, double seconds,
                                  const std::function<bool()>& cancelled, bool keep_scene);

class Analyst {
 public:
  // `done` is called by the thread that reads; a second time with the same analysis where lints take long.
  using Done = std::function<void(std::shared_ptr<const Analysis>, const std::vector<LintFinding>&)>;
  Analyst(const Options& options, AnalysisSettings settings, std::filesystem::path scratch, Done done);
  ~Analyst();
  Analyst(const Analyst&) = delete;
  Analyst& operator=(const Analyst&) = delete;

  // Reads a scene when nothing has changed for a moment; what is under way for the same scene ends.
  void want(const Root& root, std::shared_ptr<const Snapshot> snapshot);
  void forget(const std::string& key);

 private:
  struct Wish {
    Root root;
    std::shared_ptr<const Snapshot> snapshot;
    std::chrono::steady_clock::time_point due;
  };
  void work();
  void give(std::shared_ptr<Analysis> analysis);

  const Options& options_;
  const AnalysisSettings settings_;
  const std::filesystem::path scratch_;
  const Done done_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Wish> wishes_;  // by Root::key
  std::string running_;                 // whose scene is being read; empty: none
  std::atomic<bool> cancel_ = false;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace verisim::cli::lsp
