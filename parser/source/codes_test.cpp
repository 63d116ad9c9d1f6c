// The catalogue of codes against the parser: each example gives its code, and gives it no longer when it is mended.
#include <gtest/gtest.h>

#include <set>

#include "parser/language/test_support.h"

namespace verisim::parser {
namespace {

std::set<std::string_view> codes_of(std::string_view sdl) {
  std::set<std::string_view> found;
  ParseOptions options;
  options.message = [&](const Diagnostic& d) { found.insert(name(d.code)); };
  const std::string head = "#version 3.7; global_settings { assumed_gamma 1 }\n";
  parse_text((sdl.find("#version") == std::string_view::npos ? head : std::string()) + std::string(sdl), "test.pov",
             options);
  return found;
}

TEST(Codes, HaveNamesThatAreTheirOwn) {
  std::set<std::string_view> names;
  for (const CodeEntry& e : all_codes()) {
    EXPECT_TRUE(names.insert(e.name).second) << e.name;
    EXPECT_FALSE(e.title.empty() || e.text.empty()) << e.name;
    EXPECT_EQ(code_named(e.name), e.code);
    EXPECT_NE(explanation(e).find(e.title), std::string::npos);
  }
  EXPECT_EQ(code_named("no-such-code"), std::nullopt);
}

TEST(Codes, ExamplesGiveThem) {
  for (const CodeEntry& e : all_codes()) {
    if (!e.wrong.empty()) {
      EXPECT_TRUE(codes_of(e.wrong).contains(e.name)) << e.name << ": " << e.wrong;
    }
    if (!e.right.empty()) {
      EXPECT_FALSE(codes_of(e.right).contains(e.name)) << e.name << ": " << e.right;
    }
  }
}

}  // namespace
}  // namespace verisim::parser
