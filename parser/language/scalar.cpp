// Fast paths over runs of plain tokens: scalars made of numbers, float variables and arithmetic, and vectors of literal numbers.
//
// They read tokens without any side effect and give up at the first thing they do not know, so the general path can start again from the same token.
#include <utility>

#include "parser/language/impl.h"

namespace verisim::parser {
namespace {

constexpr int kMaxDepth = 32;

class Scanner {
 public:
  Scanner(const Token* at, Names& names, bool blocked) : at_(at), names_(names), blocked_(blocked) {}

  bool sum(double& out, int depth) {
    if (!product(out, depth)) return false;
    for (;;) {
      const char operation = at_->punctuation;
      if (operation != '+' && operation != '-') return ends();
      ++at_;
      double right;
      if (!product(right, depth)) return false;
      out = operation == '+' ? out + right : out - right;
    }
  }
  const Token* at() const { return at_; }

 private:
  // The expression ends before this token: not when a directive, a macro or the end of the file could still continue it, or a component follows.
  bool ends() const {
    switch (at_->kind) {
      case TokenKind::punctuation: return at_->punctuation != '.' && at_->punctuation != '[';
      case TokenKind::identifier:
        return blocked_ || !names_[at_->id()].symbol || !names_[at_->id()].symbol->is_macro;
      case TokenKind::word:
      case TokenKind::number:
      case TokenKind::string: return true;
      default: return false;
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
      case TokenKind::identifier: {
        Symbol* symbol = names_[at_->id()].symbol;
        if (!symbol || symbol->is_macro || symbol->deprecation) return false;
        const auto* value = std::get_if<Numeric>(&symbol->value());
        if (!value || value->terms != 1) return false;
        out = value->v[0];
        ++at_;
        return at_->punctuation != '.';
      }
      case TokenKind::punctuation:
        if (depth >= kMaxDepth) return false;
        switch (at_->punctuation) {
          case '(': {
            ++at_;
            const bool blocked = std::exchange(blocked_, false);
            if (!sum(out, depth + 1) || at_->punctuation != ')') return false;
            blocked_ = blocked;
            ++at_;
            return at_->punctuation != '.';
          }
          case '-':
            ++at_;
            if (!factor(out, depth + 1)) return false;
            out = -out;
            return true;
          case '+':
            ++at_;
            return factor(out, depth + 1);
          default:
            return false;
        }
      default:
        return false;
    }
  }

  const Token* at_;
  Names& names_;
  bool blocked_;
};

}  // namespace

bool Parser::Impl::scalar_fast(double& out) {
  if (language_version < 150) return false;
  Scanner scanner(position, names, blocked);
  if (!scanner.sum(out, 0)) return false;
  position = scanner.at();
  ready = false;
  return true;
}

bool Parser::Impl::literal_vector(Vec3& out) {
  const Token* at = position;
  if (at->punctuation != '<') return false;
  ++at;
  double v[3];
  for (int i = 0; i < 3; ++i) {
    const bool negative = at->punctuation == '-';
    if (negative) ++at;
    if (at->kind != TokenKind::number) return false;
    v[i] = negative ? -at->number() : at->number();
    ++at;
    if (at->punctuation != (i == 2 ? '>' : ',')) return false;
    ++at;
  }
  // What could continue the expression: an operator, a component, a directive, a macro.
  switch (at->kind) {
    case TokenKind::punctuation:
      if (at->punctuation == '+' || at->punctuation == '-' || at->punctuation == '*' || at->punctuation == '/' || at->punctuation == '.') return false;
      break;
    case TokenKind::identifier:
    case TokenKind::directive:
    case TokenKind::end:
    case TokenKind::error: return false;
    default: break;
  }
  position = at;
  ready = false;
  out = {v[0], v[1], v[2]};
  return true;
}

}  // namespace verisim::parser
