// The reports that are text: JSON against its schema, JUnit, Markdown, GitHub annotations, the terminal's table; atomic
// writing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"
#include "compare/oracle/working_copy.h"
#include "compare/report/json.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;
namespace {

SceneResult scene(const std::string& name, Status status, const std::string& reason = "", bool metrics = true) {
  SceneResult s;
  s.request.name = name, s.request.scene = "/s/" + name, s.status = status, s.reason = reason;
  s.oracle_seconds = 2, s.native_seconds = 0.25, s.rays = {{"camera", 19200}};
  if (metrics)
    s.metrics = measure(scene_like_picture(16, 12),
                        status == Status::exact ? scene_like_picture(16, 12) : random_picture(16, 12, 2));
  return s;
}

compare::Run sample() {
  compare::Run run;
  run.started = "2026-01-02T03:04:05Z", run.oracle_version = "3.7";
  run.scenes = {scene("a/equal.pov", Status::exact),
                scene("b|<x>&\"q\".pov", Status::differ, "rmse 80 > 2, 100% bad\nline two"),
                scene("c\x1b[31m\xff.pov", Status::unsupported, "c.pov:3:4: isosurface", false),
                scene("d.pov", Status::oracle_failed, "no end after 600 s", false),
                scene("e.pov", Status::error, "e.pov:1:1: error: oops", false)};
  run.scenes[1].scene_class = SceneClass::stochastic;
  run.scenes[1].native_low_pass = LowPass{1, 2, 3}, run.scenes[1].noise_low_pass = LowPass{0.1, 0.2, 0.3};
  run.scenes[0].previous = Status::differ;
  run.summary = summarise(run.scenes);
  return run;
}

// The part of JSON Schema that report.schema.json uses; anything else in it is an error of the test.
std::string violation(const json& schema, const json& value, const json& root, const std::string& where) {
  for (const auto& [key, rule] : schema.items()) {
    if (key == "$ref") {
      if (auto v = violation(root.at(json::json_pointer(rule.get<std::string>().substr(1))), value, root, where);
          !v.empty())
        return v;
    } else if (key == "type") {
      const std::string type = rule;
      const bool ok = (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
                      (type == "string" && value.is_string()) || (type == "integer" && value.is_number_integer()) ||
                      (type == "number" && value.is_number()) || (type == "boolean" && value.is_boolean()) ||
                      (type == "null" && value.is_null());
      if (!ok) return where + " is no " + type;
    } else if (key == "required") {
      for (const std::string name : rule)
        if (!value.contains(name)) return where + " lacks " + name;
    } else if (key == "properties") {
      for (const auto& [name, sub] : rule.items())
        if (value.contains(name))
          if (auto v = violation(sub, value[name], root, where + "." + name); !v.empty()) return v;
    } else if (key == "additionalProperties") {
      for (const auto& [name, sub] : value.items())
        if (auto v = violation(rule, sub, root, where + "." + name); !v.empty()) return v;
    } else if (key == "items") {
      for (std::size_t i = 0; i < value.size(); ++i)
        if (auto v = violation(rule, value[i], root, where + "[" + std::to_string(i) + "]"); !v.empty()) return v;
    } else if (key == "minItems") {
      if (value.size() < rule.get<std::size_t>()) return where + " has too few items";
    } else if (key == "maxItems") {
      if (value.size() > rule.get<std::size_t>()) return where + " has too many items";
    } else if (key == "enum") {
      if (std::find(rule.begin(), rule.end(), value) == rule.end()) return where + " is none of the values";
    } else if (key == "minimum") {
      if (value.is_number() && value.get<double>() < rule.get<double>()) return where + " is too small";
    } else if (key == "maximum") {
      if (value.is_number() && value.get<double>() > rule.get<double>()) return where + " is too large";
    } else if (key == "anyOf") {
      if (std::none_of(rule.begin(), rule.end(),
                       [&](const json& sub) { return violation(sub, value, root, where).empty(); }))
        return where + " fits none";
    } else if (key != "$schema" && key != "$defs" && key != "title" && key != "description") {
      return "unknown rule " + key;
    }
  }
  return {};
}

TEST(JsonReport, FollowsItsSchema) {
  std::ifstream in(fs::path(VERISIM_SOURCE_DIR) / "compare/report/report.schema.json");
  const json schema = json::parse(in);
  const json report = json::parse(json_report(sample()));
  EXPECT_EQ(violation(schema, report, schema, "report"), "");
  json broken = report;
  broken["scenes"][0].erase("class");
  EXPECT_NE(violation(schema, broken, schema, "report"), "");
  broken = report;
  broken["scenes"][0]["metrics"]["psnr"] = nullptr;
  EXPECT_NE(violation(schema, broken, schema, "report"), "");
}

TEST(JsonReport, HasWhatTheDesignNames) {
  const json report = json::parse(json_report(sample()));
  const json& equal = report["scenes"][0];
  EXPECT_EQ(equal["scene"], "a/equal.pov");
  EXPECT_EQ(equal["status"], "exact");
  EXPECT_EQ(equal["class"], "deterministic");
  EXPECT_EQ(equal["metrics"]["psnr"], 999);
  EXPECT_EQ(equal["metrics"]["within_1_pct"], 100);
  EXPECT_EQ(equal["seconds"]["oracle"], 2);
  EXPECT_EQ(equal["rays"]["camera"], 19200);
  EXPECT_TRUE(report["scenes"][2]["metrics"].is_null());
  EXPECT_EQ(report["summary"]["differ"], 1);
  EXPECT_EQ(report["summary"]["scenes"], 5);
}

TEST(JsonReport, IsReadBack) {
  const compare::Run run = sample();
  const json report = json::parse(json_report(run));
  const SceneResult s = scene_result_from_json(report["scenes"][1]);
  EXPECT_EQ(s.request.name, run.scenes[1].request.name);
  EXPECT_EQ(s.status, Status::differ);
  EXPECT_EQ(s.scene_class, SceneClass::stochastic);
  EXPECT_DOUBLE_EQ(s.metrics->rmse, run.scenes[1].metrics->rmse);
  EXPECT_DOUBLE_EQ(s.noise_low_pass->rmse, 0.3);
  EXPECT_THROW(scene_result_from_json(json::object()), json::exception);
}

TEST(Summary, FailsForAnythingButExactAndMatch) {
  for (const auto& [status, failed] :
       {std::pair(Status::exact, false), std::pair(Status::match, false), std::pair(Status::differ, true),
        std::pair(Status::unsupported, true), std::pair(Status::error, true), std::pair(Status::oracle_failed, true)}) {
    EXPECT_EQ(summarise({scene("x", status, "", false)}).failed(), failed) << to_string(status);
    EXPECT_EQ(status_from_string(to_string(status)), status);
  }
  EXPECT_FALSE(summarise({}).failed());
}

TEST(JunitReport, CountsAndEscapes) {
  const std::string xml = junit_report(sample());
  EXPECT_THAT(xml, HasSubstr("tests=\"5\" failures=\"1\" errors=\"2\" skipped=\"1\""));
  EXPECT_THAT(xml, HasSubstr("b|&lt;x&gt;&amp;&quot;q&quot;.pov"));
  EXPECT_THAT(xml, Not(HasSubstr("\x1b")));
  EXPECT_THAT(xml, Not(HasSubstr("\xff")));  // no byte that is not UTF-8
}

TEST(MarkdownReport, FailuresFirstAndCellsEscaped) {
  const std::string text = markdown_report(sample());
  EXPECT_LT(text.find("d.pov"), text.find("a/equal.pov"));
  EXPECT_THAT(text, HasSubstr("b\\|\\<x>"));
  EXPECT_THAT(text, HasSubstr("was differ"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("| b")) {
      EXPECT_THAT(line, HasSubstr("line two"));
    }
}

TEST(GithubAnnotations, OneForEachFailureOnOneLine) {
  const std::string text = github_annotations(sample());
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  EXPECT_THAT(text, HasSubstr("::error file=/s/b|<x>&\"q\".pov,title=verisim%3A b|"));
  EXPECT_THAT(text, HasSubstr("100%25 bad%0Aline two"));
  EXPECT_THAT(text, HasSubstr("::warning file="));
}

TEST(GithubAnnotations, OfASceneThatIsGoneNameNoFile) {
  compare::Run run = sample();
  for (SceneResult& s : run.scenes) s.request.scene.clear();
  const std::string text = github_annotations(run);
  EXPECT_THAT(text, Not(HasSubstr("file=")));
  EXPECT_THAT(text, HasSubstr("::error title=verisim%3A b|"));
}

TEST(TerminalTable, OneLineForEachScene) {
  const std::string text = terminal_table(sample(), false, 120);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
  EXPECT_THAT(text, HasSubstr("isosurface"));
  EXPECT_THAT(text, HasSubstr("(was differ)"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(terminal_table(sample(), true, 120), HasSubstr("\x1b[32mexact"));
  EXPECT_THAT(terminal_table(sample(), true, 120), Not(HasSubstr("\x1b[31m\xff")));  // colours are ours only
}

TEST(TerminalMetrics, NamesEveryFigure) {
  const std::string text = terminal_metrics(measure(scene_like_picture(16, 12), random_picture(16, 12, 2)));
  for (const char* name : {"max_abs", "mae", "rmse", "psnr", "within_1", "within_2", "bias", "ssim_mean",
                           "ssim_block_min", "flip_mean", "ciede2000_p95"})
    EXPECT_THAT(text, HasSubstr(name));
}

TEST(WriteReport, ReplacesWholeFilesAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "r.json";
  write_report("first", path);
  write_report("second", path);
  std::ifstream in(path);
  std::string text;
  std::getline(in, text);
  EXPECT_EQ(text, "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteReport, SaysWhatCannotBeWritten) {
  try {
    write_report("text", "/no/such/folder/report.html");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/no/such/folder/report.html"));
    EXPECT_THAT(error.what(), HasSubstr("No such file"));
  }
  EXPECT_THROW(write_report("text", "/proc/self/nothing"), std::runtime_error);
}

TEST(RunOfPair, JudgesTwoPictures) {
  const TemporaryFolder folder;
  image::write_picture(random_picture(8, 8, 1), folder.path() / "a.png");
  image::write_picture(random_picture(8, 8, 2), folder.path() / "b.png");
  const compare::Run run = run_of_pair(folder.path() / "a.png", folder.path() / "b.png");
  EXPECT_EQ(run.reference_name, "a.png");
  EXPECT_TRUE(run.summary.failed());
  EXPECT_FALSE(run_of_pair(folder.path() / "a.png", folder.path() / "a.png").summary.failed());
  std::ofstream(folder.path() / "c.png") << "\x89PNG\r\n\x1a\nrubbish";
  EXPECT_THROW(run_of_pair(folder.path() / "a.png", folder.path() / "c.png"), std::runtime_error);
  EXPECT_THROW(run_of_pair(folder.path() / "a.png", folder.path() / "missing.png"), std::runtime_error);
  image::write_picture(random_picture(9, 8, 2), folder.path() / "d.png");
  EXPECT_THROW(run_of_pair(folder.path() / "a.png", folder.path() / "d.png"), PictureMismatch);
}

}  // namespace
}  // namespace verisim::compare
