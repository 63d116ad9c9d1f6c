#include "cli/lsp/analysis.h"

#include <algorithm>
#include <utility>

#include "cli/describe/scene_findings.h"
#include "cli/frame/job.h"
#include "tracer/base/whole_file.h"

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

class NameRecorder : public parser::Recorder {
 public:
  explicit NameRecorder(Analysis& analysis) : analysis_(analysis) {}
  void declared(const std::string& file, std::size_t offset, std::string_view, std::string_view kind,
                const std::string& value) override {
    if (file != file_) {
      file_ = file;
      names_ = &analysis_.declared[fs::path(file).empty() ? file : normal(file).string()];
    }
    DeclaredName& name = (*names_)[offset];
    name.kind = kind;
    name.value = value;
  }

 private:
  Analysis& analysis_;
  std::string file_;
  std::unordered_map<std::size_t, DeclaredName>* names_ = nullptr;
};

// That reading was stopped by this server's limits is not a mistake of the scene.
bool is_stop(const parser::Diagnostic& d) { return d.code == parser::Code::time_limit; }

}  // namespace

fs::path normal(const fs::path& path) {
  std::error_code failed;
  const fs::path absolute = fs::absolute(path, failed);
  return (failed ? path : absolute).lexically_normal();
}

Snapshot::File Analysis::file(const fs::path& path) const {
  if (path.empty() || (root.path.empty() && path == root.uri)) return {root.text, root.version};
  if (const auto open = snapshot->files.find(path); open != snapshot->files.end()) return open->second;
  return {std::make_shared<const Text>(whole_file(path).value_or("")), 0};
}

std::shared_ptr<Analysis> analyse(const Options& options, const Root& root, std::shared_ptr<const Snapshot> snapshot,
                                  const fs::path& scratch, double seconds, const std::function<bool()>& cancelled,
                                  bool keep_scene) {
  auto analysis = std::make_shared<Analysis>();
  analysis->root = root;
  analysis->snapshot = std::move(snapshot);
  const Animation frames = animation(options);
  parser::ParseOptions parse =
      parse_options(options, root.path.empty() ? fs::path(root.uri) : root.path, frames, frames.frame(0));
  NameRecorder recorder(*analysis);
  parse.recorder = &recorder;
  parse.scratch = scratch;
  parse.debug = [](const std::string&) {};
  parse.message = [&](const parser::Diagnostic& d) {
    if (is_stop(d))
      analysis->stopped = true;
    else
      analysis->diagnostics.push_back(d);
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  parse.cancelled = [&] { return std::chrono::steady_clock::now() > end || cancelled(); };
  parse.unsaved = [&](const fs::path& path) -> std::optional<std::string> {
    const auto open = analysis->snapshot->files.find(normal(path));
    if (open == analysis->snapshot->files.end()) return std::nullopt;
    return open->second.text->str();
  };
  parser::ParseResult result =
      root.path.empty() ? parser::parse_text(root.text->str(), root.uri, parse) : parser::parse_file(root.path, parse);
  for (const fs::path& path : result.files_read) analysis->files_read.insert(normal(path));
  if (!root.path.empty()) analysis->files_read.insert(root.path);
  if (result.scene && !cancelled())
    for (parser::Diagnostic& finding : scene_findings(*result.scene))
      analysis->diagnostics.push_back(std::move(finding));
  if (keep_scene) analysis->scene = std::move(result.scene);
  return analysis;
}

Analyst::Analyst(const Options& options, AnalysisSettings settings, fs::path scratch, Done done)
    : options_(options),
      settings_(std::move(settings)),
      scratch_(std::move(scratch)),
      done_(std::move(done)),
      thread_([this] { work(); }) {}

Analyst::~Analyst() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
    cancel_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Analyst::want(const Root& root, std::shared_ptr<const Snapshot> snapshot) {
  const std::string key = root.key();
  {
    const std::lock_guard lock(mutex_);
    wishes_[key] = {root, std::move(snapshot), std::chrono::steady_clock::now() + settings_.delay};
    if (running_ == key) cancel_ = true;
  }
  changed_.notify_all();
}

void Analyst::forget(const std::string& key) {
  const std::lock_guard lock(mutex_);
  wishes_.erase(key);
  if (running_ == key) cancel_ = true;
}

// Lints come with what is wrong where they are found at once, and behind it where they take longer.
void Analyst::give(std::shared_ptr<Analysis> analysis) {
  constexpr std::chrono::milliseconds kAtOnce{20};
  if (cancel_) return;
  const std::optional<scene::Scene> scene = std::exchange(analysis->scene, std::nullopt);
  if (!scene) return done_(analysis, {});
  const fs::path own = analysis->root.path.empty() ? fs::path(analysis->root.uri) : analysis->root.path;
  LintedScene linted{*scene, {own}, [&](const fs::path& path) { return analysis->file(path).text->str(); }};
  for (const fs::path& path : analysis->files_read)
    if (path != own) linted.files.push_back(path);
  const auto soon = std::chrono::steady_clock::now() + kAtOnce;
  auto lints = find_lints(linted, settings_.lints, [&] { return cancel_ || std::chrono::steady_clock::now() > soon; });
  if (cancel_) return;
  done_(analysis, lints.value_or(std::vector<LintFinding>{}));
  if (lints) return;
  lints = find_lints(linted, settings_.lints, [&] { return cancel_.load(); });
  if (lints && !cancel_) done_(analysis, *lints);
}

void Analyst::work() {
  std::unique_lock lock(mutex_);
  while (!end_) {
    const auto next = std::min_element(wishes_.begin(), wishes_.end(),
                                       [](const auto& a, const auto& b) { return a.second.due < b.second.due; });
    if (next == wishes_.end()) {
      changed_.wait(lock);
      continue;
    }
    if (const auto due = next->second.due; due > std::chrono::steady_clock::now()) {
      changed_.wait_until(lock, due);
      continue;
    }
    const Wish wish = std::move(next->second);
    wishes_.erase(next);
    running_ = wish.root.key();
    cancel_ = false;
    lock.unlock();
    try {
      give(analyse(
          options_, wish.root, wish.snapshot, scratch_, settings_.seconds, [this] { return cancel_.load(); }, true));
    } catch (const std::exception&) {  // a file that vanished, no memory: the next change tries again
    }
    lock.lock();
    running_.clear();
    changed_.notify_all();
  }
}

}  // namespace verisim::cli::lsp
