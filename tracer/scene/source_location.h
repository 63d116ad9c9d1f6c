// Where in the scene's source something was written, for diagnostics after parsing.
#pragma once

#include <memory>
#include <string>

namespace verisim::scene {

struct SourceLocation {
  std::shared_ptr<const std::string> file;
  int line = 0, column = 0;  // 1-based; 0: unknown
  friend bool operator==(const SourceLocation&, const SourceLocation&) = default;
};

}  // namespace verisim::scene
