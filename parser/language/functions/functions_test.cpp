// User functions as the parser builds them: probes P24 to P26 of spec 01 section 30.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "parser/language/test_support.h"

namespace verisim::parser {
namespace {

using testing::accepts;
using testing::components;
using testing::number;

std::string value(const std::string& function, const std::string& call, const std::string& before = {}) {
  return number("F" + call, before + "#declare F = function" + function + " ");
}

TEST(UserFunctions, Values) {
  EXPECT_EQ(value("(u,v){x+y*v}", "(2,3)"), "11");
  EXPECT_EQ(value("(a){-a*-2}", "(3)"), "6");
  EXPECT_EQ(value("(a,b){a=b}", "(1,1+1e-11)"), "0");
  EXPECT_EQ(value("(n){sum(i,1,n,prod(j,1,i,j))}", "(4)"), "33");
  EXPECT_EQ(value("(a){a/3}", "(10)"), "3.333333333333333");
  EXPECT_EQ(value("(a){a/(3)}", "(10)"), "3.3333333333333335");
  EXPECT_EQ(value("(a){pow(a,7)}", "(1.1)"), "1.948717100000001");
  EXPECT_EQ(value("(a,b){pow(a,b)}", "(0,0)"), "1");
  EXPECT_EQ(value("{select(x,1,2,3)}", "(0,0,0)"), "2");
  EXPECT_EQ(value("(a){1<2&0|a}", "(1)"), "1");
}

TEST(UserFunctions, FoldingOfConstants) {
  const auto at_zero = [](const std::string& body) { return value("(a){" + body + "}", "(0)"); };
  EXPECT_EQ(at_zero("a-2*3+4"), "-10");
  EXPECT_EQ(at_zero("a-2*3-4"), "-2");
  EXPECT_EQ(at_zero("a-6/2+4"), "-7");
  EXPECT_EQ(at_zero("2*a-2*3+4"), "-10");
  EXPECT_EQ(at_zero("a-(2*3)+4"), "-2");
  EXPECT_EQ(at_zero("1-2*3+a"), "-5");
  EXPECT_EQ(value("{x-A*B+C}", "(0,0,0)", "#declare A=2; #declare B=3; #declare C=4; "), "-10");
  EXPECT_EQ(value("{sin(1)/2*3+x}", "(0,0,0)"), "0.1402451641346494");
}

TEST(UserFunctions, SpecialBodies) {
  const std::string p = "#declare p = function { pigment { gradient x color_map { [0 rgb 0][1 rgb <1,.5,.25>] } } } ";
  EXPECT_EQ(components(5, 9, "p(.25,0,0)", p), "0.25 0.125 0.0625 0 0");
  EXPECT_EQ(value("(a){p(a,0,0).gray}", "(.25)", p).substr(0, 8), "0.155");
  EXPECT_EQ(components(3, 9, "T(1,0,0)", "#declare T = function { transform { rotate 90*z translate x } } "), "1 1 0");
  EXPECT_EQ(components(3, 9, "S(.5)", "#declare S = function { spline { 0,<0,0,0> 1,<2,4,6> } } "), "1 2 3");
  EXPECT_EQ(number("I(3,4,0)", "#declare I = function { internal(57) } "), "5");
}

TEST(UserFunctions, Rules) {
  EXPECT_TRUE(accepts("#declare f = function(a b){a} #declare A = f(1 2); #declare g = function{sum(x,1,3,x)}"));
  EXPECT_TRUE(accepts("#declare f = function(x){x} #declare g = f; #declare A = g(1);"));
  for (const char* bad :
       {"#declare f = function(x){x} #declare f = function(x){x}", "#declare a = 1; #declare f = function(a){a}",
        "#declare f = function(t){t}", "#declare f = function{--x}", "#declare f = function{!x}",
        "#declare f = function{x?1:2}", "#declare f = function(){1}",
        "#declare f = function(a){a} #declare A = f(1,2);", "#declare f = function(a,b){a} #declare A = f(1);",
        "#declare f = function{internal(79)}", "#declare f = function{sqr(x)}", "#declare f = function{x/0}",
        "#declare f = function(a) { pigment { rgb 1 } }", "#declare f = function{unknown}",
        "#declare f = function{max(x y)}", "#declare f = function{max(x,y,)}", "#declare f = function{sum(i 1 3 i)}",
        "#declare i = 5; #declare f = function{sum(i,1,3,i)}", "#declare f = function(a,b){a} #declare A = f(1,2,);"})
    EXPECT_FALSE(accepts(bad)) << bad;
}

TEST(UserFunctions, ValuesThatNobodyCanWaitForAreErrors) {
  const std::string doubled =
      "#declare F = function(x) { abs(x) } #for (I, 1, 30) #undef G #declare G = function(x) { F(2 * x) + F(3 * x + 1) "
      "} "
      "#undef F #declare F = function(x) { G(2 * x) + G(3 * x + 1) } #end ";
  for (const std::string& endless : {doubled, std::string("#declare F = function(x) { sum(i, 1, 1e15, i * x) } ")}) {
    EXPECT_THAT(number("F(1)", endless), ::testing::HasSubstr("for one value"));
    EXPECT_THAT(number("1 + 2 * F(1)", endless), ::testing::HasSubstr("for one value"));
  }
}

}  // namespace
}  // namespace verisim::parser
