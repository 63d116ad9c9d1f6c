#include "compare/reduce/sdl_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace verisim::compare {
namespace {

using testing::ElementsAre;

std::vector<std::string> statements(const std::string& text, const SdlBlock& block) {
  std::vector<std::string> out;
  for (const SdlStatement& s : block.statements) out.push_back(text.substr(s.range.begin, s.range.end - s.range.begin));
  return out;
}
std::vector<std::string> statements(const std::string& text) {
  const auto tree = sdl_tree(text);
  return tree ? statements(text, *tree) : std::vector<std::string>{"no tree"};
}
// Of the first block of the n-th statement.
std::vector<std::string> inside(const std::string& text, std::size_t n = 0) {
  const auto tree = sdl_tree(text);
  return tree ? statements(text, tree->statements.at(n).parts.at(0).blocks.at(0)) : std::vector<std::string>{"no tree"};
}

TEST(SdlTree, StatementsOfAScene) {
  EXPECT_THAT(
      statements("#version 3.7; camera { location -5*z } // seen\nsphere{0,1} #declare A = 3; Macro(1, 2)"),
      ElementsAre("#version 3.7;", "camera { location -5*z }", "sphere{0,1}", "#declare A = 3;", "Macro(1, 2)"));
}

TEST(SdlTree, WhatADeclarationHoldsBelongsToIt) {
  EXPECT_THAT(
      statements("#declare T = texture { pigment { color Red } } #declare F = function(x) { x*2 } plane { y, 0 }"),
      ElementsAre("#declare T = texture { pigment { color Red } }", "#declare F = function(x) { x*2 }",
                  "plane { y, 0 }"));
}

TEST(SdlTree, ItemsOfABlock) {
  EXPECT_THAT(inside("sphere { <0, 0, 0>, 1 pigment { rgb x } rotate 30*y*A no_shadow T_Wood }"),
              ElementsAre("<0, 0, 0>, 1", "pigment { rgb x }", "rotate 30*y*A", "no_shadow T_Wood"));
}

TEST(SdlTree, EntriesOfAMap) {
  EXPECT_THAT(inside("color_map { [0 rgb A[1]] [0.5 color Red] [1 rgb 1] }"),
              ElementsAre("[0 rgb A[1]]", "[0.5 color Red]", "[1 rgb 1]"));
}

TEST(SdlTree, ADirectiveAndItsEndAreOne) {
  const std::string text = "#if (A > 1) sphere { 0, 1 } box { 0, 1 } #else plane { y, 0 } #end torus { 1, 0.2 }";
  const auto tree = sdl_tree(text);
  ASSERT_TRUE(tree);
  ASSERT_EQ(tree->statements.size(), 2u);
  ASSERT_EQ(tree->statements[0].parts[0].blocks.size(), 2u);
  EXPECT_THAT(statements(text, tree->statements[0].parts[0].blocks[0]), ElementsAre("sphere { 0, 1 }", "box { 0, 1 }"));
  EXPECT_THAT(statements(text, tree->statements[0].parts[0].blocks[1]), ElementsAre("plane { y, 0 }"));
  EXPECT_THAT(inside("#macro M(A, B) sphere { A, B } #local C = 1; #end"),
              ElementsAre("sphere { A, B }", "#local C = 1;"));
}

// An exporter's text: a branch opens a block that another one closes.
TEST(SdlTree, DirectivesAloneWhereBranchesHoldHalfABlock) {
  EXPECT_THAT(statements("#if (A) union { #else merge { #end } #declare A = 1;"), ElementsAre("no tree"));
  EXPECT_THAT(statements("#if (A) union { #end sphere { 0, 1 } #if (A) } #end box { 0, 1 }"),
              ElementsAre("#if (A)", "union { #end sphere { 0, 1 } #if (A) }", "#end", "box { 0, 1 }"));
}

TEST(SdlTree, NoTreeWithoutMatchingBrackets) {
  for (const char* text : {"sphere { 0, 1", "sphere { 0, 1 } }", "box { (0], 1 }", "text { ttf \"a", "union { ( }"})
    EXPECT_FALSE(sdl_tree(text)) << text;
  EXPECT_FALSE(sdl_tree(std::string(100'000, '{')));
}

TEST(SdlTree, TextsWithoutCommentsAndInLines) {
  EXPECT_EQ(stripped("// head\nsphere { /* none */ 0, 1 }\n\n\nbox{0,1}//x"), "sphere { 0, 1 }\nbox{0,1}\n");
  EXPECT_EQ(stripped("text { ttf \"// no comment\" }"), "text { ttf \"// no comment\" }\n");
  EXPECT_EQ(laid_out("union { sphere { 0, 1 pigment { rgb x } } box { 0, 1 } } plane { y, 0 }"),
            "union {\n  sphere {\n    0, 1\n    pigment { rgb x }\n  }\n  box { 0, 1 }\n}\nplane { y, 0 }\n");
}

}  // namespace
}  // namespace verisim::compare
