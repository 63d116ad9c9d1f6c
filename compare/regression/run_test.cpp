// Whole runs with a script in the place of POV-Ray and a function in the place of our renderer; manifests, filters,
// baselines, bench.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"
#include "compare/metrics/values.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
namespace {

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}
void script(const fs::path& path, const std::string& text) {
  write(path, "#!/bin/sh\n" + text);
  chmod(path.c_str(), 0755);
}

// OpenEXR, as renderers write it.
void write_linear(const Picture& picture, const fs::path& path) {
  render::Framebuffer frame;
  frame.width = picture.width, frame.height = picture.height;
  for (std::size_t i = 0; i < picture.samples.size(); i += 3)
    frame.pixels.push_back(Color{picture.samples[i], picture.samples[i + 1], picture.samples[i + 2], 0, 0});
  image::OutputOptions options;
  options.format = image::Format::exr;
  image::write(frame, path, options);
}

Filter chosen(std::vector<std::string> names, std::vector<std::string> tags) {
  Filter f;
  f.names = std::move(names), f.tags = std::move(tags);
  return f;
}
Filter failed_in(const fs::path& report) {
  Filter f;
  f.failed_last_time = true, f.last_report = report;
  return f;
}

// Every scene file holds the name of the picture that the oracle will answer with.
class RunTest : public testing::Test {
 protected:
  RunTest() {
    image::write_picture(scene_like_picture(32, 24), pictures() / "plain.png");
    image::write_picture(changed(scene_like_picture(32, 24), [](double v) { return std::min(255.0, v + 30); }),
                         pictures() / "bright.png");
    std::mt19937 random(5);
    for (int i = 1; i <= 8; ++i) {
      std::normal_distribution<double> noise(0, 8);
      image::write_picture(changed(scene_like_picture(32, 24),
                                   [&](double v) { return std::clamp(std::round(v + noise(random)), 0.0, 255.0); }),
                           pictures() / fmt::format("noisy{}.png", i));
    }
    script(root() / "pov",
           "if [ \"$1\" = --version ]; then echo 'POV-Ray 3.7.test'; exit 0; fi\n"
           "for a in \"$@\"; do case \"$a\" in +I*) in=\"${a#+I}\";; +O*) out=\"${a#+O}\";; +WT*) t=\"${a#+WT}\";; "
           "esac; done\n"
           "echo \"$in\" >> " +
               (root() / "oracle.log").string() +
               "\n"
               "case $(cat $in) in crash) kill -SEGV $$;; hang) sleep 60;; noisy) cp " +
               pictures().string() + "/noisy$t.png $out;; *) cp " + pictures().string() + "/plain.png $out;; esac\n");
    options_.oracle.program = root() / "pov";
    options_.oracle.cache = root() / "cache";
    options_.oracle.time_limit = 20;
    options_.native = [this](const NativeRequest& request) { return native(request); };
    options_.native_version = "test 1";
  }

  const fs::path& root() const { return folder_.path(); }
  fs::path pictures() const {
    fs::create_directories(root() / "pictures");
    return root() / "pictures";
  }
  void scene(const std::string& name, const std::string& text) { write(root() / "scenes" / name, text); }
  Suite suite() const { return load_suite({root() / "scenes"}, {32, 24, {"-A"}}); }
  std::map<std::string, SceneResult> run() {
    last_ = run_suite(suite(), options_);
    std::map<std::string, SceneResult> out;
    for (const SceneResult& s : last_.scenes) out[s.request.name] = s;
    return out;
  }
  int oracle_runs() const {
    std::ifstream in(root() / "oracle.log");
    return static_cast<int>(std::count(std::istreambuf_iterator<char>(in), {}, '\n'));
  }

