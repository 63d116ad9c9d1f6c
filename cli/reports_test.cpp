// What `verisim diff` and `verisim compare` (VERISIM_BINARY_DIR/bin/verisim, cli/process_fixture.h) say, and where.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/process_fixture.h"

namespace verisim::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class Reports : public Process {
 protected:
  void SetUp() override {
    Process::SetUp();
    ASSERT_EQ(run({"render", "scene.pov", "+W32", "+H24", "+Oa.png"}).status, 0);
    ASSERT_EQ(run({"render", "scene.pov", "+W64", "+H48", "+Olarge.png"}).status, 0);
  }
  nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(text_of(folder_ / name), nullptr, false);
  }
  Ended baseline(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"compare", "suite", "--baseline", "stored", "--quiet", "--json", "run.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  std::string status_of(const std::string& scene) const {
    const nlohmann::json report = json("run.json");
    for (const auto& s : report.at("scenes"))
      if (s["scene"] == scene) return s["status"];
    return "absent";
  }
};

TEST_F(Reports, ADiffOfACroppedPairHasAPage) {
  const Ended ended =
      run({"diff", "large.png", "a.png", "--crop", "16,12,32,24", "--html", "page.html", "--json", "figures.json"});
  EXPECT_EQ(ended.status, 1) << ended.errors;
  EXPECT_THAT(text_of(folder_ / "page.html"), HasSubstr("reference cut to 32x24"));
  EXPECT_EQ(json("figures.json")["fit"]["crop"], nlohmann::json({16, 12, 32, 24}));
}

// The page shows what was measured: one exposure apart, the fitted pictures are the same, and the file's own are not.
TEST_F(Reports, ADiffOfAFittedPairShowsTheFittedPictures) {
  for (const auto& [name, light] : {std::pair("bright", "1"), std::pair("dark", "0.5")}) {
    file(std::string(name) + ".pov",
         "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }\n"
         "light_source { <3,4,-9> rgb " +
             std::string(light) + " } sphere { 0, 1 pigment { rgb .7 } finish { ambient 0 } }\n");
    ASSERT_EQ(
        run({"render", std::string(name) + ".pov", "+W32", "+H24", "+FN16", "+O" + std::string(name) + ".png"}).status,
        0);
  }
  const auto picture_of = [&](const std::string& page) {
    const std::string text = text_of(folder_ / page), mark = "id=\"p0n\">";
    const std::size_t from = text.find(mark);
    return from == std::string::npos ? std::string()
                                     : text.substr(from + mark.size(), text.find('<', from) - from - mark.size());
  };
  EXPECT_EQ(run({"diff", "bright.png", "dark.png", "--html", "plain.html"}).status, 1);
  EXPECT_EQ(run({"diff", "bright.png", "dark.png", "--fit", "exposure", "--html", "fitted.html"}).status, 0);
  EXPECT_NE(picture_of("plain.html"), "");
  EXPECT_EQ(picture_of("fitted.html"), "") << "equal pictures stand in the page once";
}

TEST_F(Reports, PsnrOfEqualPicturesIsWrittenAlikeEverywhere) {
  const Ended ended = run({"diff", "a.png", "a.png", "--json", "d.json", "--html", "d.html"});
  EXPECT_EQ(json("d.json")["psnr"], 999);
  EXPECT_THAT(ended.output, HasSubstr("999 dB"));
  EXPECT_THAT(text_of(folder_ / "d.html"), HasSubstr("\"psnr\":999"));
  const std::vector<std::string> words{"compare", "verisim.toml", "--quiet", "--junit", "r.xml"};
  file("verisim.toml", "width = 32\nheight = 24\n[[scene]]\nfile = \"scene.pov\"\nreference = \"a.png\"\n");
  const std::string table = run(words).output;
  for (const std::string& text : {table, text_of(folder_ / "r.xml"), ended.output}) {
    EXPECT_THAT(text, HasSubstr("999"));
    EXPECT_THAT(text, Not(HasSubstr("inf")));
  }
}

