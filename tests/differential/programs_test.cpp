// Random programs of SDL - loops, branches, switches, macros, arrays, strings, scopes - run by POV-Ray and by verisim;
// what they write is compared character by character. Skips when POV-Ray is not installed. VERISIM_PROGRAM_STATEMENTS
// sets how long they are (400), VERISIM_SEED where the generator starts (1).
#include <algorithm>
#include <random>
#include <string>

#include "tests/differential/settings.h"
#include "tests/differential/written_by_both.h"

namespace verisim {
namespace {

class ProgramGenerator {
 public:
  explicit ProgramGenerator(unsigned seed) : random_(seed) {}

  std::string program(int statements) {
    std::string text = preamble();
    for (int i = 0; i < statements; ++i) text += statement(3) + print();
    return text + "#fclose O\n";
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string number() {
    static const char* numbers[] = {"0", "1", "2", "3", ".5", "1.25", "7", "-1", "0.1", "1e-11", "12"};
    return numbers[pick(11)];
  }
  std::string name(char kind, int count) { return std::string(1, kind) + std::to_string(pick(count)); }
  std::string f() { return name('f', 4); }
  std::string v() { return name('w', 3); }
  std::string s() { return name('s', 3); }
  std::string element() { return "g[mod(abs(int(" + f() + ")),4)]"; }

  std::string scalar(int depth) {
    if (depth <= 0) return pick(2) ? f() : number();
    switch (pick(11)) {
      case 0:
        return scalar(depth - 1) + "+" + scalar(depth - 1);
      case 1:
        return scalar(depth - 1) + "-" + scalar(depth - 1);
      case 2:
        return scalar(depth - 1) + "*" + number();
      case 3:
        return "(" + scalar(depth - 1) + ")/3";
      case 4:
        return element();
      case 5:
        return v() + ".y";
      case 6:
        return "strlen(" + s() + ")";
      case 7:
        return "(" + condition(depth - 1) + "?" + scalar(depth - 1) + ":" + scalar(depth - 1) + ")";
      case 8:
        return "(Add(" + scalar(depth - 1) + "," + scalar(depth - 1) + "))";
      case 9:
        return "vdot(" + vector(depth - 1) + "," + vector(depth - 1) + ")";
      default:
        return "min(" + scalar(depth - 1) + "," + scalar(depth - 1) + ")";
    }
  }
  std::string vector(int depth) {
    switch (pick(depth > 0 ? 6 : 2)) {
      case 0:
        return v();
      case 1:
        return "<" + scalar(0) + "," + scalar(0) + "," + scalar(0) + ">";
      case 2:
        return vector(depth - 1) + "+" + vector(depth - 1);
      case 3:
        return vector(depth - 1) + "*" + number();
      case 4:
        return "vcross(" + vector(depth - 1) + "," + vector(depth - 1) + ")";
      default:
        return "<#if (" + condition(0) + ") " + number() + " #else " + number() + " #end," + scalar(depth - 1) + ",2>";
    }
  }
  std::string string(int depth) {
    switch (pick(depth > 0 ? 6 : 2)) {
      case 0:
        return s();
      case 1:
        return pick(2) ? "\"ab\"" : "\"Xyz\"";
      case 2:
        return "substr(concat(" + string(depth - 1) + ",\"..\"),1,2)";
      case 3:
        return "str(" + scalar(depth - 1) + ",0," + std::to_string(pick(4)) + ")";
      case 4:
        return "strupr(" + string(depth - 1) + ")";
      default:
        return "chr(65+mod(abs(int(" + f() + ")),20))";
    }
  }
  std::string condition(int depth) {
    static const char* relations[] = {"<", ">", "=", "<=", ">=", "!="};
    std::string text = scalar(depth) + relations[pick(6)] + scalar(depth);
    if (pick(3) == 0) text += std::string(pick(2) ? " & " : " | ") + scalar(depth) + relations[pick(6)] + number();
    return text;
  }
  // Values stay small, so that every digit is printed.
  std::string bounded(const std::string& expression) { return "mod(" + expression + ",97)"; }

  std::string block(int depth) {
    std::string text;
    for (int i = 1 + pick(2); i > 0; --i) text += statement(depth - 1);
    return text;
  }

  std::string statement(int depth) {
    const std::string counter = "n" + std::to_string(depth);
    switch (pick(depth > 0 ? 16 : 6)) {
      case 0:
      case 1:
        return "#declare " + f() + " = " + bounded(scalar(2)) + ";\n";
      case 2: {
        const std::string target = v();
        return "#declare " + target + " = " + vector(1) + ";\n#declare " + target + " = <mod(" + target +
               ".x,31),mod(" + target + ".y,31),mod(" + target + ".z,31)>;\n";
      }
      case 3:
        return "#declare " + s() + " = " + string(2) + "\n";
      case 4:
        return "#declare " + element() + " = " + bounded(scalar(1)) + ";\n";
      case 5:
        return "#write (O, " + string(1) + ", \" \", " + scalar(1) + ", \" \", " + vector(0) + ", \"\\n\")\n";
      case 6:
      case 7:
        return "#if (" + condition(1) + ")\n" + block(depth) +
               (pick(2)   ? "#else\n" + block(depth)
                : pick(2) ? "#elseif (" + condition(0) + ")\n" + block(depth)
                          : "") +
               "#end\n";
      case 8:
        return "#for (" + counter + ", " + std::to_string(pick(3)) + ", " + std::to_string(pick(5)) +
               (pick(2) ? ", .5" : "") + ")\n" + block(depth) +
               (pick(4) ? "" : "#if (" + condition(0) + ") #break #end\n") + "#end\n";
      case 9:
        return "#declare " + counter + " = 0;\n#while (" + counter + " < " + std::to_string(pick(4)) + ")\n#declare " +
               counter + " = " + counter + "+1;\n" + block(depth) + "#end\n";
      case 10:
        return "#switch (mod(int(" + f() + "),4))\n#case (0)\n" + block(depth) + (pick(2) ? "#break\n" : "") +
               "#case (1)\n" + block(depth) + "#break\n#range (2,3)\n" + block(depth) + "#break\n#else\n" +
               block(depth) + "#end\n";
      case 11:
        return "Swap(" + f() + ", " + f() + ")\n";
      case 12:
        return "Scoped(" + scalar(1) + ")\n";
      case 13:
        return "#ifdef (Sometimes) #undef Sometimes #else #declare Sometimes = " + number() + "; #end\n";
      case 14:
        return "#declare " + f() + " = Sum(" + std::to_string(pick(6)) + ");\n";
      default:
        return "Set(" + element() + ", " + scalar(1) + ")\n";
    }
  }

  std::string print() {
    return "#write (O, str(f0,0,9),\" \",str(f1,0,9),\" \",f2,\" \",f3,\" \",w0,w1,vstr(3,w2,\",\",0,9),\" "
           "\",s0,\"|\",s1,\"|\",s2,\" \",g[0],\" \",g[1],\" \",g[2],\" \",g[3],\"\\n\")\n";
  }

  static std::string preamble() {
    return "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#fopen O \"out.txt\" write\n"
           "#declare f0 = 1; #declare f1 = -2.5; #declare f2 = 7; #declare f3 = .1;\n#declare w0 = <1,2,3>; #declare "
           "w1 = -y; #declare w2 = <.5,0,-9>;\n"
           "#declare s0 = \"\" #declare s1 = \"abc\" #declare s2 = \"Q\"\n#declare g = array[4]{1,-2,3.5,0}\n"
           "#macro Add(a, b) #local r = a+b; r #end\n#macro Swap(a, b) #local kept = a; #declare a = b; #declare b = "
           "kept; #end\n"
           "#macro Scoped(a) #local f0 = a; #declare f0 = f0+1; #declare f1 = mod(f0,50); #end\n"
           "#macro Sum(n) #local total = 0; #for (i, 1, n) #local total = total+i; #end total #end\n#macro Set(a, b) "
           "#declare a = mod(b,89); #end\n";
  }

  std::mt19937 random_;
};

TEST(Differential, Programs) {
  if (!has_povray()) GTEST_SKIP() << "POV-Ray is not installed (package povray)";
  WrittenByBoth written;
  run_by_both(ProgramGenerator(static_cast<unsigned>(setting("VERISIM_SEED", 1)))
                  .program(setting("VERISIM_PROGRAM_STATEMENTS", 400)),
              "programs", written);
  if (HasFatalFailure()) return;
  const std::string &expected = written.povray, &actual = written.verisim;
  ASSERT_GT(expected.size(), 1000u);
  const auto at = std::mismatch(expected.begin(), expected.end(), actual.begin(), actual.end()).first;
  EXPECT_EQ(expected, actual) << "first difference behind: "
                              << std::string(at - std::min<std::ptrdiff_t>(at - expected.begin(), 300), at);
}

}  // namespace
}  // namespace verisim
