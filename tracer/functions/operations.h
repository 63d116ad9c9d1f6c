// The operations of the register machine with POV-Ray's NaN and range rules (spec 01 23.3, 23.4).
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace verisim::functions {

// All operations of one or two numbers, listed once: X(NAME).
// clang-format off
#define VERISIM_BINARY_OPERATIONS(X)                                                                                \
  X(add) X(subtract) X(multiply) X(divide) X(less) X(less_equal) X(equal) X(not_equal) X(greater_equal) X(greater) \
  X(logic_and) X(logic_or) X(minimum) X(maximum) X(atan2) X(mod) X(div) X(pow)
#define VERISIM_UNARY_OPERATIONS(X)                                                                               \
  X(negate) X(abs) X(acos) X(acosh) X(asin) X(asinh) X(atan) X(atanh) X(ceil) X(cos) X(cosh) X(degrees) X(exp)   \
  X(floor) X(integer) X(ln) X(log) X(radians) X(sin) X(sinh) X(sqrt) X(tan) X(tanh) X(move)
// clang-format on
#define VERISIM_OPERATIONS(X) VERISIM_BINARY_OPERATIONS(X) VERISIM_UNARY_OPERATIONS(X)

enum class Code : std::uint8_t {
#define VERISIM_NAME(NAME) NAME,
  VERISIM_OPERATIONS(VERISIM_NAME)
#undef VERISIM_NAME
  // a < 0 ? b : a == 0 ? c : d
  select,
  // call table entry a
  call,
  // control flow: the target instruction is in `to`
  jump,
  jump_unless_negative /* a */,
  jump_unless_zero /* a */,
  jump_unless_less_equal /* a <= b */
};

constexpr bool is_binary(Code code) { return code <= Code::pow; }
constexpr bool is_unary(Code code) { return code >= Code::negate && code <= Code::move; }
constexpr bool is_jump(Code code) { return code >= Code::jump; }

// Conversion to a 32 bit integer as x86 does it: anything out of range, and NaN, gives the smallest one.
inline double to_int(double a) {
  if (!(a > -2147483649.0 && a < 2147483648.0)) return -2147483648.0;
  return static_cast<double>(static_cast<std::int32_t>(a));
}

inline double select(bool where, double a, double b) { return where ? a : b; }
#include "tracer/functions/exact_operations.inc"

template <Code C>
inline double apply(double a, [[maybe_unused]] double b = 0) {
  if constexpr (kExact<C>)
    return exact<C>(a, b);
  else if constexpr (C == Code::logic_and)
    return a != 0 && b != 0;
  else if constexpr (C == Code::logic_or)
    return a != 0 || b != 0;
  else if constexpr (C == Code::atan2)
    return std::atan2(a, b);
  else if constexpr (C == Code::mod)
    return std::fmod(a, b);
  else if constexpr (C == Code::div)
    return to_int(a / b);
  else if constexpr (C == Code::pow)
    return std::pow(a, b);
  else if constexpr (C == Code::acos)
    return std::acos(a);
  else if constexpr (C == Code::acosh)
    return std::acosh(a);
  else if constexpr (C == Code::asin)
    return std::asin(a);
  else if constexpr (C == Code::asinh)
    return std::asinh(a);
  else if constexpr (C == Code::atan)
    return std::atan(a);
  else if constexpr (C == Code::atanh)
    return std::atanh(a);
  else if constexpr (C == Code::ceil)
    return std::ceil(a);
  else if constexpr (C == Code::cos)
    return std::cos(a);
  else if constexpr (C == Code::cosh)
    return std::cosh(a);
  else if constexpr (C == Code::exp)
    return std::exp(a);
  else if constexpr (C == Code::floor)
    return std::floor(a);
  else if constexpr (C == Code::integer)
    return to_int(a);
  else if constexpr (C == Code::ln)
    return std::log(a);
  else if constexpr (C == Code::log)
    return std::log10(a);
  else if constexpr (C == Code::sin)
    return std::sin(a);
  else if constexpr (C == Code::sinh)
    return std::sinh(a);
  else if constexpr (C == Code::sqrt)
    return std::sqrt(a);
  else if constexpr (C == Code::tan)
    return std::tan(a);
  else
    return std::tanh(a);
}

inline double select(double a, double negative, double zero, double positive) {
  return a < 0 ? negative : a == 0 ? zero : positive;
}

// Calls f.template operator()<Code>() for one of the unary or binary codes.
template <class F>
inline auto with_code(Code code, F&& f) {
#define VERISIM_CASE(NAME) \
  case Code::NAME:         \
    return f.template operator()<Code::NAME>();
  switch (code) {
    VERISIM_OPERATIONS(VERISIM_CASE)
    default:
      return f.template operator()<Code::move>();
  }
#undef VERISIM_CASE
}

}  // namespace verisim::functions