TEST_F(Reports, LayersOfOpenExrHaveLimitsOnTheCommandLine) {
  for (const auto& [name, x] : {std::pair("one", "0"), std::pair("two", "0.2")}) {
    file(std::string(name) + ".pov",
         "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }\n"
         "sphere { <0,0," +
             std::string(x) + ">, 1 pigment { rgb 0 } }\n");
    ASSERT_EQ(run({"render", std::string(name) + ".pov", "+W32", "+H24", "--layers", "beauty,depth",
                   "+Odeep_" + std::string(name) + ".exr"})
                  .status,
              0);
    ASSERT_EQ(run({"render", std::string(name) + ".pov", "+W32", "+H24", "--layers", "depth,id",
                   "+O" + std::string(name) + ".exr"})
                  .status,
              0);
  }
  const Ended plain = run({"diff", "one.exr", "two.exr", "--json", "d.json"});
  EXPECT_EQ(plain.status, 1);
  EXPECT_THAT(plain.output, HasSubstr("layer Z (depth): differ: "));
  EXPECT_EQ(json("d.json")["layers"].at(0)["name"], "Z");
  EXPECT_THAT(std::string(json("d.json")["reason"]), HasSubstr("layer Z: "));
  EXPECT_EQ(run({"diff", "one.exr", "two.exr", "--layer", "*:ignore"}).status, 0);
  EXPECT_EQ(run({"diff", "one.exr", "two.exr", "--layer", "Z:pixels=800", "--layer", "id:ignore"}).status, 0);
  EXPECT_EQ(run({"diff", "one.exr", "two.exr", "--layer", "Z:pixels"}).status, 2);
  EXPECT_EQ(run({"diff", "deep_one.exr", "deep_two.exr", "--layer", "Z:ignore"}).status, 0) << "depth is no alpha";
}

TEST_F(Reports, ReplayOfASceneAsksPOVRayForItsNumbers) {
  if (::access("/usr/bin/povray", X_OK) != 0) GTEST_SKIP() << "POV-Ray is not installed";
  file("noisy.pov",
       "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }\n"
       "light_source { <3,4,-9> rgb 1 } sphere { 0, 1 pigment { rgb .7 } finish { crand 0.3 } }\n");
  const std::vector<std::string> words{"explain", "noisy.pov", "+W32", "+H24"};
  EXPECT_THAT(run(words).output, Not(HasSubstr("noisy.pov: exact"))) << "noise of its own";
  std::vector<std::string> replayed = words;
  replayed.emplace_back("--replay");
  EXPECT_THAT(run(replayed).output, HasSubstr("noisy.pov: exact"));
}

// Of four runs with one seed each pixel would be stored as one without noise, and every other seed refused.
TEST_F(Reports, RunsDifferWithASeedToo) {
  fs::create_directory(folder_ / "suite");
  file("suite/noisy.pov",
       "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }\n"
       "light_source { <3,4,-9> rgb 1 } sphere { 0, 1 pigment { rgb .7 } finish { crand 0.3 } }\n");
  const std::vector<std::string> noisy{"+W32", "+H24", "--class", "stochastic", "--seed"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), noisy.begin(), noisy.end());
    return more;
  };
  ASSERT_EQ(baseline(with({"1007", "--runs", "8", "--update"})).status, 0);
  EXPECT_EQ(baseline(with({"52", "--runs", "1"})).status, 0) << status_of("noisy.pov");
}

TEST_F(Reports, ADiffAsJsonSaysWhatThePeopleAreTold) {
  ASSERT_EQ(run({"render", "scene.pov", "+W32", "+H24", "+Q0", "+Ob.png"}).status, 0);
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--json", "d.json"}).status, 1);
  EXPECT_EQ(json("d.json")["status"], "differ");
  EXPECT_NE(json("d.json")["reason"], "");
  EXPECT_TRUE(json("d.json")["suspects"].is_array());
  EXPECT_EQ(
      run({"diff", "a.png", "b.png", "--threshold", "max_rmse=255", "--json", "d.json", "--html", "d.html"}).status, 0);
  EXPECT_EQ(json("d.json")["status"], "match");
  EXPECT_THAT(text_of(folder_ / "d.html"), HasSubstr("\"status\":\"match\""))
      << "the page has the verdict of the limits that were given";
}

