// A program as a child process: own process group, captured output, time limit, CPU time and peak memory.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace verisim::compare {

struct ProcessRequest {
  std::vector<std::string> arguments;                            // arguments[0]: the program's path
  std::filesystem::path folder;                                  // current folder of the child
  std::vector<std::pair<std::string, std::string>> environment;  // all of it
  double time_limit = 0;                                         // seconds of wall time; 0: none
  std::atomic<bool>* cancel = nullptr;
};

struct ProcessResult {
  bool started = false;
  std::string start_error;  // why not
  int exit_code = -1;       // when it ended by itself
  int signal = 0;           // when a signal ended it
  bool timed_out = false, cancelled = false;
  std::string out, err;          // standard output and error: the last 256 KiB of each
  double wall = 0, cpu = 0;      // seconds; cpu: user + system of the process and the children it waited for
  std::uint64_t peak_bytes = 0;  // largest resident set
  bool succeeded() const { return started && !timed_out && !cancelled && signal == 0 && exit_code == 0; }
  // A crash, not one of ours that ended it.
  bool crashed() const { return started && !timed_out && !cancelled && signal != 0; }
  // "exit status 1", "killed by signal 11 (Segmentation fault)", "no end after 600 s" ...
  std::string how_it_ended(double time_limit) const;
};

// Waits for the end; at the time limit or on cancel the whole process group is killed. Standard input is empty. Thread
// safe.
ProcessResult run_process(const ProcessRequest& request);

// An executable file by name in PATH, or the name itself when it has a slash; empty if there is none.
std::filesystem::path find_program(const std::string& name);

// As one word of a command for the shell.
std::string shell_quoted(const std::string& text);

}  // namespace verisim::compare
