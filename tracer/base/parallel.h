// One way to run a loop on all threads: oneTBB, or plain threads where ThreadSanitizer watches.
//
// libtbb comes as a package without instrumentation: the sanitizer cannot see that a task begins after it was handed
// over and ends before the loop returns, and would report every access across that edge. With plain threads it sees
// all, and our loops' bodies are what is to be checked.
#pragma once

#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace verisim {

// Calls body(i) for 0 <= i < count, at most `grain` consecutive indices (at least 1) a task, on the threads of the
// calling arena. The first exception that a body throws is thrown here once the running tasks have ended. The order is
// unspecified: a result must not depend on it.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
  if (count <= grain) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
#ifdef __SANITIZE_THREAD__
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&] {
    try {
      for (std::size_t first; (first = next.fetch_add(grain)) < count;)
        for (std::size_t i = first; i < std::min(count, first + grain); ++i) body(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  const std::size_t tasks = (count + grain - 1) / grain;
  std::vector<std::thread> threads(
      std::min<std::size_t>(tasks, static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()))));
  for (std::thread& thread : threads) thread = std::thread(run);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
#else
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, grain),
      [&body](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
      },
      tbb::simple_partitioner());
#endif
}

}  // namespace verisim
