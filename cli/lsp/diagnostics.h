// What is wrong, as the protocol says it; published file by file, whichever scene it came from.
#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "cli/lsp/analysis.h"

namespace verisim::cli::lsp {

// A correction that is certain, of the text that was read.
struct KnownFix {
  parser::Fix fix;
  std::string code;
  Json diagnostic, range;  // as published
};

class Publisher {
 public:
  explicit Publisher(Connection& connection) : connection_(connection) {}
  void set_columns(Columns columns) { columns_ = columns; }
  void set_seconds(double seconds) { seconds_ = seconds; }

  void publish(const Analysis& analysis, const std::vector<LintFinding>& lints,
               const std::map<std::filesystem::path, std::string>& open_uris);
  void drop(const std::string& key);  // the scene is closed
  // Fixes of a file's diagnostics, and the text they are for.
  std::vector<KnownFix> fixes(const std::string& uri, std::shared_ptr<const Text>* text) const;

 private:
  struct Given {
    Json diagnostics = Json::array();
    std::vector<KnownFix> fixes;
    std::shared_ptr<const Text> text;
    int version = 0;
  };
  void send(const std::string& uri);  // mutex held

  Connection& connection_;
  Columns columns_ = Columns::utf16;
  double seconds_ = 0;
  mutable std::mutex mutex_;
  std::map<std::string, std::map<std::string, Given>> by_scene_;  // and by URI
};

}  // namespace verisim::cli::lsp
