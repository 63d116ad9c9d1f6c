// Fast paths over runs of plain tokens: scalars made of numbers, variables, arithmetic and calls of functions, conditions, and vectors of literal numbers.
//
// They read tokens without any side effect (draws from random streams are undone) and give up at the first thing they do not know, so that the general path
// can start again from the same token, and gives all messages.
#include <cmath>
#include <numbers>
#include <utility>

#include "parser/language/impl.h"
#include "tracer/functions/expression.h"

namespace verisim::parser {
namespace {

constexpr int kMaxDepth = 32;

class Scanner {
 public:
  Scanner(Parser::Impl& impl, const Token* at) : p_(impl), at_(at), blocked_(impl.blocked) {}

  // A scalar whose end is certain.
  bool scalar(double& out) { return (sum(out, 0) && ends()) || undo(); }

  // Everything inside "( ... )" of a condition: a scalar, or two of them compared.
  bool condition(double& out) {
    if (at_->punctuation != '(') return false;
    ++at_;
    return (comparison(out, 0) && at_->punctuation == ')' && (++at_, true)) || undo();
  }
  const Token* at() const { return at_; }

 private:
  // The expression ends before this token: not when a directive, a macro or the end of the file could still continue it, or a component follows.
  bool ends() const {
    switch (at_->kind) {
      case TokenKind::punctuation: return at_->punctuation != '.' && at_->punctuation != '[';
      case TokenKind::identifier: return blocked_ || !p_.names[at_->id()].symbol || !p_.names[at_->id()].symbol->is_macro;
      case TokenKind::word:
      case TokenKind::number:
      case TokenKind::vector:
      case TokenKind::string: return true;
      default: return false;
    }
  }

  bool undo() {
    while (drawn_) {
      --drawn_;
      p_.random_streams[draws_[drawn_].stream] = draws_[drawn_].state;
    }
    return false;
  }

  bool comparison(double& out, int depth) {
    if (!sum(out, depth)) return false;
    const char operation = at_->punctuation;
    if (operation == ')') return true;
    if (at_->kind == TokenKind::vector) return false;
    if (operation != '<' && operation != '>' && operation != '=' && operation != kLessEqual && operation != kGreaterEqual && operation != kNotEqual) return false;
    ++at_;
    double right;
    if (!sum(right, depth)) return false;
    const bool equal = !(std::fabs(out - right) > kEps);
    switch (operation) {
      case '<': out = out < right; break;
      case '>': out = out > right; break;
      case '=': out = equal; break;
      case kLessEqual: out = out <= right || equal; break;
      case kGreaterEqual: out = out >= right || equal; break;
      default: out = !equal;
    }
    return true;
  }

  bool sum(double& out, int depth) {
    if (!product(out, depth)) return false;
    for (;;) {
      const char operation = at_->punctuation;
      if (operation != '+' && operation != '-') return true;
      ++at_;
      double right;
      if (!product(right, depth)) return false;
      out = operation == '+' ? out + right : out - right;
    }
  }

  bool product(double& out, int depth) {
    if (!factor(out, depth)) return false;
    for (;;) {
      const char operation = at_->punctuation;
      if (operation != '*' && operation != '/') return true;
      ++at_;
      double right;
      if (!factor(right, depth)) return false;
      if (operation == '*') {
        out *= right;
      } else {
        if (right == 0) return false;
        out /= right;
      }
    }
  }

  bool factor(double& out, int depth) {
    switch (at_->kind) {
      case TokenKind::number:
        out = at_++->number();
        return at_->punctuation != '.';
      case TokenKind::identifier: return identifier(out, depth);
      case TokenKind::word: return depth < kMaxDepth && call(out, depth);
      case TokenKind::punctuation:
        if (depth >= kMaxDepth) return false;
        switch (at_->punctuation) {
          case '(':
            ++at_;
            if (!comparison(out, depth + 1) || at_->punctuation != ')') return false;
            ++at_;
            return at_->punctuation != '.';
          case '-':
            ++at_;
            if (!factor(out, depth + 1)) return false;
            out = -out;
            return true;
          case '+':
            ++at_;
            return factor(out, depth + 1);
          default: return false;
        }
      default: return false;
    }
  }

