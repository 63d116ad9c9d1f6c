// Every pattern at 1,000 points in POV-Ray and here: one SDL script writes the values, both programs run it, the files
// are compared.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "parser/parse.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string sdl;
  double tolerance = 1e-9;  // pattern functions are double precision
};

// Accepted by function { pattern { ... } }.
std::vector<Case> patterns() {
  std::vector<Case> cases;
  for (const char* sdl :
       {"agate", "agate agate_turb 0.5 turbulence 0.3 octaves 4 omega 0.6 lambda 2.3", "agate noise_generator 1",
        "agate noise_generator 3", "boxed scale 3", "bozo", "bozo noise_generator 1", "bozo noise_generator 3",
        "bozo turbulence <0.5, 0.2, 0.1>", "brick", "brick brick_size <1, 0.5, 0.7> mortar 0.1", "bumps", "cells",
        "checker", "checker frequency 0.3 phase 0.1", "crackle", "crackle solid", "crackle form <1, 0, 0>",
        "crackle form <1, 1, -1> offset 0.3", "crackle metric 1", "crackle metric 3",
        "crackle metric 0.5 form <-1, 2, -1>", "cubic", "cylindrical scale 3", "dents", "gradient x",
        "gradient <1, 2, -0.5>", "granite", "granite noise_generator 1", "granite noise_generator 3", "hexagon",
        "leopard", "marble", "marble turbulence 0.7", "onion", "planar scale 3", "quilted",
        "quilted control0 0.2 control1 1.7", "radial", "radial frequency 6", "ripples",
        "ripples frequency 2.5 phase 0.3", "spherical scale 4", "spiral1 3", "spiral1 -2 turbulence 0.3", "spiral2 5",
        "spiral2 2 turbulence 0.4", "spotted", "waves", "waves frequency 4 phase 0.1 sine_wave", "wood",
        "wood turbulence <0.3, 0.1, 0.2> octaves 4", "wrinkles", "wrinkles noise_generator 1",
        "wrinkles noise_generator 3", "function { sin(x)*cos(y) + z/7 }", "pigment_pattern { bozo scale 2 }",
        "object { sphere { 0, 4 } }", "object { box { -3, 3 } }",
        // wave forms and periods
        "onion sine_wave", "onion triangle_wave frequency 3", "onion scallop_wave", "onion cubic_wave phase 0.3",
        "onion poly_wave 2.2", "onion frequency -2.5 phase 0.1", "marble frequency 3 ramp_wave",
        "gradient z frequency 0",
        // warps and their order
        "bozo warp { turbulence <0.5, 0.3, 0.2> octaves 4 lambda 2.2 omega 0.6 }",
        "bozo turbulence 0.5 scale 2 translate x", "bozo scale 2 warp { turbulence 0.5 }",
        "bozo warp { turbulence 0.5 } scale 2 rotate <10, 20, 30>",
        "bozo warp { repeat 1.7*y offset <0.3, 0.2, -0.1> flip <1, 1, 0> }",
        "bozo warp { black_hole <0.6, 0.6, 0.6>, 0.6 strength 1.5 repeat <2, 2, 2> turbulence <0.5, 0.6, 0.3> }",
        "bozo warp { black_hole <0.5, 0.5, 0>, 4 strength 1.8 falloff 1.3 inverse }",
        "bozo warp { cylindrical orientation y dist_exp 1 }", "bozo warp { spherical }",
        "bozo warp { spherical orientation <1, 2, 3> dist_exp 0.7 }",
        "bozo warp { toroidal orientation y dist_exp 1 major_radius 2 }", "bozo warp { planar y, 0.7 }",
        "bozo warp { cubic }", "bozo matrix <1, 0.2, 0, 0.1, 2, 0, 0, 0.3, 0.5, 1, 2, 3>"})
    cases.push_back({sdl});
  for (const char* sdl :
       {"mandel 25 scale 4", "mandel 20 interior 1, 1 scale 4", "mandel 25 exponent 5 scale 5",
        "mandel 20 exterior 2, 0.3 scale 4", "julia <0.3, 0.5>, 20 exterior 6, 0.1 scale 4",
        "magnet 1 mandel 12 scale 4", "magnet 2 mandel 10 scale 4", "magnet 1 julia <0.4, 0.6>, 10 scale 4",
        "magnet 2 julia <0.3, 0.5>, 8 interior 6, 0.5 scale 4"})
    cases.push_back({sdl, 1e-6});  // chaotic: a difference in the last bit grows with each iteration
  return cases;
}