  NativeResult native(const NativeRequest& request) {
    ++native_runs_;
    std::ifstream in(request.scene);
    std::string text;
    std::getline(in, text);
    NativeResult out;
    out.files_read = {request.scene};
    if (text == "throws") throw std::runtime_error("thrown");
    if (text == "unsupported" || text == "bad") {
      out.outcome = text == "bad" ? NativeResult::Outcome::error : NativeResult::Outcome::unsupported;
      out.message = request.scene.string() + ":1:1: isosurface";
      return out;
    }
    out.outcome = NativeResult::Outcome::rendered;
    if (text == "noisy") out.stochastic_features = {"radiosity"};
    if (text == "forgets") return out;
    fs::copy_file(pictures() / (text == "noisy"                   ? fmt::format("noisy{}.png", 2 + 2 * request.run)
                                : text == "bright" || all_bright_ ? "bright.png"
                                                                  : "plain.png"),
                  request.output);
    out.seconds = 0.5, out.rays = {{"camera", 768}};
    return out;
  }

  TemporaryFolder folder_;
  RunOptions options_;
  compare::Run last_;
  std::atomic<int> native_runs_{0};
  bool all_bright_ = false;
};

TEST_F(RunTest, EveryOutcomeAndTheRestGoesOn) {
  scene("a/plain.pov", "plain");
  scene("bright.pov", "bright");
  scene("unsupported.pov", "unsupported");
  scene("bad.pov", "bad");
  scene("throws.pov", "throws");
  scene("forgets.pov", "forgets");
  scene("crash.pov", "crash");
  scene("hang.pov", "hang");
  scene("noisy.pov", "noisy");
  options_.oracle.time_limit = 0.5;
  options_.jobs = 3;
  auto r = run();
  EXPECT_EQ(r.size(), 9u);
  EXPECT_EQ(r["a/plain.pov"].status, Status::exact);
  EXPECT_EQ(r["bright.pov"].status, Status::differ);
  EXPECT_THAT(r["bright.pov"].reason, HasSubstr("within_1_pct"));
  EXPECT_FALSE(r["bright.pov"].suspicions.empty());
  EXPECT_THAT(terminal_table(last_), HasSubstr("suspect"));
  EXPECT_EQ(r["unsupported.pov"].status, Status::unsupported);
  EXPECT_EQ(r["unsupported.pov"].reason, (root() / "scenes/unsupported.pov").string() + ":1:1: isosurface");
  EXPECT_EQ(r["bad.pov"].status, Status::error);
  EXPECT_EQ(r["throws.pov"].reason, "thrown");
  EXPECT_THAT(r["forgets.pov"].reason, HasSubstr("no picture"));
  EXPECT_EQ(r["crash.pov"].status, Status::oracle_failed);
  EXPECT_EQ(r["hang.pov"].status, Status::oracle_failed);
  EXPECT_THAT(r["hang.pov"].reason, HasSubstr("0.5 s"));
  EXPECT_EQ(r["noisy.pov"].status, Status::match) << r["noisy.pov"].reason;
  EXPECT_EQ(r["noisy.pov"].scene_class, SceneClass::stochastic);
  EXPECT_TRUE(r["noisy.pov"].noise_low_pass);
  EXPECT_EQ(last_.summary.count[Status::oracle_failed], 2);
  EXPECT_TRUE(last_.summary.failed());
  EXPECT_TRUE(fs::exists(r["bright.pov"].native_picture));
  const fs::path kept = r["bright.pov"].native_picture;
  last_ = {};
  EXPECT_FALSE(fs::exists(kept)) << "the temporary pictures go with the run";
}

TEST_F(RunTest, ReplayJudgesNoisyScenesLikeAnyOther) {
  scene("noisy.pov", "noisy");
  options_.replay = true;
  EXPECT_EQ(run()["noisy.pov"].status, Status::differ);
  EXPECT_EQ(oracle_runs(), 1);
}

// A reference whose picture hangs on the number of its threads.
TEST_F(RunTest, AReferenceThatDiffersFromItselfSaysSo) {
  scene("unsteady.pov", "noisy");
  std::string ours = "noisy3.png";
  options_.native = [&](const NativeRequest& request) {
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered, out.files_read = {request.scene};
    fs::copy_file(pictures() / ours, request.output);
    return out;
  };
  SceneResult r = run()["unsteady.pov"];
  EXPECT_EQ(r.status, Status::match);
  EXPECT_THAT(r.reason, testing::StartsWith("the reference differs from itself in another run, at "));
  EXPECT_EQ(oracle_runs(), 2);
  ours = "noisy5.png";  // as neither of its runs
  r = run()["unsteady.pov"];
  EXPECT_EQ(r.status, Status::differ);
  EXPECT_THAT(r.reason, HasSubstr("; the reference differs from itself in another run"));
}

