// Operators (spec 01 section 8): additive terms everywhere, the full grammar inside brackets and in the few places that
// allow it.
#include <cmath>
#include <limits>

#include "parser/language/impl.h"

namespace verisim::parser {
namespace {

// The operand with fewer terms is widened: a scalar is replicated, a vector padded with zeros.
void widen(Numeric& a, int terms) {
  if (a.terms == 1)
    for (int i = 1; i < terms; ++i) a.v[static_cast<std::size_t>(i)] = a.v[0];
  else
    for (int i = a.terms; i < terms; ++i) a.v[static_cast<std::size_t>(i)] = 0;
  a.terms = terms;
}

void promote(Numeric& a, Numeric& b) {
  if (a.terms < b.terms)
    widen(a, b.terms);
  else if (b.terms < a.terms)
    widen(b, a.terms);
}

bool truth(double v) { return std::fabs(v) > kEps; }

bool is_relation(char c) {
  return c == '<' || c == '>' || c == '=' || c == kLessEqual || c == kGreaterEqual || c == kNotEqual;
}

bool compare(char operation, double a, double b) {
  switch (operation) {
    case '<':
      return a < b;
    case '>':
      return a > b;
    case kLessEqual:
      return a <= b || !truth(a - b);
    case kGreaterEqual:
      return a >= b || !truth(a - b);
    case '=':
      return !truth(a - b);
    default:
      return truth(a - b);
  }
}

template <class F>
void each(Numeric& a, Numeric& b, F&& f) {
  promote(a, b);
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.terms); ++i) a.v[i] = f(a.v[i], b.v[i]);
}

}  // namespace

double Parser::Impl::divide(double a, double b, const Token* divisor) {
  if (b != 0) return a / b;
  message_at({file, divisor}, Severity::warning, Code::divide_by_zero, "Divide by zero.");
  return std::numeric_limits<double>::infinity();
}

void Parser::Impl::unary(int width, Numeric& out) {
  const Token& token = peek();
  const char sign = token.punctuation;
  if (sign != '-' && sign != '+' && sign != '!') return primary(width, out);
  const Nesting nesting(*this);
  skip_token();
  unary(width, out);
  if (sign == '+') return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(out.terms); ++i)
    out.v[i] = sign == '-' ? -out.v[i] : truth(out.v[i]) ? 0.0 : 1.0;
}

void Parser::Impl::multiplicative(int width, Numeric& out) {
  unary(width, out);
  for (;;) {
    const char operation = peek_operator().punctuation;
    if (operation != '*' && operation != '/') return;
    skip_token();
    const Spot divisor{file, position};
    Numeric right;
    unary(width, right);
    if (operation == '*')
      each(out, right, [](double a, double b) { return a * b; });
    else
      each(out, right,
           [&](double a, double b) { return divide(a, b, divisor.file == file ? divisor.token : position); });
  }
}

void Parser::Impl::additive(int width, Numeric& out) {
  // Before version 1.5 operators need parentheses.
  if (language_version < 150 && depth_of_parentheses == 0) return unary(width, out);
  if (position->kind == TokenKind::vector && literal(false, out)) {
    if (out.terms == 3 && width > 3) out.terms = width, out.v[3] = out.v[4] = 0;
    return;
  }
  if (additive_fast(width, out)) return;
  multiplicative(width, out);
  for (;;) {
    const char operation = peek_operator().punctuation;
    if (operation != '+' && operation != '-') return;
    skip_token();
    Numeric right;
    multiplicative(width, right);
    if (operation == '+')
      each(out, right, [](double a, double b) { return a + b; });
    else
      each(out, right, [](double a, double b) { return a - b; });
  }
}

// string op string; the result is a truth value.
void Parser::Impl::string_relation(Numeric& out) {
  const std::u16string left = string(false);
  const char operation = peek_operator().punctuation;
  if (!is_relation(operation)) expected("a comparison of strings");
  skip_token();
  if (!at_string()) expected("string expression");
  const int order = left.compare(string(false));
  bool result = false;
  switch (operation) {
    case '<':
      result = order < 0;
      break;
    case '>':
      result = order > 0;
      break;
    case kLessEqual:
      result = order <= 0;
      break;
    case kGreaterEqual:
      result = order >= 0;
      break;
    case '=':
      result = order == 0;
      break;
    default:
      result = order != 0;
  }
  out = Numeric{{result ? 1.0 : 0.0}, 1};
}

