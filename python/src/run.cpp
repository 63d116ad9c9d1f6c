#include "python/src/run.h"

#include <pthread.h>
#include <tbb/global_control.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>

#include "tracer/base/lent_arena.h"

namespace py = pybind11;

namespace verisim::python {
namespace {

// Objects may be within objects some thousand levels deep, and walks over them are recursive. Only what is used of a
// stack takes memory.
constexpr std::size_t kStack = std::size_t{100} << 20;
constexpr std::chrono::milliseconds kTick{20};  // between two looks at Ctrl-C and the listeners

// A thread with a large stack, and what came of it.
class Worker {
 public:
  Worker(const std::function<void(Watch&)>& work, int threads) : work_(work), threads_(threads) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStack);
    const int failed = pthread_create(
        &thread_, &attributes,
        [](void* self) -> void* {
          static_cast<Worker*>(self)->body();
          return nullptr;
        },
        this);
    pthread_attr_destroy(&attributes);
    if (failed != 0) throw std::system_error(failed, std::generic_category(), "cannot start a thread");
  }
  // Not holding the GIL, as all that waits.
  ~Worker() {
    watch.cancel = true;
    pthread_join(thread_, nullptr);
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  bool wait() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kTick, [&] { return ended_; });
  }
  // Once it has ended.
  std::exception_ptr failure() const { return failure_; }

  Watch watch;

 private:
  void body() {
    // Workers of oneTBB stay for later loops: from the first on they have what the deepest scene needs.
    static const auto& stack = *new tbb::global_control(tbb::global_control::thread_stack_size, kStack);
    static_cast<void>(stack);
    try {
      LentArena arena(threads_ > 0 ? threads_ : tbb::task_arena::automatic);
      arena.execute([&] { work_(watch); });
    } catch (...) {
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_one();
  }

  const std::function<void(Watch&)>& work_;
  const int threads_;
  pthread_t thread_{};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::exception_ptr failure_;
};

}  // namespace

void run(const std::function<void(Watch&)>& work, int threads, const Listeners& listeners) {
  const py::gil_scoped_release waiting;
  Worker worker(work, threads);
  double told = 0;
  const auto tell = [&](double fraction) {
    if (listeners.progress.is_none() || fraction <= told) return;
    told = fraction;
    listeners.progress(fraction);
  };
  while (!worker.wait()) {
    const py::gil_scoped_acquire holding;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!listeners.cancel.is_none() && py::bool_(listeners.cancel())) worker.watch.cancel = true;
    tell(worker.watch.progress);
  }
  if (worker.failure()) std::rethrow_exception(worker.failure());
  if (worker.watch.cancel) return;
  const py::gil_scoped_acquire holding;
  tell(1);
}

}  // namespace verisim::python