// Odd numbers of threads on the oracle's side; a second POV-Ray would take the even ones.
TEST_F(RunTest, SeveralRunsAskWelch) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 6);
  for (int i = 1; i <= 12; ++i)
    image::write_picture(
        changed(scene_like_picture(32, 24),
                [&](double v) { return std::clamp(std::round(v + noise(random) + (i > 8 ? 1 : 0)), 0.0, 255.0); }),
        pictures() / ("noisy" + std::to_string(i) + ".png"));
  scene("noisy.pov", "noisy");
  options_.runs = 4;
  int first = 2, step = 2;
  std::vector<int> asked;
  options_.native = [&](const NativeRequest& request) {
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered;
    out.files_read = {request.scene}, out.stochastic_features = {"radiosity"};
    asked.push_back(request.run);
    fs::copy_file(pictures() / ("noisy" + std::to_string(first + step * (request.run % 4)) + ".png"), request.output);
    return out;
  };
  auto r = run();
  EXPECT_THAT(asked, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(oracle_runs(), 4);
  EXPECT_EQ(r["noisy.pov"].status, Status::match) << r["noisy.pov"].reason;
  ASSERT_TRUE(r["noisy.pov"].welch);
  EXPECT_FALSE(r["noisy.pov"].welch->rejected);
  first = 9, step = 1;  // brighter by a code value: less than the low-pass comparison finds
  asked.clear();
  r = run();
  EXPECT_EQ(r["noisy.pov"].status, Status::differ);
  ASSERT_TRUE(r["noisy.pov"].welch) << r["noisy.pov"].reason;
  EXPECT_EQ(asked.size(), 12u) << "a refusal is tried again with twice as many others";
  EXPECT_EQ(oracle_runs(), 12) << "four of them from the cache";
  EXPECT_GT(r["noisy.pov"].welch->mean_difference, 0.5);
}

// The first runs of each side are alike by chance and pass for a place without noise; others show it. Together with the
// first ones they would still be refused.
TEST_F(RunTest, ARefusalIsTriedAgainWithTwiceAsManyOthers) {
  const auto spot = [&](int value, const std::string& name) {
    Picture p = scene_like_picture(32, 24);
    for (int c = 0; c < 3; ++c)
      p.samples[static_cast<std::size_t>(3 * (12 * 32 + 16) + c)] = static_cast<float>(value) / 255;
    image::write_picture(p, pictures() / name);
  };
  for (int i = 1; i <= 7; i += 2) spot(118, "noisy" + std::to_string(i) + ".png");
  for (int i = 0; i < 12; ++i) spot(i < 4 ? 90 : i % 2 ? 116 : 120, "ours" + std::to_string(i) + ".png");
  scene("noisy.pov", "noisy");
  options_.runs = 4;
  options_.native = [&](const NativeRequest& request) {
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered;
    out.files_read = {request.scene}, out.stochastic_features = {"area light jitter"};
    fs::copy_file(pictures() / ("ours" + std::to_string(request.run) + ".png"), request.output);
    return out;
  };
  auto r = run();
  EXPECT_EQ(r["noisy.pov"].status, Status::match) << r["noisy.pov"].reason;
  EXPECT_EQ(oracle_runs(), 12);
}

TEST_F(RunTest, SecondRunTakesTheOracleFromItsCache) {
  scene("plain.pov", "plain");
  scene("noisy.pov", "noisy");
  run();
  const int before = oracle_runs();
  EXPECT_TRUE(run()["plain.pov"].oracle_cached);
  EXPECT_EQ(oracle_runs(), before);
}

