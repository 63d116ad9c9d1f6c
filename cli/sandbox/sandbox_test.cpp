// What the kernel refuses to a process in the sandbox, asked directly, as hostile code in it would; and what scenes are
// told that ask for the same (VERISIM_BINARY_DIR/bin/verisim, cli/process_fixture.h). Skipped where the kernel has no
// Landlock or no filters.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>

#include <functional>
#include <map>
#include <thread>

#include "cli/process_fixture.h"
#include "cli/console/exit_status.h"
#include "cli/sandbox/landlock.h"
#include "cli/sandbox/sandbox.h"
#include "cli/sandbox/system_calls.h"
#include "cli/settings/process_limits.h"

namespace verisim::cli {
namespace {

using testing::HasSubstr;

// The error of a call that gives -1; 0: it went well.
int error_of(long result) { return result < 0 ? errno : 0; }

int opened(const fs::path& path, int flags) {
  const int fd = ::open(path.c_str(), flags, 0600);
  const int error = error_of(fd);
  if (fd >= 0) ::close(fd);
  return error;
}

class Sandbox : public Process {
 protected:
  void SetUp() override {
    Process::SetUp();
    if (landlock_version() == 0 || !has_system_call_filters()) GTEST_SKIP() << "this kernel has no sandbox";
    fs::create_directories(folder_ / "scenes");
    fs::create_directories(folder_ / "pictures");
    file("secret.txt", "#declare Secret = 4711;\n");
    file("scenes/scene.pov", kQuickScene);
    file("scenes/own.inc", "#declare Own = 1;\n");
    fs::create_symlink(folder_ / "secret.txt", folder_ / "scenes/link.inc");
  }

  // Does it in a process that may read scenes/ and write pictures/; 0 or the error.
  int attempt(const std::function<int()>& attempt, bool server = false) const {
    const pid_t child = ::fork();
    if (child == 0) {
      process_limits.sandbox = "strict";
      enter_sandbox(Policy{{folder_ / "scenes"}, {folder_ / "pictures"}, {}, server});
      ::_exit(attempt());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status));
    return WEXITSTATUS(status);
  }
};

TEST_F(Sandbox, FilesThatAreNotNamedAreRefused) {
  const fs::path scenes = folder_ / "scenes", pictures = folder_ / "pictures";
  EXPECT_EQ(attempt([&] { return opened(scenes / "own.inc", O_RDONLY); }), 0);
  EXPECT_EQ(attempt([&] { return opened(pictures / "new.png", O_WRONLY | O_CREAT | O_TRUNC); }), 0);
  EXPECT_EQ(attempt([&] { return opened(pictures, O_TMPFILE | O_WRONLY); }), 0);
  const std::map<std::string, std::pair<fs::path, int>> hostile{
      {"a file of the system", {"/etc/passwd", O_RDONLY}},
      {"a link out", {scenes / "link.inc", O_RDONLY}},
      {"dots out", {scenes / "../secret.txt", O_RDONLY}},
      {"a folder", {folder_, O_RDONLY | O_DIRECTORY}},
      {"its own memory", {"/proc/self/mem", O_RDWR}},
      {"its own memory to read", {"/proc/self/mem", O_RDONLY}},
      {"the memory of its parent", {"/proc/" + std::to_string(::getpid()) + "/mem", O_RDONLY}},
      {"its environment", {"/proc/self/environ", O_RDONLY}},
      {"a device", {"/dev/zero", O_RDWR}},
      {"a new file beside", {folder_ / "new.txt", O_WRONLY | O_CREAT}},
      {"a new file beside the scene", {scenes / "new.txt", O_WRONLY | O_CREAT}},
      {"the scene", {scenes / "scene.pov", O_WRONLY}},
      {"emptying the scene", {scenes / "scene.pov", O_RDONLY | O_TRUNC}},
      {"reading a picture", {pictures / "new.png", O_RDONLY}}};
  file("pictures/new.png", "x");
  for (const auto& [what, how] : hostile) {
    const int error = attempt([&, how = how] { return opened(how.first, how.second); });
    EXPECT_TRUE(error == EACCES || error == EPERM) << what << ": " << std::strerror(error);
  }
  EXPECT_EQ(text_of(scenes / "scene.pov"), kQuickScene);
  for (const auto& change : std::map<std::string, std::function<int()>>{
           {"truncate", [&] { return error_of(::truncate((scenes / "scene.pov").c_str(), 0)); }},
           {"unlink", [&] { return error_of(::unlink((scenes / "scene.pov").c_str())); }},
           {"rename", [&] { return error_of(::rename((scenes / "scene.pov").c_str(), (scenes / "b.pov").c_str())); }},
           {"move", [&] { return error_of(::rename((pictures / "new.png").c_str(), (folder_ / "b").c_str())); }},
           {"hard link", [&] { return error_of(::link((folder_ / "secret.txt").c_str(), (pictures / "l").c_str())); }},
           {"link", [&] { return error_of(::symlink("/etc/passwd", (pictures / "l").c_str())); }},
           {"folder", [&] { return error_of(::mkdir((pictures / "d").c_str(), 0700)); }},
           {"device", [&] { return error_of(::mknod((pictures / "f").c_str(), S_IFIFO | 0600, 0)); }},
           {"chmod", [&] { return error_of(::chmod((scenes / "scene.pov").c_str(), 0)); }},
           {"mount", [&] { return error_of(::mount("none", pictures.c_str(), "tmpfs", 0, nullptr)); }}}) {
    const int error = attempt(change.second);
    EXPECT_TRUE(error == EACCES || error == EPERM || error == EXDEV) << change.first << ": " << std::strerror(error);
  }
  EXPECT_EQ(text_of(scenes / "scene.pov"), kQuickScene);
  EXPECT_FALSE(exists("pictures/l"));
}

TEST_F(Sandbox, ProcessesNetworkAndOthersMemoryAreRefused) {
  const pid_t parent = ::getpid();
  char byte = 0;
  iovec local{&byte, 1}, remote{&byte, 1};
  const std::map<std::string, std::function<int()>> calls{
      {"fork", [] { return error_of(::syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0)); }},
#ifdef SYS_fork
      {"the old fork", [] { return error_of(::syscall(SYS_fork)); }},
#endif
      {"exec",
       [] {
         char* none[] = {nullptr};
         return error_of(::execve("/bin/true", none, none));
       }},
      {"socket", [] { return error_of(::socket(AF_INET, SOCK_STREAM, 0)); }},
      {"local socket", [] { return error_of(::socket(AF_UNIX, SOCK_DGRAM, 0)); }},
      {"ptrace", [=] { return error_of(::ptrace(PTRACE_ATTACH, parent, nullptr, nullptr)); }},
      {"memory of the parent", [&] { return error_of(::process_vm_readv(parent, &local, 1, &remote, 1, 0)); }},
      {"kill", [=] { return error_of(::kill(parent, SIGTERM)); }},
      {"a signal to a thread", [=] { return error_of(::syscall(SYS_tgkill, parent, parent, SIGTERM)); }},
      {"io_uring", [] { return error_of(::syscall(SYS_io_uring_setup, 1, nullptr)); }},
      {"limits of the parent", [=] { return error_of(::prlimit(parent, RLIMIT_CPU, nullptr, nullptr)); }},
      {"terminal input", [] { return error_of(::ioctl(0, 0x5412 /* TIOCSTI */, "x")); }}};
  for (const bool server : {false, true})
    for (const auto& [what, call] : calls) EXPECT_EQ(attempt(call, server), EPERM) << what;
  EXPECT_EQ(attempt([] {
              int result = 1;
              std::thread([&] { result = opened("/etc/passwd", O_RDONLY); }).join();
              return result;
            }),
            EACCES)
      << "threads are as restricted as who starts them";
}

