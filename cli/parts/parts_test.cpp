// Parts of a picture and their merging as users meet them: VERISIM_BINARY_DIR's program with good and bad files. That
// merged parts are the whole picture for random scenes is the test parts.property.
#include <random>

#include "cli/parts/part_file.h"
#include "cli/process_fixture.h"

namespace verisim::cli {
namespace {

class Parts : public Process {
 protected:
  std::vector<std::string> part(const std::string& which, const std::string& file, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"render", "scene.pov", "--part", which, "--output", file});
    if (std::find_if(more.begin(), more.end(), [](const auto& w) { return w.starts_with("+W"); }) == more.end())
      more.insert(more.end(), {"+W70", "+H50", "+BS16"});
    return more;
  }
  void three() {
    for (const char* k : {"1", "2", "3"})
      ASSERT_EQ(run(part(std::string(k) + "/3", std::string(k) + ".vsp")).status, 0);
  }
  // The merge fails with these words and leaves no picture.
  void refused(const std::vector<std::string>& files, const std::vector<std::string>& words) {
    std::vector<std::string> arguments{"merge"};
    arguments.insert(arguments.end(), files.begin(), files.end());
    arguments.insert(arguments.end(), {"--output", "out.png"});
    const Ended ended = run(arguments);
    EXPECT_NE(ended.status, 0);
    EXPECT_EQ(ended.signal, 0);
    for (const std::string& word : words) EXPECT_NE(ended.errors.find(word), std::string::npos) << ended.errors;
    EXPECT_FALSE(exists("out.png"));
  }
};

TEST_F(Parts, WhatDoesNotBelongTogetherIsRefusedByName) {
  three();
  refused({"1.vsp", "3.vsp"}, {"of 3 parts 1 is missing: 2"});
  refused({"1.vsp", "2.vsp", "3.vsp", "2.vsp"}, {"part 2 of 3 is there twice", "2.vsp"});
  refused({"scene.pov"}, {"scene.pov", "no part of a picture"});
  refused({"nowhere.vsp"}, {"nowhere.vsp"});
  ASSERT_EQ(run(part("2/3", "other.vsp", {"+W71", "+H50", "+BS16"})).status, 0);
  refused({"1.vsp", "other.vsp", "3.vsp"}, {"different pictures", "size", "71x50"});
  ASSERT_EQ(run(part("2/3", "other.vsp", {"+W70", "+H50", "+BS16", "+A0.1"})).status, 0);
  refused({"1.vsp", "other.vsp", "3.vsp"}, {"different pictures", "settings", "Antialias"});
  ASSERT_EQ(run(part("2/4", "other.vsp")).status, 0);
  refused({"1.vsp", "other.vsp", "3.vsp"}, {"part 2 of 4"});
  file("scene.pov", std::string(kQuickScene) + "sphere { 1, 0.2 }");
  ASSERT_EQ(run(part("2/3", "other.vsp")).status, 0);
  refused({"1.vsp", "other.vsp", "3.vsp"}, {"different pictures", "what is in the file scene.pov"});
}

TEST_F(Parts, DamageIsFoundWhereverItIs) {
  three();
  const std::string whole = text_of(folder_ / "2.vsp");
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    std::string damaged = whole;
    if (i % 3 == 0)
      damaged.resize(random() % damaged.size());
    else
      damaged[random() % damaged.size()] ^= static_cast<char>(1 << random() % 8);
    file("bad.vsp", damaged);
    refused({"1.vsp", "bad.vsp", "3.vsp"}, {"bad.vsp"});
  }
  file("bad.vsp", whole + "x");
  refused({"1.vsp", "bad.vsp", "3.vsp"}, {"bad.vsp", "more in it"});
}

// A farm's merge may meet thousands of them.
TEST_F(Parts, DamagedOnesDoNotStayOpen) {
  file("bad.vsp", "verisim-part-1\n and no more of it");
  const auto open_files = [] {
    const fs::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
  };
  const auto before = open_files();
  for (int i = 0; i < 5; ++i) EXPECT_THROW(PartFile(folder_ / "bad.vsp"), std::runtime_error);
  EXPECT_EQ(open_files(), before);
}

TEST_F(Parts, AnotherVersionIsNamed) {
  three();
  std::string other = text_of(folder_ / "2.vsp");
  const std::string name = "\"version\":\"";
  const std::size_t at = other.find(name) + name.size();
  // The checksum of the header fits no longer; which of the two is told does not matter.
  other[at] = other[at] == '9' ? '8' : '9';
  file("2.vsp", other);
  refused({"1.vsp", "2.vsp", "3.vsp"}, {"2.vsp"});
}

