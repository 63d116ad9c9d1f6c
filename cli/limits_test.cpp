// Scenes that ask the program (VERISIM_BINARY_DIR/bin/verisim, cli/process_fixture.h) for more than there is: each ends
// soon, by name, with the status that the documentation gives.
#include "cli/process_fixture.h"
#include "cli/console/exit_status.h"
#include "tracer/base/sanitizers.h"

namespace verisim::cli {
namespace {

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 } camera { location -5*z look_at 0 }\n";
// 2^60 of something.
const std::string kUnions =
    kHead +
    "#declare U=sphere{0,1 pigment{rgb 1}} #for(i,1,60) #declare U=union{object{U} object{U translate i}} #end "
    "object{U}";
const std::string kClips = kHead +
                           "#declare U=sphere{0,1} #for(i,1,60) #declare U=sphere{0,1 clipped_by{object{U}} "
                           "clipped_by{object{U}}} #end object{U}";
const std::string kMovedCopies =
    kHead +
    "#declare U=sphere{0,1 pigment{rgb 1}} #for(i,1,60) #declare V=union{object{U} object{U translate i}} "
    "#declare U=object{V translate 1} #end object{U}";
const std::string kLightGroups =
    kHead +
    "#declare U=sphere{0,1} #for(i,1,60) #declare U=light_group{object{U} object{U translate i}} #end object{U}";
const std::string kArrays = kHead + "#declare A=array[2]{1,2} #for(i,1,60) #declare A=array[2]{A,A} #end";
// Each value takes as many passes as one may; limits are looked at after thousands of them.
const std::string kFunctions = kHead + "#declare F=function(x){sum(i,1,99000000,i*x)} #while(1) #declare Z=F(1); #end";
const std::string kDeepUnions =
    kHead + "#declare U=sphere{0,1} #for(i,1,100000) #declare U=union{object{U} sphere{i,1}} #end object{U}";

bool says(const Ended& ended, const std::string& text) { return ended.errors.find(text) != std::string::npos; }

class Limits : public Process {
 protected:
  // Seconds until it ended.
  double seconds(const std::vector<std::string>& arguments, Ended& ended) const {
    const auto start = std::chrono::steady_clock::now();
    ended = run(arguments);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  std::vector<std::string> words(const std::string& command) const {
    std::vector<std::string> result{command, "bomb.pov"};
    if (command == "render") result.insert(result.end(), {"+W16", "+H12"});
    return result;
  }
};

TEST_F(Limits, SharedCopiesAreCountedBeforeTheyAreWrittenOut) {
  for (const std::string& text : {kUnions, kMovedCopies}) {
    file("bomb.pov", text);
    for (const std::string command : {"check", "render"}) {
      std::vector<std::string> arguments = words(command);
      arguments.emplace_back("--max-memory=100000000");
      Ended ended;
      EXPECT_LT(seconds(arguments, ended), 20) << text;
      EXPECT_EQ(ended.status, 3) << text << ended.errors;
      EXPECT_TRUE(says(ended, "--max-memory") && says(ended, "bomb.pov:2:") && says(ended, "objects")) << ended.errors;
    }
  }
}

TEST_F(Limits, MemoryEndsEverything) {
  for (const std::string& text : {kClips, kArrays, kLightGroups}) {
    file("bomb.pov", text);
    Ended ended;
    EXPECT_LT(seconds({"check", "bomb.pov", "--max-memory=200000000"}, ended), 60) << text;
    EXPECT_TRUE(ended.status == kInterrupted || ended.status == kSceneErrors) << ended.status << ended.errors;
    EXPECT_TRUE(says(ended, "--max-memory")) << ended.errors;
  }
  Ended ended;
  seconds({"render", "scene.pov", "+W8000", "+H6000", "+MI100000", "--max-memory=200000000"}, ended);
#ifdef VERISIM_SANITIZED  // its own memory is more than that before there is a picture
  EXPECT_EQ(ended.status, kInterrupted);
#else
  EXPECT_EQ(ended.status, kInputOutput);
#endif
  EXPECT_TRUE(says(ended, "--max-memory")) << ended.errors;
  EXPECT_FALSE(exists("scene.png"));
}

TEST_F(Limits, TimeEndsWhatNeverLooksAtIt) {
  file("bomb.pov", kFunctions);
  for (const std::string command : {"check", "render"})
    for (const std::string limit : {"--max-seconds", "--max-cpu-seconds"}) {
      std::vector<std::string> arguments = words(command);
      arguments.push_back(limit + "=0.3");
      Ended ended;
      EXPECT_LT(seconds(arguments, ended), 20);
      EXPECT_EQ(ended.status, kInterrupted) << ended.errors;
      EXPECT_TRUE(says(ended, limit + " 0.3 is reached")) << ended.errors;
    }
}

TEST_F(Limits, RaysOfThePassesBeforeThePictureCount) {
  const std::string photons =
      "global_settings { photons { count 1000000 } } light_source { 9 rgb 1 } sphere { 0, 1 pigment { rgbt 1 } "
      "interior { ior 1.5 } photons { target refraction on } } plane { y, -1 pigment { rgb 1 } }";
  const std::string radiosity =
      "global_settings { radiosity { pretrace_end 0.001 error_bound 0.1 } } light_source { 9 rgb 1 } sphere { 0, 1 "
      "pigment { rgb 1 } } plane { y, -1 pigment { rgb 1 } }";
  for (const std::string& what : {photons, radiosity}) {
    file("bomb.pov", kHead + what);
    const Ended ended =
        run({"render", "bomb.pov", "+W64", "+H48", "--max-rays=20000", "--max-seconds=60", "--progress=json"});
    EXPECT_EQ(ended.status, kInterrupted) << ended.errors;
    EXPECT_TRUE(says(ended, "--max-rays 20000 is reached")) << ended.errors;
    EXPECT_FALSE(says(ended, "\"stage\":\"picture\"")) << ended.errors;
  }
}

TEST_F(Limits, SignalsEndWhatNeverLooksAtThem) {
  file("bomb.pov", kFunctions);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t child = start({"check", "bomb.pov"});
    std::this_thread::sleep_for(milliseconds(300));
    ::kill(child, signal);
    const Ended ended = wait(child);
    EXPECT_EQ(ended.status, kInterrupted) << signal << ended.errors;
    EXPECT_EQ(ended.signal, 0);
  }
}

TEST_F(Limits, ASignalEndsTheViewOfASceneWithoutEnd) {
  file("bomb.pov", kFunctions);
  const pid_t child = start({"view", "bomb.pov", "--no-open", "--sandbox=best-effort"});
  wait_for("stdout.txt");  // the address
  std::this_thread::sleep_for(milliseconds(300));
  ::kill(child, SIGTERM);
  const Ended ended = wait(child);
  EXPECT_EQ(ended.status, kOk) << ended.errors;  // the scene is given up in time: an orderly end, as at any other time
}

TEST_F(Limits, StrangersAreHeldShortAndSingleLimitsCountMore) {
  file("bomb.pov", kFunctions);
  const Ended strangers = run({"check", "bomb.pov", "--max-seconds=0.2", "--limits", "strangers"});
  EXPECT_EQ(strangers.status, kInterrupted);
  EXPECT_TRUE(says(strangers, "--max-seconds 0.2")) << strangers.errors;
  EXPECT_EQ(run({"render", "scene.pov", "+W16", "+H12", "--limits=strangers"}).status, kOk);
  EXPECT_NE(run({"render", "scene.pov", "+W8000", "+H6000", "--limits=strangers"}).status, kOk);
  EXPECT_EQ(run({"check", "scene.pov", "--limits=friends"}).status, kUsage);
}

TEST_F(Limits, DeepObjectsNeverOverflowTheStack) {
  file("bomb.pov", kDeepUnions);
  const Ended too_deep = run({"check", "bomb.pov"});
  EXPECT_EQ(too_deep.status, kSceneErrors);
  EXPECT_TRUE(says(too_deep, "nested deeper than 10000 levels")) << too_deep.errors;
  file("bomb.pov", kHead +
                       "#declare U=sphere{0,1} #for(i,1,6000) #declare U=difference{object{U} sphere{i/10000,1}} "
                       "#end object{U pigment{rgb 1}}");
  const Ended deep = run({"render", "bomb.pov", "+W4", "+H4", "+WT2", "+BS4"});
  EXPECT_EQ(deep.status, kOk) << deep.signal << deep.errors;
  // The same where nobody may have a larger stack.
  const pid_t held_short = ::fork();
  if (held_short == 0) {
    const rlimit small{256 << 10, 256 << 10};
    ::setrlimit(RLIMIT_STACK, &small);
    const Ended ended = run({"render", "bomb.pov", "+W4", "+H4", "+WT2", "+BS4"});
    ::_exit(ended.signal ? 99 : ended.status);
  }
  int status = 0;
  ::waitpid(held_short, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), kOk);
}

}  // namespace
}  // namespace verisim::cli
