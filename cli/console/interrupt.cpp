#include "cli/console/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <ctime>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <fmt/format.h>

#include "tracer/base/resident_memory.h"

namespace verisim::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// Handlers may only touch lock-free atomics.
std::atomic<bool> stop{false};
std::atomic<int> received{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
  if (received.exchange(number) != 0) _exit(2);
  stop = true;
}

constexpr std::array kSignals{SIGINT, SIGTERM, SIGQUIT, SIGHUP};

constexpr Seconds kLook{0.01};     // between two looks at the limits: a core fills some 20 MB in that time
constexpr Seconds kPatience{0.7};  // from the flag to the beginning of an orderly end
constexpr double kMemoryMargin = 1.04;

double cpu_time() {
  timespec t{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void say_error(const std::string& text) {
  const std::string line = "verisim: error: " + text + "\n";
  if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return;  // there is nobody left to be told
}

}  // namespace

struct Interrupt::Impl {
  explicit Impl(const Watch& limits) : watch(limits) {}

  void run() {
    const Clock::time_point start = Clock::now();
    std::optional<Clock::time_point> asked;
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, kLook, [this] { return done; })) {
      const Clock::time_point now = Clock::now();
      const std::size_t memory = watch.memory ? resident_memory() : 0;
      if (!reached) {
        const std::string limit = exceeded(Seconds(now - start).count(), memory);
        if (!limit.empty()) {
          say_error(limit);
          reached = stop = true;
        }
      }
      if (!stop) continue;
      if (!asked) asked = now;
      if (reached && static_cast<double>(memory) > kMemoryMargin * static_cast<double>(watch.memory))
        force("memory goes on growing");
      if (now - *asked > Seconds(patience)) force("the work under way does not end by itself");
    }
  }

  // In words; empty: no limit is.
  std::string exceeded(double seconds, std::size_t memory) const {
    if (watch.memory && memory > watch.memory)
      return fmt::format("--max-memory {} is reached: {} bytes are in use", watch.memory, memory);
    if (watch.seconds > 0 && seconds > watch.seconds) return fmt::format("--max-seconds {} is reached", watch.seconds);
    if (watch.cpu_seconds > 0 && cpu_time() > watch.cpu_seconds)
      return fmt::format("--max-cpu-seconds {} is reached", watch.cpu_seconds);
    return {};
  }

  [[noreturn]] void force(const char* why) const {
    say_error(fmt::format("ended by force: {}", why));
    ::_exit(watch.status);
  }

  Watch watch;
  std::array<struct sigaction, kSignals.size()> previous{};
  struct sigaction previous_pipe {};
  std::atomic<bool> reached{false};
  std::atomic<double> patience{kPatience.count()};  // seconds, from the flag on
  std::mutex mutex;
  std::condition_variable wake;
  bool done = false;
  std::thread clock;
};

Interrupt::Interrupt(const Watch& watch) : impl_(std::make_unique<Impl>(watch)) {
  stop = false;
  received = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &action, &impl_->previous[i]);
    // nohup's wish is kept.
    if (kSignals[i] == SIGHUP && impl_->previous[i].sa_handler == SIG_IGN)
      sigaction(SIGHUP, &impl_->previous[i], nullptr);
  }
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, &impl_->previous_pipe);
  if (watch.seconds > 0 || watch.cpu_seconds > 0 || watch.memory > 0)
    impl_->clock = std::thread([this] { impl_->run(); });
  memory_limit = watch.memory;
}

Interrupt::~Interrupt() {
  memory_limit = 0;
  if (impl_->clock.joinable()) {
    {
      const std::lock_guard lock(impl_->mutex);
      impl_->done = true;
    }
    impl_->wake.notify_all();
    impl_->clock.join();
  }
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &impl_->previous[i], nullptr);
  sigaction(SIGPIPE, &impl_->previous_pipe, nullptr);
}

std::atomic<bool>& Interrupt::flag() { return stop; }
int Interrupt::signal() const { return received; }
bool Interrupt::limit_reached() const { return impl_->reached; }
void Interrupt::orderly_end(double seconds) { impl_->patience = seconds; }

}  // namespace verisim::cli
