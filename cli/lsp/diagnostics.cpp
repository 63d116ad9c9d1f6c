#include "cli/lsp/diagnostics.h"

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace verisim::cli::lsp {
namespace {

// DiagnosticSeverity of the protocol.
int severity_of(parser::Severity severity) {
  return severity == parser::Severity::warning ? 2 : severity == parser::Severity::possible_error ? 2 : 1;
}

class Converter {
 public:
  Converter(const Analysis& analysis, Columns columns, const std::map<fs::path, std::string>& open_uris)
      : analysis_(analysis), columns_(columns), open_uris_(open_uris) {}

  std::string uri(const std::string& file) const {
    if (file.empty() || (analysis_.root.path.empty() && file == analysis_.root.uri)) return analysis_.root.uri;
    const fs::path path = normal(file);
    const auto open = open_uris_.find(path);
    return open == open_uris_.end() ? uri_of(path) : open->second;
  }

  const Snapshot::File& file(const std::string& name) {
    const std::string key = name.empty() ? analysis_.root.uri : name;
    const auto known = files_.find(key);
    if (known != files_.end()) return known->second;
    const bool root = name.empty() || (analysis_.root.path.empty() && name == analysis_.root.uri);
    return files_[key] = analysis_.file(root ? analysis_.root.path : normal(name));
  }

  Json range(const parser::Excerpt& place) {
    const Text& text = *file(place.file).text;
    if (place.line <= 0) return range_json(text, 0, 0, columns_);
    const auto line = static_cast<std::size_t>(place.line - 1);
    const auto column = static_cast<std::size_t>(std::max(place.column - 1, 0));
    const std::size_t begin = text.byte_offset(line, column);
    const std::size_t end = std::min(begin + static_cast<std::size_t>(std::max(place.length, 1)), text.str().size());
    return range_json(text, begin, std::max(begin, end), columns_);
  }

  Json diagnostic(const parser::Diagnostic& d) {
    Json out{{"range", range(d)},
             {"severity", severity_of(d.severity)},
             {"code", std::string(parser::name(d.code))},
             {"source", "verisim"},
             {"message", d.advice.empty() ? d.message : d.message + "\n" + d.advice}};
    for (const parser::Related& r : d.related)
      out["relatedInformation"].push_back(
          {{"location", {{"uri", uri(r.place.file)}, {"range", range(r.place)}}}, {"message", r.message}});
    // The way to a message in an include file or macro.
    if (!d.trail.empty()) {
      std::string trail;
      for (const std::string& step : d.trail) trail += "\n" + step;
      out["message"] = out["message"].get<std::string>() + trail;
    }
    if (d.code == parser::Code::no_effect || d.code == parser::Code::deprecated)
      out["tags"] = {d.code == parser::Code::deprecated ? 2 : 1};
    return out;
  }

  // Hints are what is allowed and yet mostly a mistake; editors show them quietly.
  Json hint(const LintFinding& f) {
    constexpr int kHint = 4, kUnnecessary = 1;  // DiagnosticSeverity, DiagnosticTag
    Json out{{"range", range(f)},
             {"severity", kHint},
             {"code", std::string(f.lint->name)},
             {"source", "verisim"},
             {"message", f.advice.empty() ? f.message : f.message + "\n" + f.advice}};
    if (f.lint->name == "unused-name") out["tags"] = {kUnnecessary};
    return out;
  }

 private:
  const Analysis& analysis_;
  Columns columns_;
  const std::map<fs::path, std::string>& open_uris_;
  std::map<std::string, Snapshot::File> files_;
};

}  // namespace

void Publisher::publish(const Analysis& analysis, const std::vector<LintFinding>& lints,
                        const std::map<fs::path, std::string>& open_uris) {
  constexpr std::size_t kMax = 500;
  Converter convert(analysis, columns_, open_uris);
  std::map<std::string, Given> given;
  given[analysis.root.uri];  // published even if there is nothing
  for (const fs::path& path : analysis.files_read)
    if (const auto open = open_uris.find(path); open != open_uris.end()) given[open->second];
  for (const parser::Diagnostic& d : analysis.diagnostics) {
    const std::string uri = convert.uri(d.file);
    Given& here = given[uri];
    if (here.diagnostics.size() == kMax) continue;
    Json diagnostic = convert.diagnostic(d);
    if (d.fix && convert.uri(d.fix->file) == uri)
      here.fixes.push_back({*d.fix, std::string(parser::name(d.code)), diagnostic, diagnostic["range"]});
    here.diagnostics.push_back(std::move(diagnostic));
  }
  for (const LintFinding& f : lints)
    if (Given& here = given[convert.uri(f.file)]; here.diagnostics.size() < kMax)
      here.diagnostics.push_back(convert.hint(f));
  if (analysis.stopped) {
    Json note{{"range", {{"start", as_json(Point{})}, {"end", as_json(Point{})}}},
              {"severity", 3},
              {"source", "verisim"},
              {"message", fmt::format("Reading this scene was stopped after {:g} s: an endless loop, or one that takes "
                                      "long. What comes behind it is not checked.",
                                      seconds_)}};
    given[analysis.root.uri].diagnostics.push_back(std::move(note));
  }
  for (auto& [uri, here] : given) {
    const Snapshot::File file =
        uri == analysis.root.uri ? analysis.file(analysis.root.path) : analysis.file(path_of(uri));
    here.text = file.text;
    here.version = file.version;
  }
  const std::lock_guard lock(mutex_);
  std::set<std::string> changed;
  auto& before = by_scene_[analysis.root.key()];
  for (const auto& [uri, here] : before) changed.insert(uri);
  for (const auto& [uri, here] : given) changed.insert(uri);
  before = std::move(given);
  for (const std::string& uri : changed) send(uri);
}

void Publisher::drop(const std::string& key) {
  const std::lock_guard lock(mutex_);
  const auto scene = by_scene_.find(key);
  if (scene == by_scene_.end()) return;
  const auto dropped = std::move(scene->second);
  by_scene_.erase(scene);
  for (const auto& [uri, here] : dropped) send(uri);
}

void Publisher::send(const std::string& uri) {
  Json all = Json::array();
  int version = 0;
  for (const auto& [key, files] : by_scene_) {
    const auto here = files.find(uri);
    if (here == files.end()) continue;
    version = std::max(version, here->second.version);
    for (const Json& d : here->second.diagnostics)
      if (std::find(all.begin(), all.end(), d) == all.end()) all.push_back(d);
  }
  Json params{{"uri", uri}, {"diagnostics", std::move(all)}};
  if (version) params["version"] = version;
  connection_.notify("textDocument/publishDiagnostics", std::move(params));
}

std::vector<KnownFix> Publisher::fixes(const std::string& uri, std::shared_ptr<const Text>* text) const {
  const std::lock_guard lock(mutex_);
  std::vector<KnownFix> all;
  for (const auto& [key, files] : by_scene_) {
    const auto here = files.find(uri);
    if (here == files.end() || here->second.fixes.empty()) continue;
    *text = here->second.text;
    all.insert(all.end(), here->second.fixes.begin(), here->second.fixes.end());
  }
  return all;
}

}  // namespace verisim::cli::lsp
