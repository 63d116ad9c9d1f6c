// Work of C++ while Python waits: without the GIL, with progress, cancellation and Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>

namespace verisim::python {

// What the work tells while it runs, and how it is told to stop.
struct Watch {
  std::atomic<double> progress{0};
  std::atomic<bool> cancel{false};
};

// Who wants to know, all called by the calling thread, which holds the GIL then.
struct Listeners {
  pybind11::object progress;  // called with the fraction that is done, or None
  pybind11::object cancel;    // called without arguments: true to stop, or None
};

// Runs `work` on a thread of its own, whose loops use at most `threads` threads (0: all cores), and returns when it has
// ended. What it throws is thrown here. An exception of a listener, or Ctrl-C in the main thread, sets Watch::cancel
// and is thrown when the work has ended.
void run(const std::function<void(Watch&)>& work, int threads, const Listeners& listeners);

}  // namespace verisim::python
