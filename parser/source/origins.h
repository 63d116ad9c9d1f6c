// Where a scene's objects come from, beyond their place in a file: the macro calls around them and the name that they
// were declared with. Collected for those who explain pictures; the scene itself does not grow by it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tracer/scene/source_location.h"

namespace verisim::parser {

class Origins {
 public:
  struct Origin {
    std::string declared;            // the identifier; empty: none
    std::vector<std::string> calls;  // "file:line" of macro calls and of object { IDENTIFIER }, the inner one first

    auto operator<=>(const Origin&) const = default;
  };

  // The same place with an origin: places of one origin share the name of their file.
  scene::SourceLocation with(const scene::SourceLocation& place, Origin origin);
  Origin of(const scene::SourceLocation& place) const;  // of a place that has none: empty

 private:
  using Name = std::shared_ptr<const std::string>;
  std::map<std::pair<std::string, Origin>, Name> names_;
  std::map<const std::string*, Origin> origins_;
};

}  // namespace verisim::parser
