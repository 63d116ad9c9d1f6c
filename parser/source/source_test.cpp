#include "parser/source/source.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace verisim::parser {
namespace {

// Long texts with line ends of all kinds, asked in any order.
TEST(Source, KnowsLinesAndColumns) {
  std::mt19937 random(4);
  for (const std::string& ends : {std::string("\n"), std::string("\n\r")}) {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += random() % 4 == 0 ? ends[random() % ends.size()] : 'a';
    std::vector<std::size_t> starts{0};
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == 'a') continue;
      if (i + 1 < text.size() && text[i + 1] != 'a' && text[i + 1] != text[i]) ++i;
      starts.push_back(i + 1);
    }
    const Source source("text", text);
    for (int i = 0; i < 2000; ++i) {
      const std::size_t offset = random() % (text.size() + 1);
      std::size_t line = 0;
      while (line + 1 < starts.size() && starts[line + 1] <= offset) ++line;
      const Position position = source.position(offset);
      ASSERT_EQ(position.line, static_cast<int>(line) + 1) << offset;
      ASSERT_EQ(position.column, static_cast<int>(offset - starts[line]) + 1) << offset;
    }
    static_cast<void>(source.position(text.size()));
    for (std::size_t line = 0; line < starts.size(); ++line) {
      const std::string rest = text.substr(starts[line]);
      EXPECT_EQ(source.line(static_cast<int>(line) + 1), rest.substr(0, rest.find_first_of("\r\n"))) << line;
    }
    EXPECT_EQ(source.line(static_cast<int>(starts.size()) + 1), "");
    EXPECT_EQ(source.line(0), "");
  }
}

}  // namespace
}  // namespace verisim::parser