  // A float, an element of an array of floats, a component of a vector, a call of a float function.
  bool identifier(double& out, int depth) {
    Symbol* symbol = p_.names[at_->id()].symbol;
    if (!symbol || symbol->is_macro || symbol->deprecation) return false;
    const Value* value = &symbol->value();
    ++at_;
    if (const auto* array = std::get_if<std::shared_ptr<Array>>(value)) {
      if (depth >= kMaxDepth) return false;
      const Array& a = **array;
      std::size_t element = 0;
      for (const int size : a.sizes) {
        double subscript;
        if (at_->punctuation != '[' || at_->id()) return false;
        ++at_;
        if (!sum(subscript, depth + 1) || at_->punctuation != ']') return false;
        ++at_;
        const int i = to_int(subscript + kEps);
        if (!(subscript >= -kEps) || i >= size) return false;
        element = element * static_cast<std::size_t>(size) + static_cast<std::size_t>(i);
      }
      value = &a.elements[element];
    }
    if (const auto* n = std::get_if<Numeric>(value)) {
      if (n->terms == 1) {
        out = n->v[0];
        return at_->punctuation != '.';
      }
      return component(*n, out);
    }
    if (const auto* function = std::get_if<FunctionPtr>(value)) return depth < kMaxDepth && user_call(**function, out, depth);
    return false;
  }

  bool component(const Numeric& n, double& out) {
    if (at_->punctuation != '.' || at_[1].kind != TokenKind::word) return false;
    int index;
    switch (at_[1].word) {
      case Word::x: case Word::u: case Word::red: index = 0; break;
      case Word::y: case Word::v: case Word::green: index = 1; break;
      case Word::z: case Word::blue: index = 2; break;
      default: return false;
    }
    if (index >= n.terms) return false;
    out = n.v[static_cast<std::size_t>(index)];
    at_ += 2;
    return at_->punctuation != '.';
  }

  bool user_call(const Function& function, double& out, int depth) {
    const int count = function.parameters();
    if (function.components() != 1 || count > 8 || at_->punctuation != '(') return false;
    ++at_;
    double values[8];
    for (int i = 0; i < count; ++i) {
      if (!sum(values[i], depth + 1)) return false;
      if (at_->punctuation != (i + 1 == count ? ')' : ',')) return false;
      ++at_;
    }
    function.evaluate({values, static_cast<std::size_t>(count)}, &out);
    if (std::isnan(out) && functions::take_loop_overrun()) return false;  // the general path makes an error of it
    return at_->punctuation != '.';
  }

  bool arguments(double* values, int count, int depth) {
    ++at_;
    if (at_->punctuation != '(') return false;
    ++at_;
    for (int i = 0; i < count; ++i) {
      if (!sum(values[i], depth + 1) || at_->punctuation != (i + 1 == count ? ')' : ',')) return false;
      ++at_;
    }
    return at_->punctuation != '.';
  }

