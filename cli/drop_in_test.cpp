// Programs that call POV-Ray find everything in its place when `povray` is a link to verisim: calls as vapory and
// molecule viewers make them, environment variables, animations, and what happens when the world around a render
// changes.
#include "cli/process_fixture.h"

#include <nlohmann/json.hpp>

namespace verisim::cli {
namespace {

class DropIn : public Process {
 protected:
  void SetUp() override {
    Process::SetUp();
    fs::create_symlink(VERISIM_BINARY_DIR "/bin/verisim", folder_ / "povray");
  }
};

// The Python package vapory writes __temp__.pov and reads a PPM or PNG from standard output.
TEST_F(DropIn, VaporyGetsItsPictureFromStandardOutput) {
  fs::copy_file(folder_ / "scene.pov", folder_ / "__temp__.pov");
  const Ended ppm = shell("./povray __temp__.pov +H30 +W40 +Q9 +A0.010000 -D Output_File_Type=P +O-", kQuickScene);
  ASSERT_EQ(ppm.status, 0) << ppm.errors;
  EXPECT_EQ(ppm.output.substr(0, 2), "P6");
  EXPECT_GE(ppm.output.size(), 40u * 30u * 3u);
  file("got.ppm", ppm.output);
  const image::Picture picture = image::read_picture(folder_ / "got.ppm");
  EXPECT_EQ(picture.width, 40);
  EXPECT_EQ(picture.height, 30);
  const Ended png = shell("./povray __temp__.pov +H30 +W40 +A0.010000 Output_Alpha=on -D Output_File_Type=N +O-");
  ASSERT_EQ(png.status, 0);
  EXPECT_EQ(png.output.substr(1, 3), "PNG");
  fs::copy_file(folder_ / "bad.pov", folder_ / "__temp__.pov", fs::copy_options::overwrite_existing);
  const Ended bad = shell("./povray __temp__.pov +H30 +W40 -D Output_File_Type=P +O-");
  EXPECT_EQ(bad.status, 1);
  EXPECT_TRUE(bad.output.empty());
  EXPECT_NE(bad.errors.find("Error"), std::string::npos);
}

TEST_F(DropIn, MoleculeViewersGetTheirFile) {
  // VMD's default call, and PyMOL's.
  EXPECT_EQ(shell("./povray +W40 +H30 -Iscene.pov -Ovmdscene.pov.tga +X +A +FT").status, 0);
  EXPECT_TRUE(exists("vmdscene.pov.tga"));
  EXPECT_EQ(shell("./povray +Iscene.pov +Otmp_pymol.png +W40 +H30 +A0.3 -D -GA").status, 0);
  EXPECT_TRUE(exists("tmp_pymol.png"));
  // An INI file made by a program, with a section.
  file("job.ini",
       "; made by a "
       "program\nAntialias=On\nInput_File_Name=scene.pov\n[small]\nWidth=20\nHeight=10\n[large]\nWidth=60\nHeight="
       "40\nOutput_File_Name=large.png\n");
  EXPECT_EQ(shell("./povray job.ini[large] -D").status, 0);
  EXPECT_EQ(image::read_picture(folder_ / "large.png").width, 60);
}

TEST_F(DropIn, ASceneComesThroughStandardInputsDevice) {
  const Ended ended = shell("./povray +I/dev/stdin +Oout.png +W16 +H12 -D", kQuickScene);
  EXPECT_EQ(ended.status, 0) << ended.errors;
  EXPECT_TRUE(exists("out.png"));
}

TEST_F(DropIn, EnvironmentVariablesAreHeeded) {
  fs::create_directories(folder_ / "inc");
  file("inc/part.inc", "#declare Size = 1;\n");
  file("needs.pov", std::string("#include \"part.inc\"\n") + kQuickScene);
  EXPECT_EQ(shell("POVINI=empty.ini ./povray needs.pov +W8 +H8 -D").status, 1);
  EXPECT_EQ(shell("POVINC=$PWD/inc ./povray needs.pov +W8 +H8 -D").status, 0);
  file("mine.ini", "Width=24\nHeight=18\nOutput_File_Name=mine.png\n");
  EXPECT_EQ(shell("POVINI=mine.ini ./povray scene.pov -D").status, 0);
  EXPECT_EQ(image::read_picture(folder_ / "mine.png").width, 24);
  fs::create_directories(folder_ / "home/.povray/3.7");
  file("home/.povray/3.7/povray.ini", "Width=28\nHeight=18\nOutput_File_Name=home.png\n");
  EXPECT_EQ(shell("unset POVINI; ./povray scene.pov -D").status, 0);
  ASSERT_TRUE(exists("home.png"));
  EXPECT_EQ(image::read_picture(folder_ / "home.png").width, 28);
  file("povray.ini", "Width=12\nHeight=9\nOutput_File_Name=here.png\n");  // the current folder's comes first, and alone
  EXPECT_EQ(shell("unset POVINI; ./povray scene.pov -D").status, 0);
  EXPECT_EQ(image::read_picture(folder_ / "here.png").width, 12);
}

TEST_F(DropIn, StatisticsComeAsTextAndAsJson) {
  const Ended ended = shell("./povray scene.pov +W16 +H12 -D --stats stats.json");
  for (const char* part : {"Render Statistics", "Pixels:", "Parser Time", "Trace Time"})
    EXPECT_NE(ended.errors.find(part), std::string::npos) << part << "\n" << ended.errors;
  const auto json = nlohmann::json::parse(text_of(folder_ / "stats.json"));
  EXPECT_EQ(json["frames"][0]["pixels"], 16 * 12);
  EXPECT_GT(json["rays"]["shadow"], 0);
}

TEST_F(DropIn, MetadataSayWhereThePictureComesFrom) {
  ASSERT_EQ(shell("./povray scene.pov +W16 +H12 +A0.2 -D --stamp").status, 0);
  const std::string png = text_of(folder_ / "scene.png");
  for (const char* part : {"verisim ", "Rendered from scene.pov", "Antialias_Threshold=", "Render Time"})
    EXPECT_NE(png.find(part), std::string::npos) << part;
  EXPECT_EQ(png.find(folder_.string()), std::string::npos) << "paths of this machine do not belong into a picture";
}

TEST_F(DropIn, SignalsEndTheRenderAsPovRayDoes) {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT}) {
    fs::remove(folder_ / "part.pov-state");
    const pid_t child = start({"+Islow.pov", "+W320", "+H240", "+A0.0", "+R6", "+Opart", "-D"});
    wait_for("part.pov-state");
    ::kill(child, signal);
    const Ended ended = wait(child);
    EXPECT_EQ(ended.status, 2) << signal << ended.errors;
    EXPECT_TRUE(exists("part.pov-state")) << signal;
    EXPECT_TRUE(leftovers(folder_).empty()) << signal;
  }
}

