// Expressions of x, y and z for tests, written as they are thought.
#pragma once

#include <utility>
#include <vector>

#include "tracer/functions/expression.h"

namespace verisim::functions::test {

inline Node number(double v) { return {Constant{v}}; }
inline Node x() { return {Parameter{0}}; }
inline Node y() { return {Parameter{1}}; }
inline Node z() { return {Parameter{2}}; }
inline Node of(Builtin f, std::vector<Node> arguments) { return {BuiltinCall{f, std::move(arguments)}}; }
inline Node chain(Node a, Op op, Node b) { return {Chain{{std::move(a), std::move(b)}, {op}}, true}; }
inline Node times(Node a, Node b) { return chain(std::move(a), Op::multiply, std::move(b)); }
inline Node plus(Node a, Node b) { return chain(std::move(a), Op::add, std::move(b)); }

}  // namespace verisim::functions::test
