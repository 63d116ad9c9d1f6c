#include "tracer/functions/function.h"

#include <vector>

namespace verisim {

void Function::evaluate_batch(const double* arguments, std::size_t stride, std::size_t count, double* result) const {
  const auto inputs = static_cast<std::size_t>(parameters()), outputs = static_cast<std::size_t>(components());
  double point[kMaxFunctionParameters], value[kMaxFunctionComponents];
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < inputs; ++i) point[i] = arguments[i * stride + k];
    evaluate({point, inputs}, value);
    for (std::size_t c = 0; c < outputs; ++c) result[c * stride + k] = value[c];
  }
}

}  // namespace verisim
