// The oracle's process, its isolation and its cache, with a shell script in the place of POV-Ray; one test asks the
// real one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"
#include "compare/oracle/content_hash.h"
#include "compare/oracle/process.h"
#include "compare/oracle/switches.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
namespace {

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

class Process : public testing::Test {
 protected:
  ProcessResult shell(const std::string& script, double limit = 20) {
    return run_process({{"/bin/sh", "-c", script}, folder_.path(), {{"PATH", "/usr/bin:/bin"}}, limit, nullptr});
  }
  TemporaryFolder folder_;
};

TEST_F(Process, OutputStatusFolderAndEnvironment) {
  const ProcessResult r = shell("pwd; echo problem >&2; test -z \"$HOME\" || echo leak; read line || echo eof; exit 3");
  EXPECT_TRUE(r.started);
  EXPECT_EQ(r.exit_code, 3);
  EXPECT_EQ(r.out, fs::canonical(folder_.path()).string() + "\neof\n");
  EXPECT_EQ(r.err, "problem\n");
  EXPECT_EQ(r.how_it_ended(0), "exit status 3");
}

TEST_F(Process, TimeLimitKillsTheWholeGroup) {
  const auto start = std::chrono::steady_clock::now();
  const ProcessResult r = shell("sleep 60 & echo $! > child; sleep 60", 0.3);
  EXPECT_TRUE(r.timed_out);
  EXPECT_FALSE(r.succeeded());
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 10);
  const int child = std::stoi(read(folder_.path() / "child"));
  for (int i = 0; i < 100 && fs::exists("/proc/" + std::to_string(child)) &&
                  !read("/proc/" + std::to_string(child) + "/stat").empty();
       ++i) {
    if (read("/proc/" + std::to_string(child) + "/stat").find(") Z ") != std::string::npos)
      break;  // dead, not yet collected by init
    usleep(20000);
  }
  const std::string stat = read("/proc/" + std::to_string(child) + "/stat");
  EXPECT_TRUE(stat.empty() || stat.find(") Z ") != std::string::npos) << stat;
}

TEST_F(Process, CrashIsNamed) {
  const ProcessResult r = shell("kill -SEGV $$");
  EXPECT_EQ(r.signal, SIGSEGV);
  EXPECT_THAT(r.how_it_ended(0), HasSubstr("signal 11"));
}

TEST_F(Process, EndlessOutputIsCutToItsEnd) {
  const ProcessResult r = shell("yes 0123456789 | head -n 200000; echo last");
  EXPECT_LE(r.out.size(), 512u * 1024);
  EXPECT_TRUE(r.out.ends_with("last\n"));
}

TEST_F(Process, CpuTimeIsThatOfTheChildren) {
  const ProcessResult r = shell("i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done");
  EXPECT_GT(r.cpu, 0.01);
  EXPECT_GT(r.peak_bytes, 100u * 1024);
}

TEST_F(Process, MissingProgram) {
  const ProcessResult r = run_process({{"/no/such/program"}, {}, {}, 0, nullptr});
  EXPECT_FALSE(r.started);
  EXPECT_THAT(r.how_it_ended(0), HasSubstr("/no/such/program"));
}

TEST_F(Process, CancelEndsIt) {
  std::atomic<bool> cancel = true;
  EXPECT_TRUE(
      run_process({{"/bin/sh", "-c", "sleep 60"}, folder_.path(), {{"PATH", "/usr/bin:/bin"}}, 0, &cancel}).cancelled);
}

TEST(ContentHash, IsSha256WithLengths) {
  // SHA-256 of eight zero bytes: the length prefix of the empty text.
  ContentHash h;
  h.add("");
  EXPECT_EQ(h.hex(), "af5570f5a1810b7af78caf4bc70a660f0df51e42baf91d4de5b2328de0e83dfc");
  ContentHash a, b;
  a.add("ab"), a.add("c"), b.add("a"), b.add("bc");
  EXPECT_NE(a.hex(), b.hex());
}