TEST_F(RunTest, BrokenOffRunsGoOn) {
  scene("a.pov", "plain");
  scene("b.pov", "plain");
  scene("c.pov", "bright");
  options_.work = root() / "work";
  std::atomic<bool> cancel = false;
  options_.cancel = &cancel;
  options_.progress = [&](const Progress& p) { cancel = p.done == 1; };
  EXPECT_EQ(run().size(), 1u);
  EXPECT_TRUE(last_.cancelled);
  EXPECT_EQ(native_runs_, 1);
  cancel = false;
  options_.resume = true;
  options_.progress = nullptr;
  auto r = run();
  EXPECT_EQ(native_runs_, 3);
  EXPECT_EQ(r["a.pov"].status, Status::exact);
  EXPECT_TRUE(r["a.pov"].metrics);
  EXPECT_TRUE(fs::exists(r["a.pov"].native_picture));
  scene("a.pov", "bright");  // changed: not resumed
  EXPECT_EQ(run()["a.pov"].status, Status::differ);
  EXPECT_EQ(native_runs_, 4);
  options_.native_version = "test 2";
  run();
  EXPECT_EQ(native_runs_, 7);
}

TEST_F(RunTest, ProgressCountsAndEstimates) {
  for (char c = 'a'; c <= 'e'; ++c) scene(std::string(1, c) + ".pov", c == 'c' ? "bright" : "plain");
  std::vector<int> done;
  int failed = 0;
  options_.progress = [&](const Progress& p) {
    done.push_back(p.done), failed = p.failed;
    EXPECT_EQ(p.total, 5);
    EXPECT_GE(p.seconds_left, 0);
    EXPECT_TRUE(p.finished);
  };
  run();
  EXPECT_THAT(done, ElementsAre(1, 2, 3, 4, 5));
  EXPECT_EQ(failed, 1);
}

TEST_F(RunTest, TrendAgainstThePreviousReport) {
  scene("a.pov", "plain");
  run();
  options_.previous_report = root() / "report.json";
  write_report(json_report(last_), options_.previous_report);
  all_bright_ = true;
  auto r = run();
  EXPECT_EQ(r["a.pov"].previous, Status::exact);
  EXPECT_EQ(r["a.pov"].previous_rmse, 0);
  EXPECT_THAT(terminal_table(last_), HasSubstr("was exact"));
  std::ofstream(options_.previous_report) << "[1,2";
  EXPECT_THROW(run(), std::runtime_error);
}

TEST_F(RunTest, BaselineNeedsNoOracle) {
  scene("a.pov", "plain");
  scene("x/b.pov", "noisy");
  options_.oracle.program = root() / "missing";
  options_.baseline = root() / "baseline";
  auto r = run();
  EXPECT_EQ(r["a.pov"].status, Status::added);
  EXPECT_THAT(r["a.pov"].reason, HasSubstr("no stored picture"));
  EXPECT_THAT(update_baseline(last_, options_.baseline, true), ElementsAre("a.pov: new", "x/b.pov: new"));
  EXPECT_FALSE(fs::exists(options_.baseline));
  update_baseline(last_, options_.baseline, false);
  std::ifstream in(options_.baseline / "baseline.json");
  const auto list = nlohmann::json::parse(in);
  EXPECT_EQ(list["version"], "test 1");
  EXPECT_EQ(list["scenes"]["x/b.pov"]["picture"], "x__b.pov.png");
  r = run();
  EXPECT_EQ(r["a.pov"].status, Status::exact);
  EXPECT_EQ(r["x/b.pov"].status, Status::exact);
  EXPECT_TRUE(update_baseline(last_, options_.baseline, true).empty());
  all_bright_ = true;
  r = run();
  EXPECT_EQ(r["a.pov"].status, Status::differ);
  EXPECT_THAT(update_baseline(last_, options_.baseline, false), ElementsAre(HasSubstr("a.pov: changed: rmse")));
  EXPECT_EQ(run()["a.pov"].status, Status::exact);
}

TEST_F(RunTest, MissingOracleNamesThePackage) {
  scene("a.pov", "plain");
  options_.oracle.program = root() / "missing";
  EXPECT_THROW(run(), OracleMissing);
}

