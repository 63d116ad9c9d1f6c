// What `verisim review` is asked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace verisim::cli {

struct ReviewSettings {
  std::filesystem::path folder, baseline;  // baseline: empty for the run's own
  std::string html, markdown;              // files to write in the place of serving
  bool update = false, status = false;     // neither serves
  bool open = true;
  int port = 0;
  std::string token;
  bool serves() const { return html.empty() && markdown.empty() && !update && !status; }
};

// Throws OptionError, or HelpWanted.
ReviewSettings review_settings(const std::vector<std::string>& arguments);

}  // namespace verisim::cli
