// Probes P12 to P20 and P29 of spec 01 section 30: strings, scope, macros, loops, switch, arrays, splines.
#include <gtest/gtest.h>

#include "parser/language/test_support.h"

namespace verisim::parser {
namespace {

using testing::accepts;
using testing::components;
using testing::number;
using testing::printed;

TEST(Strings, Functions) {
  const auto text = [](const std::string& e) { return printed("#debug " + e); };
  EXPECT_EQ(text("str(123.456,-9,3)"), "00123.456");
  EXPECT_EQ(text("str(2.5,0,0)"), "2");
  EXPECT_EQ(text("str(-0.0001,0,2)"), "-0.00");
  EXPECT_EQ(text("str(1e251,0,3)"), "1e+251");
  EXPECT_EQ(text("str(5,300,2)"), "<invalid>");
  EXPECT_EQ(text("str(1e22,0,0)"), "10000000000000000000000");
  EXPECT_EQ(text("vstr(1,1,\", \",0,1)"), "1.0, 0.0");
  EXPECT_EQ(text("vstr(3,<1,2,3,4>,\",\",0,1)"), "1.0,2.0,3.0");
  EXPECT_EQ(text("concat(\"a\" \"b\", substr(\"xyz\",2,2))"), "abyz");
  EXPECT_EQ(text("substr(\"abc\",0,1)"), "");
  EXPECT_EQ(text("substr(\"abc\",0,4)"), "");
  EXPECT_EQ(text("strupr(\"aBc\")"), "ABC");
  EXPECT_EQ(text("datetime(1.5,\"%Y/%m/%d %H:%M:%S\")"), "2000/01/02 12:00:00");
  EXPECT_EQ(text("\"a\\tb\\\"c\\\\ \\u00e4\""), "a\tb\"c\\ \u00e4");
  EXPECT_EQ(number("strcmp(\"abc\",\"ab\")"), "99");
  EXPECT_EQ(number("strcmp(\"a\",\"B\")"), "31");
  EXPECT_EQ(number("val(\"0x1F\")"), "31");
  EXPECT_EQ(number("val(\"1.5e3x\")"), "1500");
  EXPECT_EQ(number("strlen(\"\\u0041b\")"), "2");
  EXPECT_EQ(number("(\"a\"=\"a\" & 1<2)"), "1");
  for (const char* bad : {"concat(\"a\",)", "\"\\0\"", "\"\\q\"", "chr(65536)", "substr(\"abc\",2,3)", "(\"a\")"})
    EXPECT_FALSE(accepts(std::string("#debug ") + bad)) << bad;
}

TEST(Strings, Charsets) {
  EXPECT_EQ(printed("#debug str(strlen(\"\xc3\xa4\"),0,0)"), "2");  // ascii: two blanks
  EXPECT_EQ(testing::run("\xef\xbb\xbf#version 3.7; #debug str(strlen(\"\xc3\xa4\"),0,0)").text, "1");
  EXPECT_EQ(testing::run("#version 3.7; \xef\xbb\xbf").error, "Illegal character in input file: value 0xef.");
}

TEST(Scope, DeclareAndLocal) {
  EXPECT_EQ(printed("#declare A=1; #macro T() #declare A=A+1; #local A=50; #declare A=A+1; #debug str(A,0,0) #end T() "
                    "#debug concat(\" \",str(A,0,0))"),
            "51 2");
  EXPECT_FALSE(accepts("#declare A=1; #macro T() #local A=A+1; #end T()"));
  EXPECT_TRUE(accepts("#declare A=1; #declare A=A+1;"));
  EXPECT_EQ(printed("#macro N() #declare a=a+1; #end #macro M() #local a=1; N() #debug str(a,0,0) #end M() #ifdef(a) "
                    "#debug \"!\" #end"),
            "2");
  EXPECT_EQ(printed("#declare A=1; #macro T() #local A=2; #undef A #debug str(A,0,0) #end T()"), "1");
}

TEST(Scope, ArraysAndLocal) {
  const std::string array = "#declare A=array[3]{1,2,3}; ", show = " #debug str(A[0],0,0)";
  EXPECT_EQ(printed(array + "#macro T() #local A[0]=50;" + show + " #end T()" + show), "11");
  EXPECT_EQ(printed(array + "#macro T() #declare A[0]=50; #end T()" + show), "50");
  EXPECT_EQ(printed(array + "#macro M(P) #local P[0]=50; #end M(A)" + show), "50");
  EXPECT_EQ(printed("#declare A=array[3]; #macro T() #local A[0]=50; #local A[1]=60; #end T()" + show +
                    " #ifdef(A[1]) #debug \"!\" #end"),
            "50");
}

TEST(Scope, LocalsDieButValuesLive) {
  EXPECT_EQ(printed("#macro M() #local b=7; b #end #declare Q = (M()); #debug str(Q,0,0) #ifdef(b) #debug \"!\" #end"),
            "7");
  EXPECT_EQ(
      printed(
          "#macro M() #local A=array[2]{5,6}; A #end #declare Q=M() #debug str(Q[1],0,0) #ifdef(A) #debug \"!\" #end"),
      "6");
  EXPECT_EQ(printed("#macro M() #local S=\"text\"; S #end #declare Q=M() #debug Q #debug M()"), "texttext");
  EXPECT_TRUE(accepts("#macro M() #local b=sphere{0,1} b #end object{M()} #declare Q=M() object{Q}"));
}

TEST(Macros, ByReference) {
  const std::string sw = "#macro SW(A,B) #local T=A; #declare A=B; #declare B=T; #end #declare X=1; #declare Y=2; ";
  EXPECT_EQ(printed(sw + "SW(X,Y) #debug vstr(2,<X,Y>,\",\",0,0)"), "2,1");
  const std::string inc = "#macro I(P) #local P=P+1; #end #declare X=3; #declare Q=array[2]{5,6} ";
  EXPECT_EQ(printed(inc + "I(X) #debug str(X,0,0)"), "4");
  EXPECT_EQ(printed(inc + "I((X)) I(+X) #debug str(X,0,0)"), "3");
  EXPECT_EQ(printed(inc + "I(Q[1]) #debug str(Q[1],0,0)"), "7");
  EXPECT_FALSE(accepts(inc + "I(Unknown)"));
}

// Where the comma is missing, POV-Ray takes the reference from the token behind a lone number (spec 08 H).
TEST(Macros, WithoutACommaTheNextIdentifierIsMeant) {
  const std::string head =
      "#macro F(A,B) concat(str(A,0,0),\" \",str(B,0,0)) #end #macro G(A,B,C,D) concat(F(A,B),\" \",F(C,D)) #end "
      "#declare p=1; #declare q=2; #declare r=3; #declare A=array[2]{5,6} #declare c=rgb 7; ";
  const auto call = [&](const std::string& arguments) { return printed(head + "#debug " + arguments); };
  EXPECT_EQ(call("F(p q)"), "2 2");
  EXPECT_EQ(call("F(A[0] q)"), "2 2");
  EXPECT_EQ(call("G(p q p q)"), "2 1 2 2");
  EXPECT_EQ(call("F(p q+r)"), "2 5");
  EXPECT_EQ(call("F(p A[1])"), "1 6");
  EXPECT_EQ(call("F(p 4)"), "1 4");
  EXPECT_EQ(call("F(p (q))"), "1 2");
  EXPECT_EQ(call("F((p) q)"), "1 2");
  EXPECT_EQ(call("F(-p q)"), "-1 2");
  EXPECT_EQ(call("F(p, q)"), "1 2");
  // It is a reference: what the macro does to its first parameter happens to q.
  EXPECT_EQ(printed("#macro S(A,B) #declare A=9; #end #declare p=1; #declare q=2; S(p q) "
                    "#debug concat(str(p,0,0),str(q,0,0))"),
            "19");
}

TEST(Macros, AreText) {
  const std::string m = "#macro M(a) a+1 #end ";
  EXPECT_EQ(number("1+M(2)*3", m), "6");
  EXPECT_EQ(number("M(2)*3", m), "5");
  const std::string my = "#macro MY(a,b) #if(a>b) a #else b #end #end ";
  EXPECT_EQ(number("(MY(1,3)*2)", my), "6");
  EXPECT_EQ(components(3, 6, "<MY(5,3),MY(1,3),0>", my), "5 3 0");
  EXPECT_FALSE(accepts(my + "#declare B=MY(1,3)*2;"));
  EXPECT_EQ(number("SUM(10)*2", "#macro SUM(n) #local s=0; #for(i,1,n) #local s=s+i; #end s #end "), "110");
  EXPECT_EQ(number("F1(5)", "#macro F1(n) #if(n<2) 1 #else (n*F1(n-1)) #end #end "), "120");
  EXPECT_TRUE(accepts("#macro O() sphere { 0, 1 #end #macro C() } #end O() C()"));
}

TEST(Loops, For) {
  const auto visits = [](const std::string& head, const std::string& body = {}) {
    return printed("#for(i," + head + ") #debug concat(str(i,0,1),\" \") " + body +
                   " #end #debug concat(\"| \",str(i,0,16))");
  };
  EXPECT_EQ(printed("#for(i,0,1,0.1) #end #debug str(i,0,16)"), "1.0999999999999999");
  EXPECT_EQ(visits("3,0,-1"), "3.0 2.0 1.0 0.0 | -1.0000000000000000");
  EXPECT_EQ(visits("1,0"), "| 1.0000000000000000");
  EXPECT_EQ(printed("#declare n=0; #for(i,0,0.3,0.1) #declare n=n+1; #end #debug str(n,0,0)"), "4");
  EXPECT_EQ(visits("0,5", "#declare i=i+1;"), "0.0 2.0 4.0 | 6.0000000000000000");
  EXPECT_FALSE(accepts("#for(i,0,5,0) #end"));
  // A parameter can be the variable only when it was passed by value (measured).
  EXPECT_TRUE(accepts("#macro M(i) #for(i,1,3) #end #end M(1)"));
  EXPECT_FALSE(accepts("#macro M(i) #for(i,1,3) #end #end #declare B=7; M(B)"));
}

TEST(Loops, WhileAndBreak) {
  EXPECT_EQ(printed("#declare i=0; #while(1) #declare i=i+1; #if(i>5) #break #end #end #debug str(i,0,0)"), "6");
  EXPECT_EQ(printed("#macro M() #debug \"a\" #break #debug \"b\" #end M() #debug \"c\""), "ac");
  EXPECT_FALSE(accepts("#break"));
  EXPECT_FALSE(accepts("#while(1)"));
}

TEST(Switch, FallsThrough) {
  const std::string body = "#case(2) #debug \"a\" #case(3) #debug \"b\" #case(4) #debug \"c\" #else #debug \"d\" #end";
  EXPECT_EQ(printed("#switch(2) " + body), "abcd");
  EXPECT_EQ(printed("#switch(4) " + body), "cd");
  EXPECT_EQ(printed("#switch(9) " + body), "d");
  EXPECT_EQ(printed("#switch(3) #range(1,2) #debug \"a\" #break #range(3,4) #debug \"b\" #break #else #debug \"c\" "
                    "#end #debug \"e\""),
            "be");
  EXPECT_EQ(printed("#switch(1) #case(1+1e-11) #debug \"y\" #end"), "y");
  EXPECT_EQ(printed("#switch(1) #range(1+1e-11,2) #debug \"y\" #end"), "");
  EXPECT_FALSE(accepts("#switch(1) #else #end"));
  EXPECT_EQ(printed("#switch(1) #case(1) #else #debug \"a\" #case(2) #debug \"b\" #end"), "ab");
  EXPECT_EQ(printed("#switch(1) #case(2) #else #debug \"a\" #else #debug \"b\" #end"), "ab");  // measured
}

TEST(Arrays, Subscripts) {
  const std::string a =
      "#declare A=array[3]{1,2,3}; #declare B=array[2][3]{{1,2,3},{4,5,6}}; #declare "
      "C=array[2]{array[1]{7},array[2]{8,9}};";
  EXPECT_EQ(number("A[0.9999999]", a), "1");
  EXPECT_EQ(number("A[0.99999999999]", a), "2");
  EXPECT_EQ(number("A[-1e-11]", a), "1");
  EXPECT_EQ(number("B[1][2]", a), "6");
  EXPECT_EQ(number("C[1][1]", a), "9");
  EXPECT_EQ(number("A [1]", a), "2");
  EXPECT_EQ(number("dimension_size(B,2)", a), "3");
  EXPECT_EQ(number("dimension_size(B,3)", a), "0");
  EXPECT_EQ(number("dimensions(B)", a), "2");
  EXPECT_EQ(number("dimension_size(D,1)", "#declare D=array[2.9];"), "2");
  // Elements get memory in blocks, each when it is written first.
  const std::string large =
      "#declare L=array[200000]; #declare L[63]=1; #declare L[64]=2; #declare L[199999]=3; #declare M=L; "
      "#declare M[64]=20; #declare M[5]=5; #undef L[63] ";
  EXPECT_EQ(number("M[5]+M[63]+M[64]+M[199999]", large), "29");
  EXPECT_EQ(number("L[64]+L[199999]+dimension_size(L,1)", large), "200005");
  EXPECT_EQ(number("defined(M[63])+10*defined(L[63])+100*defined(L[5])+1000*defined(L[64])", large), "1001");
  EXPECT_FALSE(accepts(large + "sphere { 0, L[100000] }"));
  EXPECT_FALSE(accepts(large + "sphere { 0, L[63] }"));
  EXPECT_EQ(number("A[1]", a + "#declare E=A; #declare E[1]=70;"), "2");
  for (const char* bad : {"A[3]", "A[-1]", "B[1]", "A/*c*/[0]", "A[1e300]", "A[-1e300]", "0+A[1e300]", "B[0][3e9]"})
    EXPECT_FALSE(accepts(a + "#declare X=" + bad + ";")) << bad;
  EXPECT_FALSE(accepts(a + "#declare A[1e300]=1;"));
  EXPECT_FALSE(accepts("#declare A=array[2]{1,x};"));
  EXPECT_FALSE(accepts("#declare A=array[2]{1};"));
  EXPECT_FALSE(accepts("#declare A=array[2]{1,2,3};"));
  EXPECT_FALSE(accepts("#macro M(a) a #end #declare A=array[2]{M(1),M(2)};"));
  EXPECT_TRUE(accepts("#macro M(a) a #end #declare A=array[2]{0+M(1),(M(2))};"));
}

TEST(Splines, Values) {
  const auto at = [](const std::string& kind, const std::string& t) {
    return components(3, 9, "S(" + t + ")",
                      "#declare S = spline { " + kind + " 0,<0,0,1> 1,<1,2,3> 2,<3,1,0> 4,<0,5,2> }");
  };
  EXPECT_EQ(at("linear_spline", ".5"), "0.5 1 2");
  EXPECT_EQ(at("quadratic_spline", "1.7"), "2.295 1.615 1.425");
  EXPECT_EQ(at("cubic_spline", "1.7"), "2.62575 1.174 0.7635");
  EXPECT_EQ(at("natural_spline", ".5"), "0.345108696 1.342391304 2.554347826");
  EXPECT_EQ(components(2, 6, "S(.5)", "#declare S = spline { 0, 1 1, 3 }"), "2 2");
  EXPECT_EQ(components(5, 6, "S(.5)", "#declare S = spline { 0,<1,2,3,4,5> 1,<1,2> }"), "1 2 3 4 5");
  EXPECT_EQ(components(3, 6, "T(2)", "#declare S = spline { 0,<0,0,0> 1,<1,1,1> } #declare T = spline { S 2,<5,5,5> }"),
            "5 5 5");
  EXPECT_EQ(components(3, 6, "S(.5,natural_spline)", "#declare S = spline { 0,<0,0,0> 1,<1,1,1> }"), "0.5 0.5 0.5");
}

TEST(Conditionals, Branches) {
  EXPECT_EQ(printed("#if(0) #debug \"a\" #elseif(1) #debug \"b\" #elseif(1) #debug \"c\" #else #debug \"d\" #end"),
            "b");
  EXPECT_EQ(printed("#if(0) #if(1) #debug \"a\" #else #debug \"b\" #end #else #debug \"c\" #end"), "c");
  EXPECT_EQ(printed("#if(1e-11) #debug \"a\" #else #debug \"b\" #end"), "b");
  EXPECT_EQ(printed("#declare A=<#if(1) 5, #else 6, #end 2,3>; #debug vstr(3,A,\",\",0,0)"), "5,2,3");
  EXPECT_EQ(printed("#declare V=<1,#declare A=3; A,4>; #debug vstr(3,V,\",\",0,0)"), "1,3,4");
  EXPECT_EQ(printed("#declare A = #if(1) 5; #else 6; #end #debug str(A,0,0)"), "5");
  EXPECT_EQ(printed("#ifdef(sphere) #debug \"a\" #end #ifndef(Foo) #debug \"b\" #end #declare Foo=1; #if(defined(Foo)) "
                    "#debug \"c\" #end"),
            "bc");
  EXPECT_FALSE(accepts("#if(1)"));
  EXPECT_FALSE(accepts("#end"));
  EXPECT_FALSE(accepts("#if(\"a\") #end"));
}

TEST(Conditionals, BranchesOfOtherConstructs) {
  // Measured, construct by construct.
  for (const char* wrong :
       {"#if(0) #case(1) #end", "#if(0) #range(1,2) #end", "#if(0) #elseif(0) #case(1) #end", "#ifdef(X) #case(1) #end",
        "#switch(1) #case(2) #elseif(1) #else #end", "#macro A() #else #end", "#macro A() #elseif(1) #end",
        "#macro A() #range(1,2) #end", "#macro A() #break #else #end", "#if(0) #macro A() #else #end #end",
        "#while(0) #if(0) #macro A() #else #end #end #end", "#macro B() #macro A() #case(1) #end #end"})
    EXPECT_FALSE(accepts(wrong)) << wrong;
  for (const char* right :
       {"#if(1) #else #else #elseif(1) #case(1) #end", "#if(0) #if(0) #case(1) #else #else #end #end",
        "#switch(1) #case(1) #break #elseif(1) #end", "#while(0) #else #case(1) #elseif(2) #end",
        "#for(I,1,2) #break #else #end", "#macro A() #if(1) #else #else #end #while(1) #else #end #end",
        "#if(0) #while(1) #else #end #end"})
    EXPECT_TRUE(accepts(right)) << right;
}

// Noise is that of the scene's generator when a function is asked, not when it is made (spec 05 5.4).
TEST(Versions, FunctionsFollowTheNoiseGenerator) {
  const std::string ask = " #debug str(F(0.3,0.7,0.2),0,6)";
  const auto asked = [&](const std::string& function) {
    return testing::run("#version 3.5; #declare F = function { " + function + " }" + ask + " #version 3.1;" + ask +
                        " global_settings { noise_generator 3 } #version 3.7;" + ask)
        .text;
  };
  EXPECT_EQ(asked("internal(76)"), "0.4196920.3043460.531731");
  EXPECT_EQ(asked("pattern { bozo }"), "0.4196920.3043460.531731");
  const std::string pigment =
      testing::run(
          "#version 3.5; #declare F = function { pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } } }"
          " #debug str(F(0.3,0.7,0.2).red,0,6) #version 3.1; #debug str(F(0.3,0.7,0.2).red,0,6)")
          .text;
  EXPECT_EQ(pigment, "0.4196920.304346");
}

TEST(Versions, Rules) {
  EXPECT_EQ(testing::run("#declare A = 1 #declare B = A").error.find("semicolon") != std::string::npos, true);
  EXPECT_EQ(testing::run("#version 3.0; #declare A = 1 #declare B = A+1 #debug str(B,0,0)").text, "2");
  EXPECT_EQ(testing::run("#version 3.1; #declare A = 1 #declare B = A+1 #debug str(B,0,0)").text, "2");
  EXPECT_NE(testing::run("#version 3.8;").error, "");
  // Macros are unknown before 3.1: where they are defined, called and ended.
  const std::string macro = "#version 3.1; #macro M(A) A #end #macro V() #version 3.0; #end ";
  for (const char* wrong : {"#version 3.0; #macro N() #end", "#version 3.0; #declare B = M(1);",
                            "#version 3.0; #declare B = 2*M(1)+1;", "V()"})
    EXPECT_NE(testing::run(macro + wrong).error.find("Macros need #version 3.1"), std::string::npos) << wrong;
  EXPECT_EQ(testing::run(macro + "#version 3.0; #ifdef (M) #if (0) M(1) #end #undef M #end").error, "");
  EXPECT_EQ(testing::run(macro + "#declare B = M(1); #version 3.0;").error, "");
  EXPECT_EQ(testing::run("#debug str(version,0,2)").text, "3.70");
  EXPECT_EQ(testing::run("sphere { 0, 1 }").result.scene->version, 362);
  EXPECT_EQ(testing::run("#version 3.1; sphere { 0, 1 }").result.scene->version, 350);
  EXPECT_EQ(testing::run("#version 3.7; #declare A = 1; version 3.5; sphere").error,
            "");  // `version` without '#' ends parsing
}

TEST(Predeclared, Values) {
  ParseOptions options;
  options.clock = 0.1;
  options.clock_delta = 1.0 / 7;
  options.declarations = {{"Foo", "0.123456789012"}, {"Bar", "\"text\""}, {"Nil", "abc"}};
  EXPECT_EQ(testing::run("#debug concat(str(clock,0,16),\" \",str(clock_delta,0,9),\" "
                         "\",str(Foo,0,9),Bar,str(Nil,0,0),\" \",str(image_width,0,0))",
                         options)
                .text,
            "0.1000000014901161 0.142857000 0.123457000text0 160");
}

}  // namespace
}  // namespace verisim::parser
