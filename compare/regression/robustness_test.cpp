// What goes wrong in one scene is a line of the report, and the rest goes on: hostile pictures, sizes, folders and
// programs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Robustness : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(root() / "scenes");
    options_.oracle.program = root() / "no povray";
    options_.native = [this](const NativeRequest& request) {
      ++renders_;
      NativeResult out;
      out.outcome = NativeResult::Outcome::rendered;
      out.files_read = {request.scene, request.folder / "common.inc"};
      fs::copy_file(picture_, request.output);
      return out;
    };
    picture_ = root() / "plain.png";
    image::write_picture(scene_like_picture(32, 24), picture_);
  }
  const fs::path& root() const { return folder_.path(); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(root() / "scenes" / name, std::ios::binary) << text;
  }
  // A scene with its stored reference.
  void scene(const std::string& name, const std::string& reference, const std::string& more = "") {
    write(name, "//");
    manifest_ += "[[scene]]\nfile = \"" + name + "\"\nreference = \"" + reference + "\"\n" + more;
    write("verisim.toml", "width = 32\nheight = 24\n" + manifest_);
  }
  std::map<std::string, SceneResult> run() {
    last_ = run_suite(load_suite({root() / "scenes"}), options_);
    std::map<std::string, SceneResult> out;
    for (const SceneResult& s : last_.scenes) out[s.request.name] = s;
    return out;
  }

  TemporaryFolder folder_;
  RunOptions options_;
  compare::Run last_;
  fs::path picture_;
  std::string manifest_;
  std::atomic<int> renders_ = 0;
};

TEST_F(Robustness, BrokenReferencesAreErrorsOfTheirScenesOnly) {
  std::ifstream in(picture_, std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(in), {}};
  write("good.png", good);
  write("empty.png", "");
  write("truncated.png", good.substr(0, good.size() / 2));
  std::string corrupt = good;
  for (std::size_t i = 60; i < corrupt.size() - 20; i += 7) corrupt[i] = static_cast<char>(~corrupt[i]);
  write("corrupt.png", corrupt);
  std::string huge = good;  // a header that claims 2^31 - 1 pixels a side
  huge.replace(16, 8, "\x7f\xff\xff\xff\x7f\xff\xff\xff");
  write("huge.png", huge);
  write("text.png", "not a picture");
  image::write_picture(scene_like_picture(1, 1), root() / "scenes/tiny.png");
  for (const char* name : {"good", "empty", "truncated", "corrupt", "huge", "text", "tiny"})
    scene(std::string(name) + ".pov", std::string(name) + ".png");
  auto r = run();
  EXPECT_EQ(r["good.pov"].status, Status::exact) << r["good.pov"].reason;
  for (const char* name : {"empty.pov", "truncated.pov", "corrupt.pov", "huge.pov", "text.pov"}) {
    EXPECT_EQ(r[name].status, Status::oracle_failed) << name;
    EXPECT_FALSE(r[name].reason.empty()) << name;
  }
  EXPECT_EQ(r["tiny.pov"].status, Status::error);
  EXPECT_THAT(r["tiny.pov"].reason, HasSubstr("1x1"));
  EXPECT_EQ(last_.summary.scenes, 7);
  EXPECT_FALSE(json_report(last_).empty());
  EXPECT_FALSE(html_report(last_).empty());
}

TEST_F(Robustness, OnePixel) {
  picture_ = root() / "one.png";
  image::write_picture(constant_picture(1, 1, 10, 20, 30), picture_);
  fs::copy_file(picture_, root() / "scenes/one.png");
  scene("one.pov", "one.png", "width = 1\nheight = 1\n");
  auto r = run();
  EXPECT_EQ(r["one.pov"].status, Status::exact) << r["one.pov"].reason;
  EXPECT_FALSE(html_report(last_).empty());
}

// 400 million pixels: refused before anything is rendered when the machine cannot hold them.
TEST_F(Robustness, PicturesThatDoNotFitInMemory) {
  fs::copy_file(picture_, root() / "scenes/good.png");
  scene("large.pov", "good.png", "width = 20000\nheight = 20000\n");
  scene("good.pov", "good.png");
  options_.memory_limit = std::uint64_t{4} << 30;
  auto r = run();
  EXPECT_EQ(r["large.pov"].status, Status::error);
  EXPECT_THAT(r["large.pov"].reason,
              HasSubstr("400.0 million pixels take about 19.4 GiB to compare, and 4.0 GiB are available"));
  EXPECT_EQ(r["good.pov"].status, Status::exact);
  EXPECT_EQ(renders_.load(), 1);
  EXPECT_GT(available_bytes(), 0u);
}

TEST_F(Robustness, AThousandScenes) {
  for (int i = 0; i < 1000; ++i) {
    const fs::path folder = root() / "scenes" / std::to_string(i / 200);
    fs::create_directories(folder);
    std::ofstream(folder / ("s" + std::to_string(i) + ".pov")) << "//";
  }
  options_.baseline = root() / "baseline";
  options_.jobs = 2;
  image::write_picture(scene_like_picture(4, 3), picture_ = root() / "small.png");
  SuiteDefaults small;
  small.width = 4, small.height = 3;
  const Suite suite = load_suite({root() / "scenes"}, small);
  ASSERT_EQ(suite.scenes.size(), 1000u);
  compare::Run first = run_suite(suite, options_);
  EXPECT_EQ(update_baseline(first, options_.baseline, false).size(), 1000u);
  EXPECT_EQ(first.summary.scenes, 1000);
  EXPECT_LT(html_report(first).size(), std::size_t{10} << 20);
  Filter some;
  some.names = {"3/*"};
  const compare::Run second = run_suite(filter(suite, some), options_);
  EXPECT_EQ(second.summary.count.at(Status::exact), 200);
}

