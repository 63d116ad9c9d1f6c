// Where the parser tries a scanner first, and literals, for which even that is too much.
#include "parser/language/scanner.h"

namespace verisim::parser {
namespace {

void store(const Term& term, Numeric& out) {
  out.terms = term.terms;
  out.v[0] = term.v[0];
  if (term.terms == 3) out.v[1] = term.v[1], out.v[2] = term.v[2];
}

}  // namespace

bool Parser::Impl::scalar_fast(double& out) {
  if (language_version < 150 || position == not_fast) return false;
  Scanner scanner(*this, position);
  Term term;
  if (!scanner.value(term, 1)) {
    not_fast = position;
    return false;
  }
  move_behind(scanner.at());
  out = term.v[0];
  return true;
}

bool Parser::Impl::vector_fast(Vec3& out) {
  if (language_version < 150 || position == not_fast) return false;
  Scanner scanner(*this, position);
  Term term;
  if (!scanner.value(term, 3)) {
    not_fast = position;
    return false;
  }
  move_behind(scanner.at());
  out = term.vector();
  return true;
}

bool Parser::Impl::additive_fast(int width, Numeric& out) {
  if (position == not_fast) return false;
  Scanner scanner(*this, position);
  Term term;
  if (!scanner.value(term, width > 3 ? 1 : 3)) {
    not_fast = position;
    return false;
  }
  move_behind(scanner.at());
  if (term.terms == 1) {
    out.terms = width;
    out.v.fill(term.v[0]);
  } else {
    store(term, out);
  }
  return true;
}

bool Parser::Impl::full_fast(Numeric& out) {
  if (language_version < 150) return false;
  Scanner scanner(*this, position);
  Term term;
  if (!scanner.full(term)) return false;
  move_behind(scanner.at());
  out.v.fill(term.v[0]);
  store(term, out);
  return true;
}

bool Parser::Impl::condition_fast(double& out) {
  if (language_version < 150) return false;
  Scanner scanner(*this, position);
  if (!scanner.condition(out)) return false;
  move_behind(scanner.at());
  return true;
}

// The form nearly all loops and macros consist of: an existing float or vector, or an element of an array of such, a
// value without side effects, a semicolon.
bool Parser::Impl::declare_fast(bool local) {
  const Token* const start = position;
  if (start->kind != TokenKind::identifier || language_version < 150 || options.recorder) return false;
  Symbol* symbol = names[start->id()].symbol;
  if (!symbol || symbol->is_macro || symbol->deprecation || (local && symbol->level != symbols.level())) return false;
  blocked = true;
  Scanner scanner(*this, start + 1);
  blocked = false;
  Value* target = &symbol->value();
  int terms = 0;  // that the value must have; 0: any number
  if (symbol->element_of) {
    terms = symbol->element_of->type - 100;
    if (terms <= 0) return false;
  }
  if (start[1].punctuation == '[') {
    const auto* array = std::get_if<std::shared_ptr<Array>>(target);
    if (!array || start[1].id() || (*array)->type <= 100) return false;
    terms = (*array)->type - 100;
    std::size_t element;
    if (!scanner.element(**array, element)) return false;
    target = &(*array)->elements.at(element);
  }
  if (!scanner.accept('=')) return false;
  const Token* const value_at = scanner.at();
  Numeric* numeric = std::get_if<Numeric>(target);
  Term term;
  if (!numeric || !scanner.value(term, 3) || (terms && terms != term.terms) || !scanner.accept(';')) {
    if (start[1].punctuation == '=') not_fast = value_at;
    return scanner.give_up();
  }
  store(term, *numeric);
  move_behind(scanner.at());
  if (position->punctuation == ';') skip_token();
  return true;
}

// The expression ends before this token: no operator, component, directive or macro can continue it. A '>' closes a
// vector unless comparisons are allowed.
bool Parser::Impl::ends_expression(const Token& token, bool in_full_expression) const {
  if (token.kind != TokenKind::punctuation) return begins_operand(token, blocked);
  switch (token.punctuation) {
    case ',':
    case ';':
    case ')':
    case '}':
    case ']':
    case '{':
      return true;
    case '>':
      return !in_full_expression;
    default:
      return false;
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
