// The HTML report: its text, and used in a real headless Chromium (skipped when there is none).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"
#include "compare/oracle/process.h"
#include "compare/oracle/working_copy.h"
#include "compare/report/display.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
namespace {

// Scenes of every kind: equal, shifted in colour, unsupported; the first has a hostile name.
Run make_run(const fs::path& folder, int scenes) {
  Run run;
  run.started = "2026-01-02T03:04:05Z", run.oracle_version = "3.7.0.10";
  image::write_picture(constant_picture(160, 120, 200, 100, 50), folder / "a.png");
  image::write_picture(constant_picture(160, 120, 100, 200, 50), folder / "b.png");
  image::write_picture(random_picture(160, 120, 1), folder / "c.png");
  const Metrics shifted = measure(image::read_picture(folder / "a.png"), image::read_picture(folder / "b.png"));
  const Metrics equal = measure(image::read_picture(folder / "c.png"), image::read_picture(folder / "c.png"));
  for (int i = 0; i < scenes; ++i) {
    SceneResult s;
    s.request.width = 160, s.request.height = 120, s.request.scene = "/scenes/it's one.pov",
    s.request.switches = {"-A"};
    s.oracle_seconds = 1.5, s.native_seconds = 0.1;
    const bool shift = i % 8 == 1;
    s.request.name = i == 0 ? "</script><b>name"
                            : (i % 8 == 2 ? "unsupported "
                               : shift    ? "shift "
                                          : "equal ") +
                                  std::to_string(i);
    if (i % 8 == 2) {
      s.status = Status::unsupported, s.reason = "isosurface";
    } else {
      s.oracle_picture = folder / (shift ? "a.png" : "c.png"), s.native_picture = folder / (shift ? "b.png" : "c.png");
      s.metrics = shift ? shifted : equal;
      const Verdict v = judge_deterministic(*s.metrics, false);
      s.status = v.status, s.reason = v.reason;
      if (shift) {
        s.blame = Blame{19200,
                        0,
                        1,
                        {{"box (a.pov:7)", 100, 100, 80, 0, 100, 1, 20, 30}},
                        {{"texture", "pigment granite", 97, 2, 0.95}}};
        for (const WorstPixel& p : s.metrics->worst)
          s.trees.push_back({p.x, p.y, "camera ray from <0, 0, 0>\n  hits <b>box</b>"});
        s.request.truth = Truth{"E cos a / pi.", {{0, 0, {0.5, 0.5, 0.5}}}, 0.001};
        s.oracle_truth = TruthError{0.1, 0.1, 0, 0, {{0.4, 0.4, 0.4}}};
        s.native_truth = TruthError{0.01, 0.01, 0, 0, {{0.49, 0.49, 0.49}}};
        s.suspicions = {{"swapped channels", "red and green", 1, 1, 0.9, {0, 160 * 120}}};
      }
    }
    run.scenes.push_back(s);
  }
  run.summary = summarise(run.scenes);
  return run;
}

TEST(Base64, Rfc4648) {
  const std::pair<const char*, const char*> pairs[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : pairs) EXPECT_EQ(base64(plain), coded);
}

TEST(Display, ThumbnailKeepsTheMeanAndTheShape) {
  const Picture t = thumbnail(random_picture(400, 100, 1), 168, 126);
  EXPECT_EQ(t.width, 168);
  EXPECT_EQ(t.height, 42);
  double sum = 0;
  for (float v : t.samples) sum += v;
  EXPECT_NEAR(sum / static_cast<double>(t.samples.size()), 0.5, 0.01);
  EXPECT_EQ(thumbnail(random_picture(1, 1, 1), 168, 126).width, 1);
}

TEST(Display, HeatMapIsBlackWhereEqualAndBrightestAtTheScalesEnd) {
  const Picture a = constant_picture(2, 1, 100, 100, 100);
  Picture b = a;
  b.samples[0] = 116 / 255.0f;
  const Picture heat = heat_map(a, b, 255 / 16.0);
  EXPECT_NEAR(heat.samples[0] * 255, 252, 0.01);
  EXPECT_NEAR(heat.samples[1] * 255, 255, 0.01);
  EXPECT_NEAR(heat.samples[3] * 255, 0, 0.01);
}

TEST(HtmlReport, IsOneFileThatAsksForNothing) {
  const TemporaryFolder folder;
  const std::string html = html_report(make_run(folder.path(), 9));
  EXPECT_THAT(html, Not(HasSubstr("http://"
                                  "fonts")));
  EXPECT_THAT(html, Not(HasSubstr("src=\"")));
  EXPECT_THAT(html, Not(HasSubstr("@DATA@")));
  EXPECT_THAT(html, Not(HasSubstr("@JS@")));
  EXPECT_THAT(html, HasSubstr("Content-Security-Policy"));
  EXPECT_THAT(html, Not(HasSubstr("</script><b>")));
}

TEST(HtmlReport, SaysWhoIsNearerToMathematics) {
  const TemporaryFolder folder;
  const std::string html = html_report(make_run(folder.path(), 10));
  EXPECT_THAT(html, HasSubstr("known answers: verisim is nearer in 2 scenes, POV-Ray in 0"));
  EXPECT_THAT(html, HasSubstr("off the known answer by 0.01000 (verisim) and 0.10000 (POV-Ray): verisim is nearer"));
}

TEST(HtmlReport, SurvivesPicturesThatWentAway) {
  const TemporaryFolder folder;
  compare::Run run = make_run(folder.path(), 3);
  fs::remove(folder.path() / "a.png");
  EXPECT_THAT(html_report(run), HasSubstr("shift 1"));
}

std::string chromium() {
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (const fs::path p = find_program(name); !p.empty()) return p.string();
  return {};
}

// The document after the self-test has run, at the given window size.
std::string use(const fs::path& folder, const std::string& size, const std::string& screenshot) {
  std::vector<std::string> arguments = {chromium(),
                                        "--headless",
                                        "--no-sandbox",
                                        "--disable-gpu",
                                        "--disable-quic",
                                        "--no-first-run",
                                        "--disable-background-networking",
                                        "--disable-component-update",
                                        "--disable-sync",
                                        "--disable-dev-shm-usage",
                                        "--user-data-dir=" + (folder / ("profile" + size)).string(),
                                        "--window-size=" + size,
                                        "--virtual-time-budget=30000"};
  arguments.push_back(screenshot.empty() ? "--dump-dom" : "--screenshot=" + screenshot);
  arguments.push_back("file://" + (folder / (screenshot.empty() ? "test.html" : "report.html")).string());
  return run_process({arguments, folder, {{"HOME", folder.string()}, {"PATH", "/usr/bin:/bin"}}, 120, nullptr}).out;
}

TEST(HtmlReport, IsUsedInARealBrowser) {
  if (chromium().empty()) GTEST_SKIP() << "Chromium is not installed";
  const TemporaryFolder folder;
  std::ifstream script(fs::path(VERISIM_SOURCE_DIR) / "compare/report/page/selftest.js");
  std::ostringstream actions;
  actions << "<script>" << script.rdbuf() << "</script>";
  for (const auto& [size, scenes] : {std::pair("1400,900", 150), std::pair("500,900", 20)}) {
    const std::string html = html_report(make_run(folder.path(), scenes));
    write_report(html, folder.path() / "report.html");
    write_report(html + actions.str(), folder.path() / "test.html");
    const std::string dom = use(folder.path(), size, "");
    const auto at = dom.find("<pre id=\"selftest\"");
    ASSERT_NE(at, std::string::npos) << dom.substr(0, 2000);
    const std::string seen = dom.substr(at, dom.find("</pre>", at) - at);
    EXPECT_THAT(seen, Not(HasSubstr("FAIL"))) << seen;
    EXPECT_THAT(seen, HasSubstr("END")) << seen;
    RecordProperty(std::string("seen_") + size[0], seen);
  }
  const fs::path kept = fs::path(VERISIM_BINARY_DIR) / "report-screenshot.png";  // an artifact of CI
  use(folder.path(), "1400,900", kept.string());
  EXPECT_TRUE(fs::exists(kept));
}

}  // namespace
}  // namespace verisim::compare
