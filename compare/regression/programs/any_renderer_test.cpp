// Renderers that are neither POV-Ray nor verisim, on both sides, and what a manifest may say of their scenes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "compare/compare.h"
#include "compare/layers/test_exr.h"
#include "compare/metrics/test_pictures.h"
#include "compare/oracle/working_copy.h"
#include "compare/regression/programs/command_renderer.h"
#include "compare/regression/ignored.h"
#include "compare/regression/run_folder.h"
#include "compare/regression/stored_variance.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using testing::HasSubstr;
namespace {

constexpr int kRendererWidth = 48, kRendererHeight = 32;

// The same picture for every scene, with some pixels in the upper left corner white.
NativeRenderer with_patch(int size) {
  return [size](const NativeRequest& request) {
    Picture picture = scene_like_picture(kRendererWidth, kRendererHeight);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        for (int c = 0; c < 3; ++c) picture.samples[static_cast<std::size_t>((y * kRendererWidth + x) * 3 + c)] = 1;
    image::write_picture(picture, request.output);
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered, out.files_read = {request.scene};
    return out;
  };
}

class AnyRenderer : public testing::Test {
 protected:
  AnyRenderer() {
    fs::create_directories(root() / "scenes");
    std::ofstream(root() / "scenes/room.xml") << "<scene/>";
    options_.native = with_patch(4), options_.reference = with_patch(0), options_.reference_name = "other";
  }
  fs::path root() const { return folder_.path(); }
  SceneResult run(const std::string& keys) {
    std::ofstream(root() / "scenes/verisim.toml")
        << "width = " << kRendererWidth << "\nheight = " << kRendererHeight << "\n[[scene]]\nfile = \"*.xml\"\n"
        << keys;
    last_ = run_suite(load_suite({root() / "scenes"}), options_);
    return last_.scenes.at(0);
  }