TEST_F(RunTest, UnwritableWorkFolder) {
  scene("a.pov", "plain");
  options_.work = "/proc/verisim";
  EXPECT_THROW(run(), std::runtime_error);
}

TEST_F(RunTest, StoredReferenceOfAnotherSizeIsAnError) {
  scene("a.pov", "plain");
  image::write_picture(random_picture(5, 5, 1), root() / "scenes/photo.png");
  write(root() / "scenes/verisim.toml",
        "width = 32\nheight = 24\n[[scene]]\nfile = \"a.pov\"\nreference = \"photo.png\"\n");
  options_.oracle.program = root() / "missing";  // not needed
  auto r = run();
  EXPECT_EQ(r["a.pov"].status, Status::error);
  EXPECT_THAT(r["a.pov"].reason, HasSubstr("differ in size"));
}

TEST_F(RunTest, SuiteOfAPlainFolder) {
  scene("b.pov", ""), scene("a/z.pov", ""), scene("a/note.txt", ""), scene(".hidden/x.pov", "");
  std::vector<std::string> names;
  for (const SceneRequest& s : suite().scenes) names.push_back(s.name);
  EXPECT_THAT(names, ElementsAre("a/z.pov", "b.pov"));
  EXPECT_THAT(load_suite({pictures()}).warnings, ElementsAre(HasSubstr("no scene")));
  EXPECT_THROW(load_suite({root() / "nothing.pov"}), std::runtime_error);
}

TEST_F(RunTest, ManifestSetsDefaultsAndScenes) {
  scene("one.pov", ""), scene("set/two.pov", ""), scene("set/three.pov", "");
  write(root() / "scenes/verisim.toml", R"(
width = 64
switches = "+A0.3 'Declare=x=1'"
tags = ["all"]
[[scene]]
file = "one.pov"
name = "first"
height = 48
class = "stochastic"
[[scene]]
file = "set/*.pov"
tags = ["set"]
switches = ["-A"]
thresholds = { max_rmse = 1.5, min_ssim_mean = 0.9 }
pixels_per_degree = 40
)");
  const Suite s = suite();
  ASSERT_EQ(s.scenes.size(), 3u);
  EXPECT_EQ(s.scenes[0].name, "first");
  EXPECT_EQ(s.scenes[0].width, 64);
  EXPECT_EQ(s.scenes[0].height, 48);
  EXPECT_THAT(s.scenes[0].switches, ElementsAre("+A0.3", "Declare=x=1"));
  EXPECT_TRUE(s.scenes[0].antialiased());
  EXPECT_EQ(s.scenes[0].scene_class, SceneClass::stochastic);
  EXPECT_EQ(s.scenes[1].name, "set/three.pov");
  EXPECT_DOUBLE_EQ(s.scenes[1].thresholds.at("max_rmse"), 1.5);
  EXPECT_DOUBLE_EQ(s.scenes[2].flip_pixels_per_degree, 40);
  const auto names = [&](const Filter& f) {
    std::vector<std::string> out;
    for (const SceneRequest& r : filter(s, f).scenes) out.push_back(r.name);
    return out;
  };
  EXPECT_THAT(names(chosen({}, {"set"})), ElementsAre("set/three.pov", "set/two.pov"));
  EXPECT_THAT(names(chosen({"*two*"}, {})), ElementsAre("set/two.pov"));
  EXPECT_THAT(names(chosen({"irs"}, {"all"})), ElementsAre("first"));
}

