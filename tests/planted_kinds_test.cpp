// How small a fault the verdict finds: faults of many kinds, three strengths each, planted in scenes of our own, and
// changes that are none.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "compare/compare.h"
#include "compare/oracle/working_copy.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;

// What stands between « and » is what faults change; each name stands once.
constexpr const char* kRoom = R"(#version 3.7;
global_settings { assumed_gamma 1 «max_trace_level 5» }
camera { location <0, 2.2, -6> direction <«Shift 0», -0.3, 1> up y right «Aspect 1.3333»*x }
light_source { <-5, 8, -6> rgb «Light 0.8» }
light_source { <6, 5, «LightZ -2»> rgb <0.7, 0.45, «Blue 0.1»> }
plane { y, -1 pigment { checker rgb <0.8, 0.8, 0.7> rgb <0.3, 0.35, 0.4> scale «Checker 0.9» } finish { diffuse
«Floor 0.7» } }
torus { 1, «Minor 0.35» rotate «Turn -60»*x translate <-1.9, 0.2, 0.5> pigment { rgb <0.8, 0.25, 0.2> } finish {
diffuse 0.8 phong «Phong 0.5» phong_size «Shine 40» } }
sphere { <1.7, «Height 0.1», 0>, «Radius 1.05» pigment { granite scale «Granite 0.7» color_map { [0 rgb 0.2] [1 rgb
<0.9, 0.8, 0.6>] } } finish { diffuse 0.8 reflection «Mirror 0.2» } }
cylinder { <0, -1, 1.6>, <0, 1.6, 1.6>, 0.5 pigment { bozo scale «Bozo 0.2» color_map { [0 rgb <0.1, 0.5, 0.2>] [1
rgb 0.8] } } normal { bumps «Bumps 0.3» scale 0.1 } finish { diffuse 0.8 } }
box { <-0.6, -1, -1.6>, <«BoxX 0.5», -0.1, -0.7> rotate «BoxTurn 20»*y pigment { rgb <0.4, 0.5, «BoxBlue 0.8»>
transmit «Clear 0.1» } finish { ambient «Ambient 0» diffuse «Box 0.80» } }
prism { linear_sweep 0, 0.4, 5, <0, 0>, <0.7, 0>, <«Vertex 0.7», 0.6>, <0, 0.6>, <0, 0> translate <0.7, -1, -2.2>
pigment { rgb <0.9, 0.8, 0.3> } finish { diffuse 0.7 } }
#if («Bead 1») sphere { <-1.5, -0.8, -2.2>, 0.2 pigment { rgb <0.2, 0.7, 0.3> } } #end
fog { distance «Fog 60» rgb <0.6, 0.65, 0.7> }
)";

// The scene with one value replaced; an empty name: as it is.
std::string scene_with(const std::string& name, const std::string& value) {
  std::string in = kRoom, out;
  const std::string open = "«", close = "»";
  bool found = name.empty();
  for (std::size_t at = 0;;) {
    const std::size_t from = in.find(open, at);
    if (from == std::string::npos) {
      EXPECT_TRUE(found) << name;
      return out + in.substr(at);
    }
    const std::size_t to = in.find(close, from), blank = in.find(' ', from);
    const std::string key = in.substr(from + open.size(), blank - from - open.size()),
                      usual = in.substr(blank + 1, to - blank - 1);
    const bool directive = key == "max_trace_level";
    out += in.substr(at, from - at) + (directive ? key + " " : "") + (key == name ? value : usual);
    found |= key == name;
    at = to + close.size();
  }
}

