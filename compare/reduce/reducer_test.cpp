// The reduction with a function in the place of both programs.
#include "compare/reduce/reducer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace verisim::compare {
namespace {

using testing::HasSubstr;
using testing::Not;

class Reducing : public testing::Test {
 protected:
  // `shows`: whether a text without line ends has the difference.
  std::string reduced(const std::string& text, std::function<bool(const std::string&)> shows) {
    options_.judge = [this, shows](const std::vector<std::string>& texts) {
      ++rounds_, tried_ += static_cast<int>(texts.size());
      EXPECT_LE(texts.size(), options_.batch);
      std::vector<bool> out;
      for (const std::string& t : texts) out.push_back(shows(plain(t)));
      return out;
    };
    const std::string out = Reducer(options_).reduced(text);
    EXPECT_TRUE(shows(plain(out))) << out;
    return plain(out);
  }
  static std::string plain(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    std::string out;
    for (const char c : text)
      if (c != ' ' || (!out.empty() && out.back() != ' ')) out += c;
    if (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
  }
  static std::function<bool(const std::string&)> holds(std::vector<std::string> words) {
    return [words](const std::string& text) {
      return std::ranges::all_of(words, [&](const auto& w) { return text.find(w) != std::string::npos; });
    };
  }

  Reducer::Options options_;
  int rounds_ = 0, tried_ = 0;
};

std::string spheres(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += "sphere { " + std::to_string(i) + ", 1 }\n";
  return out;
}

TEST_F(Reducing, TwoStatementsOfAThousandAreLeft) {
  const std::string text = spheres(500) + "torus { 1, 0 }" + spheres(300) + "cone { 0, 1, 1, 0 }" + spheres(200);
  EXPECT_EQ(reduced(text, holds({"torus", "cone"})), "torus { } cone { }");
  EXPECT_LT(rounds_, 40);
}

TEST_F(Reducing, BlocksGiveWayToWhatStandsInThem) {
  EXPECT_EQ(
      reduced("#if (A) union { object { sphere { 0, 1 } rotate y } box { 0, 1 } scale 2 } #else plane { y, 0 } #end",
              holds({"sphere { 0, 1 }"})),
      "sphere { 0, 1 }");
  EXPECT_EQ(reduced("#if (A) box { 0, 1 } #else plane { y, 0 } #end", holds({"box"})), "box { }");
}

TEST_F(Reducing, WhatDependsOnEachOtherStays) {
  const std::string text = "#declare B = 2; #declare A = 1; sphere { A, 1 } box { B, 1 } torus { B, A }";
  const auto declared = [](const std::string& t) {
    const auto is_used = [&](const char* name) { return t.find(std::string("{ ") + name) != std::string::npos; };
    return (!is_used("A") || t.find("declare A") != std::string::npos) &&
           (!is_used("B") || t.find("declare B") != std::string::npos) && t.find("box { B") != std::string::npos;
  };
  EXPECT_EQ(reduced(text, declared), "#declare B = 2; box { B, 1 }");
}

TEST_F(Reducing, NamesGiveWayToWhatTheyMean) {
  const auto shows = [](const std::string& t) {
    const bool used = t.find("object { S") != std::string::npos, declared = t.find("declare S") != std::string::npos;
    return t.find("torus { 5, 3 }") != std::string::npos && t.find("object {") != std::string::npos && used == declared;
  };
  EXPECT_EQ(reduced("#declare S = torus { 5, 3 } object { S }", shows), "object { torus { 5, 3 } }");
}

TEST_F(Reducing, NumbersBecomeRounder) {
  EXPECT_EQ(reduced("sphere { <0.333, 12.5, -7>, 0.127 }", holds({"sphere", "0.1"})), "sphere { <0, 0, -7>, 0.1 }");
}

TEST_F(Reducing, SaysWhenOnlyNumbersAreLeft) {
  std::vector<std::string> seen;
  options_.before_rounding = [&](const std::string& best) { seen.push_back(plain(best)); };
  reduced("box { 0, 1 } sphere { 0, 0.125 }", holds({"sphere", "0.1"}));
  EXPECT_EQ(seen, std::vector<std::string>{"sphere { 0, 0.125 }"});
}

TEST_F(Reducing, LoopsRunOnce) {
  EXPECT_THAT(reduced("#for (I, 1, 10, 2) torus { I, 1 } #end", holds({"#for", "torus"})), HasSubstr("#for (I, 1, 1)"));
  EXPECT_THAT(reduced("#while (A < 3) torus { A, 1 } #end",
                      [](const std::string& t) {
                        return t.find("torus") != std::string::npos && t.find("#end") != std::string::npos;
                      }),
              HasSubstr("#if"));
}

TEST_F(Reducing, IncludeFilesOfTheSceneAreRead) {
  options_.include = [](const std::string& name) {
    return name == "mine.inc" ? std::optional<std::string>(spheres(50) + "torus { 1, 0 }") : std::nullopt;
  };
  const auto shows = [](const std::string& t) {
    return t.find("torus") != std::string::npos || t.find("mine.inc") != std::string::npos;
  };
  // Left as it is, the file could not be looked into.
  const std::string out = reduced("#include \"mine.inc\"\n#include \"colors.inc\"\n" + spheres(5), shows);
  EXPECT_THAT(out, HasSubstr("torus"));
  EXPECT_THAT(out, Not(HasSubstr("sphere")));
}

TEST_F(Reducing, LinesWhereBracketsDoNotMatch) {
  EXPECT_EQ(reduced("sphere { 0, 1\nbox { 0, 1 }\n} }\ntorus { 1, 0 }\n", holds({"} }"})), "} }");
}

TEST_F(Reducing, TheVersionStays) {
  EXPECT_EQ(reduced("#version 3.7;\n" + spheres(9) + "torus { 1, 0 }", holds({"torus"})), "#version 3.7; torus { }");
}

TEST_F(Reducing, EndsWithTheBestSoFar) {
  options_.stop = [this] { return rounds_ > 1; };
  const std::string out = reduced(spheres(400) + "torus { 1, 0 }" + spheres(400), holds({"torus"}));
  EXPECT_LT(out.size(), spheres(400).size());
  EXPECT_GT(out.size(), 200u);
}

TEST_F(Reducing, NoTextIsTriedTwice) {
  std::vector<std::string> seen;
  options_.judge = [&](const std::vector<std::string>& texts) {
    std::vector<bool> out;
    for (const std::string& t : texts) {
      EXPECT_EQ(std::count(seen.begin(), seen.end(), t), 0) << t;
      seen.push_back(t);
      out.push_back(t.find("torus") != std::string::npos && t.find("rotate") != std::string::npos);
    }
    return out;
  };
  Reducer(options_).reduced(spheres(20) + "union { torus { 1, 0.25 rotate 30 } scale 2 }");
  EXPECT_GT(seen.size(), 10u);
}

}  // namespace
}  // namespace verisim::compare
