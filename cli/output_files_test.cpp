// What the program (VERISIM_BINARY_DIR/bin/verisim, cli/process_fixture.h) does to the files it is told to write:
// pipes, devices and links stay what they are.
#include <sys/sysmacros.h>

#include "cli/process_fixture.h"

namespace verisim::cli {
namespace {

class OutputFiles : public Process {
 protected:
  void SetUp() override {
    Process::SetUp();
    ASSERT_EQ(run({"render", "scene.pov", "+W8", "+H6", "+Oa.png"}).status, 0);
    fs::copy_file(folder_ / "a.png", folder_ / "b.png");
  }
  fs::path at(const std::string& name) const { return folder_ / name; }
  mode_t mode(const std::string& name) const {
    struct stat about {};
    return ::lstat(at(name).c_str(), &about) == 0 ? about.st_mode : 0;
  }
  // What comes out of a pipe while the program runs. Empty when nobody wrote into it.
  std::string through_pipe(const std::vector<std::string>& arguments, const std::string& pipe) const {
    EXPECT_EQ(::mkfifo(at(pipe).c_str(), 0600), 0);
    const int end = ::open(at(pipe).c_str(), O_RDONLY | O_NONBLOCK);
    const pid_t child = start(arguments);
    std::string text;
    int status = 0;
    bool ended = false;
    for (int i = 0; i < 1000 && !ended; ++i) {
      ended = ::waitpid(child, &status, WNOHANG) == child;
      char buffer[4096];
      for (ssize_t n; (n = ::read(end, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(n));
      if (!ended) std::this_thread::sleep_for(milliseconds(10));
    }
    if (!ended) ::kill(child, SIGKILL), ::waitpid(child, &status, 0);
    ::close(end);
    EXPECT_TRUE(ended) << pipe;
    EXPECT_TRUE(S_ISFIFO(mode(pipe))) << pipe << " was replaced";
    return text;
  }
};

TEST_F(OutputFiles, PipesAreWrittenThrough) {
  EXPECT_NE(through_pipe({"diff", "a.png", "b.png", "--json", "json.pipe"}, "json.pipe").find("\"rmse\""),
            std::string::npos);
  EXPECT_NE(through_pipe({"diff", "a.png", "b.png", "--html", "html.pipe"}, "html.pipe").find("<html"),
            std::string::npos);
  EXPECT_EQ(through_pipe({"diff", "a.png", "b.png", "--heat-map", "map.pipe"}, "map.pipe").substr(0, 4), "\x89PNG");
  EXPECT_NE(through_pipe({"render", "scene.pov", "+W8", "+H6", "-F", "--stats", "stats.pipe"}, "stats.pipe").find('{'),
            std::string::npos);
  EXPECT_EQ(through_pipe({"render", "scene.pov", "+W8", "+H6", "+Opipe.png"}, "pipe.png").substr(0, 4), "\x89PNG");
  EXPECT_EQ(through_pipe({"render", "scene.pov", "+W8", "+H6", "+Opipe.jpg"}, "pipe.jpg").substr(0, 2), "\xff\xd8");
  EXPECT_EQ(
      through_pipe({"render", "scene.pov", "+W8", "+H6", "--layers", "depth", "+Opipe.exr"}, "pipe.exr").substr(0, 2),
      "\x76\x2f");
}

TEST_F(OutputFiles, ReportsOfARunGoThroughPipes) {
  const std::vector<std::string> run{"compare", "scene.pov", "+W8", "+H6", "--baseline", "none", "--quiet"};
  for (const std::string kind : {"--json", "--html", "--junit", "--markdown"}) {
    std::vector<std::string> arguments = run;
    arguments.insert(arguments.end(), {kind, "report" + kind});
    EXPECT_NE(through_pipe(arguments, "report" + kind), "") << kind;
  }
}

TEST_F(OutputFiles, DevicesStayDevices) {
  const auto null_device = [&](const std::string& name) {
    return ::mknod(at(name).c_str(), S_IFCHR | 0666, ::makedev(1, 3)) == 0;
  };
  if (!null_device("json") || !null_device("picture.png") || !null_device("picture.exr"))
    GTEST_SKIP() << "only root can make a device";
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--json", "json"}).status, 0);
  EXPECT_EQ(run({"render", "scene.pov", "+W8", "+H6", "+Opicture.png"}).status, 0);
  EXPECT_EQ(run({"render", "scene.pov", "+W8", "+H6", "+Opicture.exr"}).status, 0);
  for (const char* name : {"json", "picture.png", "picture.exr"}) EXPECT_TRUE(S_ISCHR(mode(name))) << name;
}

TEST_F(OutputFiles, LinksAreFollowed) {
  fs::create_directory(at("there"));
  file("there/old.json", "old");
  fs::create_symlink("there/old.json", at("old.link"));
  fs::create_symlink("there/new.json", at("new.link"));
  fs::create_symlink("there/new.png", at("link.png"));
  fs::create_symlink("there/new.jpg", at("link.jpg"));
  fs::create_symlink("loop.link", at("loop.link"));
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--json", "old.link"}).status, 0);
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--json", "new.link"}).status, 0);
  EXPECT_EQ(run({"render", "scene.pov", "+W8", "+H6", "+Olink.png"}).status, 0);
  EXPECT_EQ(run({"render", "scene.pov", "+W8", "+H6", "+Olink.jpg"}).status, 0);
  for (const char* link : {"old.link", "new.link", "link.png", "link.jpg"}) {
    EXPECT_TRUE(S_ISLNK(mode(link))) << link;
    EXPECT_GT(fs::file_size(at(link)), 3u) << link;
  }
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--json", "loop.link"}).status, 5);
}

// Every kind of file that the program writes: the call, whose last word is the file.
struct Output {
  std::vector<std::string> call;
  std::string extension;
  std::vector<std::string> with(const std::string& file) const {
    std::vector<std::string> words = call;
    if (words.back() == "+O")
      words.back() += file;
    else
      words.push_back(file);
    return words;
  }
};
const std::vector<Output>& outputs() {
  static const std::vector<Output> all = [] {
    const std::vector<std::string> run{"compare", "scene.pov", "+W8", "+H6", "--baseline", "none", "--quiet"};
    std::vector<Output> out;
    for (const char* kind : {"--json", "--html", "--heat-map", "--pick"})
      out.push_back({{"diff", "a.png", "b.png", kind}, ""});
    for (const char* kind : {"--json", "--html", "--junit", "--markdown"}) {
      out.push_back({run, ""});
      out.back().call.emplace_back(kind);
    }
    for (const char* kind : {"--json", "--svg", "--html"})
      out.push_back({{"explain", "scene.pov", "3", "3", "+W8", "+H6", "--no-oracle", kind}, ""});
    out.push_back({{"explain", "scene.pov", "+W8", "+H6", "--tags"}, ""});
    out.push_back({{"render", "scene.pov", "+W8", "+H6", "-F", "--stats"}, ""});
    for (const char* type : {".png", ".jpg", ".exr", ".tga", ".bmp", ".ppm", ".hdr"})
      out.push_back({{"render", "scene.pov", "+W8", "+H6", "+O"}, type});
    return out;
  }();
  return all;
}

TEST_F(OutputFiles, OfEveryKindGoThroughLinksAndPipesAndDevices) {
  int number = 0;
  for (const Output& output : outputs()) {
    const std::string about = output.call[0] + " " + output.call.back() + output.extension,
                      name = "file" + std::to_string(number++);
    fs::create_symlink("real_" + name + output.extension, at(name + ".link" + output.extension));
    run(output.with(name + ".link" + output.extension));
    EXPECT_TRUE(S_ISLNK(mode(name + ".link" + output.extension))) << about << ": the link was replaced";
    EXPECT_TRUE(exists("real_" + name + output.extension)) << about;
    const std::string pipe = name + ".pipe" + output.extension;
    EXPECT_NE(through_pipe(output.with(pipe), pipe), "") << about;
    const std::string device = name + ".device" + output.extension;
    if (::mknod(at(device).c_str(), S_IFCHR | 0666, ::makedev(1, 3)) != 0) continue;  // only root can make one
    run(output.with(device));
    EXPECT_TRUE(S_ISCHR(mode(device))) << about << ": the device was replaced";
  }
}

TEST_F(OutputFiles, PermissionsFollowTheUmask) {
  file("kept.json", "old");
  fs::permissions(at("kept.json"), fs::perms::owner_read | fs::perms::owner_write);
  const mode_t before = ::umask(027);
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--json", "new.json", "--heat-map", "new.png"}).status, 0);
  EXPECT_EQ(run({"diff", "a.png", "b.png", "--json", "kept.json"}).status, 0);
  ::umask(before);
  EXPECT_EQ(mode("new.json") & 0777, 0640u);
  EXPECT_EQ(mode("new.png") & 0777, 0640u);
  EXPECT_EQ(mode("kept.json") & 0777, 0600u) << "what only its owner may read stays so";
}

// The report is not written over by what the program says later, nor does it take the file's place.
// A program that was found through PATH only knows its name: what is called so in the current folder is not it.
TEST_F(OutputFiles, PlugInsOfTheCurrentFolderAreNotLoaded) {
  file("verisim", "");
  file("libverisim_image_module.so", "not of verisim");
  const Ended ended = run({"render", "scene.pov", "+W8", "+H8", "--output", "picture.jpg"});
  EXPECT_EQ(ended.status, 0) << ended.errors;
}

TEST_F(OutputFiles, StandardOutputByNameKeepsEverything) {
  fs::create_symlink("/proc/self/fd/1", at("output"));  // as /dev/stdout is
  const Ended ended = run({"diff", "a.png", "b.png", "--json", "output"});
  EXPECT_NE(ended.output.find("\"rmse\""), std::string::npos);
  EXPECT_NE(ended.output.find("exact"), std::string::npos);
}

TEST_F(OutputFiles, AStateFileIsNeverAPipe) {
  ASSERT_EQ(::mkfifo(at("slow.pov-state").c_str(), 0600), 0);
  const pid_t child = start({"render", "scene.pov", "+W8", "+H6", "+Oslow.png", "+C"});
  int status = 0;
  bool ended = false;
  for (int i = 0; i < 1000 && !ended; ++i) {
    ended = ::waitpid(child, &status, WNOHANG) == child;
    if (!ended) std::this_thread::sleep_for(milliseconds(10));
  }
  if (!ended) ::kill(child, SIGKILL), ::waitpid(child, &status, 0);
  EXPECT_TRUE(ended && WIFEXITED(status) && WEXITSTATUS(status) == 0) << "it waits for somebody to open the pipe";
  EXPECT_TRUE(S_ISFIFO(mode("slow.pov-state")));
}

}  // namespace
}  // namespace verisim::cli
