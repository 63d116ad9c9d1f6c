// Each chain e0 op1 e1 op2 e2 ... is simplified from left to right, and two neighbouring constants are merged with the
// operator between them although the operator in front of the left one should have come first: `a-2*3+4` becomes
// a-(6+4). Scenes are tuned by eye, so the picture depends on it.
#include "tracer/functions/fold.h"

#include <stdexcept>
#include <utility>

namespace verisim::functions {

namespace {

bool mentions_parameter(const Node& node) {
  const auto any = [](const std::vector<Node>& nodes) {
    for (const Node& n : nodes) {
      if (mentions_parameter(n)) return true;
    }
    return false;
  };
  return std::visit(
      [&](const auto& v) -> bool {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, Parameter> || std::is_same_v<T, Zero>)
          return true;
        else if constexpr (std::is_same_v<T, Constant>)
          return false;
        else if constexpr (std::is_same_v<T, Chain>)
          return any(v.operands);
        else if constexpr (std::is_same_v<T, Negate>)
          return any(v.operand);
        else if constexpr (std::is_same_v<T, Loop>)
          return any(v.parts);
        else
          return any(v.arguments);
      },
      node.value);
}

double literal(const Node& node) { return std::get<Constant>(node.value).value; }

double combine(Op op, double a, double b) {
  if (op == Op::divide && b == 0) throw std::invalid_argument("Division by zero.");
  return with_code(code_of(op), [&]<Code C>() { return apply<C>(a, b); });
}

void fold_chain(Chain& chain) {
  std::vector<Node> operands;
  std::vector<Op> operators;
  operands.reserve(chain.operands.size());
  bool parameter_seen = false;
  for (std::size_t i = 0; i < chain.operands.size(); ++i) {
    Node& node = chain.operands[i];
    Op op = i == 0 ? Op::add : chain.operators[i - 1];
    const bool product = op == Op::multiply || op == Op::divide ||
                         (i == 0 && !chain.operators.empty() &&
                          (chain.operators[0] == Op::multiply || chain.operators[0] == Op::divide));
    if (i > 0 && op == Op::subtract && is_literal(node)) {
      op = Op::add;
      node.value = Constant{-literal(node)};
    }
    fold(node);
    if (product) parameter_seen = parameter_seen || mentions_parameter(node);
    if (i > 0 && is_literal(operands.back()) && is_literal(node) && !(product && parameter_seen)) {
      operands.back().value = Constant{combine(op, literal(operands.back()), literal(node))};
      continue;
    }
    if (i > 0) operators.push_back(op);
    operands.push_back(std::move(node));
  }
  chain.operands = std::move(operands);
  chain.operators = std::move(operators);
}

}  // namespace

bool is_literal(const Node& node) { return !node.parenthesised && std::holds_alternative<Constant>(node.value); }

void fold(Node& node) {
  if (auto* chain = std::get_if<Chain>(&node.value)) {
    fold_chain(*chain);
    if (chain->operands.size() == 1) {
      Node only = std::move(chain->operands[0]);
      only.parenthesised = only.parenthesised || node.parenthesised;
      node = std::move(only);
    }
  } else if (auto* negate = std::get_if<Negate>(&node.value)) {
    fold(negate->operand[0]);
    if (is_literal(negate->operand[0])) node.value = Constant{-literal(negate->operand[0])};
  } else if (auto* builtin = std::get_if<BuiltinCall>(&node.value)) {
    for (Node& n : builtin->arguments) fold(n);
  } else if (auto* call = std::get_if<UserCall>(&node.value)) {
    for (Node& n : call->arguments) fold(n);
  } else if (auto* loop = std::get_if<Loop>(&node.value)) {
    for (Node& n : loop->parts) fold(n);
  }
}

}  // namespace verisim::functions