void Parser::Impl::relation(Numeric& out) {
  if (at_string()) return string_relation(out);
  additive(1, out);
  for (;;) {
    const char operation = peek_operator().punctuation;
    if (!is_relation(operation) || position->kind == TokenKind::vector) return;
    skip_token();
    Numeric right;
    additive(1, right);
    each(out, right, [operation](double a, double b) { return compare(operation, a, b) ? 1.0 : 0.0; });
  }
}

void Parser::Impl::logical(Numeric& out) {
  relation(out);
  for (;;) {
    const char operation = peek_operator().punctuation;
    if (operation != '&' && operation != '|') return;
    skip_token();
    Numeric right;
    relation(right);
    if (operation == '&')
      each(out, right, [](double a, double b) { return truth(a) && truth(b) ? 1.0 : 0.0; });
    else
      each(out, right, [](double a, double b) { return truth(a) || truth(b) ? 1.0 : 0.0; });
  }
}

// C ? E : E. Both branches are evaluated.
void Parser::Impl::full(Numeric& out) {
  if (literal(true, out) || full_fast(out)) return;
  logical(out);
  if (peek_operator().punctuation != '?') return;
  const Nesting nesting(*this);
  if (out.terms > 1) error(Code::wrong_terms, "The condition before '?' must be a float.");
  skip_token();
  const bool first = truth(out.v[0]);
  Numeric yes, no;
  full(yes);
  expect_operator(':');
  full(no);
  out = first ? yes : no;
}

// At the end a value gets the width of its context; more terms than that are an error.
void Parser::Impl::fit(Numeric& value, int width, const Token* start) {
  if (value.terms > width) {
    const char* found = value.terms == 5 ? "a colour" : "a vector with more terms";
    const Spot at = start >= file->tokens.data() && start <= position ? Spot{file, start} : here();
    if (width == 1)
      error_at(at, Code::wrong_terms,
               std::string("Float expected but ") + (value.terms == 5 ? "colour" : "vector") + " expression found.");
    error_at(at, Code::wrong_terms,
             std::string("Expected a vector of ") + std::to_string(width) + " terms, " + found + " found.");
  }
  widen(value, width);
}

double Parser::Impl::scalar() {
  if (double value; scalar_fast(value)) return value;
  const Token* const start = position;
  Numeric value;
  additive(1, value);
  if (value.terms > 1) fit(value, 1, start);
  return value.v[0];
}

double Parser::Impl::full_scalar() {
  const Token* const start = position;
  Numeric value;
  full(value);
  if (value.terms > 1) fit(value, 1, start);
  return value.v[0];
}

// ---- The public face ----

namespace {

// Remembers where a value begins that a block reads: messages about it point there.
class ReadValue {
 public:
  explicit ReadValue(Parser::Impl& impl) : impl_(impl), start_(impl.next()) {}
  ~ReadValue() { impl_.value_read = start_; }
  ReadValue(const ReadValue&) = delete;
  ReadValue& operator=(const ReadValue&) = delete;
  const Token* start() const { return start_.token; }

 private:
  Parser::Impl& impl_;
  Spot start_;
};

}  // namespace

double Parser::parse_float() {
  const ReadValue value(*impl_);
  return impl_->scalar();
}

int Parser::parse_int() { return to_int(parse_float()); }
bool Parser::parse_flag(bool absent) { return at_number_start() ? parse_float() > 0 : absent; }
double Parser::parse_optional_float(double absent) { return at_number_start() ? parse_float() : absent; }

Numeric Parser::parse_numeric(int width) {
  const ReadValue read(*impl_);
  Numeric value;
  impl_->additive(width, value);
  impl_->fit(value, width, read.start());
  return value;
}

Numeric Parser::parse_full_numeric() {
  const ReadValue read(*impl_);
  Numeric value;
  impl_->full(value);
  return value;
}

Vec2 Parser::parse_vec2() {
  if (Vec2 v; impl_->literal_vector(2, &v.x)) return v;
  const Numeric n = parse_numeric(2);
  return {n.v[0], n.v[1]};
}

Vec3 Parser::parse_vec3() {
  const ReadValue read(*impl_);
  if (Vec3 v; impl_->literal_vector(3, &v.x) || impl_->vector_fast(v)) return v;
  const Numeric n = parse_numeric(3);
  return {n.v[0], n.v[1], n.v[2]};
}

}  // namespace verisim::parser