TEST_F(RunTest, ManifestErrorsHaveTheirPlace) {
  scene("one.pov", "");
  const auto message = [&](const std::string& text) -> std::string {
    write(root() / "scenes/verisim.toml", text);
    try {
      suite();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message("width = \n"), HasSubstr("verisim.toml:1:"));
  EXPECT_THAT(message("\nwitdh = 3\n"), testing::AllOf(HasSubstr(":2:"), HasSubstr("unknown key 'witdh'")));
  EXPECT_THAT(message("width = \"3\"\n"), HasSubstr("'width' must be a whole number"));
  EXPECT_THAT(message("width = 0\n"), HasSubstr("between 1 and"));
  EXPECT_THAT(message("class = \"random\"\n"), HasSubstr("'class' must be"));
  EXPECT_THAT(message("thresholds = {max_rsme = 1}\n"), HasSubstr("max_rsme"));
  EXPECT_THAT(message("switches = \"'open\"\n"), HasSubstr("quote"));
  EXPECT_THAT(message("[[scene]]\nname = \"x\"\n"), HasSubstr("needs 'file'"));
  EXPECT_THAT(message("[[scene]]\nfile = \"none.pov\"\n"), HasSubstr("none.pov"));
  EXPECT_THAT(message("[[scene]]\nfile = \"none*.pov\"\n"), HasSubstr("no scene is named"));
  EXPECT_THAT(message("scene = 3\n"), HasSubstr("[[scene]]"));
  EXPECT_THAT(message("[[scene]]\nfile = \"one.pov\"\npasses = [{ switches = \"-A\" }]\n"),
              HasSubstr("needs a 'matrix'"));
  EXPECT_THAT(message("[[scene]]\nfile = \"one.pov\"\npasses = [{ matrix = [[1, 2], [3, 4]] }]\n"),
              HasSubstr("three rows of three numbers"));
  EXPECT_EQ(message("width = 40\n"), "no error");
}

// Two renders that add up: red from the first one's blue, green from the second.
TEST_F(RunTest, PassesAddUpToOnePicture) {
  scene("bands.pov", "plain");
  write(root() / "scenes/verisim.toml",
        "width = 4\nheight = 3\n[[scene]]\nfile = \"bands.pov\"\npasses = [\n"
        "  { switches = \"Declare=Bands=0\", matrix = [[0, 0, 0.5], [0, 0, 0], [0, 0, 0]] },\n"
        "  { switches = \"Declare=Bands=1\", matrix = [[0, 0, 0], [0, 2, 0], [-1, 0, 0]] },\n]\n");
  options_.baseline = root() / "baseline";
  std::vector<std::vector<std::string>> asked;
  options_.native = [&](const NativeRequest& request) {
    asked.push_back(request.switches);
    Picture linear = constant_picture(4, 3, 0, 0, 0);
    for (std::size_t i = 0; i < linear.samples.size(); ++i) linear.samples[i] = std::array{0.25f, 0.125f, 0.5f}[i % 3];
    write_linear(linear, request.output);
    NativeResult out;
    out.outcome = NativeResult::Outcome::rendered, out.seconds = 2, out.files_read = {request.scene};
    return out;
  };
  run();
  EXPECT_THAT(asked,
              ElementsAre(ElementsAre("-A", "Declare=Bands=0", "+FE"), ElementsAre("-A", "Declare=Bands=1", "+FE")));
  ASSERT_EQ(last_.scenes.size(), 1u);
  EXPECT_EQ(last_.scenes[0].native_seconds, 4);
  update_baseline(last_, options_.baseline, false);
  const Picture stored = image::read_picture(options_.baseline / "bands.pov.png");
  EXPECT_EQ(stored.bits, 16);
  EXPECT_NEAR(stored.samples[0], linear_to_srgb(0.25), 1e-5);
  EXPECT_NEAR(stored.samples[1], linear_to_srgb(0.25), 1e-5);
  EXPECT_EQ(stored.samples[2], 0) << "a negative sum is clipped";
  EXPECT_EQ(run()["bands.pov"].status, Status::exact);
}

TEST_F(RunTest, FailedLastTime) {
  scene("good.pov", "plain"), scene("wrong.pov", "bright");
  run();
  write_report(json_report(last_), root() / "last.json");
  const Suite again = filter(suite(), failed_in(root() / "last.json"));
  ASSERT_EQ(again.scenes.size(), 1u);
  EXPECT_EQ(again.scenes[0].name, "wrong.pov");
  EXPECT_THROW(filter(suite(), failed_in(root() / "none.json")), std::runtime_error);
}

TEST_F(RunTest, HundredsOfScenesAndHostileNames) {
  for (int i = 0; i < 150; ++i) scene("s" + std::to_string(i) + ".pov", "plain");
  scene("sp ace & 'quote' \"double\".pov", "plain");
  scene("new\nline.pov", "plain");
  options_.jobs = 4;
  const auto r = run();
  EXPECT_EQ(r.size(), 152u);
  for (const auto& [name, s] : r) EXPECT_EQ(s.status, Status::exact) << name << ": " << s.reason;
}

// native_program with a script in the place of verisim.
TEST_F(RunTest, NativeProgramReadsStatusMessageAndStatistics) {
  scene("a.pov", "plain");
  const auto result = [&](const std::string& body) {
    script(root() / "verisim",
           "for a in \"$@\"; do case \"$a\" in +O*) out=\"${a#+O}\";; esac; [ \"$last\" = --stats ] && stats=\"$a\"; "
           "last=\"$a\"; done\n"
           "echo \"$@\" > " +
               (root() / "arguments").string() + "\n" + body + "\n");
    NativeRequest request;
    request.folder = root() / "scenes", request.scene = root() / "scenes/a.pov", request.output = root() / "out.png",
    request.switches = {"-A"}, request.time_limit = 1;
    return native_program(root() / "verisim")(request);
  };
  NativeResult r = result(
      "echo '{\"rays\":{\"camera\":7},\"stochastic_features\":[\"crand\"],\"files_read\":[\"a.pov\"]}' > \"$stats\"");
  EXPECT_EQ(r.outcome, NativeResult::Outcome::rendered);
  EXPECT_EQ(r.rays["camera"], 7u);
  EXPECT_THAT(r.stochastic_features, ElementsAre("crand"));
  EXPECT_THAT(r.files_read, ElementsAre("a.pov"));
  EXPECT_GT(r.seconds, 0);
  r = result("echo 'a.pov:3:4: unsupported: isosurface' >&2; echo more >&2; exit 4");
  EXPECT_EQ(r.outcome, NativeResult::Outcome::unsupported);
  EXPECT_EQ(r.message, "a.pov:3:4: unsupported: isosurface");
  r = result("echo 'a.pov:1:1: error: oops' >&2; exit 3");
  EXPECT_EQ(r.outcome, NativeResult::Outcome::error);
  EXPECT_EQ(r.message, "a.pov:1:1: error: oops");
  EXPECT_THAT(result("kill -SEGV $$").message, HasSubstr("signal 11"));
  EXPECT_THAT(result("sleep 60").message, HasSubstr("no end after 1 s"));
  EXPECT_EQ(result("echo '{\"rays\":3' > \"$stats\"").outcome, NativeResult::Outcome::rendered);
}

TEST_F(RunTest, BenchRunsBothInTurn) {
  scene("a.pov", "plain"), scene("b.pov", "crash");
  const std::string log = (root() / "oracle.log").string();
  script(root() / "verisim", "echo ours >> " + log + "; i=0; while [ $i -lt 2000 ]; do i=$((i+1)); done");
  BenchOptions bench;
  bench.oracle = options_.oracle, bench.native_program = root() / "verisim", bench.runs = 2;
  const Bench b = run_bench(suite(), bench);
  std::ifstream in(log);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  EXPECT_THAT(lines, ElementsAre("a.pov", "ours", "a.pov", "ours", "b.pov"));
  ASSERT_EQ(b.scenes.size(), 2u);
  EXPECT_EQ(b.scenes[0].oracle.size(), 2u);
  EXPECT_GT(b.scenes[0].wall_ratio, 0);
  EXPECT_DOUBLE_EQ(b.wall_ratio, b.scenes[0].wall_ratio) << "the scene that failed does not count";
  EXPECT_THAT(b.scenes[1].error, HasSubstr("signal 11"));
  EXPECT_THAT(bench_table(b), HasSubstr("geometric mean"));
  const auto json = nlohmann::json::parse(bench_json(b));
  EXPECT_EQ(json["scenes"][0]["runs"]["native"].size(), 2u);
  EXPECT_GT(json["geometric_mean"]["wall"].get<double>(), 0);
}

}  // namespace
}  // namespace verisim::compare
