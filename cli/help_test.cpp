// The help says what the program takes, and its pages are up to date.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/console/exit_status.h"
#include "cli/process_fixture.h"
#include "cli/settings/reading/own_options.h"
#include "cli/settings/reading/switch_help.h"

namespace verisim::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class Help : public Process {};

TEST_F(Help, ThePageOfTheCommandLineIsUpToDate) {
  const Ended page = run({"help", "--format", "markdown"});
  ASSERT_EQ(page.status, 0) << page.errors;
  EXPECT_TRUE(page.output == text_of(VERISIM_SOURCE_DIR "/docs/cli.md"))
      << "build/release/bin/verisim help --format markdown > docs/cli.md";
}

TEST_F(Help, ThePageOfTheLanguageIsUpToDate) {
  const Ended page = run({"help", "--format", "language"});
  ASSERT_EQ(page.status, 0) << page.errors;
  EXPECT_TRUE(page.output == text_of(VERISIM_SOURCE_DIR "/docs/language/README.md"))
      << "build/release/bin/verisim help --format language > docs/language/README.md";
}

TEST_F(Help, WordsOfScenesAreExplained) {
  EXPECT_THAT(run({"help", "photons"}).output, HasSubstr("In: every object."));
  EXPECT_THAT(run({"help", "#macro"}).output, HasSubstr("#macro NAME (PARAMETER, ...) ... #end"));
  const std::string both = run({"help", "merge"}).output;  // a command and a word
  EXPECT_THAT(both, HasSubstr("verisim merge"));
  EXPECT_THAT(both, HasSubstr("merge { OBJECT OBJECT ... }"));
  const Ended unknown = run({"help", "spher"});
  EXPECT_EQ(unknown.status, kUsage);
  EXPECT_THAT(unknown.errors, HasSubstr("did you mean sphere?"));
}

TEST_F(Help, EveryKeywordAndSwitchIsExplained) {
  const std::string help = run({"render", "--help"}).output;
  for (const Setting& setting : settings()) EXPECT_THAT(help, HasSubstr(std::string(setting.key) + "="));
  for (const Switch& s : switches()) EXPECT_THAT(help, HasSubstr("+" + std::string(s.name)));
  for (Topic topic : {Topic::scene, Topic::size, Topic::output, Topic::quality, Topic::speed, Topic::animation,
                      Topic::messages, Topic::commands, Topic::ignored})
    for (const HelpEntry& entry : topic_help(topic).entries) EXPECT_NE(entry.meaning, "") << entry.spellings[0];
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST_F(Help, ACommandListsOnlyWhatDoesSomethingThere) {
  const std::string check = run({"check", "--help"}).output;
  EXPECT_THAT(check, HasSubstr("--max-seconds"));
  for (const char* other : {"--path-samples", "--output", "--sampler", "--seed", "Antialias", "Work_Threads"})
    EXPECT_THAT(check, Not(HasSubstr(other)));
  const Ended refused = run({"check", "scene.pov", "--path-samples", "4"});
  EXPECT_EQ(refused.status, kUsage);
  EXPECT_THAT(refused.errors, HasSubstr("verisim render"));
  EXPECT_EQ(run({"check", "scene.pov", "+A0.3", "+WT2"}).status, kOk);  // the switches of a render may stay
}

TEST_F(Help, SettingsInTheStyleOfOtherProgramsAreAnsweredWithTheRightWord) {
  const auto errors = [&](const std::vector<std::string>& arguments) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.status, kUsage);
    return ended.errors;
  };
  EXPECT_THAT(errors({"render", "scene.pov", "--width", "640"}), HasSubstr("+W640 or Width=640"));
  EXPECT_THAT(errors({"render", "scene.pov", "--height=48"}), HasSubstr("+H48 or Height=48"));
  EXPECT_THAT(errors({"render", "scene.pov", "--antialias"}), HasSubstr("+A or Antialias=on"));
  EXPECT_THAT(errors({"render", "scene.pov", "--threads", "2"}), HasSubstr("+WT2 or Work_Threads=2"));
  EXPECT_THAT(errors({"render", "scene.pov", "--size", "64x48"}), HasSubstr("+W64 +H48"));
  EXPECT_THAT(errors({"render", "scene.pov", "--sed", "4"}), HasSubstr("did you mean --seed?"));
  EXPECT_THAT(errors({"render", "scene.pov", "--qqqqqqqq"}), HasSubstr("verisim render --help"));
}

TEST_F(Help, TheManPagesAreGoodRoff) {
  if (std::system("command -v groff >/dev/null && command -v man >/dev/null") != 0)
    GTEST_SKIP() << "groff is not installed";
  ASSERT_EQ(run({"help", "--pages", "pages"}).status, kOk);
  int pages = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "pages")) {
    if (entry.path().extension() != ".1") continue;
    ++pages;
    const std::string groff =
        "cd '" + folder_.string() + "' && groff -man -Tutf8 -ww -z '" + entry.path().string() + "' >faults.txt 2>&1";
    EXPECT_EQ(std::system(groff.c_str()), 0);
    EXPECT_EQ(text_of(folder_ / "faults.txt"), "") << entry.path();
  }
  EXPECT_GT(pages, 8);  // the program's and one for each command
  EXPECT_TRUE(exists("pages/verisim-view.1"));
}

TEST_F(Help, BashCompletesCommandsOptionsAndKeywords) {
  file("verisim.bash", run({"help", "--format", "bash"}).output);
  const auto completed = [&](const std::string& words, int current) {
    const std::string script = "cd '" + folder_.string() + "' && bash -c '. ./verisim.bash; COMP_WORDS=(" + words +
                               "); COMP_CWORD=" + std::to_string(current) +
                               "; _verisim 2>/dev/null; echo ${COMPREPLY[@]}' > completed.txt";
    EXPECT_EQ(std::system(script.c_str()), 0);
    return text_of(folder_ / "completed.txt");
  };
  EXPECT_EQ(completed("verisim ren", 1), "render\n");
  EXPECT_EQ(completed("verisim sc", 1), "scene.pov\n");
  EXPECT_EQ(completed("verisim check --max-st", 2), "--max-steps\n");
  EXPECT_EQ(completed("verisim render scene.pov Antialias_D", 3), "Antialias_Depth=\n");
  EXPECT_EQ(completed("verisim check --outp", 2), "\n");
}

TEST_F(Help, TheVersionTellsProgramsWhatItIsMadeOf) {
  const auto version = nlohmann::json::parse(run({"--version", "--json"}).output);
  EXPECT_EQ(version["program"], "verisim");
  EXPECT_THAT(run({"--version"}).output, HasSubstr("verisim " + version["version"].get<std::string>()));
  EXPECT_EQ(version["instruction_sets"][0], "baseline");
  EXPECT_TRUE(version["libraries"].contains("libpng"));
}

}  // namespace
}  // namespace verisim::cli