TEST(Switches, WhatTheComparisonHasToKnow) {
  EXPECT_TRUE(switch_on({"+A0.3"}, 'A', "antialias"));
  EXPECT_TRUE(switch_on({"-A", "Antialias=On"}, 'A', "antialias"));
  EXPECT_FALSE(switch_on({"+A", "-A"}, 'A', "antialias"));
  EXPECT_FALSE(switch_on({"+AM2", "+AG1"}, 'A', "antialias"));
  EXPECT_TRUE(alpha_on({"+ua"}));
  EXPECT_FALSE(alpha_on({"+UA", "Output_Alpha=off"}));
  EXPECT_EQ(output_extension({"+FN16"}), ".png");
  EXPECT_EQ(output_extension({"+FE"}), ".exr");
  EXPECT_THAT(split_switches("+A0.3  'Declare=s=\"a b\"' \"Input File=x y\""),
              ElementsAre("+A0.3", "Declare=s=\"a b\"", "Input File=x y"));
  EXPECT_THROW(split_switches("\"open"), std::invalid_argument);
}

TEST(WorkingCopy, CopiesTheFolderAndLinksItsNeighbours) {
  const TemporaryFolder root;
  fs::create_directories(root.path() / "a/scenes/maps");
  fs::create_directories(root.path() / "a/include");
  for (const char* f : {"a/scenes/s.pov", "a/scenes/maps/m.png", "a/include/x.inc"})
    std::ofstream(root.path() / f) << f;
  fs::create_directory_symlink("..", root.path() / "a/scenes/loop");
  {
    const WorkingCopy copy(root.path() / "a/scenes/s.pov");
    EXPECT_EQ(read(copy.scene()), "a/scenes/s.pov");
    EXPECT_EQ(read(copy.folder() / "maps/m.png"), "a/scenes/maps/m.png");
    EXPECT_EQ(read(copy.folder() / "../include/x.inc"), "a/include/x.inc");
    EXPECT_TRUE(fs::is_empty(copy.home()));
    std::ofstream(copy.scene()) << "overwritten";
    std::ofstream(copy.folder() / "new.txt") << "written";
  }
  EXPECT_EQ(read(root.path() / "a/scenes/s.pov"), "a/scenes/s.pov");
  EXPECT_FALSE(fs::exists(root.path() / "a/scenes/new.txt"));
  // The next scene of the folder finds it as the original is, now.
  std::ofstream(root.path() / "a/scenes/maps/m.png") << "newer";
  fs::remove(root.path() / "a/scenes/loop");
  const WorkingCopy next(root.path() / "a/scenes/s.pov");
  EXPECT_EQ(read(next.scene()), "a/scenes/s.pov");
  EXPECT_EQ(read(next.folder() / "maps/m.png"), "newer");
  EXPECT_FALSE(fs::exists(next.folder() / "new.txt"));
  EXPECT_FALSE(fs::exists(fs::symlink_status(next.folder() / "loop")));
  // Two at a time are two.
  const WorkingCopy other(root.path() / "a/scenes/s.pov");
  EXPECT_NE(other.folder(), next.folder());
}

// A scene may lie where temporary files are made: the copy does not hold itself, nor those of other runs.
TEST(WorkingCopy, DoesNotHoldTheFolderOfTemporaryFiles) {
  const TemporaryFolder root;
  std::ofstream(root.path() / "s.pov") << "scene";
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", root.path().c_str(), 1);
  {
    const TemporaryFolder another;
    std::ofstream(another.path() / "large.png") << "picture";
    const WorkingCopy copy(root.path() / "s.pov");
    EXPECT_EQ(read(copy.scene()), "scene");
    EXPECT_EQ(std::distance(fs::directory_iterator(copy.folder()), {}), 1);
    EXPECT_THAT(files_below(root.path()).files, ElementsAre(root.path() / "s.pov"));
  }
  before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
}