TEST_F(DropIn, AFolderThatVanishesMeanwhileIsAClearError) {
  fs::create_directories(folder_ / "gone");
  const pid_t child = start({"render", "slow.pov", "+W320", "+H240", "+A0.0", "+R5", "+Ogone/out.png"});
  wait_for("gone/out.pov-state");
  fs::rename(folder_ / "gone", folder_ / "elsewhere");
  const Ended ended = wait(child);
  EXPECT_EQ(ended.status, 5) << ended.errors;
  EXPECT_NE(ended.errors.find("gone/out.png"), std::string::npos) << ended.errors;
  EXPECT_TRUE(leftovers(folder_ / "elsewhere").empty());
}

TEST_F(DropIn, AnIncludeFileThatVanishesBetweenFramesEndsTheAnimation) {
  file("part.inc", "#declare Size = 1;\n");
  file("frames.pov", std::string("#include \"part.inc\" #declare C = clock;\n") + kQuickScene);
  file("frames.ini",
       "Input_File_Name=frames.pov\nWidth=8\nHeight=8\nFinal_Frame=3\nPost_Frame_Command=rm -f part.inc\n");
  const Ended ended = run({"frames.ini", "-D", "--allow-shell"});
  EXPECT_EQ(ended.status, 1);
  EXPECT_NE(ended.errors.find("part.inc"), std::string::npos);
  EXPECT_TRUE(exists("frames1.png"));
  EXPECT_FALSE(exists("frames2.png"));
}