struct Kind {
  const char *what, *name;
  std::array<const char*, 3> values;  // weak, middle, strong
};
constexpr Kind kKinds[] = {{"a light 0.5, 1, 3 % darker", "Light", {"0.796", "0.792", "0.776"}},
                           {"a light moved", "LightZ", {"-2.02", "-2.05", "-2.2"}},
                           {"a light's colour", "Blue", {"0.102", "0.105", "0.12"}},
                           {"a finish 1, 2, 5 % darker", "Box", {"0.792", "0.784", "0.76"}},
                           {"the floor's finish", "Floor", {"0.697", "0.693", "0.68"}},
                           {"ambient light", "Ambient", {"0.003", "0.005", "0.02"}},
                           {"a pigment's blue", "BoxBlue", {"0.79", "0.78", "0.75"}},
                           {"transparency", "Clear", {"0.11", "0.12", "0.15"}},
                           {"a highlight's strength", "Phong", {"0.49", "0.48", "0.4"}},
                           {"a highlight's size", "Shine", {"41", "42", "50"}},
                           {"reflection", "Mirror", {"0.198", "0.19", "0.15"}},
                           {"reflection cut off", "max_trace_level", {"1", "1", "1"}},
                           {"fog 1, 2, 5 % further", "Fog", {"60.6", "61.2", "63"}},
                           {"an object moved", "Height", {"0.103", "0.11", "0.15"}},
                           {"an object scaled", "Radius", {"1.053", "1.06", "1.1"}},
                           {"an object turned", "BoxTurn", {"20.2", "20.5", "22"}},
                           {"a torus turned", "Turn", {"-60.2", "-60.5", "-62"}},
                           {"a torus thicker", "Minor", {"0.351", "0.355", "0.37"}},
                           {"a box's side moved", "BoxX", {"0.505", "0.51", "0.55"}},
                           {"a prism's vertex moved", "Vertex", {"0.71", "0.72", "0.8"}},
                           {"a small object missing", "Bead", {"0", "0", "0"}},
                           {"a pattern scaled", "Granite", {"0.7007", "0.707", "0.75"}},
                           {"another pattern scaled", "Bozo", {"0.2002", "0.202", "0.21"}},
                           {"a checker scaled", "Checker", {"0.9009", "0.905", "0.92"}},
                           {"bumps", "Bumps", {"0.303", "0.31", "0.35"}},
                           {"the camera's direction", "Shift", {"0.0005", "0.001", "0.01"}},
                           {"the camera's width", "Aspect", {"1.334", "1.336", "1.35"}}};

class PlantedKinds : public testing::Test {
 protected:
  compare::Picture render(const std::string& scene, const std::vector<std::string>& switches) const {
    const compare::TemporaryFolder folder;
    compare::NativeRequest ask;
    ask.folder = folder.path(), ask.scene = folder.path() / "room.pov", ask.output = folder.path() / "out.png";
    ask.switches = switches;
    std::ofstream(ask.scene) << scene;
    const compare::NativeResult result = compare::native_program(fs::path(VERISIM_BINARY_DIR) / "bin/verisim")(ask);
    EXPECT_EQ(result.outcome, compare::NativeResult::Outcome::rendered) << result.message;
    return image::read_picture(ask.output);
  }
  // Of all kinds; what passed is printed.
  int found(int strength, const std::string& type, bool antialiased) const {
    const std::vector<std::string> switches{type, antialiased ? "+A0.3" : "-A"};
    const compare::Picture right = render(scene_with("", ""), switches);
    int count = 0;
    for (const Kind& kind : kKinds) {
      const compare::Metrics m = compare::measure(
          right, render(scene_with(kind.name, kind.values[static_cast<std::size_t>(strength)]), switches));
      const compare::Verdict verdict = compare::judge_deterministic(m, antialiased);
      if (verdict.status == compare::Status::differ)
        ++count;
      else
        fmt::print("passes with {}{}: {} ({}): within_1 {:.3f}, patches {}, drift {:.3f}\n", type,
                   antialiased ? " anti-aliased" : "", kind.what, kind.values[static_cast<std::size_t>(strength)],
                   m.within_1_pct, m.solid_2_pixels, m.drift_max);
    }
    fmt::print("strength {} with {}: {} of {} found\n", strength, type, count, std::size(kKinds));
    return count;
  }
};

constexpr int kAll = static_cast<int>(std::size(kKinds));

TEST_F(PlantedKinds, WhatAPersonSeesIsFound) {
  EXPECT_EQ(found(2, "+FN16", false), kAll);
  EXPECT_EQ(found(2, "+FN16", true), kAll);
  EXPECT_GE(found(2, "+FN8", false), kAll - 1);
}

TEST_F(PlantedKinds, MostOfWhatNobodySeesIsFound) {
  EXPECT_GE(found(1, "+FN16", false), kAll - 1);
  EXPECT_GE(found(1, "+FN16", true), kAll - 1);
  EXPECT_GE(found(0, "+FN16", false), kAll - 4);
}

TEST_F(PlantedKinds, WhatIsNoFaultPasses) {
  const compare::Picture right = render(scene_with("", ""), {"+FN16", "-A"});
  for (const char* same : {"+BS8", "+WT1", "-UR", "+FN16"}) {
    const compare::Verdict verdict =
        compare::judge_deterministic(compare::measure(right, render(scene_with("", ""), {"+FN16", "-A", same})), false);
    EXPECT_EQ(verdict.status, compare::Status::exact) << same << verdict.reason;
  }
  // The same scene, said in other words.
  for (const auto& [name, value] : {std::pair("Radius", "2.1/2"), {"Fog", "6e1"}, {"Mirror", "(0.1 + 0.1)"}})
    EXPECT_EQ(
        compare::judge_deterministic(compare::measure(right, render(scene_with(name, value), {"+FN16", "-A"})), false)
            .status,
        compare::Status::exact)
        << name;
}

}  // namespace
}  // namespace verisim
