#include "tracer/functions/internal/formula_table.h"

#include <stdexcept>
#include <string>

#include "tracer/functions/expression.h"
#include "tracer/functions/internal/noise_functions.h"

namespace verisim::functions {

namespace {

class Internal final : public Function {
 public:
  explicit Internal(const Entry& entry) : entry_(entry) {}
  int parameters() const override { return 3 + entry_.extra; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> a, double* result) const override {
    *result = entry_.formula({a[0], a[1], a[2], a.data() + 3});
  }

 private:
  Entry entry_;
};

}  // namespace

FunctionPtr internal_function(int n, int noise_generator) {
  if (auto noise = noise_function(n, noise_generator)) return noise;
  for (const Entry& entry : {polynomial_function(n), transcendental_function(n)}) {
    if (entry.formula) return std::make_shared<Internal>(entry);
  }
  throw std::invalid_argument("Function 'internal(" + std::to_string(n) + ")' does not exist.");
}

}  // namespace verisim::functions
