// Functions of SDL: user functions, internal(n), pattern, pigment, transform and spline functions (spec 01 sections 23
// and 24).
//
// The parser builds the expression tree of expression.h; `compile` turns it into a program for a register machine
// (program.h).
#pragma once

#include <array>
#include <memory>
#include <span>

namespace verisim {

inline constexpr int kMaxFunctionParameters = 56;
inline constexpr int kMaxFunctionComponents = 5;

// Immutable and callable from any thread.
class Function {
 public:
  virtual ~Function() = default;
  virtual int parameters() const = 0;  // number of arguments expected
  virtual int components() const = 0;  // 1: a float function; 3 transform; 5 pigment; 2..5 spline
  // arguments.size() == parameters(); writes components() values to result.
  virtual void evaluate(std::span<const double> arguments, double* result) const = 0;
  // Batch form: argument i of point k is arguments[i * stride + k]; component c of point k goes to result[c * stride +
  // k].
  virtual void evaluate_batch(const double* arguments, std::size_t stride, std::size_t count, double* result) const;

  double operator()(double x, double y, double z) const {
    const std::array<double, 3> arguments{x, y, z};
    double result[kMaxFunctionComponents];
    evaluate(arguments, result);
    return result[0];
  }
};
using FunctionPtr = std::shared_ptr<const Function>;

}  // namespace verisim
