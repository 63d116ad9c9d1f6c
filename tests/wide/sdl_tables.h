// What is compared is SDL in files beside the tests: what all scenes begin with, then tables, each below `== its name`.
// A line of a table is `name | SDL`, or SDL alone, which then is the name, too; lines that are indented continue it.
#pragma once

#include <string>
#include <vector>

#include "parser/parse.h"

namespace verisim::test {

struct SdlLine {
  std::string name, sdl;
};

class SdlTables {
 public:
  // `file`: its name in tests/wide.
  explicit SdlTables(const std::string& file);
  const std::vector<SdlLine>& operator[](const std::string& table) const;
  // What they begin with, and `sdl`. Throws what is wrong with it.
  scene::Scene scene(const std::string& sdl, const parser::ParseOptions& options = {}) const;

 private:
  struct Table {
    std::string name;
    std::vector<SdlLine> lines;
  };
  std::string prelude_;
  std::vector<Table> tables_;
};

}  // namespace verisim::test
