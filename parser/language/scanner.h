// Reads runs of plain tokens: scalars and 3-vectors made of numbers, variables, arithmetic, calls of functions and of
// macros that are expressions.
//
// A scanner has no side effect before its caller moves the cursor (draws from random streams are undone) and gives up
// at the first thing it does not know, so that the general path can start again from the same token, and gives all
// messages. Values of 2, 4 and 5 terms are left to that, because how they are widened depends on the context.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "parser/language/impl.h"

namespace verisim::parser {

// Functions of one number that have a value everywhere; null: `word` is none of them.
double (*unary_function(Word word))(double);

// The state that follows in a random stream of seed() (32-bit linear congruential, spec 01 section 10).
constexpr std::uint32_t next_random(std::uint32_t state) { return 1812433253u * state + 12345u; }
inline double random_of(std::uint32_t state) { return state / 4294967295.0; }

// A scalar, in v[0], or a 3-vector.
struct Term {
  double v[3];
  int terms;
  void set(double x) { v[0] = x, terms = 1; }
  void set(const Vec3& a) { v[0] = a.x, v[1] = a.y, v[2] = a.z, terms = 3; }
  void widen() {
    if (terms == 1) v[1] = v[2] = v[0], terms = 3;
  }
  Vec3 vector() const { return terms == 1 ? Vec3(v[0]) : Vec3(v[0], v[1], v[2]); }
};

class Scanner {
 public:
  Scanner(Parser::Impl& impl, const Token* at) : p_(impl), at_(at), file_(impl.file), blocked_(impl.blocked) {}
  Scanner(const Scanner&) = delete;
  Scanner& operator=(const Scanner&) = delete;

  // An additive term whose end is certain, of at most so many terms.
  bool value(Term& out, int most_terms) { return (sum(out, 0) && out.terms <= most_terms && ends()) || give_up(); }
  // The same for a full expression.
  bool full(Term& out) { return (conditional(out, 0) && ends()) || give_up(); }

  // Everything inside "( ... )" of a condition.
  bool condition(double& out) {
    if (at_->punctuation != '(') return false;
    advance();
    Term term;
    if (!conditional(term, 0) || term.terms != 1 || !closes(')') || macros_) return give_up();
    out = term.v[0];
    return true;
  }

  bool element(const Array& array, std::size_t& index) { return subscripts(array, index, 0) || give_up(); }
  bool accept(char punctuation) {
    if (at_->punctuation != punctuation) return give_up();
    advance();
    return true;
  }
  const Token* at() const { return at_; }
  // False, as if nothing had been read.
  bool give_up() {
    while (macros_) leave_macro();
    while (drawn_) {
      --drawn_;
      p_.random_streams[draws_[drawn_].stream] = draws_[drawn_].state;
    }
    return false;
  }

 private:
  // The expression ends before this token: not when a directive, a macro or the end of the file could still continue
  // it, or a component follows.
  bool ends() const {
    if (macros_) return false;
    if (at_->kind == TokenKind::punctuation) return at_->punctuation != '.' && at_->punctuation != '[';
    return p_.begins_operand(*at_, blocked_);
  }

  [[gnu::always_inline]] void advance() {
    if (++at_ == end_) [[unlikely]]
      leave_ended_macros();
  }
  bool closes(char punctuation) {
    if (at_->punctuation != punctuation) return false;
    advance();
    return true;
  }

  static bool truth(double v) { return std::fabs(v) > kEps; }

  bool conditional(Term& out, int depth) {
    if (!operations<kLogical>(out, depth)) return false;
    if (at_->punctuation != '?') return true;
    if (depth >= kMaxDepth || out.terms != 1) return false;
    advance();
    Term yes, no;
    if (!conditional(yes, depth + 1) || at_->punctuation != ':') return false;
    advance();
    if (!conditional(no, depth + 1)) return false;
    out = truth(out.v[0]) ? yes : no;
    return true;
  }

  // How tightly operators of two sides bind; 0: the character is none.
  enum Precedence : std::uint8_t { kNone, kLogical, kRelation, kSum, kProduct };
  static Precedence precedence(char operation) {
    static constexpr auto kTable = [] {
      std::array<Precedence, 256> table{};
      for (const char c : {'&', '|'}) table[static_cast<unsigned char>(c)] = kLogical;
      for (const char c : {'<', '>', '=', kLessEqual, kGreaterEqual, kNotEqual})
        table[static_cast<unsigned char>(c)] = kRelation;
      for (const char c : {'+', '-'}) table[static_cast<unsigned char>(c)] = kSum;
      for (const char c : {'*', '/'}) table[static_cast<unsigned char>(c)] = kProduct;
      return table;
    }();
    return kTable[static_cast<unsigned char>(operation)];
  }