// Old files are not copied again; what a scene did to them shows all the same.
TEST(WorkingCopy, IsUsedAgain) {
  const TemporaryFolder root;
  const fs::path scene = root.path() / "s.pov", other = root.path() / "other.inc";
  for (const fs::path& f : {scene, other}) {
    std::ofstream(f) << "original";
    fs::last_write_time(f, fs::last_write_time(f) - std::chrono::hours(1));
  }
  fs::path first;
  {
    const WorkingCopy copy(scene);
    first = copy.folder();
  }
  fs::file_time_type made;
  {
    const WorkingCopy copy(scene);
    EXPECT_EQ(copy.folder(), first);
    made = fs::last_write_time(copy.folder() / "other.inc");
    std::ofstream(copy.scene()) << "changed!";  // of the same size
    fs::remove(copy.folder() / "other.inc");
    fs::create_directory(copy.folder() / "other.inc");
    std::ofstream(copy.home() / "left") << "x";
  }
  EXPECT_EQ(made, fs::last_write_time(other));
  const WorkingCopy copy(scene);
  EXPECT_EQ(read(copy.scene()), "original");
  EXPECT_EQ(read(copy.folder() / "other.inc"), "original");
  EXPECT_TRUE(fs::is_empty(copy.home()));
}

// A script that answers --version, and otherwise does `body` with $out being the picture's name; it logs its arguments
// and environment.
class Oracle : public testing::Test {
 protected:
  Oracle() {
    fs::create_directories(root_.path() / "scenes");
    scene_.name = "s.pov", scene_.scene = root_.path() / "scenes/s.pov", scene_.width = 8, scene_.height = 6,
    scene_.switches = {"-A"};
    std::ofstream(scene_.scene) << "sphere{0,1}";
    image::write_picture(random_picture(8, 6, 1), root_.path() / "answer.png");
    options_.program = root_.path() / "fakepov";
    options_.cache = root_.path() / "cache";
    options_.time_limit = 20;
    body("cp " + (root_.path() / "answer.png").string() + " \"$out\"");
  }
  void body(const std::string& text, const std::string& version = "POV-Ray 3.7.0.10.fake") {
    std::ofstream(options_.program) << "#!/bin/sh\nif [ \"$1\" = --version ]; then echo noise >&2; echo '" << version
                                    << "' >&2; exit 0; fi\n"
                                    << "echo run >> " << (root_.path() / "runs").string() << "\n"
                                    << "for a in \"$@\"; do echo \"$a\" >> " << (root_.path() / "arguments").string()
                                    << "; case \"$a\" in +O*) out=\"${a#+O}\";; esac; done\n"
                                    << "env > " << (root_.path() / "environment").string() << "; pwd > "
                                    << (root_.path() / "folder").string() << "; ls -A \"$HOME\" > "
                                    << (root_.path() / "home").string() << "\n"
                                    << text << "\n";
    chmod(options_.program.c_str(), 0755);
  }
  OracleRender render(int variant = 0, const std::vector<fs::path>& files = {}) {
    return run_oracle(find_oracle(options_), options_, scene_, variant, files);
  }
  int runs() {
    const std::string log = read(root_.path() / "runs");
    return static_cast<int>(std::count(log.begin(), log.end(), '\n'));
  }
  std::vector<std::string> lines(const char* file) {
    std::istringstream in(read(root_.path() / file));
    std::vector<std::string> out;
    for (std::string line; std::getline(in, line);) out.push_back(line);
    return out;
  }

  TemporaryFolder root_;
  OracleOptions options_;
  SceneRequest scene_;
};

TEST_F(Oracle, RendersInIsolation) {
  options_.threads = 2;
  const OracleRender r = render();
  ASSERT_TRUE(r.ok) << r.message;
  EXPECT_EQ(r.picture.width, 8);
  EXPECT_FALSE(r.from_cache);
  EXPECT_THAT(lines("arguments"), testing::IsSupersetOf({"+Is.pov", "-A", "+W8", "+H6", "+WT2", "-D", "-P", "+FN16"}));
  EXPECT_THAT(lines("home"), ElementsAre("oracle.ini"));  // nothing of the user's
  EXPECT_THAT(read(root_.path() / "environment"), HasSubstr("POVINI="));
  EXPECT_THAT(lines("folder"), testing::Not(Contains((root_.path() / "scenes").string())));
}

