// Probes P20, P21, P30 and P31 of spec 01 section 30, and hostile input: every file must end in a scene or in a clear
// error.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "parser/language/test_support.h"

namespace verisim::parser {
namespace {

namespace fs = std::filesystem;
using testing::accepts;
using testing::printed;
using testing::run;

// A folder of its own, which is also the current one while the test runs.
class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("verisim_parser_" + std::to_string(::getpid()) + "_" +
                                           ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_ / "lib");
    before_ = fs::current_path();
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }
  static void put(const std::string& name, const std::string& text) { std::ofstream(name, std::ios::binary) << text; }
  static std::string get(const std::string& name) {
    std::ifstream in(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  ParseOptions with_library() const {
    ParseOptions options;
    options.library_paths = {folder_ / "lib"};
    return options;
  }
  fs::path folder_, before_;
};

TEST(Syntax, Accepted) {
  for (const char* good :
       {"sphere{0 1}", "#declare A=<1,2,3,>;", "/* a /* b */ c */", "/*/ */", "# sphere{0,1}", "#\n declare A=1;",
        "#declare A=1;;", "#declare O=sphere{0,1};", "#declare O=sphere{0,1} union{sphere{0,1} O}",
        "#declare O=sphere{0,1} sphere{O translate x}", "#declare A=array[1]{1} #declare B=A\n[0];",
        "#declare A = 1 /* c */ ; // d", "#local A = 2;"})
    EXPECT_EQ(run(std::string("#version 3.7; ") + good).error, "") << good;
}

TEST(Syntax, Rejected) {
  for (const char* bad : {"sphere{0,1};",
                          "#declare O=sphere{0,1};;",
                          "sphere{0,,1}",
                          "#declare A=<1,,2,3>;",
                          "#declare A=(1==1);",
                          "#declare A=(<1,2,3>=<1,2,3>",
                          "#declare A=t;",
                          "#declare A=max(1<2,3);",
                          "#declare O=sphere{0,1} union{O sphere{0,1}}",
                          "#declare C=rgb 1; #declare D=color C+red .5;",
                          "#declare X=1<2;",
                          "#if(\"a\")#end",
                          "#debug concat(\"a\",)",
                          "#declare sphere=1;",
                          "#macro M(x) #end",
                          "#debug \"x\";",
                          "#declare A=1; #macro A() #end",
                          "#macro A() #end #declare A=1;",
                          "#declare A=<1>;",
                          "#declare A=<1,2,3,4,5,6>;",
                          "#declare A=V;",
                          "(>=1)",
                          "#local"})
    EXPECT_FALSE(accepts(bad)) << bad;
}

TEST(Diagnostics, SayWhereAndWhy) {
  const auto outcome = run("#version 3.7;\n#declare Radius = 2;\nsphere { 0, Raduis }\n");
  ASSERT_FALSE(outcome.error.empty());
  const Diagnostic& d = outcome.result.errors.front();
  EXPECT_EQ(d.file, "test.pov");
  EXPECT_EQ(d.line, 3);
  EXPECT_EQ(d.column, 13);
  EXPECT_EQ(d.source_line, "sphere { 0, Raduis }");
  EXPECT_NE(d.advice.find("Radius"), std::string::npos) << d.advice;
  EXPECT_EQ(format(d).substr(0, 21), "test.pov:3:13: error:");
  const auto macro = run("#version 3.7;\n#macro M()\n #declare A = 1 +* 2;\n#end\nM()\n");
  EXPECT_EQ(macro.line, 3);
  ASSERT_EQ(macro.result.errors.front().trail.size(), 1u);
  EXPECT_EQ(macro.result.errors.front().trail[0], "in macro 'M' called at test.pov:5");
}

TEST(Hostile, EndsInAnError) {
  const std::string deep(10000, '(');
  EXPECT_NE(run("#declare A = " + deep + "1;").error.find("ested"), std::string::npos);
  EXPECT_NE(run("#declare F = function { " + deep + "x }").error.find("ested"), std::string::npos);
  EXPECT_NE(run("#declare A = " + std::string(10000, '-') + "1;").error.find("ested"), std::string::npos);
  EXPECT_NE(run("#macro M() M() #end M()").error, "");
  EXPECT_NE(run("#macro M(a) a #end #declare A = (" +
                [] {
                  std::string text;
                  for (int i = 0; i < 10000; ++i) text += "M(";
                  return text;
                }() +
                "1")
                .error,
            "");
  std::string unions;
  for (int i = 0; i < 10000; ++i) unions += "union {";
  EXPECT_NE(run(unions).error, "");
  std::string ifs;
  for (int i = 0; i < 10000; ++i) ifs += "#if(1) ";
  EXPECT_NE(run(ifs).error, "");
  EXPECT_NE(run("#declare A = array[1]{1} #while(1) #declare B = array[1]{A} #declare A = B #end").error, "");
  EXPECT_NE(run("\"abc").error, "");
  EXPECT_NE(run("/* abc /* */").error, "");
  EXPECT_NE(run("sphere { 0, 1").error, "");
  EXPECT_NE(run("#macro M()").error, "");
  EXPECT_NE(run("#declare A = array[2000000000][2000000000];").error, "");
  EXPECT_NE(run("#declare S = \"abcd\" #while(1) #declare S = concat(S,S) #end").error, "");
  EXPECT_NE(run("#debug str(1,2147483647,2147483647) #error \"x\"").error, "");
  EXPECT_NE(run(std::string("sphere { 0, 1 }\0\x1a sphere", 24)).error, "");
}

TEST(Hostile, EndlessLoopsAreStopped) {
  ParseOptions options;
  options.limits.max_steps = 1000000;
  EXPECT_NE(run("#while(1) #end", options).error.find("--max-steps"), std::string::npos);
  EXPECT_NE(run("#declare i=0; #for(i,0,1) #declare i=0; #end", options).error.find("--max-steps"), std::string::npos);
  ParseOptions cancelled;
  int polls = 0;
  cancelled.cancelled = [&polls] { return ++polls > 3; };
  EXPECT_NE(run("#while(1) #end", cancelled).error.find("Interrupted"), std::string::npos);
}

// Few statements, and twice as many copies with each.
TEST(Hostile, CopiesOfCopiesAreStopped) {
  ParseOptions options;
  options.limits.max_steps = 1000000;
  EXPECT_NE(
      run("#declare A = array[2]{1,2} #for(i,1,60) #declare A = array[2]{A,A} #end", options).error.find("--max-steps"),
      std::string::npos);
  ParseOptions cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_NE(run("#declare U = sphere{0,1} #for(i,1,60) #declare U = difference{object{U} object{U}} #end", cancelled)
                .error.find("Interrupted"),
            std::string::npos);
}

// Constructs that are ended where they cannot be.
TEST(Hostile, ConstructsAreNotEndedTwice) {
  EXPECT_NE(run("#switch (1) #case (1) #break #else").error.find("#switch"), std::string::npos);
  EXPECT_NE(run("#while (1) #if (1) #break").error, "");
  for (const char* ended :
       {"#while (#break 1) #end 1)", "#while (#end 1)", "#if (#end 0)", "#if (#else 0) #end 0)",
        "#if (0) #elseif (#end 0)", "#switch (#break 1) #case (1) #end 1)", "#switch (#end 1) #case (2) #end",
        "#switch (1) #case (#end 2) #else #end", "#switch (1) #range (0, #end 0) #else #end",
        "#for (I, 0, #break 1) #end 1)", "#for (I, #end 0, 1)", "#declare A = array[1] #ifdef (A[#end 0])",
        "#declare I = 0; #while (I < 1 #if (I) #break #end) #declare I = 1; #end"})
    EXPECT_NE(run(ended).error, "") << ended;
}

// Each step takes long, though none of them too long: limits are noticed all the same, as nobody ends a language server
// or a Python by force.
TEST(Hostile, LongStepsAreStoppedInTime) {
  const std::string functions =
      "#declare F = function(n) { sum(i, 1, n, i) } #declare P = function { pattern { pigment_pattern {"
      "  function { F(2e7 + 0*x) } color_map { [0 rgb 0] [1 rgb 1] } } } }";
  const std::string strings =
      "#declare S = \"abcd\" #for(i,1,20) #declare S = concat(S,S) #end #declare T = concat(S, \"\")";
  for (const std::string& scene :
       {functions + "#for(i,1,1e6) #declare A = F(2e7); #end", functions + "#for(i,1,1e6) #declare A = P(i,0,0); #end",
        functions + "#declare I = isosurface { function { F(1e5 + 0*x) } } #for(i,1,1e6) #declare A = "
                    "inside(I,<i/1e6,0,0>); #end",
        strings + "#for(i,1,1e6) #declare A = strcmp(S,T); #end", strings + "#for(i,1,1e6) #declare T = S; #end"}) {
    using Clock = std::chrono::steady_clock;
    ParseOptions options;
    Clock::time_point asked;
    options.cancelled = [end = Clock::now() + std::chrono::milliseconds(300), &asked] {
      if (asked == Clock::time_point() && Clock::now() > end) asked = Clock::now();
      return asked != Clock::time_point();
    };
    const Clock::time_point start = Clock::now();
    EXPECT_NE(run(scene, options).error.find("Interrupted"), std::string::npos) << scene;
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(10)) << scene;
  }
}

// What one query asks counts together.
TEST(Hostile, QueriesHaveTheBudgetOfOneValue) {
  const std::string surface =
      "#declare F = function(n) { sum(i, 1, n, i) } #declare I = isosurface { function { x*x - 1 - 1e-30*F(6e7 + 0*x) }"
      " max_gradient 1e6 accuracy 1e-9 contained_by { box { -2, 2 } } }";
  EXPECT_NE(run(surface + "#declare A = trace(I, -5*x, x);").error.find("trace() needs more than"), std::string::npos);
}

TEST(Hostile, LongLines) {
  std::string scene = "#version 3.7; #declare A = 0";
  for (int i = 0; i < 200000; ++i) scene += "+1";
  const auto outcome = run(scene + "; #debug str(A,0,0) #declare B = nothing;");
  EXPECT_EQ(outcome.text, "200000");
  ASSERT_FALSE(outcome.error.empty());
  EXPECT_LT(outcome.result.errors.front().source_line.size(), 400u);
  EXPECT_NE(run("#declare " + std::string(1 << 20, 'a') + " = 1; #debug str(b,0,0)").error, "");
}

TEST_F(Files, Include) {
  put("one.inc", "1");
  put("end.inc", "#end");
  put("lib/w.dat.inc", "#debug \"lib\"");
  put("w.dat", "#debug \"here\"");
  put("scope.inc", "#local L = 1; #declare G = 2;");
  EXPECT_EQ(run("#declare A=#include \"one.inc\"; #debug str(A,0,0)").text, "1");
  EXPECT_EQ(run("#if(0) #debug \"a\" #include \"end.inc\" #end #debug \"b\"").text, "b");
  EXPECT_EQ(run("#if(1) #debug \"a\" #include \"end\" #debug \"b\"").text, "ab");
  EXPECT_EQ(run("#include \"w.dat\"", with_library()).text, "lib");
  EXPECT_EQ(run("#include \"scope\" #ifdef(L) #debug \"L\" #end #ifdef(G) #debug \"G\" #end").text, "G");
  const auto missing = run("#include \"no.inc\"");
  EXPECT_NE(missing.error.find("no.inc"), std::string::npos);
  ParseOptions none;
  none.standard_includes = false;
  const auto standard = run("#include \"colors.inc\"", none);
  EXPECT_NE(standard.advice.find("povray-includes"), std::string::npos);
  put("self.inc", "#include \"self.inc\"");
  EXPECT_NE(run("#include \"self.inc\"").error, "");
  put("bad.inc", "\n\n#declare = 1;");
  const auto bad = run("#include \"bad.inc\"");
  EXPECT_EQ(bad.line, 3);
  EXPECT_EQ(bad.result.errors.front().trail[0], "included from test.pov:1");
}

TEST_F(Files, IncludeSeesARewrittenFile) {
  EXPECT_EQ(printed("#macro P(S) #fopen F \"t.tmp\" write #write(F,S) #fclose F #include \"t.tmp\" #end P(\"#declare "
                    "A=1;\") #debug str(A,0,0) "
                    "P(\"#declare A=2;\") #debug str(A,0,0)"),
            "12");
}

TEST_F(Files, Read) {
  const std::string loop =
      "#fopen F \"d.txt\" read #declare n=0; #while(defined(F)) #read(F,a,b,c) #declare n=n+1; #debug "
      "concat(str(c,0,0),\" \") #end";
  put("d.txt", "1,2,3,\n4,5,6");
  EXPECT_EQ(printed(loop), "3 6 ");
  put("d.txt", "1,2,3,\n4,5,6,\n");
  EXPECT_EQ(printed(loop), "3 6 6 ");
  put("d.txt", "1 2 3 4");
  EXPECT_EQ(printed("#fopen F \"d.txt\" read #while(defined(F)) #read(F,a) #debug concat(str(a,0,0),\" \") #end"),
            "1 3 3 ");
  put("d.txt", "<1,-2,3>,\"a\\tb\",-.5");
  EXPECT_EQ(printed("#fopen F \"d.txt\" read #read(F,V,S,N) #debug concat(vstr(3,V,\" \",0,0),S,str(N,0,1))"),
            "1 -2 3a\tb-0.5");
  EXPECT_FALSE(accepts("#fopen F \"none.txt\" read"));
}

TEST_F(Files, Write) {
  EXPECT_EQ(printed("#declare C=rgb 1; #fopen F \"o.txt\" write #write(F,1/3,\" \",1e10,\" \",1e-10,\" "
                    "\",123456789,\"|\",<1,2,3>,1000000,\"|\",(C)) #fclose F"),
            "");
  EXPECT_EQ(get("o.txt"), "0.333333 1e+10 1e-10 1.23457e+08|<1,2,3> 1e+06|<1,1,1,0,0> ");
  EXPECT_EQ(printed("#fopen F \"b.bin\" write #write(F, uint8 1 2 300 (-5) 2.5 3.49, uint16be 258, sint16le -2, "
                    "sint32le 16909060.4) #fclose F"),
            "");
  EXPECT_EQ(get("b.bin"), std::string("\x01\x02\xff\x00\x03\x03\x01\x02\xfe\xff\x04\x03\x02\x01", 14));
  EXPECT_FALSE(accepts("#declare C=rgb 1; #fopen F \"o.txt\" write #write(F,C)"));
  const auto outside = run("#fopen F \"/verisim_must_not_exist\" write");
  EXPECT_NE(outside.advice.find("--allow-write"), std::string::npos);
  EXPECT_FALSE(fs::exists("/verisim_must_not_exist"));
}

TEST_F(Files, ScenesThatAreNone) {
  EXPECT_NE(parse_file(folder_, {}).errors.size(), 0u);
  EXPECT_NE(parse_file(folder_ / "missing.pov", {}).errors.size(), 0u);
  put("empty.pov", "");
  EXPECT_EQ(parse_file(folder_ / "empty.pov", {}).errors.size(), 0u);
  ParseOptions options;
  options.allow_read = {folder_ / "lib"};
  EXPECT_NE(parse_file(folder_ / "empty.pov", options).errors.size(), 0u);
}

}  // namespace
}  // namespace verisim::parser
