// What ends a run before its time: Ctrl-C and its like, and the limits of the whole process (--max-seconds,
// --max-cpu-seconds, --max-memory).
//
// All of them first ask for an orderly end by a flag that long work looks at. What does not look at it in time is
// ended by force: no loop of a scene, known or not, can run on. State files are written as blocks are finished, so +C
// goes on from there.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

#include "cli/console/exit_status.h"

namespace verisim::cli {

// Limits of a run; 0: none.
struct Watch {
  double seconds = 0, cpu_seconds = 0;  // by the clock; of all threads together
  std::size_t memory = 0;               // resident, in bytes
  int status = kInterrupted;            // of a run that is ended by force
};

// Installs handlers for SIGINT, SIGTERM, SIGQUIT and SIGHUP as long as it lives, and ignores SIGPIPE (writing reports
// it). The second signal ends the process at once. With limits a thread looks at them, and says on standard error
// which one was reached.
class Interrupt {
 public:
  explicit Interrupt(const Watch& watch = {});
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::atomic<bool>& flag();  // true: stop
  int signal() const;         // the one that came; 0: none
  bool limit_reached() const;
  // The work has seen the flag and writes down what it has, which may take so long.
  void orderly_end(double seconds = 60);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace verisim::cli