TEST_F(Reports, FoldersOfPicturesAreComparedByNames) {
  for (const char* folder : {"left/sub", "right/sub"}) fs::create_directories(folder_ / folder);
  for (const char* name : {"left/same.png", "right/same.png", "left/sub/size.png", "left/gone.png", "right/fresh.png"})
    fs::copy_file(folder_ / "a.png", folder_ / name);
  fs::copy_file(folder_ / "large.png", folder_ / "right/sub/size.png");
  file("left/notes.txt", "no picture");
  EXPECT_EQ(run({"diff", "left", "right", "--json", "run.json", "--html", "page.html"}).status, 1);
  EXPECT_EQ(json("run.json")["scenes"].size(), 4u);
  EXPECT_EQ(status_of("same.png"), "exact");
  EXPECT_EQ(status_of("sub/size.png"), "differ");
  EXPECT_EQ(status_of("gone.png"), "removed");
  EXPECT_EQ(status_of("fresh.png"), "new");
  EXPECT_THAT(text_of(folder_ / "page.html"), HasSubstr("sub/size.png"));
  EXPECT_EQ(run({"diff", "left", "left"}).status, 0);
  EXPECT_EQ(run({"diff", "left", "right", "--threshold", "max_nonsense=1"}).status, 2);
  EXPECT_EQ(run({"diff", "home", "home"}).status, 5) << "nothing to compare is no success";
}

TEST_F(Reports, AnyRendererIsJudgedByItsCommand) {
  fs::create_directory(folder_ / "suite");
  file("suite/it's one.pov", kQuickScene);
  const std::string verisim =
      VERISIM_BINARY_DIR "/bin/verisim render {scene} +W{width} +H{height} {switches} +O{out} +WT{threads}";
  ASSERT_EQ(baseline({"+W16", "+H12", "--update"}).status, 0);
  EXPECT_EQ(baseline({"+W16", "+H12", "--test", verisim}).status, 0);
  EXPECT_EQ(baseline({"+W16", "+H12", "--test", verisim + " +Q0"}).status, 1);
  EXPECT_EQ(status_of("it's one.pov"), "differ");
  EXPECT_EQ(baseline({"+W16", "+H12", "--test", "echo 'no {{ licence' >&2; exit 3 # {scene} {out}"}).status, 1);
  EXPECT_EQ(json("run.json").at("scenes").at(0).at("reason"), "exit status 3: no { licence");
  EXPECT_EQ(baseline({"--test", "render {scene} {out} {nonsense}"}).status, 2);
  EXPECT_EQ(baseline({"--test", "render {scene}"}).status, 2);
}

TEST_F(Reports, AKnownFailureIsReportedAndFailsNothing) {
  const std::string manifest =
      "width = 32\nheight = 24\nswitches = \"+Q0\"\n[[scene]]\nfile = \"scene.pov\"\nreference = \"a.png\"\n";
  const std::vector<std::string> compare{"compare",  "verisim.toml", "--quiet", "--json",
                                         "run.json", "--junit",      "run.xml", "--github"};
  file("verisim.toml", manifest);
  EXPECT_EQ(run(compare).status, 1);
  file("verisim.toml", manifest + "known_failure = \"lights come with issue 7\"\n");
  const Ended known = run(compare);
  EXPECT_EQ(known.status, 0) << known.errors;
  EXPECT_THAT(known.output, HasSubstr("known to fail: lights come with issue 7"));
  EXPECT_THAT(known.output, Not(HasSubstr("::error")));
  EXPECT_EQ(status_of("scene.pov"), "differ");
  EXPECT_EQ(json("run.json")["summary"]["known_failures"], 1);
  EXPECT_THAT(text_of(folder_ / "run.xml"), HasSubstr("<skipped"));
  file("verisim.toml",
       "width = 32\nheight = 24\n[[scene]]\nfile = \"scene.pov\"\nreference = \"a.png\"\nknown_failure = \"x\"\n");
  EXPECT_THAT(run(compare).output, HasSubstr("passes, though it was known to fail"));
}

TEST_F(Reports, AReportToStandardOutputIsAlone) {
  const Ended diff = run({"diff", "a.png", "a.png", "--json", "-"});
  EXPECT_FALSE(nlohmann::json::parse(diff.output, nullptr, false).is_discarded()) << diff.output;
  const Ended suite = run({"compare", "scene.pov", "+W8", "+H6", "--baseline", "none", "--quiet", "--json", "-"});
  EXPECT_FALSE(nlohmann::json::parse(suite.output, nullptr, false).is_discarded()) << suite.output;
}

