// The example of docs/comparison.md and of compare.h, compiled and run.
#include <gtest/gtest.h>

#include <fstream>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"
#include "compare/oracle/working_copy.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;

// What a program of one's own looks like: pictures, then a whole suite against stored pictures.
bool example(const fs::path& folder) {
  compare::Metrics metrics =
      compare::measure(image::read_picture(folder / "povray.png"), image::read_picture(folder / "verisim.png"));
  compare::Verdict verdict = compare::judge_deterministic(metrics, /*antialiased=*/false);
  if (verdict.status != compare::Status::exact) return false;

  compare::RunOptions options;
  options.native = [&](const compare::NativeRequest& request) {  // any function that renders a scene to a file
    fs::copy_file(folder / "verisim.png", request.output);
    compare::NativeResult result;
    result.outcome = compare::NativeResult::Outcome::rendered;
    return result;
  };
  options.jobs = 2;
  compare::Run run = compare::run_suite(compare::load_suite({folder / "scenes"}), options);
  compare::write_report(compare::html_report(run), folder / "report.html");
  compare::write_report(compare::json_report(run), folder / "report.json");
  return !run.summary.failed();
}

TEST(LibraryExample, Runs) {
  const compare::TemporaryFolder folder;
  const image::Picture picture = compare::scene_like_picture(32, 24);
  fs::create_directories(folder.path() / "scenes");
  for (const char* name : {"povray.png", "verisim.png", "scenes/stored.png"})
    image::write_picture(picture, folder.path() / name);
  std::ofstream(folder.path() / "scenes/a.pov") << "camera {}";
  std::ofstream(folder.path() / "scenes/verisim.toml")
      << "width = 32\nheight = 24\n[[scene]]\nfile = \"a.pov\"\nreference = \"stored.png\"\n";
  EXPECT_TRUE(example(folder.path()));
  EXPECT_GT(fs::file_size(folder.path() / "report.html"), 10000u);
}

}  // namespace
}  // namespace verisim
