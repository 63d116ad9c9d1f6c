// Every keyword of every block, with nothing, a number, a vector, a colour, a string, braces ... behind it: accepted
// where POV-Ray accepts it. keyword_forms.txt has one statement a line, behind '+' or '-': what povray 3.7.0.10 says to
// it after "#version 3.7;" and an assumed_gamma.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "parser/parse.h"

namespace verisim {
namespace {

TEST(Differential, KeywordForms) {
  std::ifstream in(std::string(VERISIM_SOURCE_DIR) + "/tests/differential/keyword_forms.txt");
  int count = 0, different = 0;
  for (std::string line; std::getline(in, line); ++count) {
    const parser::ParseResult result =
        parser::parse_text("#version 3.7;\nglobal_settings{assumed_gamma 1}\n" + line.substr(1) + "\n", "form.pov", {});
    const bool accepted = result.errors.empty();
    if (accepted == (line[0] == '+')) continue;
    if (++different <= 20)
      ADD_FAILURE() << line << "\n  " << (accepted ? "is accepted" : parser::format(result.errors.front()));
  }
  EXPECT_GT(count, 4000);
  EXPECT_EQ(different, 0) << "of " << count;
}

}  // namespace
}  // namespace verisim
