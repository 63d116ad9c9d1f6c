// Faults are planted in a renderer, and the comparison has to find each one, say which figure broke and name the
// culprit. A fault is planted by changing the scene on its way to the program, as the fault in the program would change
// what the scene means, or by changing the picture that it wrote.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

#include "compare/compare.h"
#include "compare/oracle/working_copy.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;
using compare::SceneResult;
using testing::HasSubstr;

constexpr const char* kRoom = R"(#version 3.7;
global_settings { assumed_gamma 1 noise_generator 3 }
#declare Shift = 0;
camera { location <0, 2.2, -6> direction <Shift, -0.3, 1> up y right 4/3*x }
light_source { <-5, 8, -6> rgb 0.8 }
light_source { <6, 5, -2> rgb <0.7, 0.45, 0.1> }
plane { y, -1 pigment { checker rgb <0.8, 0.8, 0.7> rgb <0.3, 0.35, 0.4> scale 0.9 } finish { diffuse 0.7 } }
torus { 1, 0.35 rotate -60*x translate <-1.9, 0.2, 0.5> pigment { rgb <0.8, 0.25, 0.2> }
finish { diffuse 0.8 phong 0.5 } }
sphere { <1.7, 0.1, 0>, 1.05 pigment { granite scale 0.7 color_map { [0 rgb 0.2] [1 rgb <0.9, 0.8, 0.6>] } }
finish { diffuse 0.8 } }
cylinder { <0, -1, 1.6>, <0, 1.6, 1.6>, 0.5 pigment { bozo scale 0.2 color_map { [0 rgb <0.1, 0.5, 0.2>] [1 rgb 0.8] } }
finish { diffuse 0.8 } }
box { <-0.6, -1, -1.6>, <0.5, -0.1, -0.7> rotate 20*y pigment { rgb <0.4, 0.5, 0.8> }
finish { ambient 0 diffuse 0.80 } }
)";

class PlantedFaults : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "scenes");
    std::ofstream(folder_.path() / "scenes/room.pov") << kRoom;
    suite_ = compare::load_suite({folder_.path() / "scenes"}, {160, 120, {"-A"}});
    options_.baseline = folder_.path() / "baseline";
    options_.native = compare::native_program(program());
    compare::update_baseline(compare::run_suite(suite_, options_), options_.baseline, false);
  }

  static fs::path program() { return fs::path(VERISIM_BINARY_DIR) / "bin/verisim"; }

  // The scene as the faulty program understands it.
  static void plant(const compare::NativeRequest& request, const std::string& from, const std::string& to) {
    std::ifstream in(request.scene);
    std::ostringstream text;
    text << in.rdbuf();
    std::string scene = text.str();
    const std::size_t at = scene.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    scene.replace(at, from.size(), to);
    std::ofstream(request.scene) << scene;
  }

  SceneResult with_fault(const std::string& from, const std::string& to) {
    options_.native = [=](const compare::NativeRequest& request) {
      plant(request, from, to);
      return compare::native_program(program())(request);
    };
    options_.tags = [=](const compare::NativeRequest& request, int step, const auto& trees) {
      plant(request, from, to);
      return compare::tags_of_program(program())(request, step, trees);
    };
    return compare::run_suite(suite_, options_).scenes.at(0);
  }

  // 8 bits are enough for what is changed in pictures.
  SceneResult with_changed_picture(const std::function<float(float)>& change) {
    options_.native = [=](const compare::NativeRequest& request) {
      const compare::NativeResult result = compare::native_program(program())(request);
      image::Picture picture = image::read_picture(request.output);
      for (float& v : picture.samples) v = change(v);
      image::write_picture(picture, request.output);
      return result;
    };
    options_.tags = compare::tags_of_program(program());
    return compare::run_suite(suite_, options_).scenes.at(0);
  }

  // The best of what the wrong pixels have in common.
  static std::string culprit(const SceneResult& result) {
    if (!result.blame || result.blame->common.empty()) return "none: " + result.blame_failed;
    return result.blame->common[0].kind + " " + result.blame->common[0].name;
  }
  static std::string suspect(const SceneResult& result) {
    return result.suspicions.empty() ? "none" : result.suspicions[0].what + ": " + result.suspicions[0].detail;
  }

  compare::TemporaryFolder folder_;
  compare::Suite suite_;
  compare::RunOptions options_;
};