  // What could be an error or a warning is left to the general path.
  bool call(double& out, int depth) {
    double v[2];
    switch (at_->word) {
      case Word::pi: out = std::numbers::pi; return (++at_)->punctuation != '.';
      case Word::clock: out = static_cast<double>(static_cast<float>(p_.options.clock)); return (++at_)->punctuation != '.';
      case Word::sin: return arguments(v, 1, depth) && (out = std::sin(v[0]), true);
      case Word::cos: return arguments(v, 1, depth) && (out = std::cos(v[0]), true);
      case Word::tan: return arguments(v, 1, depth) && (out = std::tan(v[0]), true);
      case Word::atan: return arguments(v, 1, depth) && (out = std::atan(v[0]), true);
      case Word::abs: return arguments(v, 1, depth) && (out = std::fabs(v[0]), true);
      case Word::exp: return arguments(v, 1, depth) && (out = std::exp(v[0]), true);
      case Word::floor: return arguments(v, 1, depth) && (out = std::floor(v[0]), true);
      case Word::ceil: return arguments(v, 1, depth) && (out = std::ceil(v[0]), true);
      case Word::int_: return arguments(v, 1, depth) && (out = to_int(v[0]), true);
      case Word::radians: return arguments(v, 1, depth) && (out = v[0] * (std::numbers::pi / 180), true);
      case Word::degrees: return arguments(v, 1, depth) && (out = v[0] / (std::numbers::pi / 180), true);
      case Word::sqrt: return arguments(v, 1, depth) && v[0] >= 0 && (out = std::sqrt(v[0]), true);
      case Word::ln: return arguments(v, 1, depth) && v[0] > 0 && (out = std::log(v[0]), true);
      case Word::mod: return arguments(v, 2, depth) && (out = std::fmod(v[0], v[1]), true);
      case Word::div: return arguments(v, 2, depth) && (out = to_int(v[0] / v[1]), true);
      case Word::pow: return arguments(v, 2, depth) && (v[0] != 0 || v[1] != 0) && (out = std::pow(v[0], v[1]), true);
      case Word::min: return arguments(v, 2, depth) && (out = v[1] < v[0] ? v[1] : v[0], true);
      case Word::max: return arguments(v, 2, depth) && (out = v[1] > v[0] ? v[1] : v[0], true);
      case Word::rand: {
        if (!arguments(v, 1, depth)) return false;
        const int stream = to_int(v[0]);
        if (stream < 0 || static_cast<std::size_t>(stream) >= p_.random_streams.size() || drawn_ == std::size(draws_)) return false;
        std::uint32_t& state = p_.random_streams[static_cast<std::size_t>(stream)];
        draws_[drawn_++] = {static_cast<std::uint32_t>(stream), state};
        state = 1812433253u * state + 12345u;
        out = state / 4294967295.0;
        return true;
      }
      default: return false;
    }
  }

  Parser::Impl& p_;
  const Token* at_;
  bool blocked_;
  struct Draw {
    std::uint32_t stream, state;
  };
  Draw draws_[8];
  std::size_t drawn_ = 0;
};

}  // namespace

bool Parser::Impl::scalar_fast(double& out) {
  if (language_version < 150) return false;
  Scanner scanner(*this, position);
  if (!scanner.scalar(out)) return false;
  position = scanner.at();
  ready = false;
  return true;
}

bool Parser::Impl::condition_fast(double& out) {
  if (language_version < 150) return false;
  Scanner scanner(*this, position);
  if (!scanner.condition(out)) return false;
  position = scanner.at();
  ready = false;
  return true;
}

// The expression ends before this token: no operator, component, directive or macro can continue it. A '>' closes a vector unless comparisons are allowed.
bool Parser::Impl::ends_expression(const Token& token, bool in_full_expression) const {
  switch (token.kind) {
    case TokenKind::punctuation:
      switch (token.punctuation) {
        case ',': case ';': case ')': case '}': case ']': case '{': return true;
        case '>': return !in_full_expression;
        default: return false;
      }
    case TokenKind::identifier: return blocked || !names[token.id()].symbol || !names[token.id()].symbol->is_macro;
    case TokenKind::word:
    case TokenKind::number:
    case TokenKind::vector:
    case TokenKind::string: return true;
    default: return false;
  }
}

bool Parser::Impl::literal_vector(std::size_t terms, double* out) {
  const Token& token = *position;
  if (token.kind != TokenKind::vector || token.terms() != terms || !ends_expression(position[1], false)) return false;
  const double* numbers = file->vector(token);
  for (std::size_t i = 0; i < terms; ++i) out[i] = numbers[i];
  skip_token();
  return true;
}

bool Parser::Impl::literal(bool in_full_expression, Numeric& out) {
  const Token& token = *position;
  if (token.kind == TokenKind::number) {
    if (!ends_expression(position[1], in_full_expression)) return false;
    out.v.fill(token.number());
    out.terms = 1;
  } else if (token.kind == TokenKind::vector) {
    if (!ends_expression(position[1], in_full_expression)) return false;
    out.terms = static_cast<int>(token.terms());
    const double* numbers = file->vector(token);
    for (std::size_t i = 0; i < token.terms(); ++i) out.v[i] = numbers[i];
  } else {
    return false;
  }
  skip_token();
  return true;
}

}  // namespace verisim::parser
