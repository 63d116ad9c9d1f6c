// Random SDL expressions evaluated by POV-Ray and by verisim, compared character by character. Skips when POV-Ray is
// not installed.
//
// VERISIM_EXPRESSIONS sets how many (300), VERISIM_SEED where the generator starts (1).
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/differential/settings.h"
#include "tests/differential/written_by_both.h"

namespace verisim {
namespace {

// Expressions that cannot fail: no domain errors, no widths that do not fit. Components POV-Ray leaves unspecified are
// avoided.
class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  std::string any(int depth) {
    switch (pick(4)) {
      case 0:
        return additive(depth);
      case 1:
        return vector(depth, 3);
      case 2:
        return vector(depth, 2);
      default:
        return "(" + full(depth) + ")";
    }
  }

  // Scalars, full grammar.
  std::string full(int depth) {
    if (depth <= 0) return additive(0);
    switch (pick(6)) {
      case 0:
        return additive(depth - 1) + " " + relation() + " " + additive(depth - 1);
      case 1:
        return additive(depth - 1) + relation() + additive(depth - 1) + (pick(2) ? " & " : " | ") + additive(depth - 1);
      case 2:
        return additive(depth - 1) + " ? " + full(depth - 1) + " : " + full(depth - 1);
      case 3:
        return "\"" + word() + "\" " + relation() + " \"" + word() + "\"";
      default:
        return additive(depth - 1);
    }
  }

