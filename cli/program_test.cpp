#include "cli/program.h"

#include <gtest/gtest.h>

namespace verisim::cli {
namespace {

TEST(Program, BadUsageHasItsStatus) {
  EXPECT_EQ(run({"verisim"}), kUsage);
  EXPECT_EQ(run({"verisim", "rendr", "x.pov"}), kUsage);
  EXPECT_EQ(run({"verisim", "render"}), kUsage);
  EXPECT_EQ(run({"verisim", "render", "x.pov", "--sed", "3"}), kUsage);
  EXPECT_EQ(run({"verisim", "render", "x.pov", "--layers", "depth"}), kUsage);
  EXPECT_EQ(run({"verisim", "render", "x.pov", "--layers", "depths", "+FE"}), kUsage);
  EXPECT_EQ(run({"verisim", "render", "x.pov", "--sampler", "random"}), kUsage);
  EXPECT_EQ(run({"verisim", "render", "x.pov", "y.pov"}), kUsage);
  EXPECT_EQ(run({"verisim", "render", "x.pov", "+ZZ"}), kUsage);
  EXPECT_EQ(run({"verisim", "--benchmark"}), kUsage);
  EXPECT_EQ(run({"verisim", "diff", "one.png"}), kUsage);
}

TEST(Program, HelpAndVersionAreFine) {
  EXPECT_EQ(run({"verisim", "--help"}), kOk);
  EXPECT_EQ(run({"verisim", "--version"}), kOk);
  EXPECT_EQ(run({"povray", "--version"}), kOk);
  for (const char* command : {"render", "check", "compare", "diff", "explain", "bench"})
    EXPECT_EQ(run({"verisim", command, "--help"}), kOk) << command;
}

TEST(Program, EveryWayOfAskingForHelpAnswers) {
  for (const char* command : {"render", "check", "compare", "diff", "explain", "bench"}) {
    for (const char* word : {"-h", "-help", "-?", "help"})
      EXPECT_EQ(run({"verisim", command, word}), kOk) << command << " " << word;
    EXPECT_EQ(run({"verisim", "help", command}), kOk) << command;
  }
  EXPECT_EQ(run({"verisim", "help"}), kOk);
  EXPECT_EQ(run({"verisim", "-h"}), kOk);
  EXPECT_EQ(run({"povray", "-h"}), kOk);
  EXPECT_EQ(run({"verisim", "help", "rendr"}), kUsage);
  EXPECT_EQ(run({"verisim", "help", "--format", "pdf"}), kUsage);
}

TEST(Program, CalledAsPovrayItHasPovraysStatus) {
  EXPECT_EQ(run({"povray"}), 1);
  EXPECT_EQ(run({"povray", "+ZZ"}), 1);
  EXPECT_EQ(run({"povray", "+W8"}), 1);
  EXPECT_EQ(run({"povray", "+Inone.pov", "-D"}), 1);
  EXPECT_EQ(run({"verisim", "+Inone.pov", "-D"}), 1);
  EXPECT_EQ(run({"povray", "+Ix.pov", "+BS3"}), 1);
}

}  // namespace
}  // namespace verisim::cli
