// Operands: literals, identifiers, calls, brackets, and the dot operator (spec 01 sections 8.3 to 8.6).
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "parser/language/impl.h"

namespace verisim::parser {
namespace {

constexpr int kGray = 5;

std::optional<int> component_index(Word word) {
  switch (word) {
    case Word::x:
    case Word::u:
    case Word::red:
      return 0;
    case Word::y:
    case Word::v:
    case Word::green:
      return 1;
    case Word::z:
    case Word::blue:
      return 2;
    case Word::t:
    case Word::filter:
      return 3;
    case Word::transmit:
      return 4;
    case Word::gray:
      return kGray;
    default:
      return std::nullopt;
  }
}

}  // namespace

void Parser::Impl::primary(int width, Numeric& out) {
  const Token& token = peek();
  switch (token.kind) {
    case TokenKind::number:
      out.v.fill(token.number());
      out.terms = 1;
      skip_token();
      break;
    case TokenKind::identifier:
      identifier_operand(out);
      break;
    case TokenKind::word:
      if (!word_operand(token.word, out)) expected("numeric expression");
      break;
    case TokenKind::vector: {
      const double* numbers = file->vector(token);
      out.terms = static_cast<int>(token.terms());
      for (std::size_t i = 0; i < token.terms(); ++i) out.v[i] = numbers[i];
      skip_token();
      break;
    }
    case TokenKind::punctuation:
      if (token.punctuation == '(')
        parenthesis(out);
      else if (token.punctuation == '<')
        vector_literal(out);
      else
        expected("numeric expression");
      break;
    default:
      expected("numeric expression");
  }
  if (out.terms == 1) {
    for (std::size_t i = 1; i < static_cast<std::size_t>(width); ++i) out.v[i] = out.v[0];
    out.terms = width;
  } else if (out.terms == 3 && width > 3) {
    out.v[3] = out.v[4] = 0;
    out.terms = width;
  }
  if (peek_operator().punctuation == '.') component(width, out);
}

// `.x` and its like: at most one a primary.
void Parser::Impl::component(int width, Numeric& out) {
  skip_token();
  const Token& token = peek();
  const std::optional<int> index = token.kind == TokenKind::word ? component_index(token.word) : std::nullopt;
  if (!index) expected("a component: x, y, z, t, u, v, red, green, blue, filter, transmit or gray");
  double value;
  if (*index == kGray) {
    value = 0.297 * out.v[0] + (out.terms > 1 ? 0.589 * out.v[1] : 0) + (out.terms > 2 ? 0.114 * out.v[2] : 0);
  } else {
    if (*index >= out.terms)
      error(Code::wrong_terms,
            fmt::format("Component '{}' of a value with {} terms.", spelling(token.word), out.terms));
    value = out.v[static_cast<std::size_t>(*index)];
  }
  skip_token();
  out.terms = width;
  out.v.fill(value);
}

void Parser::Impl::parenthesis(Numeric& out) {
  const Nesting nesting(*this);
  skip_token();
  const Live live(*this);
  ++depth_of_parentheses;
  full(out);
  --depth_of_parentheses;
  if (peek().punctuation != ')') expected(")");
  skip_token();
}

void Parser::Impl::vector_literal(Numeric& out) {
  const Nesting nesting(*this);
  skip_token();
  const Live live(*this);
  std::array<double, 5> v{};
  int terms = 0;
  for (;;) {
    if (terms == 5) error(Code::too_many, "A vector has at most 5 components.");
    v[static_cast<std::size_t>(terms++)] = scalar();
    if (peek().punctuation == ',') skip_token();
    if (peek().punctuation == '>') break;
  }
  if (terms < 2) error(Code::wrong_terms, "A vector has at least 2 components.");
  skip_token();
  out.v = v;
  out.terms = terms;
}

void Parser::Impl::identifier_operand(Numeric& out) {
  const std::uint32_t name = position->id();
  const Resolved resolved = resolve();
  const Value& value = resolved.value();
  if (const auto* numeric = std::get_if<Numeric>(&value)) {
    out = *numeric;
    return;
  }
  if (const auto* function = std::get_if<FunctionPtr>(&value)) return call_function(*FunctionPtr(*function), out);
  if (const auto* curve = std::get_if<Shared<Spline>>(&value)) return call_spline(*Shared<Spline>(*curve), out);
  --position;  // the message names this identifier
  ready = true;
  if (value.index() == 0)
    error(Code::no_value,
          fmt::format("'{}' has no value yet: it cannot be used in its own declaration.", names[name].text));
  error(Code::wrong_type, fmt::format("Expected 'numeric expression', {} found instead.", describe(*position)));
}

void Parser::Impl::call_function(const Function& function, Numeric& out) {
  const Nesting nesting(*this);
  if (!accept_operator('(')) expected("(");
  const Live live(*this);
  std::array<double, kMaxFunctionParameters> arguments_of_call{};
  const int count = function.parameters();
  for (int i = 0; i < count; ++i) {
    if (peek().punctuation == ')')
      error(Code::function_arguments, fmt::format("The function needs {} arguments, {} found.", count, i));
    arguments_of_call[static_cast<std::size_t>(i)] = scalar();
    if (i + 1 < count && peek().punctuation == ',') skip_token();
  }
  if (peek().punctuation != ')')
    error(Code::function_arguments,
          fmt::format("Expected ')' behind the {} arguments of the function, {} found instead.", count,
                      describe(*position)));
  skip_token();
  double values[kMaxFunctionComponents]{};
  within_budget("The function", [&] {
    function.evaluate({arguments_of_call.data(), static_cast<std::size_t>(count)}, values);
  });
  out.terms = function.components();
  std::copy(std::begin(values), std::end(values), out.v.begin());
}

// s(t) or s(t, kind).
void Parser::Impl::call_spline(const Spline& curve, Numeric& out) {
  const Nesting nesting(*this);
  if (!accept_operator('(')) expected("(");
  const Live live(*this);
  const double t = scalar();
  const bool typed = peek().punctuation == ',';
  if (typed) skip_token();
  Spline::Kind kind = curve.kind();
  switch (peek().word) {
    case Word::linear_spline:
      kind = Spline::Kind::linear, skip_token();
      break;
    case Word::quadratic_spline:
      kind = Spline::Kind::quadratic, skip_token();
      break;
    case Word::cubic_spline:
      kind = Spline::Kind::cubic, skip_token();
      break;
    case Word::natural_spline:
      kind = Spline::Kind::natural, skip_token();
      break;
    default:
      if (typed) expected("linear_spline, quadratic_spline, cubic_spline or natural_spline");
  }
  if (peek().punctuation != ')') expected(")");
  skip_token();
  if (curve.empty()) error(Code::missing_item, "The spline has no points.");
  out.v = curve.evaluate(t, kind);
  out.terms = curve.terms();
}

}  // namespace verisim::parser
