// Several errors in one run: which are named, and that consequences of the first are not.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "parser/parse.h"

namespace verisim::parser {
namespace {

std::vector<int> lines_of_errors(const std::string& text) {
  const ParseResult result = parse_text("#version 3.7; global_settings { assumed_gamma 1 }\n" + text, "scene.pov", {});
  EXPECT_EQ(result.scene.has_value(), result.errors.empty());
  std::vector<int> lines;
  for (const Diagnostic& error : result.errors) lines.push_back(error.line);
  return lines;
}

using Lines = std::vector<int>;

TEST(Recovery, GoesOnBehindTheFailingStatement) {
  EXPECT_EQ(
      lines_of_errors(
          "sphere { 0, one }\nbox { 0, 1 pigment { two } finish { ambient 1 } }\nsphere { 0, 1 }\ncone { three }"),
      (Lines{2, 3, 5}));
  EXPECT_EQ(lines_of_errors("#declare A = 1\n#declare B = 2;\n#declare C = sin;\nsphere { 0, B }"), (Lines{2, 4}));
  EXPECT_EQ(lines_of_errors("union { sphere { 0, oops }\nbox { 0, 1 } }\nsphere { 0, again }"), (Lines{2, 4}));
}

TEST(Recovery, DoesNotReportConsequences) {
  EXPECT_EQ(
      lines_of_errors(
          "#declare T = texture { pigment { nothing } }\nsphere { 0, 1 texture { T } }\nbox { 0, 1 texture { T } }"),
      (Lines{2}));
  EXPECT_EQ(lines_of_errors("#declare T = texture { pigment { a } }\n#declare U = texture { T }\nsphere { 0, 1 texture "
                            "{ U } }\nsphere { 0, b }"),
            (Lines{2, 5}));
  EXPECT_EQ(lines_of_errors("#macro M(sin) #end\nM(1)\nsphere { 0, oops }"), (Lines{2, 4}));
}

TEST(Recovery, TakesMisspeltDirectivesForWhatWasMeant) {
  EXPECT_EQ(lines_of_errors("#Declare A = 1;\nsphere { 0, A }\nbox { 0, bad }"), (Lines{2, 4}));
  EXPECT_EQ(lines_of_errors("#If (1)\nsphere { 0, 1 }\n#else\n#if (1)\n#end\n#end\nbox { 0, bad }"), (Lines{2, 8}));
  EXPECT_EQ(lines_of_errors("#function Ball(R)\nsphere { 0, R }\n#end\nBall(2)\nbox { 0, bad }"), (Lines{2, 6}));
  EXPECT_EQ(lines_of_errors("#if (1)\nsphere { 0, 1 }\n#endif\nbox { 0, bad }"), (Lines{4, 5}));
  EXPECT_EQ(lines_of_errors("difference ( sphere { 0, 1 } box { 0, 1 } )\nbox { 0, bad }"), (Lines{2, 3}));
}

TEST(Recovery, NamesAnErrorInALoopOrMacroOnce) {
  EXPECT_EQ(lines_of_errors("#for (I, 1, 5)\nsphere { I, oops }\n#end\nbox { 0, bad }"), (Lines{3, 5}));
  EXPECT_EQ(lines_of_errors("#macro M(a) sphere { a, oops } #end\nM(1) M(2)\nbox { 0, bad }"), (Lines{2, 4}));
}

TEST(Recovery, GoesOnBehindACallThatFailed) {
  const std::string macro = "#macro M(a, b) #declare N = a; sphere { a, b } #end\n";
  EXPECT_EQ(lines_of_errors(macro + "M(1)\nsphere { 0, N }\nbox { 0, bad }"), (Lines{3, 5}));
  EXPECT_EQ(lines_of_errors(macro + "M(1, 2, 3)\nbox { 0, bad }"), (Lines{3, 4}));
  EXPECT_EQ(lines_of_errors(macro + "M\nbox { 0, bad }"), (Lines{3, 4}));
  EXPECT_EQ(lines_of_errors(macro + "union { M(1) }\nbox { 0, bad }"), (Lines{3, 4}));
}

TEST(Recovery, EndsWhereItCannotTell) {
  EXPECT_EQ(lines_of_errors("#include \"no such file.inc\"\nsphere { 0, oops }"), (Lines{2}));
  EXPECT_EQ(lines_of_errors("sphere { 0, oops\nsphere { 0, 1 }"), (Lines{2}));
  EXPECT_EQ(lines_of_errors("sphere { 0, oops }\n#error \"no\"\nsphere { 0, more }"), (Lines{2, 3}));
  EXPECT_EQ(lines_of_errors("sphere { 0, oops }\n\"open string"), (Lines{2, 3}));
  std::string many;
  for (int i = 0; i < 100; ++i) many += "sphere { 0, oops }\n";
  EXPECT_EQ(lines_of_errors(many).size(), 20u);
}

TEST(Recovery, SkipsConstructsWithABadCondition) {
  EXPECT_EQ(lines_of_errors("#if (oops) sphere { 0, 1 }\n#else box { 0, 1 }\n#end\nsphere { 0, bad }"), (Lines{2, 5}));
  EXPECT_EQ(lines_of_errors("#while (x) sphere { 0, 1 }\n#end\nsphere { 0, bad }"), (Lines{2, 4}));
  EXPECT_EQ(lines_of_errors("#ifdef A sphere { 0, 1 }\n#else box { 0, 1 }\n#end\nsphere { 0, bad }"), (Lines{2, 5}));
  EXPECT_EQ(lines_of_errors("#ifndef A sphere { 0, 1 }\n#end\nsphere { 0, bad }"), (Lines{2, 4}));
}

TEST(Recovery, NothingIsWrittenAfterAnError) {
  const ParseResult result =
      parse_text("sphere { 0, oops }\n#fopen F \"written.txt\" write\n#write (F, 1)", "scene.pov", {});
  EXPECT_EQ(result.errors.size(), 1u);
  EXPECT_FALSE(std::filesystem::exists("written.txt"));
}

TEST(Recovery, WhatWasBegunBeforeAnErrorGetsNoMore) {
  std::string printed;
  ParseOptions options;
  options.debug = [&](const std::string& text) { printed += text; };
  const ParseResult result = parse_text(
      "#fopen F \"begun.txt\" write\n#write (F, \"one\")\n#debug \"one\"\nsphere { 0, oops }\n#debug \"two\"\n"
      "#write (F, \"two\")\nbox { 0, bad }",
      "scene.pov", options);
  EXPECT_EQ(result.errors.size(), 1u);
  EXPECT_EQ(printed, "one");
  std::stringstream text;
  text << std::ifstream("begun.txt").rdbuf();
  EXPECT_EQ(text.str(), "one");
  std::filesystem::remove("begun.txt");
}

TEST(RecursiveFunctions, CallThemselves) {
  std::string printed;
  ParseOptions options;
  options.debug = [&](const std::string& text) { printed += text; };
  const ParseResult result = parse_text(
      "#version 3.7; global_settings { assumed_gamma 1 }\n#declare F = function(n) { select(n-1, 1, 1, n*F(n-1)) "
      "}\n#declare G = function(n) { F(n)+1 }\n#undef F\n"
      "#debug concat(str(G(7),0,0), \" \", str(G(0.5),0,0))\n#declare E = function(n) { E(n+1) }\n#debug str(E(1),0,0)",
      "scene.pov", options);
  EXPECT_TRUE(result.errors.empty());
  EXPECT_EQ(printed.substr(0, 6), "5041 2");
  EXPECT_NE(printed.find("nan"), std::string::npos);  // endless: POV-Ray crashes
}

TEST(Limits, EndlessSumsEnd) {
  const ParseResult result = parse_text(
      "#version 3.7; global_settings { assumed_gamma 1 }\n#declare F = function(n) { sum(i, 1, n, prod(j, 1, n, 1)) "
      "}\n#declare A = F(1000);\n#declare B = F(1e15);",
      "scene.pov", {});
  ASSERT_EQ(result.errors.size(), 1u);
  EXPECT_EQ(result.errors[0].line, 4);
  EXPECT_NE(result.errors[0].message.find("sum and prod"), std::string::npos);
}

TEST(Limits, ErrorsNameTheOption) {
  const auto error_with = [](const std::string& text, auto&& limit) {
    ParseOptions options;
    limit(options.limits);
    const ParseResult result = parse_text("#version 3.7;\n" + text, "scene.pov", options);
    return result.errors.empty() ? std::string("none")
                                 : result.errors.back().message + " " + result.errors.back().advice;
  };
  const auto names = [](const std::string& error, const std::string& option) {
    return error.find(option) != std::string::npos;
  };
  EXPECT_TRUE(names(error_with("#while (1) #end", [](Limits& l) { l.max_steps = 100000; }), "--max-steps"));
  EXPECT_TRUE(names(error_with("#macro M() M() #end M()", [](Limits&) {}), "--max-depth"));
  EXPECT_TRUE(names(error_with("#declare A = " + std::string(2000, '(') + "1", [](Limits&) {}), "--max-depth"));
  EXPECT_TRUE(names(error_with("sphere { 0, 1 }", [](Limits& l) { l.max_tokens = 5; }), "--max-tokens"));
  EXPECT_TRUE(names(error_with("sphere { 0, 1 }", [](Limits& l) { l.max_file_bytes = 5; }), "--max-file-bytes"));
  EXPECT_TRUE(names(error_with("#declare S = \"a\" #while (1) #declare S = concat(S, S) #end", [](Limits&) {}),
                    "--max-memory"));
  EXPECT_TRUE(names(error_with("#declare A = array[1000][1000][1000][100];", [](Limits&) {}), "--max-memory"));
}

}  // namespace
}  // namespace verisim::parser
