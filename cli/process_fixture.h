// Runs the program as a process in a folder of its own, for tests of what users and other programs see of it.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "tracer/base/whole_file.h"
#include "tracer/image/output.h"

namespace verisim::cli {

namespace fs = std::filesystem;
using std::chrono::milliseconds;

inline constexpr const char* kQuickScene =
    "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }\n"
    "light_source { <3,4,-9> rgb 1 } sphere { 0, 1 pigment { rgb <1,.5,.2> } }\n";
// Some seconds of work at 320x240 +A0.0 +R5, and more than the one after which the state file appears.
inline constexpr const char* kSlowScene =
    "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> look_at 0 }\n"
    "light_source { <3,4,-9> rgb 1 area_light x*3, y*3, 12, 12 } sphere { 0, 1 pigment { rgb .5 } } plane { y,-1 "
    "pigment { checker rgb 1 rgb .2 } }\n";

struct Ended {
  int status = -1;  // exit status
  int signal = 0;   // or the signal that ended it
  std::string output, errors;
};

inline std::string text_of(const fs::path& path) { return whole_file(path).value_or(""); }

class Process : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("verisim_process_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "home");
    file("scene.pov", kQuickScene);
    file("slow.pov", kSlowScene);
    file("bad.pov", "sphere { 0, 1 pigment { rgbx 1 } }\n");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  bool exists(const std::string& name) const { return fs::exists(folder_ / name); }
  // Until the file is there and something is in it: how long a render takes depends on the machine. Gives up after half
  // a minute.
  void wait_for(const std::string& name) const {
    std::error_code none;
    for (int i = 0; i < 3000 && (!exists(name) || fs::file_size(folder_ / name, none) == 0); ++i)
      std::this_thread::sleep_for(milliseconds(10));
  }

  // Starts the program in the test's folder, with a home of its own and no configuration.
  pid_t start(const std::vector<std::string>& arguments, const std::string& called = "verisim") const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (::chdir(folder_.c_str()) != 0) ::_exit(127);
    ::signal(SIGHUP, SIG_DFL);  // tests may be run by nohup, and what ignores a signal does not end by it
    ::setenv("HOME", (folder_ / "home").c_str(), 1);
    ::setenv("POVINI", "empty.ini", 1);
    std::ofstream(folder_ / "empty.ini") << "; nothing\n";
    const int out = ::open("stdout.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666),
              err = ::open("stderr.txt", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(out, 1);
    ::dup2(err, 2);
    std::vector<char*> argv{const_cast<char*>(called.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(VERISIM_BINARY_DIR "/bin/verisim", argv.data());
    ::_exit(127);
  }
  Ended wait(pid_t child) const {
    int status = 0;
    ::waitpid(child, &status, 0);
    return ended_with(status);
  }
  Ended run(const std::vector<std::string>& arguments, const std::string& called = "verisim") const {
    return wait(start(arguments, called));
  }
  // Through the shell, as most callers do: a command in the test's folder, with the program as $V and `input` on its
  // standard input.
  Ended shell(const std::string& command, const std::string& input = "") const {
    file("input.txt", input);
    const std::string whole = "cd '" + folder_.string() +
                              "' && export V='" VERISIM_BINARY_DIR "/bin/verisim' HOME=$PWD/home && (" + command +
                              ") <input.txt >stdout.txt 2>stderr.txt";
    return ended_with(std::system(whole.c_str()));
  }

  // Files that should not be there after a run: temporary names.
  std::vector<std::string> leftovers(const fs::path& where) const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(where)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(".verisim") || name.find(".tmp") != std::string::npos ||
          name.find(".part") != std::string::npos)
        names.push_back(name);
    }
    return names;
  }
  fs::path folder_;

 private:
  Ended ended_with(int status) const {
    Ended ended;
    if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
    ended.output = text_of(folder_ / "stdout.txt");
    ended.errors = text_of(folder_ / "stderr.txt");
    return ended;
  }
};

}  // namespace verisim::cli
