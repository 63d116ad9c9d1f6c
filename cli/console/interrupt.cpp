#include "cli/console/interrupt.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace verisim::cli {
namespace {

// Handlers may only touch lock-free atomics.
std::atomic<bool> stop{false};
std::atomic<int> received{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
  if (received.exchange(number) != 0) _exit(2);
  stop = true;
}

constexpr std::array kSignals{SIGINT, SIGTERM, SIGQUIT};

}  // namespace

struct Interrupt::Impl {
  std::array<struct sigaction, kSignals.size()> previous{};
  struct sigaction previous_pipe {};
  std::atomic<bool> late{false};
  std::mutex mutex;
  std::condition_variable wake;
  bool done = false;
  std::thread clock;
};

Interrupt::Interrupt(double max_seconds) : impl_(std::make_unique<Impl>()) {
  stop = false;
  received = 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &impl_->previous[i]);
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, &impl_->previous_pipe);
  if (max_seconds > 0)
    impl_->clock = std::thread([this, max_seconds] {
      std::unique_lock lock(impl_->mutex);
      if (!impl_->wake.wait_for(lock, std::chrono::duration<double>(max_seconds), [this] { return impl_->done; }))
        impl_->late = stop = true;
    });
}

Interrupt::~Interrupt() {
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
bool Interrupt::out_of_time() const { return impl_->late; }

}  // namespace verisim::cli
