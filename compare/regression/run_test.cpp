// Whole runs with a script in the place of POV-Ray and a function in the place of our renderer; baselines, bench.
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/metrics/values.h"
#include "compare/regression/run_test_support.h"

namespace verisim::compare {
namespace {

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

Filter failed_in(const fs::path& report) {
  Filter f;
  f.failed_last_time = true, f.last_report = report;
  return f;
}

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
