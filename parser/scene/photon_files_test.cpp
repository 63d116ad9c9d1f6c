#include <gtest/gtest.h>

#include "parser/parse.h"

namespace verisim::parser {
namespace {

std::string error_of_item(const std::string& item) {
  const ParseResult result = parse_text("global_settings { photons { " + item + " } }", "test.pov", {});
  return result.errors.empty() ? "" : result.errors.front().message;
}

TEST(PhotonFiles, AreWrittenOnlyWhereTheSceneMayWrite) {
  EXPECT_EQ(error_of_item("save_file \"map.ph\""), "");
  EXPECT_NE(error_of_item("save_file \"/map.ph\"").find("may not write"), std::string::npos);
  EXPECT_NE(error_of_item("save_file \"../../../../../../../../map.ph\"").find("may not write"), std::string::npos);
}

TEST(PhotonFiles, AreReadOnlyWhenTheyAreThere) {
  EXPECT_NE(error_of_item("load_file \"none.ph\"").find("Cannot find"), std::string::npos);
}

}  // namespace
}  // namespace verisim::parser