  TemporaryFolder folder_;
  RunOptions options_;
  compare::Run last_;
};

TEST_F(AnyRenderer, StandsInThePlaceOfPovray) {
  const SceneResult scene = run("");
  EXPECT_EQ(scene.status, Status::differ) << scene.reason;
  EXPECT_EQ(scene.metrics->max_abs > 50, true);
  EXPECT_EQ(last_.reference_name, "other");
  EXPECT_EQ(last_.oracle_version, "");
  options_.native = with_patch(0);
  EXPECT_EQ(run("").status, Status::exact);
}

TEST_F(AnyRenderer, SoManyPixelsMayBeWrong) {
  EXPECT_EQ(run("fail = { pixels = 16 }\n").status, Status::match);
  const SceneResult scene = run("fail = { absolute = 1, pixels = 15 }\n");
  EXPECT_EQ(scene.status, Status::differ);
  EXPECT_EQ(scene.reason.substr(0, 21), "pixels_beyond 16 > 15");
}

TEST_F(AnyRenderer, WarningsFailNothing) {
  const SceneResult scene = run("fail = { pixels = 16 }\nwarn = { max_max_abs = 10 }\n");
  EXPECT_EQ(scene.status, Status::match);
  EXPECT_THAT(scene.reason, HasSubstr("warning: max_abs"));
}

TEST_F(AnyRenderer, IgnoredPixelsAreNotCompared) {
  EXPECT_EQ(run("ignore = { rectangles = [[0, 0, 4, 4]] }\n").status, Status::exact);
  EXPECT_EQ(run("ignore = { rectangles = [[0, 0, 4, 2]] }\n").status, Status::differ);
  Picture mask = constant_picture(kRendererWidth, kRendererHeight, 0, 0, 0);
  for (int y = 0; y < 4; ++y) std::fill_n(mask.samples.begin() + y * kRendererWidth * 3, 12, 1.0f);
  image::write_picture(mask, root() / "scenes/mask.png");
  EXPECT_EQ(run("ignore = { mask = \"mask.png\" }\n").status, Status::exact);
  const SceneResult scene = run("ignore = { objects = [\"sphere\"] }\n");
  EXPECT_EQ(scene.status, Status::error);
  EXPECT_THAT(scene.reason, HasSubstr("nothing says which pixels show it"));
}

TEST(Ignored, ObjectsAreKnownByTheirTags) {
  PixelTags tags;
  tags.width = 2, tags.height = 1;
  tags.tags = {{"object", "sphere (room.pov:7)"}, {"light", "sphere light"}};
  tags.sets = {{0}, {1}}, tags.set_of = {0, 1};
  Picture a = constant_picture(2, 1, 9, 9, 9), b = a;
  EXPECT_EQ(ignore_pixels(Ignored{{}, {}, {"sphere"}}, &tags, a, b), (std::vector<unsigned char>{1, 0}));
  EXPECT_EQ(a.samples[0], 0);
  EXPECT_GT(a.samples[3], 0);
}

TEST_F(AnyRenderer, TheNearestOfSeveralReferencesCounts) {
  image::write_picture(scene_like_picture(kRendererWidth, kRendererHeight), root() / "scenes/one.png");
  NativeRequest request;
  request.output = root() / "scenes/two.png";
  options_.native(request);
  EXPECT_EQ(run("reference = [\"one.png\", \"two.png\"]\n").status, Status::exact);
  EXPECT_EQ(run("reference = \"one.png\"\n").status, Status::differ);
}

// Both sides write a depth of their own beside the same picture.
NativeRenderer with_depth(float depth) {
  return [depth](const NativeRequest& request) {
    const std::vector<float> grey(kRendererWidth * kRendererHeight, 0.5f), far(kRendererWidth * kRendererHeight, depth);
    ExrWriter(kRendererWidth, kRendererHeight,
              {{"", {floats("R", grey), floats("G", grey), floats("B", grey), floats("Z", far)}}})
        .write(request.output);
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered, out.files_read = {request.scene};
    return out;
  };
}

TEST_F(AnyRenderer, LayersAreJudgedWithTheirOwnLimits) {
  options_.native = with_depth(10.1f), options_.reference = with_depth(10);
  const std::string exr = "switches = \"+FE\"\n";
  const SceneResult plain = run(exr);
  EXPECT_EQ(plain.status, Status::differ);
  EXPECT_THAT(plain.reason, HasSubstr("layer Z: 1536 pixels differ"));
  EXPECT_THAT(json_report(last_), HasSubstr("\"kind\": \"depth\""));
  EXPECT_EQ(run(exr + "layers = [\"Z:relative=0.02\"]\n").status, Status::match);
  EXPECT_EQ(run(exr + "layers = [\"Z:ignore\"]\n").status, Status::exact);
  EXPECT_THROW(run(exr + "layers = [\"Z:nonsense=1\"]\n"), std::runtime_error);
}

TEST_F(AnyRenderer, MistakesInManifestsAreNamed) {
  const auto message = [&](const std::string& keys) {
    try {
      run(keys);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message("fail = { rmse = 1 }\n"), HasSubstr("unknown threshold 'rmse'"));
  EXPECT_THAT(message("fail = { pixels = -1 }\n"), HasSubstr("must not be negative"));
  EXPECT_THAT(message("ignore = { object = [\"a\"] }\n"), HasSubstr("unknown key 'object' of 'ignore'"));
  EXPECT_THAT(message("ignore = { rectangles = [[1, 2, 3]] }\n"), HasSubstr("rectangles"));
  EXPECT_THAT(message("reference = []\n"), HasSubstr("names no picture"));
  EXPECT_THAT(message("corners = [[1, 2]]\n"), HasSubstr("four points"));
}

// A noisy renderer: its runs are stored once, and one render is enough later.
TEST_F(AnyRenderer, NoiseIsStoredWithABaseline) {
  int renders = 0;
  double brighter = 1;
  options_.reference = {};
  options_.native = [&](const NativeRequest& request) {
    std::mt19937 generator(static_cast<unsigned>(++renders));
    std::normal_distribution<double> noise(0, 5);
    image::write_picture(
        changed(scene_like_picture(kRendererWidth, kRendererHeight),
                [&](double v) { return std::clamp(std::round(brighter * v + noise(generator)), 0.0, 255.0); }),
        request.output);
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered, out.files_read = {request.scene};
    return out;
  };
  options_.baseline = root() / "baseline", options_.work = root() / "work", options_.runs = 6;
  const std::string stochastic = "class = \"stochastic\"\n";
  EXPECT_EQ(run(stochastic).status, Status::added);
  EXPECT_EQ(renders, 6);
  update_baseline(last_, options_.baseline, false);
  EXPECT_TRUE(fs::exists(options_.baseline / "room.xml.deviation-of-6.png"));
  const SceneResult again = run(stochastic);
  EXPECT_EQ(again.status, Status::match) << again.reason;
  EXPECT_EQ(renders, 7);
  EXPECT_TRUE(fs::exists(again.p_map));
  EXPECT_TRUE(update_baseline(last_, options_.baseline, true).empty());  // nothing changed
  brighter = 1.15;
  EXPECT_EQ(run(stochastic).status, Status::differ);
  // The run is kept, and read back as it was.
  const KeptRun kept = load_run(options_.work);
  ASSERT_EQ(kept.run.scenes.size(), 1u);
  EXPECT_EQ(kept.run.scenes[0].reason, last_.scenes[0].reason);
  EXPECT_EQ(kept.run.scenes[0].metrics->histogram, last_.scenes[0].metrics->histogram);
  EXPECT_EQ(kept.baseline, options_.baseline);
}

}  // namespace
}  // namespace verisim::compare
