// Scenes that draw random numbers, judged in whole runs.
#include <fmt/format.h>

#include "compare/metrics/values.h"
#include "compare/regression/run_test_support.h"

namespace verisim::compare {
namespace {

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

}  // namespace
}  // namespace verisim::compare
