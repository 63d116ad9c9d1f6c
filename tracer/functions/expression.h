// The expression tree of a user function, as parsed and before POV-Ray's constant folding (spec 01 section 23).
//
// One node is one *chain* of operands of equal precedence, because the folding rules work on chains; `parenthesised`
// marks nodes written in ( ).
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "tracer/functions/function.h"

namespace verisim::functions {

enum class Op : unsigned char {
  add,
  subtract,
  multiply,
  divide,
  less,
  less_equal,
  equal,
  not_equal,
  greater_equal,
  greater,
  logic_and,
  logic_or
};
enum class Builtin : unsigned char {
  abs_,
  acos_,
  acosh_,
  asin_,
  asinh_,
  atan_,
  atan2_,
  atanh_,
  ceil_,
  cos_,
  cosh_,
  degrees_,
  div_,
  exp_,
  floor_,
  int_,
  ln_,
  log_,
  max_,
  min_,
  mod_,
  pow_,
  radians_,
  select_,
  sin_,
  sinh_,
  sqrt_,
  tan_,
  tanh_
};

struct Node;
struct Constant {
  double value;
};  // a literal, a declared float, pi, clock
struct Parameter {
  int index;
};               // slot in the parameter list; sum/prod variables get slots behind the parameters
struct Zero {};  // x, y or z that is not in the parameter list reads as 0
struct Chain {
  std::vector<Node> operands;
  std::vector<Op> operators;
};  // operands[0] op[0] operands[1] ...
struct Negate {
  std::vector<Node> operand;
};  // exactly one
struct BuiltinCall {
  Builtin builtin;
  std::vector<Node> arguments;
};
struct UserCall {
  FunctionPtr function;
  std::vector<Node> arguments;
  int component = 0;
  bool grey = false, hf = false;
};  // f(...) or g(...).c
struct Loop {
  bool product = false;
  int variable = 0;
  std::vector<Node> parts;
};  // sum/prod(variable, first, last, body): parts = first, last, body

struct Node {
  std::variant<Constant, Parameter, Zero, Chain, Negate, BuiltinCall, UserCall, Loop> value;
  bool parenthesised = false;
};

// Folds as POV-Ray does (spec 01 23.5), eliminates common subexpressions and compiles. `parameters` is the length of
// the parameter list, `slots` that plus the number of loop variables. Throws std::invalid_argument with POV-Ray's
// meaning (division by literal 0 ...).
FunctionPtr compile(const Node& root, int parameters, int slots);
// internal(n); throws std::invalid_argument for n out of range. The noise generator is fixed at creation.
FunctionPtr internal_function(int n, int noise_generator);

}  // namespace verisim::functions
