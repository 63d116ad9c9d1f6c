// The program as a process: exit statuses (P21), bad input, interrupted renders, what is left on the disk.
#include "cli/process_fixture.h"

#include <sys/mount.h>
#include <sys/resource.h>

#include <algorithm>
#include <random>

#include "tracer/base/sanitizers.h"

namespace verisim::cli {
namespace {

TEST_F(Process, StatusesOfPovRayCalls) {
  EXPECT_EQ(run({"+Iscene.pov", "+W16", "+H12", "-D"}).status, 0);
  EXPECT_TRUE(exists("scene.png"));
  EXPECT_EQ(run({"+Ibad.pov", "-D"}).status, 1);
  EXPECT_EQ(run({"+Imissing.pov", "-D"}).status, 1);
  EXPECT_EQ(run({"+Iscene.pov", "+ZZ"}).status, 1);
  EXPECT_EQ(run({"+W10"}).status, 1);
  EXPECT_EQ(run({"+Iscene.pov", "+Onowhere/out.png", "+W8", "+H8"}).status, 1);
  EXPECT_EQ(run({"+Iscene.pov", "+W8", "+H8", "+EC0"}).status, 1);
  EXPECT_EQ(run({"+Iscene.pov", "+W8", "+H8", "+SC6", "+EC3"}).status, 0);
  EXPECT_EQ(run({"scene.pov", "Width=8", "Height=8"}, "povray").status, 0);
}

TEST_F(Process, NoThreadsMakeABlackPicture) {
  ASSERT_EQ(run({"+Iscene.pov", "+W16", "+H12", "+WT0", "-D"}).status, 0);
  const image::Picture picture = image::read_picture(folder_ / "scene.png");
  for (const float sample : picture.samples) ASSERT_EQ(sample, 0);
}

TEST_F(Process, StatusesOfSubcommands) {
  EXPECT_EQ(run({"render", "scene.pov", "+W16", "+H12"}).status, 0);
  EXPECT_EQ(run({"render", "bad.pov"}).status, 3);
  EXPECT_EQ(run({"check", "scene.pov"}).status, 0);
  EXPECT_EQ(run({"check", "bad.pov"}).status, 3);
  EXPECT_EQ(run({"check", "missing.pov"}).status, 5);
  EXPECT_EQ(run({"render", "missing.pov"}).status, 5);
  EXPECT_EQ(run({"render", "scene.pov", "+Onowhere/out.png"}).status, 5);
  EXPECT_EQ(run({"render", "scene.pov", "--unknown"}).status, 2);
}

TEST_F(Process, DiagnosticsShowPlaceAndCaret) {
  const Ended ended = run({"check", "bad.pov"});
  EXPECT_NE(ended.errors.find("bad.pov:1:25"), std::string::npos) << ended.errors;
  EXPECT_NE(ended.errors.find("^"), std::string::npos);
  EXPECT_NE(run({"+Ibad.pov", "-D"}).errors.find("File 'bad.pov' line 1: Parse Error: "), std::string::npos);
  const Ended json = run({"check", "bad.pov", "--json"});
  EXPECT_NE(json.output.find("\"severity\": \"error\""), std::string::npos) << json.output;
}

TEST_F(Process, RadiosityFilesAreWrittenAndRead) {
  EXPECT_EQ(run({"render", "scene.pov", "+W8", "+H8", "+RFI"}).status,
            0);  // no radiosity in the scene: nothing to read
  file("radiosity.pov",
       std::string(kQuickScene) + "global_settings { radiosity { count 20 } } plane { y, -1 pigment { rgb 1 } }\n");
  const Ended written = run({"render", "radiosity.pov", "+W40", "+H30", "+RFO", "+RFsamples.rca", "+Oone"});
  ASSERT_EQ(written.status, 0) << written.errors;
  EXPECT_GT(fs::file_size(folder_ / "samples.rca"), 0u);
  EXPECT_EQ(run({"render", "radiosity.pov", "+W40", "+H30", "+RFI", "+RFsamples.rca", "+Otwo"}).status, 0);
  EXPECT_TRUE(exists("two.png"));
  const Ended missing = run({"render", "radiosity.pov", "+W40", "+H30", "+RFI", "+RFnone.rca", "+Othree"});
  EXPECT_EQ(missing.signal, 0);
  EXPECT_TRUE(missing.status == 0 || missing.errors.find("none.rca") != std::string::npos) << missing.errors;
}

TEST_F(Process, BadScenesEndWithAnErrorAndNoPicture) {
  file("include.pov", "#include \"nowhere.inc\"\n");
  file("string.pov", "#declare A = \"never closed\n");
  file("comment.pov", "/* never closed\n");
  file("block.pov", "sphere { 0, 1 pigment { rgb 1 }\n");
  file("deep.pov", "#declare A = " + std::string(10000, '(') + "1" + std::string(10000, ')') + ";\n");
  file("nested.pov", "#macro M(N) M(N + 1) #end M(0)\n");
  file("bytes.pov", "\xff\xfe\x80\x01 sphere");
  for (const char* name :
       {"include.pov", "string.pov", "comment.pov", "block.pov", "deep.pov", "nested.pov", "bytes.pov"}) {
    const Ended ended = run({"render", name, "+W8", "+H8", "+Oout.png"});
    EXPECT_EQ(ended.status, 3) << name << ": " << ended.errors << " signal " << ended.signal;
    EXPECT_FALSE(exists("out.png")) << name;
    EXPECT_NE(ended.errors.find(name), std::string::npos) << name << ": " << ended.errors;
  }
}

TEST_F(Process, EndlessScenesEndAtTheirLimit) {
  file("endless.pov", "#while (1) #end\n");
  const Ended time = run({"render", "endless.pov", "--max-seconds", "0.5"});
  EXPECT_NE(time.status, 0);
  EXPECT_EQ(time.signal, 0);
  EXPECT_EQ(run({"render", "endless.pov", "--max-steps", "100000"}).status, 3);
  file("told.pov", "#fopen F \"started\" write #write(F, 1) #fclose F #while (1) #end\n");
  const pid_t child = start({"render", "told.pov"});
  wait_for("started");
  ::kill(child, SIGINT);
  EXPECT_EQ(wait(child).status, 130);
}

TEST_F(Process, AFolderIsNoScene) {
  fs::create_directories(folder_ / "folder.pov");
  EXPECT_EQ(run({"render", "folder.pov"}).status, 5);
  EXPECT_EQ(run({"+Ifolder.pov", "-D"}).status, 1);
}

TEST_F(Process, HugePicturesAreRefused) {
  EXPECT_EQ(run({"render", "scene.pov", "+W100000", "+H100000"}).status, 2);
  EXPECT_EQ(run({"+Iscene.pov", "+W2000000000", "+H2000000000"}).status, 1);
}

TEST_F(Process, AFullDiskIsAnErrorAndLeavesNothing) {
  // A tiny file system; without the right to mount one, a limit of the size of files does it.
  const fs::path disk = folder_ / "disk";
  fs::create_directories(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=16k") != 0) {
    const pid_t child = ::fork();
    if (child == 0) {
      const rlimit limit{4096, 4096};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      ::signal(SIGXFSZ, SIG_IGN);
      if (::chdir(folder_.c_str()) != 0) ::_exit(127);
      ::execl(VERISIM_BINARY_DIR "/bin/verisim", "verisim", "render", "slow.pov", "+W300", "+H200", "+Odisk/out.png",
              nullptr);
      ::_exit(127);
    }
    EXPECT_EQ(wait(child).status, 5);
    EXPECT_TRUE(fs::is_empty(disk));
    return;
  }
  const Ended ended = run({"render", "slow.pov", "+W300", "+H200", "+FP", "+Odisk/out.ppm"});
  const bool empty = fs::is_empty(disk);
  ::umount(disk.c_str());
  EXPECT_EQ(ended.status, 5) << ended.errors;
  EXPECT_NE(ended.errors.find("out.ppm"), std::string::npos) << ended.errors;
  EXPECT_TRUE(empty);
}

TEST_F(Process, AReadOnlyFolderIsAnError) {
  const fs::path locked = folder_ / "locked";
  fs::create_directories(locked);
  if (::geteuid() == 0) {
    if (::mount("tmpfs", locked.c_str(), "tmpfs", MS_RDONLY, "size=16k") != 0)
      GTEST_SKIP() << "cannot make a folder that root cannot write to";
  } else {
    fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
  }
  const Ended ended = run({"render", "scene.pov", "+W8", "+H8", "+Olocked/out.png"});
  if (::geteuid() == 0) ::umount(locked.c_str());
  EXPECT_EQ(ended.status, 5) << ended.errors;
  EXPECT_NE(ended.errors.find("locked/out.png"), std::string::npos) << ended.errors;
}

TEST_F(Process, PicturesGoToStandardOutput) {
  ASSERT_EQ(run({"+Iscene.pov", "+W16", "+H12", "+O-", "-D"}).status, 0);
  const std::string png = text_of(folder_ / "stdout.txt");
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(run({"+Iscene.pov", "+W16", "+H12", "+O-", "+FJ", "-D"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "stdout.txt").substr(0, 2), "\xff\xd8");
}

TEST_F(Process, TypesFollowTheNameInRenderAndTheSwitchInPovRayCalls) {
  EXPECT_EQ(run({"render", "scene.pov", "+W16", "+H12", "+Oout.exr"}).status, 0);
  EXPECT_TRUE(exists("out.exr"));
  EXPECT_EQ(run({"render", "scene.pov", "+W16", "+H12", "--output", "a.ppm"}).status, 0);
  EXPECT_EQ(text_of(folder_ / "a.ppm").substr(0, 2), "P6");
  EXPECT_EQ(run({"+Iscene.pov", "+W16", "+H12", "+Oout.tga"}).status, 0);
  EXPECT_TRUE(exists("out.tga.png"));
  EXPECT_EQ(run({"render", "scene.pov", "--output", "a.xyz"}).status, 2);
}

// Renders that a signal must meet half way: a second or more, with sanitizers as well as without.
#ifdef VERISIM_SANITIZED
constexpr const char* kLong = "+R2";
constexpr const char* kLonger = "+R2";
#else
constexpr const char* kLong = "+R4";
constexpr const char* kLonger = "+R5";
#endif

TEST_F(Process, AnInterruptKeepsWhatWasRenderedAndContinues) {
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove(folder_ / "part.pov-state");
    const pid_t child = start({"+Islow.pov", "+W320", "+H240", "+A0.0", kLonger, "+Opart", "-D"});
    wait_for("part.pov-state");
    ::kill(child, signal);
    const Ended ended = wait(child);
    ASSERT_EQ(ended.status, 2) << ended.errors;
    EXPECT_TRUE(exists("part.png"));
    EXPECT_TRUE(exists("part.pov-state"));
  }
  ASSERT_EQ(run({"+Islow.pov", "+W320", "+H240", "+A0.0", kLonger, "+Opart", "-D", "+C"}).status, 0);
  EXPECT_FALSE(exists("part.pov-state"));
  ASSERT_EQ(run({"+Islow.pov", "+W320", "+H240", "+A0.0", kLonger, "+Owhole", "-D"}).status, 0);
  EXPECT_EQ(image::read_picture(folder_ / "part.png").samples, image::read_picture(folder_ / "whole.png").samples);
  // The picture is there: nothing is rendered again.
  const auto before = fs::last_write_time(folder_ / "part.png");
  const Ended again = run({"+Islow.pov", "+W320", "+H240", "+A0.0", kLonger, "+Opart", "-D", "+C"});
  EXPECT_EQ(again.status, 0);
  EXPECT_NE(again.errors.find("File already rendered and continue requested; skipping."), std::string::npos);
  EXPECT_EQ(fs::last_write_time(folder_ / "part.png"), before);
}

TEST_F(Process, KilledAtTwentyMomentsItContinuesToTheIdenticalPicture) {
  const std::vector<std::string> call{"+Islow.pov", "+W320", "+H240", "+A0.0", kLong, "+BS16", "-D", "+C"};
  auto with = [&](const std::string& output) {
    std::vector<std::string> words = call;
    words.push_back("+O" + output);
    return words;
  };
  ASSERT_EQ(run(with("whole")).status, 0);
  const std::vector<float> whole = image::read_picture(folder_ / "whole.png").samples;
  std::mt19937 random(1);
  int finished = 0;
  for (int kills = 0; kills < 20;) {
    const pid_t child = start(with("part"));
    std::this_thread::sleep_for(milliseconds(std::uniform_int_distribution<int>(5, 1200)(random)));
    ::kill(child, SIGKILL);
    const Ended ended = wait(child);
    if (ended.signal == SIGKILL) {
      ++kills;
      // Whole or absent: a kill between the renaming of the picture and the program's end finds it whole.
      if (exists("part.png")) {
        EXPECT_EQ(image::read_picture(folder_ / "part.png").samples, whole);
        fs::remove(folder_ / "part.png");
      }
      continue;
    }
    ASSERT_EQ(ended.status, 0) << ended.errors;  // it was done before the kill: from the beginning again
    EXPECT_EQ(image::read_picture(folder_ / "part.png").samples, whole);
    fs::remove(folder_ / "part.png");
    ASSERT_LT(++finished, 60) << "too fast to be killed";
  }
  ASSERT_EQ(run(with("part")).status, 0);
  EXPECT_EQ(image::read_picture(folder_ / "part.png").samples, whole);
  EXPECT_FALSE(exists("part.pov-state"));
  EXPECT_TRUE(leftovers(folder_).empty());
}

TEST_F(Process, AChangedSceneIsNotContinued) {
  const pid_t child = start({"+Islow.pov", "+W320", "+H240", "+A0.0", "+R5", "+Opart", "-D"});
  wait_for("part.pov-state");
  ::kill(child, SIGKILL);
  wait(child);
  ASSERT_TRUE(exists("part.pov-state"));
  file("slow.pov", kQuickScene);
  const Ended ended = run({"+Islow.pov", "+W320", "+H240", "+A0.0", "+R5", "+Opart", "-D", "+C"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.errors.find("belongs to another scene"), std::string::npos) << ended.errors;
  ASSERT_EQ(run({"+Islow.pov", "+W320", "+H240", "+A0.0", "+R5", "+Owhole", "-D"}).status, 0);
  EXPECT_EQ(image::read_picture(folder_ / "part.png").samples, image::read_picture(folder_ / "whole.png").samples);
}

TEST_F(Process, ThreadsDoNotChangeThePicture) {
  std::vector<float> first;
  for (const char* threads : {"+WT1", "+WT2", "+WT3", "+WT8"}) {
    ASSERT_EQ(run({"+Islow.pov", "+W80", "+H60", "+A0.1", "+Oout", "-D", threads}).status, 0);
    const std::vector<float> samples = image::read_picture(folder_ / "out.png").samples;
    if (first.empty()) first = samples;
    EXPECT_EQ(samples, first) << threads;
  }
}

TEST_F(Process, AnimationsRenderEveryFrame) {
  file("move.pov", std::string(kQuickScene) +
                       "sphere { clock*x, .5 pigment { rgb frame_number/final_frame } }\n#debug concat(\"clock \", "
                       "str(clock,0,6), \"\\n\")\n");
  const Ended ended = run({"+Imove.pov", "+W16", "+H12", "+KFF3", "-D", "--stats", "stats.json"});
  ASSERT_EQ(ended.status, 0) << ended.errors;
  for (const char* name : {"move1.png", "move2.png", "move3.png"}) EXPECT_TRUE(exists(name)) << name;
  EXPECT_NE(ended.errors.find("clock 0.500000"), std::string::npos) << ended.errors;
  EXPECT_NE(text_of(folder_ / "stats.json").find("move2.png"), std::string::npos);
}

TEST_F(Process, ShellCommandsNeedPermission) {
  file("shell.ini", "Input_File_Name=scene.pov\nWidth=8\nHeight=8\nPost_Frame_Command=touch done_%n_%w_%s\n");
  EXPECT_EQ(run({"shell.ini", "-D"}).status, 0);
  EXPECT_FALSE(exists("done_0_8_scene.pov"));
  EXPECT_EQ(run({"shell.ini", "-D", "--allow-shell"}).status, 0);
  EXPECT_TRUE(exists("done_0_8_scene.pov"));
}

TEST_F(Process, ReturnRulesOfCommandsAlwaysFire) {
  struct Case {
    const char* rule;
    int status;
    bool picture;
  };
  for (const Case& test :
       {Case{"Pre_Frame_Return=I", 0, true}, Case{"Pre_Frame_Return=S", 0, false}, Case{"Pre_Frame_Return=!S", 0, true},
        Case{"Pre_Frame_Return=Q", 0, false}, Case{"Pre_Frame_Return=U", 1, false},
        Case{"Pre_Frame_Return=F", 1, false}, Case{"Pre_Frame_Return=-F", 0, true}}) {
    fs::remove(folder_ / "scene.png");
    file("shell.ini",
         std::string("Input_File_Name=scene.pov\nWidth=8\nHeight=8\nPre_Frame_Command=true\n") + test.rule + "\n");
    EXPECT_EQ(run({"shell.ini", "-D"}).status, test.status) << test.rule;
    EXPECT_EQ(exists("scene.png"), test.picture) << test.rule;
  }
}

TEST_F(Process, TextStreamsGoToTheirFiles) {
  file("talk.pov", std::string(kQuickScene) + "#debug \"hello debug\\n\" #warning \"hello warning\"\n");
  ASSERT_EQ(run({"+Italk.pov", "+W8", "+H8", "-D", "+GDd.txt", "-GA"}).status, 0);
  EXPECT_NE(text_of(folder_ / "d.txt").find("hello debug"), std::string::npos);
  const Ended quiet = run({"+Italk.pov", "+W8", "+H8", "-D", "-GW"});
  EXPECT_EQ(quiet.errors.find("hello warning"), std::string::npos);
  EXPECT_NE(quiet.errors.find("hello debug"), std::string::npos);
  EXPECT_NE(run({"+Italk.pov", "+W8", "+H8", "-D"}).errors.find("hello warning"), std::string::npos);
}

// The figures are POV-Ray's for these scenes.
TEST_F(Process, IsosurfacesTellWhetherMaxGradientFits) {
  const std::string camera =
      "#version 3.7; global_settings{assumed_gamma 1} camera{location <0,0,-5> angle 30} light_source{<3,5,-8> rgb "
      "1}\n";
  const auto ball = [](const std::string& items) {
    return "isosurface{function{x*x+y*y+z*z-0.7} " + items + " pigment{rgb 1}}";
  };
  const auto warning = [&](const std::string& scene, const std::string& size = "+W160 +H120") {
    file("iso.pov", camera + scene);
    std::string text =
        run({"+Iiso.pov", size.substr(0, size.find(' ')), size.substr(size.find(' ') + 1), "-D", "-A"}).errors;
    std::erase(text, '\n');
    const std::size_t at = text.find("Shutdown Warning: ");
    return at == std::string::npos ? std::string() : text.substr(at + 18, text.find("----", at) - at - 18);
  };
  EXPECT_NE(warning(ball("max_gradient 3.6"))
                .find("gradient found was 2.604, but max_gradient of the isosurface was set to 3.600. Adjust "
                      "max_gradient to get a faster"),
            std::string::npos);
  EXPECT_NE(warning(ball("max_gradient 1.1 scale 0.5"))
                .find("found was 2.239, but max_gradient of the isosurface was set to 1.100. The isosurface may "
                      "contain holes!"),
            std::string::npos);
  EXPECT_EQ(warning(ball("max_gradient 2.6")), "");
  EXPECT_EQ(warning("#declare I = " + ball("max_gradient 9") + " object{I}"), "");
  EXPECT_EQ(warning("#declare I = union{" + ball("max_gradient 9") + "} object{I}"), "");
  EXPECT_EQ(warning("intersection{" + ball("max_gradient 9") + " plane{x,0}}"), "");
  EXPECT_NE(warning("camera{orthographic location <0.1,0.05,-5> direction z right 0.8*x up 0.0001*y} " +
                        ball("max_gradient 3.1 evaluate 1,1.5,0.9"),
                    "+W2 +H1")
                .find("Evaluate found a maximum gradient of 4.219 and an average gradient of 4.008. The maximum "
                      "gradient variation was 1.119."),
            std::string::npos);
}

TEST_F(Process, TheScenesFolderIsSearchedAfterPovRaysPlaces) {
  fs::create_directories(folder_ / "sub");
  file("sub/part.inc", "#declare Size = 1;\n");
  file("sub/scene.pov", std::string("#include \"part.inc\"\n") + kQuickScene);
  EXPECT_EQ(run({"+Isub/scene.pov", "+W8", "+H8", "-D"}).status, 0);
  EXPECT_TRUE(exists("sub/scene.png"));
}

TEST_F(Process, ExplainTellsTheStoryOfAPixel) {
  file("story.pov",
       "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> direction z right x up y }\n"
       "light_source { <0,0,-9> rgb 1 } light_source { <0,20,2> rgb 1 }\n"
       "sphere { 0, 1 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 1 reflection { .25 } } }\n"
       "plane { z, -20 pigment { rgb 1 } finish { ambient 1 diffuse 0 } }\n");
  const Ended ended = run({"explain", "story.pov", "4", "4", "+W9", "+H9", "--no-oracle"});
  ASSERT_EQ(ended.status, 0) << ended.errors;
  for (const char* part :
       {"camera ray from <0, 0, -5> towards <0, 0, 1>", "4  orange sphere (story.pov:3)",
        "6  orange sphere (story.pov:3)", "normal <0, 0, -1>",
        "light at <0, 0, -9>: 8 away towards <0, 0, -1>, <1, 1, 1> arrives, adds <1, 0.5, 0.25>",
        "light at <0, 20, 2>: behind the surface", "reflected ray from <0, 0, -1> towards <0, 0, -1>, weight 0.25",
        "hits white plane (story.pov:4) at 19", "linear <1.25, 0.75, 0.5>"})
    EXPECT_NE(ended.output.find(part), std::string::npos) << part << "\n" << ended.output;
  EXPECT_EQ(run({"explain", "story.pov", "9", "4", "+W9", "+H9"}).status, 2);
  EXPECT_EQ(run({"explain", "story.pov", "4", "+W9", "+H9"}).status, 2);
  EXPECT_EQ(run({"explain", "bad.pov", "1", "1"}).status, 3);
}

TEST_F(Process, CreatedIniGivesTheSamePicture) {
  ASSERT_EQ(run({"+Iscene.pov", "+W20", "+H10", "+A0.1", "+Oone", "+GIall.ini", "-D"}).status, 0);
  ASSERT_EQ(run({"all.ini", "+Otwo"}).status, 0);
  EXPECT_EQ(image::read_picture(folder_ / "one.png").samples, image::read_picture(folder_ / "two.png").samples);
}

}  // namespace
}  // namespace verisim::cli