  // Operands with operators that bind at least as tightly as `loosest`, from left to right. A template, so that what
  // is between two operands of a loop's statement is one piece of code.
  template <Precedence loosest>
  [[gnu::always_inline]] bool operations(Term& out, int depth) {
    constexpr auto kTighter = static_cast<Precedence>(loosest + 1);
    if constexpr (loosest > kProduct) {
      return operand(out, depth);
    } else {
      if (!operations<kTighter>(out, depth)) return false;
      while (precedence(at_->punctuation) == loosest) {
        if (at_->kind == TokenKind::vector) return false;
        const char operation = at_->punctuation;
        advance();
        Term right;
        if (!operations<kTighter>(right, depth)) return false;
        if (!(out.terms + right.terms == 2 ? apply<loosest>(operation, out.v[0], right.v[0])
                                           : loosest >= kSum && apply_to_vectors<loosest>(operation, out, right)))
          return false;
      }
      return true;
    }
  }
  bool sum(Term& out, int depth) { return operations<kSum>(out, depth); }

  // a = a operation b, with an operation of that precedence. False: a division by zero.
  template <Precedence binds>
  static bool apply(char operation, double& a, double b) {
    if constexpr (binds == kProduct) {
      if (operation == '*') {
        a *= b;
      } else {
        if (b == 0) return false;
        a /= b;
      }
    } else if constexpr (binds == kSum) {
      a = operation == '+' ? a + b : a - b;
    } else if constexpr (binds == kLogical) {
      a = operation == '&' ? truth(a) && truth(b) : truth(a) || truth(b);
    } else {
      a = relation(operation, a, b);
    }
    return true;
  }
  static bool relation(char operation, double a, double b) {
    switch (operation) {
      case '<':
        return a < b;
      case '>':
        return a > b;
      case '=':
        return !truth(a - b);
      case kLessEqual:
        return a <= b || !truth(a - b);
      case kGreaterEqual:
        return a >= b || !truth(a - b);
      default:
        return truth(a - b);
    }
  }
  template <Precedence binds>
  static bool apply_to_vectors(char operation, Term& out, Term& right) {
    out.widen(), right.widen();
    return apply<binds>(operation, out.v[0], right.v[0]) && apply<binds>(operation, out.v[1], right.v[1]) &&
           apply<binds>(operation, out.v[2], right.v[2]);
  }

  bool scalar(double& out, int depth) {
    Term term;
    if (!sum(term, depth) || term.terms != 1) return false;
    out = term.v[0];
    return true;
  }

  // Numbers and floats at once; everything else is a factor.
  bool operand(Term& out, int depth) {
    if (at_->kind == TokenKind::number) {
      out.set(at_->number());
      advance();
      return at_->punctuation != '.';
    }
    if (at_->kind == TokenKind::identifier && at_[1].punctuation != '.') {
      const Symbol* symbol = p_.names[at_->id()].symbol;
      if (symbol && !symbol->element_of && !symbol->deprecation) {
        const auto* n = std::get_if<Numeric>(&symbol->variable->value);
        if (n && n->terms == 1) {
          out.set(n->v[0]);
          advance();
          return at_->punctuation != '.';
        }
      }
    }
    return factor(out, depth);
  }

  bool factor(Term& out, int depth) {
    switch (at_->kind) {
      case TokenKind::number:
        out.set(at_->number());
        advance();
        return at_->punctuation != '.';
      case TokenKind::identifier:
        return identifier(out, depth);
      case TokenKind::word:
        return depth < kMaxDepth && call(out, depth);
      case TokenKind::vector: {
        if (at_->terms() != 3) return false;
        const double* numbers = file_->vector(*at_);
        out.set(Vec3(numbers[0], numbers[1], numbers[2]));
        advance();
        return component(out);
      }
      case TokenKind::punctuation:
        if (depth >= kMaxDepth) return false;
        switch (at_->punctuation) {
          case '(':
            advance();
            if (!conditional(out, depth + 1) || at_->punctuation != ')') return false;
            advance();
            return component(out);
          case '<':
            return literal(out, depth + 1) && component(out);
          case '-':
            advance();
            if (!factor(out, depth + 1)) return false;
            for (int i = 0; i < out.terms; ++i) out.v[i] = -out.v[i];
            return true;
          case '+':
            advance();
            return factor(out, depth + 1);
          case '!':
            advance();
            if (!factor(out, depth + 1)) return false;
            for (int i = 0; i < out.terms; ++i) out.v[i] = !truth(out.v[i]);
            return true;
          default:
            return false;
        }
      default:
        return false;
    }
  }