// Blocks of other sizes are other threads' work, but anti-aliasing sees where they end.
TEST_F(Oracle, VariantsHaveBlocksOfOtherSizesWhereNothingSeesThem) {
  const auto sizes_so_far = [&](int variant) {
    EXPECT_TRUE(render(variant).ok);
    std::vector<std::string> out;
    for (const std::string& argument : lines("arguments"))
      if (argument.starts_with("+BS")) out.push_back(argument);
    return out;
  };
  EXPECT_THAT(sizes_so_far(0), testing::IsEmpty());
  EXPECT_THAT(sizes_so_far(2), ElementsAre("+BS22"));
  EXPECT_THAT(sizes_so_far(4), ElementsAre("+BS22", "+BS19"));
  scene_.switches = {"+A0.3"};
  EXPECT_THAT(sizes_so_far(2), ElementsAre("+BS22", "+BS19"));
}

TEST_F(Oracle, VersionAndMissingProgram) {
  EXPECT_EQ(find_oracle(options_).version, "3.7.0.10.fake");
  options_.program = root_.path() / "nothing";
  try {
    find_oracle(options_);
    FAIL();
  } catch (const OracleMissing& error) {
    EXPECT_THAT(error.what(), HasSubstr("Debian package povray"));
  }
  options_.program = "/bin/true";
  EXPECT_THROW(find_oracle(options_), OracleMissing);
}

// `povray` may be a link to verisim: all scenes would be exact.
TEST_F(Oracle, VerisimUnderTheNameOfPovrayProvesNothing) {
  const fs::path folder = root_.path() / "links";
  fs::create_directories(folder);
  std::ofstream(folder / "povray") << "#!/bin/sh\necho 'verisim 9.9 (renders scenes of POV-Ray 3.7)' >&2\n";
  fs::permissions(folder / "povray", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder.string() + ":" + path).c_str(), 1);
  options_.program.clear();
  std::string said;
  try {
    find_oracle(options_);
  } catch (const OracleMissing& error) {
    said = error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(said, HasSubstr("is verisim itself"));
  options_.program = folder / "povray";  // named, it is what is wanted
  EXPECT_EQ(find_oracle(options_).name, "verisim");
}

TEST_F(Oracle, CacheIsKeyedByContent) {
  const fs::path include = root_.path() / "scenes/x.inc", other = root_.path() / "scenes/unused.txt";
  std::ofstream(include) << "1";
  std::ofstream(other) << "1";
  const std::vector<fs::path> files = {scene_.scene, include};
  const OracleRender first = render(0, files), second = render(0, files);
  EXPECT_EQ(runs(), 1);
  EXPECT_TRUE(second.from_cache);
  EXPECT_EQ(second.picture.samples, first.picture.samples);
  EXPECT_DOUBLE_EQ(second.seconds, first.seconds);
  std::ofstream(other) << "2";  // nobody read it
  EXPECT_TRUE(render(0, files).from_cache);
  std::ofstream(include) << "2";
  EXPECT_FALSE(render(0, files).from_cache);
  EXPECT_FALSE(render(1, files).from_cache);  // other threads
  scene_.switches = {"+A0.3"};
  EXPECT_FALSE(render(0, files).from_cache);
  scene_.switches = {"-A"};
  EXPECT_TRUE(render(0, files).from_cache);
  body("cp " + (root_.path() / "answer.png").string() + " \"$out\"", "POV-Ray 3.7.0.11.fake");
  EXPECT_FALSE(render(0, files).from_cache);
  EXPECT_FALSE(render(0).from_cache);  // unknown files: the whole folder counts ...
  std::ofstream(other) << "3";
  EXPECT_FALSE(render(0).from_cache);  // ... with what was unused before
  options_.use_cache = false;
  EXPECT_FALSE(render(0, files).from_cache);
}

