// Warnings that POV-Ray gives about statements it accepts; the texts are ours where they say the same.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "parser/parse.h"

namespace verisim::parser {
namespace {

std::vector<std::string> warnings(const std::string& scene) {
  std::vector<std::string> found;
  ParseOptions options;
  options.message = [&](const Diagnostic& d) { found.push_back(d.message); };
  parse_text(scene, "test.pov", options);
  return found;
}

std::vector<std::string> of_statement(const std::string& statement) {
  return warnings("#version 3.7; global_settings { assumed_gamma 1 }\n" + statement + "\nsphere { 5, 1 }");
}

using Texts = std::vector<std::string>;

TEST(Warnings, UselessBounds) {
  const std::string parts = "sphere { 0, 1 } box { 0, 1 }", bound = "bounded_by { sphere { 0, 2 } }";
  EXPECT_EQ(of_statement("union { " + parts + bound + "}"), Texts{"CSG union unnecessarily bounded."});
  EXPECT_EQ(of_statement("union { plane { y, 0 }" + parts + bound + "}"), Texts{});
  EXPECT_EQ(of_statement("union { " + parts + bound + "split_union off }"), Texts{});
  EXPECT_EQ(of_statement("merge { " + parts + bound + "}"), Texts{});
  EXPECT_EQ(of_statement("#declare U = union { " + parts + bound + "}"), Texts{});
  EXPECT_EQ(of_statement("torus { 1, .2 " + bound + "}"), Texts{"Unnecessary bounding object removed."});
  EXPECT_EQ(of_statement("intersection { sphere { 0, 1 } torus { 1, .2 " + bound + "} }"), Texts{"Unnecessary bounding object removed."});
}

TEST(Warnings, OpenPrisms) {
  EXPECT_EQ(of_statement("prism { 0, 1, 3, <0, 0>, <1, 0>, <0, 1> }"), Texts{"Linear prism not closed. Closing it."});
  EXPECT_EQ(of_statement("prism { 0, 1, 8, <0,0>, <1,0>, <0,1>, <0,0>, <.1,.1>, <.2,.1>, <.1,.2>, <.1,.1> }"), Texts{});
  EXPECT_EQ(of_statement("prism { bezier_spline 0, 1, 4, <0,0>, <1,0>, <0,1>, <.2,.2> }"), Texts{"Prism not closed. Ignoring it."});
}

TEST(Warnings, ZeroPower) {
  EXPECT_EQ(of_statement("#declare F = function(a) { a*pow(a - 1, 0) + 1 };"), Texts{"Zero power optimised to constant 1.0!"});
  EXPECT_EQ(of_statement("#declare F = function(a) { pow(a, (0)) };"), Texts{});
}

TEST(Warnings, DeprecatedNamesAreUndefinedWithAWarning) {
  EXPECT_EQ(of_statement("#declare deprecated \"old\" X = 1; #undef X"), Texts{"old"});
}

TEST(Warnings, EveryFinishItemOutsideOfAFinish) {
  const Texts found = warnings("#version 1.0; sphere { 0 1 texture { color red 1 phong 1 ambient .5 } }");
  ASSERT_GE(found.size(), 3u);
  EXPECT_NE(found[1].find("'phong'"), std::string::npos);
  EXPECT_NE(found[2].find("'ambient'"), std::string::npos);
}

}  // namespace
}  // namespace verisim::parser