TEST_F(PlantedFaults, NoFaultNoAlarm) {
  const SceneResult result = compare::run_suite(suite_, options_).scenes.at(0);
  EXPECT_EQ(result.status, compare::Status::exact) << result.reason;
  EXPECT_TRUE(result.suspicions.empty());
  EXPECT_EQ(result.metrics->max_abs, 0);
}

// A quartic whose nearest root is lost shows the surface behind: as if the front were cut away.
TEST_F(PlantedFaults, WrongTorusRoot) {
  const SceneResult result = with_fault("<-1.9, 0.2, 0.5>", "<-1.9, 0.2, 0.5> clipped_by { plane { -z, -0.3 } }");
  EXPECT_EQ(result.status, compare::Status::differ);
  EXPECT_THAT(result.reason, HasSubstr("within_1_pct"));
  // The first object named is the torus; that its inside is seen is the better clue, and stands before it.
  EXPECT_EQ(culprit(result), "feature a surface seen from inside") << compare::terminal_blame(result);
  const auto& common = result.blame->common;
  EXPECT_EQ(std::find_if(common.begin(), common.end(), [](const auto& tag) { return tag.kind == "object"; })->name,
            "torus (room.pov:8)")
      << compare::terminal_blame(result);
  EXPECT_THAT(result.blame->objects.at(0).name, HasSubstr("torus")) << compare::terminal_blame(result);
  EXPECT_FALSE(result.trees.empty());
}

TEST_F(PlantedFaults, SwappedLightColor) {
  const SceneResult result = with_fault("<0.7, 0.45, 0.1>", "<0.1, 0.45, 0.7>");
  EXPECT_EQ(result.status, compare::Status::differ);
  EXPECT_THAT(result.reason, HasSubstr("within_1_pct"));
  EXPECT_EQ(culprit(result), "light lit by the light at <6, 5, -2>") << compare::terminal_blame(result);
}

TEST_F(PlantedFaults, GammaSlip) {
  const SceneResult result = with_changed_picture([](float v) { return std::pow(v, 1 / 1.1f); });
  EXPECT_EQ(result.status, compare::Status::differ);
  EXPECT_THAT(result.reason, HasSubstr("within_1_pct"));
  EXPECT_THAT(suspect(result), HasSubstr("gamma: values are the reference's to the power of 0.9"));
}

TEST_F(PlantedFaults, HalfPixelShift) {
  const SceneResult result =
      with_fault("Shift = 0", "Shift = 4/3 * 0.5/160");  // half a pixel to the right: the picture moves to the left
  EXPECT_EQ(result.status, compare::Status::differ);
  EXPECT_THAT(result.reason, HasSubstr("within_1_pct"));
  EXPECT_THAT(suspect(result), HasSubstr("shift: the picture is moved by -0.")) << compare::terminal_blame(result);
}

// Less than one code value in most pixels, but everywhere on one object.
TEST_F(PlantedFaults, DarkerFinish) {
  const SceneResult result = with_fault("diffuse 0.80", "diffuse 0.792");
  EXPECT_EQ(result.status, compare::Status::differ);
  EXPECT_LT(result.metrics->max_abs, 2);
  EXPECT_THAT(result.reason, HasSubstr("drift_max"));
  EXPECT_EQ(culprit(result), "object box (room.pov:14)") << compare::terminal_blame(result);
  EXPECT_THAT(compare::terminal_blame(result),
              HasSubstr("suspect brightness: box (room.pov:14): 1.0 % darker in linear light"))
      << compare::terminal_blame(result);
}

TEST_F(PlantedFaults, WrongNoiseTable) {
  const SceneResult result = with_fault("noise_generator 3", "noise_generator 1");
  EXPECT_EQ(result.status, compare::Status::differ);
  EXPECT_THAT(result.reason, HasSubstr("within_1_pct"));
  EXPECT_THAT(culprit(result), HasSubstr("feature noise")) << compare::terminal_blame(result);
}

}  // namespace
}  // namespace verisim