TEST_F(Reports, ACropOfAnotherShapeIsRefused) {
  const Ended ended = run({"diff", "large.png", "a.png", "--crop", "0,0,64,16"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.errors, HasSubstr("another shape"));
}

TEST_F(Reports, NamesAreWholeWhereNobodyCountsColumns) {
  const std::string name = "a_very_long_name_of_a_scene_that_fills_most_of_a_line_of_a_terminal.pov";
  file(name, kQuickScene);
  EXPECT_THAT(run({"compare", name, "+W8", "+H6", "--baseline", "none", "--quiet"}).output,
              HasSubstr("\n" + name + " new"));
}

TEST_F(Reports, NoPictureIsToldFromNoPngFile) {
  fs::create_directory(folder_ / "folder.png");
  file("empty.png", "");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.png").c_str(), 0600), 0);
  const int both = ::open((folder_ / "pipe.png").c_str(), O_RDWR);  // or opening it would wait
  EXPECT_THAT(run({"diff", "a.png", "folder.png"}).errors, HasSubstr("it is a folder"));
  EXPECT_THAT(run({"diff", "a.png", "empty.png"}).errors, HasSubstr("the file is empty"));
  EXPECT_THAT(run({"diff", "a.png", "absent.png"}).errors, HasSubstr("No such file"));
  ::write(both, "x", 1) == 1 ? void() : ADD_FAILURE();
  EXPECT_THAT(run({"diff", "a.png", "pipe.png"}).errors, HasSubstr("pipe"));
  ::close(both);
}

TEST_F(Reports, ACutOffJpegIsNoPicture) {
  ASSERT_EQ(run({"render", "scene.pov", "+W64", "+H48", "+Owhole.jpg"}).status, 0);
  const std::string whole = text_of(folder_ / "whole.jpg");
  file("cut.jpg", whole.substr(0, whole.size() * 3 / 4));
  file("trailing.jpg", whole + "a telephone's notes");
  EXPECT_EQ(run({"diff", "whole.jpg", "trailing.jpg"}).status, 0);
  const Ended ended = run({"diff", "whole.jpg", "cut.jpg"});
  EXPECT_NE(ended.status, 0);
  EXPECT_THAT(ended.errors, HasSubstr("cut off"));
}

TEST_F(Reports, BaselinesNameWhatIsNewRemovedOrOfAnotherSize) {
  fs::create_directory(folder_ / "suite");
  file("suite/old.pov", kQuickScene);
  file("suite/gone.pov", kQuickScene);
  ASSERT_EQ(baseline({"+W8", "+H6", "--update"}).status, 0);
  fs::remove(folder_ / "suite/gone.pov");
  file("suite/fresh.pov", kQuickScene);
  EXPECT_EQ(baseline({"+W8", "+H6"}).status, 1);
  EXPECT_EQ(status_of("old.pov"), "exact");
  EXPECT_EQ(status_of("fresh.pov"), "new");
  EXPECT_EQ(status_of("gone.pov"), "removed");
  EXPECT_EQ(baseline({"+W8", "+H6", "--name", "old"}).status, 0) << "what was not asked for is not gone";
  const Ended larger = baseline({"+W16", "+H12"});
  EXPECT_THAT(larger.output, HasSubstr("the stored picture has 8x6 pixels, this one 16x12; it was stored by"));
  ASSERT_EQ(baseline({"+W8", "+H6", "--update"}).status, 0);
  EXPECT_EQ(baseline({"+W8", "+H6"}).status, 0);
  EXPECT_EQ(status_of("gone.pov"), "absent");
  EXPECT_FALSE(exists("stored/gone.pov.png"));
}

TEST_F(Reports, APictureThatCannotBeMadeIsNoUpdate) {
  fs::create_directory(folder_ / "suite");
  file("suite/a.pov", kQuickScene);
  ASSERT_EQ(baseline({"+W8", "+H6", "--update"}).status, 0);
  const std::string stored = text_of(folder_ / "stored/a.pov.png");
  file("suite/a.pov", "sphere {");
  file("suite/b.pov", kQuickScene);
  EXPECT_EQ(baseline({"+W8", "+H6", "--update"}).status, 1);
  EXPECT_EQ(text_of(folder_ / "stored/a.pov.png"), stored);
  EXPECT_TRUE(exists("stored/b.pov.png"));
}

// As shells complete it; in POV-Ray's own calls that would be a place to look for include files.
TEST_F(Reports, AFolderOfScenesMayEndWithASlash) {
  fs::create_directories(folder_ / "scenes");
  file("scenes/one.pov", kQuickScene);
  EXPECT_EQ(run({"check", "scenes/"}).status, 0);
  const Ended compared = run({"compare", "scenes/", "--oracle", "/bin/true"});
  EXPECT_EQ(compared.errors.find("name scenes"), std::string::npos) << compared.errors;
}

TEST_F(Reports, POVRayReadsScenesOfAnyName) {
  if (::access("/usr/bin/povray", X_OK) != 0) GTEST_SKIP() << "POV-Ray is not installed";
  fs::create_directory(folder_ / "suite");
  for (const char* name : {"a b.pov", "co,ma;x.pov", "gr\u00fcn.pov", "it's.pov", "say \"hi\".pov"})
    file(std::string("suite/") + name, kQuickScene);
  const Ended ended =
      run({"compare", "suite", "+W8", "+H6", "--quiet", "--oracle-cache", (folder_ / "cache").string()});
  EXPECT_EQ(ended.status, 0) << ended.output << ended.errors;
}

TEST_F(Reports, APhotographIsNotPOVRays) {
  file("verisim.toml",
       "[[scene]]\nfile = \"scene.pov\"\nwidth = 32\nheight = 24\nreference = \"a.png\"\nfit = [\"exposure\"]\n");
  const Ended ended = run({"compare", "verisim.toml", "--quiet", "--json", "run.json", "--html", "page.html"});
  EXPECT_EQ(ended.status, 0) << ended.output << ended.errors;
  EXPECT_EQ(json("run.json")["reference"], "photograph");
  EXPECT_THAT(ended.output, Not(HasSubstr("POV")));
}

TEST_F(Reports, AnnotationsHaveALine) {
  file("wrong.pov", "#version 3.7;\n\nsphere { 0, 1 pigment { rgbx 1 } }\n");
  EXPECT_THAT(run({"compare", "wrong.pov", "+W8", "+H6", "--baseline", "none", "--quiet", "--github"}).output,
              HasSubstr("wrong.pov,line=3,title="));
  // Of a scene that differs: the line of the object that does.
  const auto room = [&](const char* color) {
    file("suite/room.pov",
         "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }\n"
         "light_source { <3,4,-9> rgb 1 }\nplane { z, 3 pigment { rgb .5 } }\n\n"
         "sphere { 0, 1 pigment { rgb " +
             std::string(color) + " } }\n");
  };
  fs::create_directory(folder_ / "suite");
  room(".5");
  ASSERT_EQ(baseline({"+W32", "+H24", "--update"}).status, 0);
  room("<.8, .5, .2>");
  EXPECT_THAT(baseline({"+W32", "+H24", "--github"}).output, HasSubstr("room.pov,line=5,title="));
}

TEST_F(Reports, ReplayOfOnePixelIsRefusedInWords) {
  const Ended ended = run({"explain", "scene.pov", "3", "3", "--replay", "--no-oracle"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.errors, HasSubstr("compares the whole picture"));
}

// A kill leaves neither a program that runs on nor, after the next run, a folder.
TEST_F(Reports, AKillLeavesNothingBehind) {
  const fs::path tmp = folder_.string() + "_tmp";  // not below the scene's folder, which is copied
  fs::create_directory(tmp);
  ::setenv("TMPDIR", tmp.c_str(), 1);
  // A reference that takes its time, and says who it is.
  file("slow.sh", "#!/bin/sh\ncase \"$*\" in *--version*) echo 'POV-Ray 3.7.0'; exit 0;; esac\necho $$ > " +
                      (folder_ / "reference.pid").string() + "\nexec sleep 60\n");
  fs::permissions(folder_ / "slow.sh", fs::perms::owner_all);
  const pid_t child = start({"compare", "scene.pov", "+W8", "+H6", "--oracle", "./slow.sh", "--quiet", "--no-cache"});
  wait_for("reference.pid");
  const pid_t reference = std::atoi(text_of(folder_ / "reference.pid").c_str());
  ASSERT_GT(reference, 0);
  EXPECT_EQ(::kill(reference, 0), 0);
  ::kill(child, SIGKILL);
  wait(child);
  bool gone = false;
  for (int i = 0; i < 200 && !gone; ++i) {
    const std::string about = text_of("/proc/" + std::to_string(reference) + "/stat");
    gone = about.empty() || about.find(") Z ") != std::string::npos;
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_TRUE(gone) << "the reference runs on";
  if (!gone) ::kill(reference, SIGKILL);
  EXPECT_FALSE(fs::is_empty(tmp));
  for (const auto& entry : fs::directory_iterator(tmp)) {
    const timespec old[2] = {{1, 0}, {1, 0}};
    ::utimensat(AT_FDCWD, entry.path().c_str(), old, 0);
  }
  run({"compare", "scene.pov", "+W8", "+H6", "--baseline", "none", "--quiet"});
  EXPECT_TRUE(fs::is_empty(tmp));
  ::unsetenv("TMPDIR");
  fs::remove_all(tmp);
}

}  // namespace
}  // namespace verisim::cli
