// The small parts of `verisim farm`; what it does as a whole is tests/farm.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "cli/farm/job.h"
#include "cli/farm/log_file.h"
#include "cli/farm/plan.h"
#include "cli/farm/slurm.h"
#include "cli/farm/task_script.h"
#include "cli/settings/frame_list.h"
#include "cli/settings/options.h"

namespace verisim::cli {
namespace {

TEST(FarmSlurm, TimeLimitsAreReadAsSbatchReadsThem) {
  EXPECT_EQ(slurm_seconds("30"), 1800);
  EXPECT_EQ(slurm_seconds("1:30"), 90);
  EXPECT_EQ(slurm_seconds("2:00:05"), 7205);
  EXPECT_EQ(slurm_seconds("1-12"), 129600);
  EXPECT_EQ(slurm_seconds("1-0:30"), 88200);
  EXPECT_EQ(slurm_seconds("1-0:0:1"), 86401);
  for (const char* bad : {"", "x", "1:", ":1", "1:2:3:4", "-1", "1-", "1 h", "9999999"})
    EXPECT_FALSE(slurm_seconds(bad)) << bad;
}

TEST(FarmSlurm, NumbersBecomeRanges) {
  EXPECT_EQ(slurm_ranges({1, 2, 3, 5, 7, 8}), "1-3,5,7-8");
  EXPECT_EQ(slurm_ranges({4}), "4");
}

TEST(FarmScript, AWordIsOneWordForTheShell) {
  EXPECT_EQ(shell_word("+W320"), "+W320");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("a b"), "'a b'");
  EXPECT_EQ(shell_word("it's $(x)"), "'it'\\''s $(x)'");
}

TEST(FarmPlan, ATaskLastsTenTimesWhatItRepeats) {
  Costs costs;
  costs.start = 1, costs.parse = 19, costs.picture = 20000;
  EXPECT_EQ(parts_for(costs, 1 << 20, 0), 100);  // of 200 s
  costs.parse = 0;
  EXPECT_EQ(parts_for(costs, 1 << 20, 0), 334);  // of a minute
  EXPECT_EQ(parts_for(costs, 50, 0), 50);        // blocks
  EXPECT_EQ(parts_for(costs, 1 << 20, 500), 2000);
  costs.picture = 3;
  EXPECT_EQ(parts_for(costs, 1 << 20, 0), 1);
  EXPECT_EQ(parts_for(costs, 1 << 20, 8), 2);  // smaller ones would not pay
  costs.picture = 0;
  EXPECT_EQ(parts_for(costs, 1 << 20, 0), 64);
}

TEST(FarmPlan, FramesOfATaskTakeAMinute) {
  Costs costs;
  costs.parse = 1, costs.picture = 5;
  EXPECT_EQ(frames_per_task_for(costs, 240, 0), 10);
  EXPECT_EQ(frames_per_task_for(costs, 240, 20), 3);  // four tasks a node
  EXPECT_EQ(frames_per_task_for(costs, 4, 0), 4);
  costs.picture = 600;
  EXPECT_EQ(frames_per_task_for(costs, 240, 0), 1);
}

TEST(FarmJobFrames, TheLastTaskMayHaveFewer) {
  FarmJob job;
  job.animation = true, job.first = 2, job.last = 13, job.step = 3, job.frames_per_task = 3, job.tasks = 2;
  EXPECT_EQ(job.frames_of(1), (std::vector<int>{2, 5, 8}));
  EXPECT_EQ(job.frames_of(2), (std::vector<int>{11}));
}

TEST(FrameList, ReadsRangesOfNumbers) {
  const auto holds = [](const char* list, int frame) {
    const std::vector<FrameRange> ranges = frame_list(list);
    return std::any_of(ranges.begin(), ranges.end(), [frame](const FrameRange& r) { return r.holds(frame); });
  };
  EXPECT_TRUE(holds("3", 3) && !holds("3", 4));
  EXPECT_TRUE(holds("1-5:2, 4", 5) && holds("1-5:2, 4", 4) && !holds("1-5:2, 4", 2));
  EXPECT_TRUE(holds("11-2000000000", 12));
  for (const char* bad : {"", ",", "1-", "3-1", "a", "1-5:0", "-2", "1,,2", "99999999999"})
    EXPECT_THROW(frame_list(bad), OptionError) << bad;
}

TEST(FarmLog, TellsWhatWasSaidLast) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("farm_log_" + std::to_string(::getpid()));
  const auto write = [&](const std::string& text) { std::ofstream(path, std::ios::binary) << text; };
  EXPECT_FALSE(read_log(path).begun);
  const std::string start = "{\"event\":\"start\",\"step\":\"3\",\"node\":\"n1\",\"time\":1700000000,\"attempt\":1}\n";
  std::string many;
  for (int i = 0; i < 400; ++i)
    many +=
        "{\"event\":\"progress\",\"stage\":\"picture\",\"fraction\":0.2,\"frame\":0,\"overall\":0.2,\"rays\":1,"
        "\"elapsed\":1,\"remaining\":8}\n";
  write(start + many +
        "{\"event\":\"progress\",\"stage\":\"picture\",\"overall\":0.75,\"remaining\":null}\n{\"event\":\"prog");
  StepLog log = read_log(path);
  EXPECT_TRUE(log.begun);
  EXPECT_EQ(log.begin, 1700000000);
  EXPECT_EQ(log.fraction, 0.75);
  EXPECT_FALSE(log.remaining || log.exit_status);
  write(start + "verisim: error: no room\n{\"event\":\"exit\",\"status\":5}\n");
  log = read_log(path);
  EXPECT_EQ(log.exit_status, 5);
  EXPECT_EQ(log.message, "verisim: error: no room");
  write(start + "{\"event\":\"exit\",\"status\":137}\n" + start);
  EXPECT_FALSE(read_log(path).exit_status);  // it runs again
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace verisim::cli