// Only accepted by function { pigment { ... } }, which is single precision.
std::vector<Case> pigments() {
  std::vector<Case> cases;
  for (const char* sdl :
       {"square rgb 0, rgb 0.2, rgb 0.4, rgb 0.6", "triangular rgb 0, rgb 0.1, rgb 0.2, rgb 0.3, rgb 0.4, rgb 0.5",
        "hexagon rgb 0, rgb 0.2, rgb 0.4", "average pigment_map { [2 bozo scale 2] [gradient x] }",
        "gradient y turbulence 0.4 pigment_map { [0.2 bozo] [0.8 granite] }"})
    cases.push_back({sdl, 3e-7});
  for (int n = 1; n <= 27; ++n)
    cases.push_back({"tiling " + std::to_string(n) + " color_map { [0 rgb 0] [1 rgb 1] }", 1e-6});
  for (const char* sdl : {"pavement number_of_sides 3 number_of_tiles 4 pattern 2 interior 1 form 1",
                          "pavement number_of_sides 3 number_of_tiles 6 pattern 7 exterior 2 form 2",
                          "pavement number_of_sides 3 number_of_tiles 5 pattern 3 exterior 1",
                          "pavement number_of_sides 4 number_of_tiles 5 pattern 11 interior 2",
                          "pavement number_of_sides 4 number_of_tiles 6 pattern 28 exterior 1 form 2",
                          "pavement number_of_sides 4 number_of_tiles 4 pattern 3 exterior 2 interior 1 form 3",
                          "pavement number_of_sides 6 number_of_tiles 3 pattern 2 form 1",
                          "pavement number_of_sides 6 number_of_tiles 5 pattern 8 interior 1",
                          "pavement number_of_sides 6 number_of_tiles 4 pattern 6 interior 2 form 2"})
    cases.push_back({std::string(sdl) + " color_map { [0 rgb 0] [1 rgb 1] }", 1e-6});
  return cases;
}

constexpr int kPoints = 1000;

std::string script(const std::vector<Case>& cases, bool as_pigment) {
  std::string text = "#version 3.7;\n#fopen OUT \"values.txt\" write\n";
  int n = 0;
  for (const Case& c : cases) {
    const std::string f = "F" + std::to_string(n++);  // functions cannot be declared again
    text +=
        "#declare " + f + (as_pigment ? " = function { pigment { " : " = function { pattern { ") + c.sdl + " } };\n";
    text += "#declare I = 0;\n#while (I < " + std::to_string(kPoints) + ")\n";
    // Points of a rank-1 lattice: the same doubles in both programs.
    text +=
        "#declare P = <mod((I + 0.31)*0.8191725134, 1)*20 - 10, mod((I + 0.31)*0.6710436067, 1)*20 - 10, mod((I + "
        "0.31)*0.5497004779, 1)*20 - 10>;\n";
    text += as_pigment ? "#declare C = " + f + "(P.x, P.y, P.z); #write (OUT, str(C.red, 0, 9), \"\\n\")\n"
                       : "#write (OUT, str(" + f + "(P.x, P.y, P.z), 0, 14), \"\\n\")\n";
    text += "#declare I = I + 1;\n#end\n";
  }
  return text + "#fclose OUT\n";
}

std::vector<double> numbers(const fs::path& file) {
  std::ifstream in(file);
  std::vector<double> values;
  for (double v; in >> v;) values.push_back(v);
  return values;
}

class TextureOracle : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v povray >/dev/null 2>&1") != 0) GTEST_SKIP() << "povray is not installed";
    folder_ = fs::temp_directory_path() / ("verisim_textures_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  void compare(const std::vector<Case>& cases, bool as_pigment, int allowed_outliers) {
    std::ofstream(folder_ / "probe.pov") << script(cases, as_pigment);
    const std::string run =
        "cd '" + folder_.string() +
        "' && HOME=. timeout 120 povray +Iprobe.pov +Oignored.png +W1 +H1 -D -GA +WT1 -F >/dev/null 2>&1";
    (void)!std::system(run.c_str());
    const std::vector<double> expected = numbers(folder_ / "values.txt");
    ASSERT_EQ(expected.size(), cases.size() * kPoints) << "POV-Ray did not finish the script";
    fs::remove(folder_ / "values.txt");

    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    parser::ParseOptions options;
    options.allow_write = {folder_};
    const parser::ParseResult result = parser::parse_file("probe.pov", options);
    fs::current_path(before);
    for (const auto& e : result.errors) ADD_FAILURE() << e.line << ": " << e.message;
    const std::vector<double> ours = numbers(folder_ / "values.txt");
    ASSERT_EQ(ours.size(), expected.size());
    for (std::size_t c = 0; c < cases.size(); ++c) {
      int outliers = 0;
      double largest = 0;
      for (std::size_t i = c * kPoints; i < (c + 1) * kPoints; ++i) {
        const double difference = std::fabs(ours[i] - expected[i]);
        if (difference > cases[c].tolerance) ++outliers;
        largest = std::max(largest, difference);
      }
      EXPECT_LE(outliers, allowed_outliers) << cases[c].sdl << ": largest difference " << largest;
    }
  }

  fs::path folder_;
};

TEST_F(TextureOracle, PatternFunctions) { compare(patterns(), false, 0); }
TEST_F(TextureOracle, PigmentFunctions) { compare(pigments(), true, 0); }

// tools/measure_noise reads the value table out of the program as it is installed here.
TEST_F(TextureOracle, FreshlyMeasuredNoiseTableIsTheOneCheckedIn) {
  const fs::path root = VERISIM_SOURCE_DIR, measured = folder_ / "table.inc";
  const std::string run =
      "bash '" + (root / "tools/measure_noise/measure.sh").string() + "' > '" + measured.string() + "' 2>/dev/null";
  ASSERT_EQ(std::system(run.c_str()), 0);
  const auto text = [](const fs::path& file) {
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_EQ(text(measured), text(root / "tracer/noise/noise_value_table.inc"));
}

}  // namespace
}  // namespace verisim