  // < a, b, c >
  bool literal(Term& out, int depth) {
    advance();
    for (int i = 0; i < 3; ++i) {
      if (!scalar(out.v[i], depth) || at_->punctuation != (i == 2 ? '>' : ',')) return false;
      advance();
    }
    out.terms = 3;
    return true;
  }

  bool subscripts(const Array& array, std::size_t& element, int depth) {
    element = 0;
    for (const int size : array.sizes) {
      double subscript;
      if (at_->punctuation != '[' || at_->id()) return false;
      advance();
      if (!scalar(subscript, depth + 1) || at_->punctuation != ']') return false;
      advance();
      const int i = subscripted(subscript, size);
      if (i < 0) return false;
      element = element * static_cast<std::size_t>(size) + static_cast<std::size_t>(i);
    }
    return true;
  }

  // A float or vector, an element of an array of such, a component of a vector, a call of a float function or of a
  // macro that is an expression.
  bool identifier(Term& out, int depth);
  bool variable(const Numeric& n, Term& out) {
    if (n.terms == 1) {
      out.set(n.v[0]);
      advance();
      return at_->punctuation != '.';
    }
    if (n.terms == 5 && p_.language_version < 350) return false;  // a component of a colour declares a colour
    if (at_[1].punctuation == '.') {
      advance();
      return component(n.v.data(), n.terms, out);
    }
    if (n.terms != 3) return false;
    out.set(Vec3(n.v[0], n.v[1], n.v[2]));
    advance();
    return true;
  }

  // The component behind a value, if there is one.
  bool component(Term& out) {
    if (at_->punctuation != '.') return true;
    return out.terms == 3 && component(out.v, 3, out);
  }

  bool component(const double* v, int terms, Term& out) {
    if (at_[1].kind != TokenKind::word) return false;
    int index;
    switch (at_[1].word) {
      case Word::x:
      case Word::u:
      case Word::red:
        index = 0;
        break;
      case Word::y:
      case Word::v:
      case Word::green:
        index = 1;
        break;
      case Word::z:
      case Word::blue:
        index = 2;
        break;
      default:
        return false;
    }
    if (index >= terms) return false;
    out.set(v[index]);
    advance();
    advance();
    return at_->punctuation != '.';
  }

  bool user_call(const Function& function, Term& out, int depth);
  bool call(Term& out, int depth);
  bool macro(const Symbol& symbol, Term& out, int depth);
  void leave_macro();
  void leave_ended_macros();

  bool arguments(double* values, int count, int depth) {
    advance();
    if (at_->punctuation != '(') return false;
    advance();
    for (int i = 0; i < count; ++i) {
      if (!scalar(values[i], depth + 1) || at_->punctuation != (i + 1 == count ? ')' : ',')) return false;
      advance();
    }
    return at_->punctuation != '.';
  }

  bool arguments(Vec3* values, int count, int depth, double* last = nullptr) {
    advance();
    if (at_->punctuation != '(') return false;
    advance();
    for (int i = 0; i < count; ++i) {
      Term term;
      if (!sum(term, depth + 1) || at_->punctuation != (i + 1 == count && !last ? ')' : ',')) return false;
      values[i] = term.vector();
      advance();
    }
    if (!last) return true;
    if (!scalar(*last, depth + 1) || at_->punctuation != ')') return false;
    advance();
    return true;
  }

  bool constant(double value, Term& out) {
    out.set(value);
    advance();
    return at_->punctuation != '.';
  }
  bool vector(const Vec3& value, Term& out) {
    out.set(value);
    return component(out);
  }

  static constexpr int kMaxDepth = 32;
  static constexpr std::size_t kMaxMacros = 16;

  Parser::Impl& p_;
  const Token* at_;
  const TokenFile* file_;
  const Token* end_ = nullptr;  // of the macro that is being read
  bool blocked_;
  // Calls of macros under way.
  struct Call {
    const Token *behind, *end;
    const TokenFile* file;
  };
  Call calls_[kMaxMacros];
  std::size_t macros_ = 0;
  struct Draw {
    std::uint32_t stream, state;
  };
  Draw draws_[8];
  std::size_t drawn_ = 0;
};

}  // namespace verisim::parser