TEST_F(Parts, BadCallsSayWhatToDo) {
  for (const auto& [arguments, word] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--part", "0/3", "--output", "a.vsp"}, "K/N"},
           {{"--part", "4/3", "--output", "a.vsp"}, "K/N"},
           {{"--part", "x", "--output", "a.vsp"}, "prepass"},
           {{"--part", "1/3"}, "--output"},
           {{"--part", "1/3", "--output", "a.vsp", "--replay"}, "--replay"},
           {{"--part", "1/3", "--output", "a.vsp", "+RFO"}, "+RFO"},
           {{"--part", "1/3", "--output", "a.vsp", "+KFF5"}, "+SF"},
           {{"--part", "prepass", "--output", "a.vsp", "--prepass", "b.vsp"}, "--prepass"}}) {
    std::vector<std::string> call{"render", "scene.pov", "+W8", "+H8"};
    call.insert(call.end(), arguments.begin(), arguments.end());
    const Ended ended = run(call);
    EXPECT_EQ(ended.status, 2) << arguments[1];
    EXPECT_NE(ended.errors.find(word), std::string::npos) << ended.errors;
    EXPECT_FALSE(exists("a.vsp"));
  }
  three();
  const Ended wrong = run({"render", "scene.pov", "+W70", "+H50", "--prepass", "1.vsp"});
  EXPECT_EQ(wrong.status, 5);
  EXPECT_NE(wrong.errors.find("not the prepasses"), std::string::npos) << wrong.errors;
  ASSERT_EQ(run(part("prepass", "pre.vsp")).status, 0);
  const Ended other = run({"render", "scene.pov", "+W71", "+H50", "--prepass", "pre.vsp"});
  EXPECT_EQ(other.status, 5);
  EXPECT_NE(other.errors.find("another picture"), std::string::npos) << other.errors;
}

TEST_F(Parts, APartThatIsWholeIsNotRenderedAgainAndADamagedOneIs) {
  three();
  const std::string whole = text_of(folder_ / "2.vsp");
  EXPECT_NE(run(part("2/3", "2.vsp", {"+W70", "+H50", "+BS16", "+C"})).errors.find("skipping"), std::string::npos);
  file("2.vsp", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(run(part("2/3", "2.vsp", {"+W70", "+H50", "+BS16", "+C"})).errors.find("skipping"), std::string::npos);
  EXPECT_TRUE(text_of(folder_ / "2.vsp") == whole);
}

TEST_F(Parts, AnInterruptedPartGoesOnWhereItStood) {
  // So large that it is not done before its state is saved for the first time, after a second.
  std::vector<std::string> call{"render", "slow.pov", "+W560", "+H420",    "+A0.0",
                                "+R5",    "--part",   "2/2",   "--output", "2.vsp"};
  const pid_t child = start(call);
  wait_for("2.pov-state");
  ::kill(child, SIGTERM);
  EXPECT_EQ(wait(child).status, 130);
  EXPECT_FALSE(exists("2.vsp"));
  EXPECT_TRUE(exists("2.pov-state"));
  call.emplace_back("+C");
  ASSERT_EQ(run(call).status, 0);
  call = {"render", "slow.pov", "+W560", "+H420", "+A0.0", "+R5", "--part", "1/2", "--output", "1.vsp"};
  ASSERT_EQ(run(call).status, 0);
  ASSERT_EQ(run({"merge", "1.vsp", "2.vsp", "--output", "merged.png"}).status, 0);
  ASSERT_EQ(run({"render", "slow.pov", "+W560", "+H420", "+A0.0", "+R5", "--output", "whole.png"}).status, 0);
  EXPECT_TRUE(text_of(folder_ / "merged.png") == text_of(folder_ / "whole.png"));
}

TEST_F(Parts, ProgressIsToldInLines) {
  const Ended json = run({"render", "scene.pov", "+W64", "+H48", "--progress", "json"});
  for (const char* part :
       {"{\"event\":\"begin\"", "\"stage\":\"parse\",\"fraction\":null", "\"stage\":\"picture\",\"fraction\":1.0",
        "\"event\":\"frame\"", "\"event\":\"end\",\"status\":0"})
    EXPECT_NE(json.errors.find(part), std::string::npos) << part << "\n" << json.errors;
  const Ended openjd = run({"render", "bad.pov", "--progress", "openjd"});
  EXPECT_NE(openjd.errors.find("openjd_fail: bad.pov:1:25"), std::string::npos) << openjd.errors;
  EXPECT_NE(
      run({"render", "scene.pov", "+W16", "+H12", "--progress", "openjd"}).errors.find("openjd_progress: 100.0\n"),
      std::string::npos);
  EXPECT_EQ(run({"render", "scene.pov", "--progress", "jason"}).status, 2);
  EXPECT_EQ(run({"render", "scene.pov", "+W8", "+H8"}).errors.find("event"), std::string::npos);
}

}  // namespace
}  // namespace verisim::cli