  std::string additive(int depth) {
    std::string out = term(depth);
    for (int i = pick(3); i > 0; --i) out += (pick(2) ? "+" : "-") + term(depth);
    return out;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string word() {
    static const char* words[] = {"a", "b", "abc", "Abc", "", "zz"};
    return words[pick(6)];
  }
  std::string relation() {
    static const char* all[] = {"<", ">", "=", "<=", ">=", "!="};
    return all[pick(6)];
  }
  std::string literal() {
    static const char* numbers[] = {"0",   "1",     "2",   ".5", "1.5",      "3",   "10",
                                    "0.1", "1e-11", "1e3", "7",  "0.333333", "255", "1e-3"};
    return numbers[pick(14)];
  }

  std::string term(int depth) {
    std::string out = factor(depth);
    for (int i = pick(3); i > 0; --i) out += (pick(2) ? "*" : "/") + factor(depth);
    return out;
  }

  std::string factor(int depth) {
    switch (pick(8)) {
      case 0:
        return "-" + factor(depth - 1);
      case 1:
        return pick(2) ? "!" + factor(depth - 1) : "+" + factor(depth - 1);
      default:
        return primary(depth);
    }
  }

  std::string primary(int depth) {
    if (depth <= 0) {
      static const char* leaves[] = {"a",  "b",    "A[1]", "A[i]",    "V.x",   "C.green", "V.z",
                                     "pi", "true", "off",  "version", "clock", "B[1][2]", "Q.y"};
      return pick(2) ? literal() : leaves[pick(14)];
    }
    const auto one = [&](const char* name) { return std::string(name) + "(" + full(depth - 1) + ")"; };
    const auto two = [&](const char* name) {
      return std::string(name) + "(" + additive(depth - 1) + "," + additive(depth - 1) + ")";
    };
    switch (pick(24)) {
      case 0:
        return one("sin");
      case 1:
        return one("cos");
      case 2:
        return one("atan");
      case 3:
        return one("abs");
      case 4:
        return one("int");
      case 5:
        return one("floor");
      case 6:
        return one("ceil");
      case 7:
        return "sqrt(abs(" + full(depth - 1) + "))";
      case 8:
        return "exp(sin(" + full(depth - 1) + "))";
      case 9:
        return two("mod");
      case 10:
        return two("min");
      case 11:
        return two("max");
      case 12:
        return "pow(abs(" + additive(depth - 1) + ")+1," + literal() + ")";
      case 13:
        return "select(" + additive(depth - 1) + "," + additive(depth - 1) + "," + additive(depth - 1) +
               (pick(2) ? "," + additive(depth - 1) : "") + ")";
      case 14:
        return two(pick(2) ? "bitwise_and" : "bitwise_xor");
      case 15:
        return "vdot(" + vector(depth - 1, 3) + "," + vector(depth - 1, 3) + ")";
      case 16:
        return "vlength(" + vector(depth - 1, 3) + ")";
      case 17:
        return "rand(R)";
      case 18:
        return two("F");
      case 19:
        return "S(" + additive(depth - 1) + ").y";
      case 20:
        return one(pick(2) ? "radians" : "degrees");
      case 21:
        return "strlen(concat(\"" + word() + "\",str(" + additive(depth - 1) + ",0,3)))";
      case 22:
        return "(" + vector(depth - 1, 3) + ")." + (pick(2) ? "x" : "z");
      default:
        return "(" + full(depth - 1) + ")";
    }
  }

  // At most `terms` terms.
  std::string vector(int depth, int terms) {
    std::string out = vector_factor(depth, terms);
    for (int i = pick(3); i > 0; --i) {
      static const char* operations[] = {"+", "-", "*", "/"};
      out += operations[pick(4)] + (pick(3) ? vector_factor(depth - 1, terms) : primary(depth - 1));
    }
    return out;
  }

  std::string vector_factor(int depth, int terms) {
    if (terms == 3) {
      switch (depth > 0 ? pick(9) : pick(4)) {
        case 0:
          return pick(2) ? "V" : "W";
        case 1:
          return pick(2) ? "x" : "z";
        case 2:
          return "y";
        case 3:
          break;
        case 4:
          return "vcross(" + vector(depth - 1, 3) + "," + vector(depth - 1, 3) + ")";
        case 5:
          return "vrotate(" + vector(depth - 1, 3) + "," + vector(depth - 1, 3) + ")";
        case 6:
          return "vaxis_rotate(" + vector(depth - 1, 3) + ",V," + additive(depth - 1) + ")";
        case 7:
          return "vnormalize(V+" + vector_factor(depth - 1, 2) + ")";
        default:
          return "-" + vector_factor(depth - 1, 3);
      }
      return "<" + additive(depth - 1) + ", " + additive(depth - 1) + ", " + additive(depth - 1) + ">";
    }
    switch (pick(4)) {
      case 0:
        return "u";
      case 1:
        return "v";
      case 2:
        return "U";
      default:
        return "<" + additive(depth - 1) + ", " + additive(depth - 1) + ">";
    }
  }

  std::mt19937 random_;
};

std::string preamble() {
  return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#declare a = 2.5; #declare b = -3; #declare i = 2; "
         "#declare A = array[3]{1,-2,.25}\n"
         "#declare B = array[2][3]{{1,2,3},{4,5,6.5}}\n#declare V = <1,-2,.5>; #declare W = <.25,3,-7>; #declare U = "
         "<2,-.5>; #declare Q = <1,2,3,4>;\n"
         "#declare C = rgbft <.1,.2,.3,.4,.5>; #declare R = seed(7);\n#declare F = function(p,q) { "
         "p*2-q/3+sin(p)*max(p,q) }\n"
         "#declare S = spline { cubic_spline 0,<0,1,2> 1,<3,2,1> 2,<1,1,5> 3,<0,-1,0> }\n#fopen O \"out.txt\" write\n";
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    // The sign of NaN is the compiler's business (spec 01 section 29).
    for (std::size_t at; (at = line.find("-nan")) != std::string::npos;) line.erase(at, 1);
    lines.push_back(line);
  }
  return lines;
}

TEST(Differential, Expressions) {
  if (!has_povray()) GTEST_SKIP() << "POV-Ray is not installed (package povray)";
  const int count = setting("VERISIM_EXPRESSIONS", 300);
  Generator generator(static_cast<unsigned>(setting("VERISIM_SEED", 1)));
  std::vector<std::string> expressions;
  std::string scene = preamble();
  for (int i = 0; i < count; ++i) {
    expressions.push_back(generator.any(1 + i % 3));
    scene += "#declare Value = " + expressions.back() + ";\n#write(O, vstr(5, Value, \" \", 0, 16), \"\\n\")\n";
  }
  scene += "#fclose O\n";
  WrittenByBoth written;
  run_by_both(scene, "expressions", written);
  if (HasFatalFailure()) return;
  const std::vector<std::string> expected = lines_of(written.povray), actual = lines_of(written.verisim);
  ASSERT_EQ(expected.size(), expressions.size());
  ASSERT_EQ(actual.size(), expressions.size());
  int different = 0;
  for (std::size_t i = 0; i < expressions.size(); ++i) {
    if (expected[i] == actual[i]) continue;
    if (++different <= 10)
      ADD_FAILURE() << expressions[i] << "\n  POV-Ray " << expected[i] << "\n  verisim " << actual[i];
  }
  EXPECT_EQ(different, 0) << "of " << count;
}

}  // namespace
}  // namespace verisim
