#include "tests/wide/sdl_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "parser/source/diagnostic.h"

namespace verisim::test {

SdlTables::SdlTables(const std::string& file) {
  std::ifstream in(VERISIM_SOURCE_DIR "/tests/wide/" + file);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("== ")) {
      tables_.push_back({line.substr(3), {}});
    } else if (tables_.empty()) {
      prelude_ += line + '\n';
    } else if (line.starts_with(' ')) {
      tables_.back().lines.back().sdl += line;
    } else if (!line.empty() && !line.starts_with("//")) {
      const std::size_t bar = line.find(" |");
      const bool named = bar != std::string::npos;
      tables_.back().lines.push_back({line.substr(0, bar), named ? line.substr(std::min(bar + 3, line.size())) : line});
    }
  }
}

const std::vector<SdlLine>& SdlTables::operator[](const std::string& table) const {
  const auto found = std::ranges::find(tables_, table, &Table::name);
  if (found == tables_.end()) throw std::runtime_error("there is no table of " + table);
  return found->lines;
}

scene::Scene SdlTables::scene(const std::string& sdl, const parser::ParseOptions& options) const {
  parser::ParseResult result = parser::parse_text(prelude_ + sdl, "line.pov", options);
  if (!result.errors.empty() || !result.scene) throw std::runtime_error(parser::format(result.errors.front()));
  return std::move(*result.scene);
}

TEST(SdlTables, HaveNamedLinesThatMayBeContinued) {
  const SdlTables tables("rays.sdl");
  EXPECT_EQ(tables["variants"][3].name, "inverse");
  EXPECT_EQ(tables["variants"][3].sdl, "rotate 90*y inverse");
  EXPECT_EQ(tables["objects"].back().name, "clipped parts");
  EXPECT_TRUE(tables["objects"].back().sdl.ends_with("M() }"));
  EXPECT_EQ(SdlTables("points.sdl")["normals"][0].sdl, "bumps");
  EXPECT_EQ(SdlTables("points.sdl")["normal modifiers"][0].sdl, "");
  EXPECT_THROW(tables["planets"], std::runtime_error);
  EXPECT_THROW(tables.scene("sphere {"), std::runtime_error);
}

}  // namespace verisim::test
