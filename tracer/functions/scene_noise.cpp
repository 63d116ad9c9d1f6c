#include "tracer/functions/scene_noise.h"

#include <atomic>
#include <mutex>

namespace verisim::functions {
namespace {

// Made when first asked, for nearly all scenes keep to one generator.
class FollowsGenerator final : public Function {
 public:
  FollowsGenerator(std::shared_ptr<const int> generator, std::function<FunctionPtr(int)> make)
      : generator_(std::move(generator)), make_(std::move(make)) {}
  int parameters() const override { return current().parameters(); }
  int components() const override { return current().components(); }
  void evaluate(std::span<const double> arguments, double* result) const override {
    current().evaluate(arguments, result);
  }
  void evaluate_batch(const double* arguments, std::size_t stride, std::size_t count, double* result) const override {
    current().evaluate_batch(arguments, stride, count, result);
  }

 private:
  struct Made {
    std::once_flag once;
    FunctionPtr owned;
    std::atomic<const Function*> function{nullptr};  // of `owned` once it is made: call_once takes longer to say so
  };
  const Function& current() const {
    Made& made = made_[static_cast<std::size_t>(*generator_ - 1)];
    if (const Function* function = made.function.load(std::memory_order_acquire)) return *function;
    std::call_once(made.once, [&] {
      made.owned = make_(*generator_);
      made.function.store(made.owned.get(), std::memory_order_release);
    });
    return *made.owned;
  }

  std::shared_ptr<const int> generator_;
  std::function<FunctionPtr(int)> make_;
  mutable std::array<Made, 3> made_;
};

}  // namespace

FunctionPtr follow_generator(std::shared_ptr<const int> generator, std::function<FunctionPtr(int)> make) {
  auto function = std::make_shared<FollowsGenerator>(std::move(generator), std::move(make));
  function->parameters();  // what is wrong with the description is found now
  return function;
}

}  // namespace verisim::functions
