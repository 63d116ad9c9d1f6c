// One scene, one set of switches, one version: one file, whatever time, thread count or interruption.
// Runs the program of VERISIM_BINARY_DIR.
#include "cli/process_fixture.h"

namespace verisim::cli {
namespace {

class SameBytes : public Process {};

// Whether a PNG has a chunk of this name.
bool has_chunk(const std::string& png, const std::string& name) {
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t size = 0;
    for (int i = 0; i < 4; ++i) size = size << 8 | static_cast<unsigned char>(png[at + static_cast<std::size_t>(i)]);
    if (png.compare(at + 4, 4, name) == 0) return true;
    at += size + 12;
  }
  return false;
}

TEST_F(SameBytes, OfEveryFormatAtAnyTimeWithAnyThreads) {
  const std::vector<std::vector<std::string>> kinds{{"--output", "p.png"},
                                                    {"--output", "p.png", "+UA", "+TH"},
                                                    {"--output", "p16.png", "+FN16"},
                                                    {"--output", "p.tga"},
                                                    {"--output", "p.ppm"},
                                                    {"--output", "p.bmp"},
                                                    {"--output", "p.jpg"},
                                                    {"--output", "p.tif"},
                                                    {"--output", "p.exr"},
                                                    {"--output", "p.hdr"},
                                                    {"--output", "layers.exr", "--layers", "all"}};
  const auto pictures = [&](const std::vector<std::string>& more) {
    std::vector<std::string> files;
    for (std::vector<std::string> arguments : kinds) {
      const std::string name = arguments[1];
      arguments.insert(arguments.begin(), {"render", "scene.pov", "+W40", "+H30", "+A0.1"});
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Ended ended = run(arguments);
      EXPECT_EQ(ended.status, 0) << ended.errors;
      files.push_back(text_of(folder_ / name));
      fs::remove(folder_ / name);
    }
    return files;
  };
  const std::vector<std::string> first = pictures({"+WT1"});
  std::this_thread::sleep_for(milliseconds(1100));  // dates in files count seconds
  const std::vector<std::string> second = pictures({"+WT3", "+C", "-V", "+MI0", "Pause_When_Done=off"});
  for (std::size_t i = 0; i < kinds.size(); ++i) EXPECT_TRUE(first[i] == second[i]) << kinds[i][1] << " " << i;
}

TEST_F(SameBytes, AfterAnInterruption) {
  const std::vector<std::string> render{"render", "slow.pov", "+W320", "+H240", "+A0.0", "+R4", "+Opart"};
  const pid_t child = start(render);
  wait_for("part.pov-state");
  ::kill(child, SIGKILL);
  wait(child);
  std::vector<std::string> again = render;
  again.emplace_back("+C");
  ASSERT_EQ(run(again).status, 0);
  std::vector<std::string> whole = render;
  whole.back() = "+Owhole";
  ASSERT_EQ(run(whole).status, 0);
  EXPECT_TRUE(text_of(folder_ / "part.png") == text_of(folder_ / "whole.png"));
}

TEST_F(SameBytes, FramesOfAnAnimationInOneCallOrInSeveral) {
  const std::vector<std::string> render{"render", "scene.pov", "+W24", "+H18", "+KFF4"};
  ASSERT_EQ(run(render).status, 0);
  const std::string third = text_of(folder_ / "scene3.png");
  ASSERT_FALSE(third.empty());
  std::vector<std::string> alone = render;
  alone.insert(alone.end(), {"+SF3", "+EF3"});
  ASSERT_EQ(run(alone).status, 0);
  EXPECT_TRUE(text_of(folder_ / "scene3.png") == third);
}

// What kernels give with each of them is compared in tests/wide.
TEST_F(SameBytes, WithEveryInstructionSet) {
  const auto ended_with = [this](const char* set) {
    ::setenv("VERISIM_INSTRUCTION_SET", set, 1);
    const Ended ended = run({"render", "scene.pov", "+W60", "+H40", "+A0.1"});
    ::unsetenv("VERISIM_INSTRUCTION_SET");
    return ended;
  };
  ASSERT_EQ(ended_with("baseline").status, 0);
  const std::string expected = text_of(folder_ / "scene.png");
  for (const char* set : {"sse4", "avx2", "avx512"}) {
    if (const Ended ended = ended_with(set); ended.status != 0)
      EXPECT_NE(ended.errors.find("this machine can run baseline"), std::string::npos) << ended.errors;
    else
      EXPECT_TRUE(text_of(folder_ / "scene.png") == expected) << set;
  }
  const Ended wrong = ended_with("mmx");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.errors.find("VERISIM_INSTRUCTION_SET is 'mmx'"), std::string::npos) << wrong.errors;
}

TEST_F(SameBytes, DatesOnlyWhenTheyAreAskedFor) {
  ::unsetenv("SOURCE_DATE_EPOCH");
  ASSERT_EQ(run({"render", "scene.pov", "+W8", "+H8", "--stamp"}).status, 0);
  const std::string stamped = text_of(folder_ / "scene.png");
  EXPECT_TRUE(has_chunk(stamped, "tIME"));
  EXPECT_NE(stamped.find("Render Time"), std::string::npos);
  ASSERT_EQ(run({"render", "scene.pov", "+W8", "+H8"}).status, 0);
  const std::string plain = text_of(folder_ / "scene.png");
  EXPECT_FALSE(has_chunk(plain, "tIME"));
  EXPECT_EQ(plain.find("Render Time"), std::string::npos);

  ::setenv("SOURCE_DATE_EPOCH", "981173106", 1);  // 2001-02-03 04:05:06
  ASSERT_EQ(run({"render", "scene.pov", "+W8", "+H8", "--stamp"}).status, 0);
  const std::string reproduced = text_of(folder_ / "scene.png");
  EXPECT_NE(reproduced.find(std::string("tIME\x07\xd1\x02\x03\x04\x05\x06", 11)), std::string::npos);
  EXPECT_EQ(reproduced.find("Render Time"), std::string::npos);
  ::setenv("SOURCE_DATE_EPOCH", "yesterday", 1);
  const Ended wrong = run({"render", "scene.pov", "+W8", "+H8", "--stamp"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.errors.find("SOURCE_DATE_EPOCH"), std::string::npos) << wrong.errors;
  ::unsetenv("SOURCE_DATE_EPOCH");
}

}  // namespace
}  // namespace verisim::cli