// A server goes on answering those who call, and calls nobody.
TEST_F(Sandbox, ServersAnswerAndDoNotCall) {
  const int listening = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(listening, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(listening, 1), 0);
  ASSERT_EQ(::getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const int caller = ::socket(AF_INET, SOCK_STREAM, 0), spare = ::socket(AF_INET, SOCK_STREAM, 0);
  ASSERT_EQ(::connect(caller, reinterpret_cast<sockaddr*>(&address), size), 0);
  const auto answer = [&] { return error_of(::accept(listening, nullptr, nullptr)); };
  EXPECT_EQ(attempt(answer), EPERM);
  EXPECT_EQ(attempt(answer, true), 0);
  EXPECT_EQ(attempt([&] { return error_of(::connect(spare, reinterpret_cast<sockaddr*>(&address), size)); }, true),
            EPERM);
  for (const int fd : {listening, caller, spare}) ::close(fd);
}

TEST_F(Sandbox, ScenesAreToldWhatTheyMayNotDo) {
  const std::string head = "#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }\n";
  const std::string secret = (folder_ / "secret.txt").string();
  for (const auto& [text, names] : std::map<std::string, std::string>{
           {"#include \"/etc/passwd\"", "may not read '/etc/passwd'"},
           {"#include \"../secret.txt\"", "may not read"},
           {"#include \"link.inc\"", "may not read"},
           {"#fopen F \"/etc/passwd\" read #read(F, A)", "may not read '/etc/passwd'"},
           {"#fopen F \"beside.txt\" write #write(F, 1)", "may not write 'beside.txt'"},
           {"#fopen F \"../beside.txt\" append #write(F, 1)", "may not write"},
           {"#fopen F \"" + secret + "\" write #write(F, 1)", "may not write"},
           {"box { 0, 1 pigment { image_map { png \"/etc/passwd\" } } }", "may not read '/etc/passwd'"},
           {"height_field { tga \"" + secret + "\" }", "may not read"},
           {"text { ttf \"" + secret + "\" \"a\" 1, 0 }", "may not read"},
           {"media { density { density_file df3 \"" + secret + "\" } }", "may not read"},
           {"global_settings { photons { count 10 save_file \"beside.ph\" } }", "may not write"},
           {"global_settings { photons { count 10 load_file \"" + secret + "\" } }", "may not read"},
           {"#if (file_exists(\"/etc/passwd\")) #error \"it is there\" #else #error \"nothing there\" #end",
            "nothing there"}}) {
    file("scenes/hostile.pov", head + text + "\n");
    for (const std::string command : {"check", "render"}) {
      std::vector<std::string> words{command, "scenes/hostile.pov", "--sandbox"};
      if (command == "render") words.insert(words.end(), {"+W16", "+H12", "+Opictures/h.png"});
      const Ended ended = run(words);
      EXPECT_EQ(ended.status, kSceneErrors) << text << ended.errors;
      EXPECT_THAT(ended.errors, HasSubstr(names)) << text;
      EXPECT_FALSE(exists("beside.txt") || exists("scenes/beside.txt") || exists("scenes/beside.ph")) << text;
    }
  }
  EXPECT_THAT(text_of(folder_ / "secret.txt"), HasSubstr("4711"));
}

// Between the program's own look at a name and its opening the name may come to mean something else: the kernel looks
// at what is opened.
TEST_F(Sandbox, RacedLinksLeadNowhere) {
  file("scenes/race.pov",
       "#version 3.7; global_settings { assumed_gamma 1 }\n#for (I, 1, 300) #ifdef (Own) #undef Own #end #include "
       "\"race.inc\" #ifdef (Secret) #error concat(\"read the\", \" secret\") #end #end\nsphere { 0, 1 }\n");
  // A process, not a thread: what is between fork and exec in run() may not wait for a thread's lock of the heap.
  const pid_t racer = ::fork();
  if (racer == 0) {
    const fs::path name = folder_ / "scenes/race.inc", next = folder_ / "scenes/next.inc";
    for (int i = 0;; ++i) {
      std::error_code ignored;
      fs::remove(next, ignored);
      fs::create_symlink(folder_ / (i % 2 ? "secret.txt" : "scenes/own.inc"), next, ignored);
      fs::rename(next, name, ignored);
    }
  }
  for (int i = 0; i < 10; ++i)
    EXPECT_THAT(run({"check", "scenes/race.pov", "--sandbox"}).errors, testing::Not(HasSubstr("read the secret")));
  ::kill(racer, SIGKILL);
  ::waitpid(racer, nullptr, 0);
}

TEST_F(Sandbox, PicturesAreTheSameBytes) {
  file("scenes/lit.pov", std::string(kQuickScene) + "#include \"own.inc\"\n");
  for (const std::string type : {"+FN", "+FE", "+FJ", "+FP", "+FT", "+FH"}) {
    ASSERT_EQ(run({"render", "scenes/lit.pov", "+W32", "+H24", type, "+Opictures/free"}).status, kOk);
    const Ended ended =
        run({"render", "scenes/lit.pov", "+W32", "+H24", type, "+Opictures/boxed", "--sandbox", "--stats=stats.json"});
    ASSERT_EQ(ended.status, kOk) << type << ended.errors;
    std::map<std::string, std::string> pictures;
    for (const auto& entry : fs::directory_iterator(folder_ / "pictures"))
      pictures[entry.path().stem().string()] = text_of(entry.path());
    EXPECT_EQ(pictures.size(), 2u);
    EXPECT_EQ(pictures["free"], pictures["boxed"]) << type;
    fs::remove_all(folder_ / "pictures");
    fs::create_directories(folder_ / "pictures");
    const Ended piped = run({"render", "scenes/lit.pov", "+W32", "+H24", type, "--output=-", "--sandbox"});
    EXPECT_EQ(piped.status, kOk) << type << piped.errors;
    EXPECT_EQ(piped.output, pictures["free"]) << type;
  }
}

TEST_F(Sandbox, WhatIsNamedIsAllowed) {
  file("scenes/writes.pov", std::string(kQuickScene) + "#fopen F \"out/a.inc\" write #write(F, \"#declare A=1;\") " +
                                "#fclose F #include \"out/a.inc\" #include \"lib.inc\"\n");
  fs::create_directories(folder_ / "out");
  fs::create_directories(folder_ / "lib");
  file("lib/lib.inc", "#declare B = 1;\n");
  const std::vector<std::string> words{"render", "scenes/writes.pov", "+W16", "+H12", "+Llib", "--sandbox"};
  EXPECT_EQ(run(words).status, kSceneErrors);
  std::vector<std::string> allowed = words;
  allowed.emplace_back("--allow-write=out");
  const Ended ended = run(allowed);
  EXPECT_EQ(ended.status, kOk) << ended.errors;
  EXPECT_TRUE(exists("out/a.inc"));
  EXPECT_EQ(run({"render", "scene.pov", "--sandbox=loose"}).status, kUsage);
  EXPECT_EQ(run({"render", "scene.pov", "--sandbox", "--allow-shell"}).status, kUsage);
  EXPECT_EQ(run({"render", "scene.pov", "+W16", "+H12", "--sandbox=best-effort"}).status, kOk);
}

}  // namespace
}  // namespace verisim::cli