TEST_F(DropIn, FramesShareASceneThatDoesNotLookAtTheClock) {
  file("still.pov", kQuickScene);
  file("moving.pov", std::string(kQuickScene) + "sphere { clock*x, 0.5 }\n");
  file("hidden.inc", "#declare C = clock;\n");
  file("indirect.pov", std::string(kQuickScene) + "#include \"hidden.inc\"\n");
  const auto parsed = [&](const std::string& name) {
    EXPECT_EQ(run({"render", name, "+W8", "+H8", "+KFF4", "--stats", "stats.json"}).status, 0) << name;
    const auto json = nlohmann::json::parse(text_of(folder_ / "stats.json"));
    int count = 0;
    for (const auto& frame : json["frames"]) count += frame["seconds"]["parse"] > 0;
    return count;
  };
  EXPECT_EQ(parsed("still.pov"), 1);
  EXPECT_TRUE(exists("still4.png"));
  EXPECT_EQ(parsed("moving.pov"), 4);
  EXPECT_EQ(parsed("indirect.pov"), 4);
}

// ------------------------------------------------------------------------------------------------ beside POV-Ray

class Animations : public DropIn {
 protected:
  void SetUp() override {
    DropIn::SetUp();
    if (std::system("command -v povray >/dev/null 2>&1") != 0) GTEST_SKIP() << "POV-Ray is not installed";
    file("film.pov",
         "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,1.13,-5> look_at 0 rotate 40*clock*y "
         "}\n"
         "light_source { <3,4,-9> rgb 1 } plane { y,-1 pigment { checker rgb 1, rgb <.2,.3,.4> } }\n"
         "box { -0.7, 0.7 rotate 90*clock*<1,1,0> pigment { rgb <1, frame_number/max(1,final_frame), 0.3> } }\n"
         "sphere { <2*clock - 1, 0.9, 0>, 0.3 + clock_delta pigment { rgb <.3,.8,.4> } finish { reflection 0.2 } }\n");
  }
  // Every frame of both, pixel by pixel.
  void same(const std::string& switches, int expected) {
    for (const char* name : {"ours", "theirs"}) fs::create_directories(folder_ / name);
    const std::string call = " +Ifilm.pov +W32 +H24 -A -D -GA " + switches;
    const Ended ours = shell("POVINI=empty.ini ./povray" + call + " +Oours/", ""),
                theirs = shell("POVINI=empty.ini povray" + call + " +Otheirs/", "");
    ASSERT_EQ(ours.status, 0) << ours.errors;
    ASSERT_EQ(theirs.status, 0) << theirs.errors;
    int frames = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / "theirs")) {
      const fs::path mine = folder_ / "ours" / entry.path().filename();
      ASSERT_TRUE(fs::exists(mine)) << switches << ": " << entry.path().filename();
      const std::vector<float> a = image::read_picture(entry.path()).samples, b = image::read_picture(mine).samples;
      ASSERT_EQ(a.size(), b.size());
      int beyond = 0;
      for (std::size_t i = 0; i < a.size(); ++i) beyond += std::fabs(a[i] - b[i]) > 1.01f / 255;
      EXPECT_EQ(beyond, 0) << switches << ": " << mine.filename();
      ++frames;
    }
    EXPECT_EQ(frames, expected) << switches;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "ours"), fs::directory_iterator()), frames) << switches;
    for (const char* name : {"ours", "theirs"}) fs::remove_all(folder_ / name);
  }
};

TEST_F(Animations, SettingsOfFramesAndClocksGiveTheSameFiles) {
  same("+KFF3 +KC", 3);
  same("+KFI2 +KFF8 +STP3", 3);
  same("+KFI1 +KFF10 +SF0.3 +EF0.4", 2);
  same("+KFI8 +KFF11 +KI0.5 +KF2 +SF9 +EF10", 2);
  same("+KFF2 +UF +UO", 2);
  same("+K0.3", 1);
}

TEST_F(Animations, SlowSixtyFramesEqualPovRays) { same("+KFF60", 60); }

}  // namespace
}  // namespace verisim::cli
