// How much one evaluation of a function may do. sum and prod run over any range, and functions may each call the one
// before twice: a scene must not be able to hang a program that cannot end a thread by force.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>

namespace verisim::functions {

// Passes of loops, of one evaluation with all that it calls. A call of a function counts as eight, which is about what
// it takes, and its instructions as one each. POV-Ray takes seconds for as many.
inline constexpr std::uint64_t kMaxPasses = 100'000'000, kPassesOfACall = 8;

// Lives as long as a loop or a call, or as a question that may take many; the outermost of a thread decides what all of
// them share.
class EvaluationBudget {
 public:
  EvaluationBudget() = default;
  EvaluationBudget(const EvaluationBudget&) = delete;
  EvaluationBudget& operator=(const EvaluationBudget&) = delete;
  ~EvaluationBudget() {
    if (open_) --open_budgets_;
  }
  void open() {
    open_ = true;
    // Whoever has gone too far, or is asked to stop, gets little more until somebody makes an error of it.
    if (!open_budgets_++) left_ = overran_ || stopped() ? kAfterwards : kMaxPasses;
  }
  // False: no more of it. The value is NaN then, and take_overrun says so once.
  bool spend(std::uint64_t passes = 1) {
    if (!open_) open();
    if (left_ >= passes) {
      left_ -= passes;
      return true;
    }
    overran_ = true;
    return false;
  }
  // Of an open one that is the outermost: whether the value was more than some arithmetic.
  static bool spent() { return left_ != kMaxPasses; }
  // True once after an evaluation of this thread was cut short.
  static bool take_overrun() { return std::exchange(overran_, false); }

  // While it lives, values of this thread have next to no budget as soon as `stop` is set: a ray may ask for thousands
  // of them, each as long as it may be, before anybody else looks at it.
  class EndsAt {
   public:
    explicit EndsAt(const std::atomic<bool>* stop) : before_(std::exchange(stop_, stop)) {}
    EndsAt(const EndsAt&) = delete;
    EndsAt& operator=(const EndsAt&) = delete;
    ~EndsAt() { stop_ = before_; }

   private:
    const std::atomic<bool>* before_;
  };

 private:
  static bool stopped() { return stop_ && stop_->load(std::memory_order_relaxed); }

  static constexpr std::uint64_t kAfterwards = 1000;
  static inline constinit thread_local int open_budgets_ = 0;
  static inline constinit thread_local std::uint64_t left_ = 0;
  static inline constinit thread_local bool overran_ = false;
  static inline constinit thread_local const std::atomic<bool>* stop_ = nullptr;
  bool open_ = false;
};

}  // namespace verisim::functions
