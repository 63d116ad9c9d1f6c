// Ctrl-C and its like: the first one asks for an orderly end, the second one ends at once. Also the clock of
// --max-seconds.
#pragma once

#include <atomic>
#include <memory>

namespace verisim::cli {

// Installs handlers for SIGINT, SIGTERM and SIGQUIT as long as it lives, and ignores SIGPIPE (writing reports it).
class Interrupt {
 public:
  explicit Interrupt(double max_seconds = 0);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::atomic<bool>& flag();  // true: stop
  int signal() const;         // the one that came; 0: none
  bool out_of_time() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace verisim::cli
