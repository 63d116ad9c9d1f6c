// Probes P1 to P10 of spec 01 section 30: numbers, precedence, tolerance, widths, components, colours, float and vector
// functions.
#include <gtest/gtest.h>

#include "parser/language/test_support.h"

namespace verisim::parser {
namespace {

using testing::accepts;
using testing::components;
using testing::number;
using testing::printed;

struct Probe {
  const char* expression;
  const char* expected;
};

template <std::size_t n>
void check(const Probe (&probes)[n], const std::string& before = {}) {
  for (const Probe& p : probes) EXPECT_EQ(number(p.expression, before), p.expected) << p.expression;
}

TEST(Expressions, Numbers) {
  check({{".5", "0.5"},
         {"1.", "1"},
         {"1e ", "1"},
         {"1e+", "1"},
         {"2.*3", "6"},
         {"1e400", "inf"},
         {"1e-400", "0"},
         {"00012.5", "12.5"},
         {".5e1", "5"}});
  EXPECT_EQ(printed("#debug str(0.1000000000000000055511151231257827,0,20)"), "0.10000000000000000555");
  for (const char* bad : {"1.2.3", "0x10", "1e.5"})
    EXPECT_FALSE(accepts(std::string("#declare A = ") + bad + ";")) << bad;
}

TEST(Expressions, Precedence) {
  check({{"(1+2*3)", "7"},
         {"(-2*3)", "-6"},
         {"(1-2-3)", "-4"},
         {"(8/4/2)", "1"},
         {"(1|0&0)", "0"},
         {"(0&0|1)", "1"},
         {"(!0+1)", "2"},
         {"(!1=0)", "1"},
         {"--3", "3"},
         {"2--4", "6"},
         {"(1<2<3)", "1"},
         {"(3>2>1)", "0"},
         {"(2=2=2)", "0"},
         {"(0?2:0?4:5)", "5"},
         {"(1?0?6:7:8)", "7"},
         {"-2*-2", "4"},
         {"!!5", "1"},
         {"(1? 2 : 3)+1", "3"}});
}

TEST(Expressions, Tolerance) {
  check({{"(1=1+1e-11)", "1"},
         {"(1<1+1e-11)", "1"},
         {"(1<=1-1e-11)", "1"},
         {"(1!=1+1e-9)", "1"},
         {"(1e-10?1:2)", "2"},
         {"(1.0000001e-10?1:2)", "1"},
         {"!1e-11", "1"},
         {"0/0", "inf"},
         {"-1/0", "inf"}});
  EXPECT_EQ(components(3, 16, "<1,2,3>/<1,0,2>"), "1 inf 1.5");
}

TEST(Expressions, Widths) {
  check({{"vdot(1+<1,2>,z)", "1"},
         {"vdot((1+<1,2>),z)", "0"},
         {"vdot(1/<1,2>,z)", "inf"},
         {"vlength(2)", "3.4641016151377544"}});
  EXPECT_EQ(number("vdot(A,z)", "#declare A=1+<1,2>;"), "0");
  EXPECT_EQ(components(3, 9, "<1,2>+<1,2,3>"), "2 4 3");
  EXPECT_EQ(components(5, 6, "<1,2,3,4,5>*2"), "2 4 6 8 10");
  EXPECT_EQ(components(2, 6, "<1 -2 3>"), "-1 3");
  EXPECT_EQ(components(3, 6, "(<1,2,3> = <3,2,1>)"), "0 1 0");
  EXPECT_EQ(components(3, 6, "(<1,2,3> < 2)"), "1 0 0");
  // Measured in addition: both sides of relations and logic are widened like those of arithmetic.
  EXPECT_EQ(components(3, 6, "(<1,2,3> = 2)"), "0 1 0");
  EXPECT_EQ(components(3, 6, "(2 < <1,2,3>)"), "0 0 1");
  EXPECT_EQ(components(4, 6, "(<5,5,5,5> > <2,2>)"), "1 1 1 1");
  EXPECT_EQ(components(3, 6, "(<1,2,3> != <1,2>)"), "0 0 1");
  EXPECT_EQ(components(3, 6, "rgb 1+<1,2>"), "2 3 0");
}

TEST(Expressions, Components) {
  const std::string v =
      "#declare V=<1,2,3>; #declare U=<1,2>; #declare C=rgbft<.1,.2,.3,.4,.5>; #declare D=<.1,.2,.3,.4,.5>; #declare "
      "Q=<.1,.2,.3,.4>;";
  check({{"V.gray", "1.8169999999999999"},
         {"U.gray", "1.4749999999999999"},
         {"(5).gray", "1.4849999999999999"},
         {"C.x", "0.1000000014901161"},
         {"C.t", "0.4000000059604645"},
         {"C.transmit", "0.5"},
         {"C.gray", "0.1817000035569072"},
         {"D.x", "0.1000000014901161"},
         {"Q.x", "0.1"},
         {"-V.x", "-1"},
         {"(V+1).z", "4"},
         {"<4,5,6>.y", "5"}},
        v);
  EXPECT_EQ(components(3, 6, "rgb <1,2,3>.x"), "1 1 1");
}

TEST(Expressions, Colors) {
  const auto color = [](const std::string& e) { return components(5, 15, e); };
  EXPECT_EQ(color("rgb <.1,.2,.3>"), "0.100000001490116 0.200000002980232 0.300000011920929 0 0");
  EXPECT_EQ(components(5, 15, "A + 1", "#declare A = rgb <.1,.2,.3>;"),
            "1.100000023841858 1.200000047683716 1.299999952316284 1 1");
  EXPECT_EQ(color("color 0.4"),
            "0.400000005960464 0.400000005960464 0.400000005960464 0.400000005960464 0.400000005960464");
  EXPECT_EQ(color("rgb 0.4"), "0.400000005960464 0.400000005960464 0.400000005960464 0 0");
  EXPECT_EQ(color("rgbt <1,2,3,4,5>"), "1 2 3 0 4");
  EXPECT_EQ(color("rgb <1,2,3,4>"), "1 2 3 4 0");
  EXPECT_EQ(color("rgb 1<2?<1,1,0>:<0,1,1>"), "1 1 0 0 0");
  EXPECT_EQ(color("rgb 1-x"), "0 1 1 0 0");
  EXPECT_EQ(color("rgb <1,2,3> filter .5 transmit .2"), "1 2 3 0.5 0.200000002980232");
  EXPECT_EQ(color("color"), "0 0 0 0 0");
  EXPECT_EQ(components(5, 15, "color C red 7", "#declare C = rgb <1,2,3>;"), "7 2 3 0 0");
}

TEST(Expressions, SrgbColors) {
  const auto color = [](const std::string& e) { return components(5, 15, e); };
  EXPECT_EQ(color("srgb <.2,.3,.4>"), "0.033104762434959 0.073238968849182 0.132868334650993 0 0");
  EXPECT_EQ(color("srgbt <51,76,102,127>/255"),
            "0.033104762434959 0.07227186113596 0.132868334650993 0 0.498039215803146");
  EXPECT_EQ(color("srgb <-.5,1.5,.03>"), "-0.038699690252542 2.537155628204346 0.002321981359273 0 0");
  EXPECT_EQ(
      testing::run("#version 3.7; global_settings { assumed_gamma 2.2 } #declare C = srgb 0.5; #debug str(C.x,0,15)")
          .text,
      "0.496227234601974");
  EXPECT_NE(testing::run("#version 3.7; #declare C = srgb 1;").error, "");
}

TEST(Expressions, FloatFunctions) {
  check({{"int(-2.7)", "-2"},
         {"div(-7,2)", "-3"},
         {"div(5,0)", "-2147483648"},
         {"mod(-7,3)", "-1"},
         {"mod(7.5,-2)", "1.5"},
         {"int(1e10)", "-2147483648"},
         {"acos(2)", "0"},
         {"acos(-2)", "3.1415926535897931"},
         {"pow(-2,3)", "-8"},
         {"bitwise_xor(12,10,-1)", "-7"},
         {"bitwise_or(3e9,1)", "-2147483647"},
         {"bitwise_and(5.9)", "5"},
         {"select(1e-300,1,2,3)", "3"},
         {"sin(1<2)", "0.8414709848078965"},
         {"tan(pi/2)", "16331239353195370"},
         {"min(3,1,2)", "1"},
         {"max(3)", "3"},
         {"select(-1,1,2)", "1"},
         {"select(0,1,2)", "2"},
         {"sqrt(\"a\"=\"a\")", "1"}});
  for (const char* bad : {"sqrt(-1)", "ln(0)", "log(-1)", "atan2(0,0)", "pow(0,0)", "max(1<2,3)", "max(1 2)",
                          "max(1,2,)", "bitwise_or(1 2)", "sqr(2)", "sum(i,1,2,i)", "rand(0)"})
    EXPECT_FALSE(accepts(std::string("#declare A = ") + bad + ";")) << bad;
}

TEST(Expressions, RandomStreams) {
  const auto stream = [](const std::string& seed, int count) {
    return printed("#declare R = seed(" + seed + "); #for(i,1," + std::to_string(count) +
                   ") #debug concat(str(rand(R),0,16),\" \") #end");
  };
  EXPECT_EQ(stream("1", 5),
            "0.4219928752682155 0.4871211982069353 0.6658962156311368 0.9757319050784530 0.3654815392488338 ");
  EXPECT_EQ(stream("0", 2), "0.0000028742942966 0.4665636845088014 ");
  EXPECT_EQ(stream("-5.7", 1), "0.8900528701231938 ");
  EXPECT_EQ(stream("3000000000", 1), "0.5000028744107119 ");
  EXPECT_EQ(stream("123456789", 2), "0.4982198780631227 0.0969679064808804 ");
  EXPECT_EQ(number("rand(R)", "#declare R = seed(1); #declare A = (0&rand(R));"), "0.4871211982069353");
}

TEST(Expressions, VectorFunctions) {
  EXPECT_EQ(components(3, 15, "vrotate(<1,2,3>,<30,40,50>)"), "1.801281061919234 2.507690147191264 2.113498677939254");
  EXPECT_EQ(components(3, 15, "vaxis_rotate(<1,2,3>,<1,1,0>,30)"),
            "2.127647469887601 0.872352530112398 2.95162960194659");
  EXPECT_EQ(components(3, 15, "vcross(<1,2,3>,<4,5,7>)"), "-1 5 -3");
  EXPECT_EQ(components(3, 15, "vturbulence(2,.5,6,<.3,.4,.5>)"),
            "0.015157837101872 -0.21729438168172 0.05912683987808");
  EXPECT_EQ(components(3, 15, "vnormalize(<0,3,4>)"), "0 0.6 0.8");
  EXPECT_EQ(components(3, 15, "vnormalize(<0,0,0>)"), "0 0 0");
}

}  // namespace
}  // namespace verisim::parser