TEST_F(Oracle, DamagedCacheIsRenderedAgain) {
  ASSERT_TRUE(render().ok);
  for (const auto& entry : fs::recursive_directory_iterator(options_.cache))
    if (entry.path().extension() == ".png") fs::resize_file(entry.path(), 40);
  const OracleRender r = render();
  EXPECT_TRUE(r.ok);
  EXPECT_EQ(runs(), 2);
  EXPECT_TRUE(render().from_cache);
}

TEST_F(Oracle, UnwritableCacheIsNoFailure) {
  options_.cache = "/proc/no/cache";
  EXPECT_TRUE(render().ok);
}

TEST_F(Oracle, FailuresSayWhatHappened) {
  body("echo \"File 's.pov' line 1: Parse Error: Undeclared identifier\" >&2; exit 1");
  EXPECT_THAT(render().message, testing::AllOf(HasSubstr("exit status 1"), HasSubstr("Undeclared identifier")));
  body("kill -SEGV $$");
  EXPECT_THAT(render().message, HasSubstr("signal 11"));
  body("exit 0");
  EXPECT_THAT(render().message, HasSubstr("no picture"));
  body("echo rubbish > \"$out\"");
  EXPECT_FALSE(render().ok);
  image::write_picture(random_picture(9, 6, 1), root_.path() / "answer.png");
  body("cp " + (root_.path() / "answer.png").string() + " \"$out\"");
  EXPECT_THAT(render().message, HasSubstr("9x6"));
}

TEST_F(Oracle, HangingOracleIsKilled) {
  body("sleep 100");
  options_.time_limit = 0.3;
  EXPECT_THAT(render().message, HasSubstr("no end after 0.3 s"));
}

TEST_F(Oracle, WaitsOnceForTheOneThatHangs) {
  body("sleep 100");
  options_.time_limit = 0.3;
  render();
  const OracleRender again = render();
  EXPECT_TRUE(again.from_cache);
  EXPECT_FALSE(again.ok);
  EXPECT_THAT(again.message, HasSubstr("no end after 0.3 s (known from an earlier run; --no-cache tries again)"));
  EXPECT_EQ(runs(), 1);
  options_.time_limit = 0.4;  // more time: perhaps it ends
  render();
  options_.use_cache = false;
  render();
  EXPECT_EQ(runs(), 3);
}

TEST(PovRay, RendersASphere) {
  if (find_program("povray").empty()) GTEST_SKIP() << "POV-Ray is not installed";
  const TemporaryFolder root;
  SceneRequest scene;
  scene.name = "s.pov", scene.scene = root.path() / "s.pov", scene.width = 32, scene.height = 24,
  scene.switches = {"-A"};
  std::ofstream(scene.scene)
      << "#include \"colors.inc\"\n#fopen F \"written.txt\" write\n#write(F, \"1\")\n#fclose F\n"
         "global_settings{assumed_gamma 1} sphere{<0,0,3>,1 pigment{Red} finish{ambient 1 diffuse 0}}";
  OracleOptions options;
  options.cache = root.path() / "cache";
  const OracleProgram program = find_oracle(options);
  EXPECT_TRUE(program.version.starts_with("3."));
  const OracleRender r = run_oracle(program, options, scene, 0, {});
  ASSERT_TRUE(r.ok) << r.message;
  EXPECT_NEAR(r.picture.samples[3 * (12 * 32 + 16)], 1, 1e-6);
  EXPECT_NEAR(r.picture.samples[3 * (12 * 32 + 16) + 1], 0, 1e-6);
  EXPECT_GT(r.seconds, 0);
  EXPECT_FALSE(fs::exists(root.path() / "written.txt"));
  std::ofstream(scene.scene) << "sphere{oops}";
  EXPECT_THAT(run_oracle(program, options, scene, 0, {}).message, HasSubstr("undeclared identifier 'oops'"));
}

}  // namespace
}  // namespace verisim::compare
