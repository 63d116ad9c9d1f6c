#include "parser/editing/index.h"

#include <gtest/gtest.h>

namespace verisim::parser {
namespace {

std::vector<std::size_t> places(const NameIndex& index, std::string_view name, std::size_t at) {
  std::vector<std::size_t> out;
  for (const NameUse& use : index.same_name(name, at)) out.push_back(use.offset);
  return out;
}

TEST(NameIndex, KnowsScopes) {
  const std::string text =
      "#declare R = 1;\n#macro M(R, S)\n  #local T = R;\n  sphere { T, S }\n#end\nsphere { R, 1 }\n";
  const NameIndex index(text);
  const std::size_t global = text.find("R = 1"), parameter = text.find("R, S"), last = text.rfind("R, 1");
  EXPECT_EQ(places(index, "R", global), (std::vector<std::size_t>{global, last}));
  EXPECT_EQ(places(index, "R", parameter), (std::vector<std::size_t>{parameter, text.find("R;")}));
  ASSERT_NE(index.meaning("M", 0), nullptr);
  EXPECT_EQ(index.meaning("M", 0)->parameters, (std::vector<std::string>{"R", "S"}));
  EXPECT_EQ(index.meaning("T", 0), nullptr);
}

TEST(NameIndex, ReadsBrokenFiles) {
  const std::string text = "#declare A = 1;\n#debug \"open\n#declare B = 2;\n";
  const NameIndex index(text);
  EXPECT_NE(index.meaning("A", 0), nullptr);
  EXPECT_NE(index.meaning("B", 0), nullptr);
  for (std::size_t i = 0; i < text.size(); ++i) NameIndex(text.substr(0, i)).use_at(i);
}

}  // namespace
}  // namespace verisim::parser
