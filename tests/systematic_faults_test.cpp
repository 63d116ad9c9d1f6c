// Faults that move no pixel by more than a few code values and yet are systematic: planted in the program, whose
// pictures are compared as `verisim compare` does it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "compare/compare.h"
#include "compare/oracle/working_copy.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;
using compare::SceneResult;
using compare::Status;
using testing::HasSubstr;

constexpr const char* kScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 0, 0> right 4/3*x }
light_source { <-5, 8, -6> rgb 1 }
plane { y, -1 pigment { rgb <0.5, 0.45, 0.4> } }
sphere { <-1.5, 0, 0>, 0.8 pigment { rgb <0.6, 0.2, 0.1> } }
sphere { <0.2, -0.4, -1>, 0.16 pigment { rgb <0.05, 0.04, 0.03> } finish { diffuse 0.8 } }
prism { linear_sweep 0, 0.5, 5, <0, 0>, <1, 0>, <1.0, 1>, <0, 1>, <0, 0> rotate 20*y translate <0.6, -1, 0> pigment {
rgb <0.3, 0.6, 0.3> } }
fog { distance 200 rgb <0.6, 0.65, 0.7> }
)";

class SystematicFaults : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "scenes");
    std::ofstream(folder_.path() / "scenes/room.pov") << kScene;
    suite_ = compare::load_suite({folder_.path() / "scenes"}, {160, 120, {"-A"}});
    options_.reference = options_.native = compare::native_program(program());
    options_.tags = compare::tags_of_program(program());
    options_.reference_name = "the right one";
  }
  static fs::path program() { return fs::path(VERISIM_BINARY_DIR) / "bin/verisim"; }

  SceneResult run() { return compare::run_suite(suite_, options_).scenes.at(0); }
  SceneResult with_fault(const std::string& from, const std::string& to) {
    options_.native = [=](const compare::NativeRequest& request) {
      std::string scene = kScene;
      const std::size_t at = scene.find(from);
      EXPECT_NE(at, std::string::npos) << from;
      std::ofstream(request.scene) << scene.replace(at, from.size(), to);
      return compare::native_program(program())(request);
    };
    return run();
  }

  compare::TemporaryFolder folder_;
  compare::Suite suite_;
  compare::RunOptions options_;
};

TEST_F(SystematicFaults, NoFaultNoAlarm) { EXPECT_EQ(run().status, Status::exact); }

TEST_F(SystematicFaults, OneDarkObjectOnePerCentDarker) {
  const SceneResult result = with_fault("diffuse 0.8", "diffuse 0.792");
  EXPECT_EQ(result.status, Status::differ);
  EXPECT_LT(result.metrics->max_abs, 1) << "no pixel by a code value";
  EXPECT_LT(result.metrics->drift_max, 0.25) << "nor any block in a picture of 8 bits";
}

TEST_F(SystematicFaults, FogTwoPerCentFurther) {
  const SceneResult result = with_fault("distance 200", "distance 204");
  EXPECT_EQ(result.status, Status::differ) << result.metrics->drift_max;
}

TEST_F(SystematicFaults, APrismsVertexMoved) {
  for (const char* x : {"<1.01, 1>", "<1.02, 1>", "<1.05, 1>"}) {
    const SceneResult result = with_fault("<1.0, 1>", x);
    EXPECT_EQ(result.status, Status::differ) << x;
  }
}

TEST_F(SystematicFaults, TheWholePictureOneCodeValueDown) {
  for (const char* bits : {"+FN16", "+FN8"}) {
    suite_.scenes[0].switches = {"-A", bits};
    options_.native = [](const compare::NativeRequest& request) {
      const compare::NativeResult result = compare::native_program(program())(request);
      image::Picture picture = image::read_picture(request.output);
      for (float& v : picture.samples) v = std::max(0.0f, v - 1 / 255.0f);
      image::write_picture(picture, request.output);
      return result;
    };
    EXPECT_EQ(run().status, Status::differ) << bits;
  }
}

TEST_F(SystematicFaults, TheManifestMayAllowThem) {
  suite_.scenes[0].allowed = {.solid_pixels = 0, .drift_max = 1, .one_sided_pixels = 20000, .leaning = 1};
  EXPECT_EQ(with_fault("distance 200", "distance 204").status, Status::exact);
}

}  // namespace
}  // namespace verisim