TEST_F(Robustness, ReportsThatCannotBeWrittenSaySo) {
  try {
    write_report("text", "/proc/verisim/report.html");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/proc/verisim/report.html"));
  }
  EXPECT_THROW(write_report("text", root()), std::runtime_error);  // a folder
  EXPECT_TRUE(fs::is_directory(root()));
}

// Whatever the scene read decides whether a kept result still holds.
TEST_F(Robustness, AChangedIncludeFileIsNotResumed) {
  fs::copy_file(picture_, root() / "scenes/good.png");
  write("common.inc", "#declare A = 1;");
  scene("a.pov", "good.png");
  options_.work = root() / "work", options_.resume = true;
  run(), run();
  EXPECT_EQ(renders_.load(), 1);
  write("common.inc", "#declare A = 2;");
  run();
  EXPECT_EQ(renders_.load(), 2);
  image::write_picture(changed(scene_like_picture(32, 24), [](double v) { return v / 2; }),
                       root() / "scenes/good.png");  // the reference, too
  EXPECT_EQ(run()["a.pov"].status, Status::differ);
  EXPECT_EQ(renders_.load(), 3);
  options_.native_identity = "another build";
  run();
  EXPECT_EQ(renders_.load(), 4);
  run();
  EXPECT_EQ(renders_.load(), 4);
  EXPECT_EQ(last_.scenes[0].status, Status::differ);
  std::ofstream(root() / "work/a.pov.result.json")
      << "{\"key\": 3, \"files_read\": [";  // broken off while it was written
  run();
  EXPECT_EQ(renders_.load(), 5);
}

TEST_F(Robustness, PhotographsAreFittedAndTheFitIsReported) {
  Picture photo = changed(scene_like_picture(64, 48), [](double v) { return 255 * std::pow(v / 255, 1.0) * 0.7; });
  image::write_picture(photo, root() / "scenes/photo.png");
  scene("a.pov", "photo.png",
        "crop = [0, 0, 64, 48]\nfit = [\"exposure\", \"white_balance\"]\nthresholds = { max_rmse = 255 }\n");
  auto r = run();
  ASSERT_TRUE(r["a.pov"].fit) << r["a.pov"].reason;
  EXPECT_TRUE(r["a.pov"].fit->resampled);
  EXPECT_LT(r["a.pov"].fit->stops, -0.5);
  EXPECT_THAT(json_report(last_), HasSubstr("white_balance"));
  EXPECT_THAT(terminal_table(last_), HasSubstr("exposure -"));
  EXPECT_THAT(html_report(last_), HasSubstr("averaged to the render's size"));
}

TEST_F(Robustness, OthersStandBesideOursInFrontOfAPhotograph) {
  image::write_picture(scene_like_picture(64, 48), root() / "scenes/photo.png");
  const auto blurred = [](const NativeRequest& request) {
    image::write_picture(resampled(resampled(scene_like_picture(32, 24), 4, 3), 32, 24), request.output);
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered;
    return out;
  };
  options_.beside["path"] = blurred;
  scene("a.pov", "photo.png",
        "crop = [0, 0, 64, 48]\nbeside = [\"path\", \"cp ../../plain.png {out} # {scene}\", \"exit 3 # {scene} "
        "{out}\"]\n");
  const SceneResult r = run()["a.pov"];
  ASSERT_EQ(r.verisimilitude.size(), 4u) << r.reason;
  EXPECT_LT(r.verisimilitude[0].ciede2000_mean, r.verisimilitude[1].ciede2000_mean);
  EXPECT_THAT(r.verisimilitude[3].failed, HasSubstr("exit status 3"));
  EXPECT_THAT(terminal_table(last_), HasSubstr("verisimilitude (mean CIEDE2000): verisim"));
  EXPECT_THAT(terminal_table(last_), HasSubstr("is nearest"));
  EXPECT_THAT(html_report(last_), HasSubstr("verisim is nearest"));
  EXPECT_THAT(json_report(last_), HasSubstr("\"renderer\": \"path\""));
}

TEST_F(Robustness, AKnownAnswerDecides) {
  const Picture right = constant_picture(32, 24, 51, 51, 51),
                wrong = constant_picture(32, 24, 60, 60, 60);  // 0.2 is true
  image::write_picture(right, root() / "right.png");
  image::write_picture(wrong, root() / "scenes/wrong.png");
  image::write_picture(right, root() / "scenes/right.png");
  const std::string truth =
      "truth = { formula = \"one fifth\", tolerance = 0.001, points = [[3, 4, 0.2], [10, 10, 0.2, 0.2, 0.2]] }\n";
  scene("ours_is_right.pov", "wrong.png", truth);
  scene("both.pov", "right.png", truth);
  picture_ = root() / "right.png";
  auto r = run();
  EXPECT_EQ(r["ours_is_right.pov"].status, Status::match);
  EXPECT_THAT(r["ours_is_right.pov"].reason, HasSubstr("the reference misses by 0.035"));
  EXPECT_EQ(r["both.pov"].status, Status::exact);
  EXPECT_THAT(html_report(last_), HasSubstr("one fifth"));
  fs::copy_file(root() / "scenes/wrong.png", root() / "right.png",
                fs::copy_options::overwrite_existing);  // now we are wrong
  r = run();
  EXPECT_EQ(r["ours_is_right.pov"].status, Status::differ) << "although both agree";
  EXPECT_THAT(r["both.pov"].reason, HasSubstr("known answer is missed by 0.035"));
}

}  // namespace
}  // namespace verisim::compare
