// The parts of a scanner that are not on the way of every token: names, calls of functions and macros.
#include "parser/language/scanner.h"

#include <numbers>

namespace verisim::parser {

bool Scanner::identifier(Term& out, int depth) {
  Symbol* symbol = p_.names[at_->id()].symbol;
  if (!symbol || symbol->deprecation) return false;
  const Value* value = &symbol->value();
  if (const auto* n = std::get_if<Numeric>(value)) return variable(*n, out);
  if (depth >= kMaxDepth) return false;
  if (symbol->is_macro) return macro(*symbol, out, depth);
  if (const auto* array = std::get_if<std::shared_ptr<Array>>(value)) {
    std::size_t element;
    advance();
    if (!subscripts(**array, element, depth)) return false;
    const auto* n = std::get_if<Numeric>(&(*array)->elements[element]);
    if (!n || (n->terms == 5 && p_.language_version < 350)) return false;
    if (at_->punctuation == '.') return n->terms > 1 && component(n->v.data(), n->terms, out);
    if (n->terms == 1)
      out.set(n->v[0]);
    else if (n->terms == 3)
      out.set(Vec3(n->v[0], n->v[1], n->v[2]));
    else
      return false;
    return true;
  }
  if (const auto* function = std::get_if<FunctionPtr>(value)) {
    advance();
    return user_call(**function, out, depth);
  }
  return false;
}

bool Scanner::user_call(const Function& function, Term& out, int depth) {
  const int count = function.parameters();
  if (function.components() != 1 || count > 8 || at_->punctuation != '(') return false;
  advance();
  double values[8];
  for (int i = 0; i < count; ++i) {
    if (!scalar(values[i], depth + 1)) return false;
    if (at_->punctuation != (i + 1 == count ? ')' : ',')) return false;
    advance();
  }
  double result;
  {
    functions::EvaluationBudget budget;
    budget.open();
    function.evaluate({values, static_cast<std::size_t>(count)}, &result);
    if (budget.spent()) p_.look_at_clock();
  }
  // The general path makes errors of these.
  if (functions::EvaluationBudget::take_overrun() || textures::MissingSurface::take()) return false;
  out.set(result);
  return at_->punctuation != '.';
}

// The tokens of its body stand in the place of the call (spec 01 section 15): the expression around the call goes on
// with them, and behind their end.
bool Scanner::macro(const Symbol& symbol, Term& out, int depth) {
  const Macro& macro = *std::get<Shared<Macro>>(symbol.variable->value);
  const std::size_t count = macro.parameters.size();
  constexpr std::size_t kMaxParameters = 8;
  if (p_.language_version < Macro::kSince) return false;  // the general path makes an error of it
  if (!macro.is_expression || count > kMaxParameters || macros_ == kMaxMacros || at_[1].punctuation != '(')
    return false;
  advance();
  advance();
  struct {
    Variable* variable = nullptr;
    Term value;
  } given[kMaxParameters];
  const bool outer = std::exchange(blocked_, true);
  for (std::size_t i = 0; i < count; ++i) {
    if (at_->kind == TokenKind::identifier && (at_[1].punctuation == ',' || at_[1].punctuation == ')')) {
      const Symbol* argument = p_.names[at_->id()].symbol;
      if (!argument || argument->element_of || argument->deprecation ||
          !std::holds_alternative<Numeric>(argument->variable->value))
        return false;
      given[i].variable = argument->variable;
      advance();
    } else if (!sum(given[i].value, depth + 1)) {
      return false;
    }
    if (i + 1 < count && !closes(',')) return false;
  }
  blocked_ = outer;
  // The closing bracket is behind the arguments of the same file, else the call ends in another macro than it began.
  if (at_->punctuation != ')' || at_ + 1 == end_) return false;
  const Token* const behind = at_ + 1;
  p_.symbols.push();
  for (std::size_t i = 0; i < count; ++i) {
    Variable* variable = given[i].variable;
    if (!variable) {
      variable = p_.symbols.new_variable();
      const Term& value = given[i].value;
      variable->value = value.terms == 1 ? Numeric{{value.v[0]}, 1} : Numeric{{value.v[0], value.v[1], value.v[2]}, 3};
    }
    Symbol& parameter = p_.symbols.bind(macro.parameters[i], p_.symbols.level(), variable);
    parameter.is_parameter = true;
    parameter.is_reference = given[i].variable != nullptr;
  }
  calls_[macros_++] = {behind, end_, file_};
  file_ = macro.file.get();
  at_ = file_->tokens.data() + macro.body;
  end_ = file_->tokens.data() + macro.end;
  p_.count_steps(macro.end - macro.body);
  return factor(out, depth + 1);
}

void Scanner::leave_macro() {
  const Call& call = calls_[--macros_];
  end_ = call.end;
  file_ = call.file;
  p_.symbols.pop();
}

void Scanner::leave_ended_macros() {
  while (at_ == end_) {
    at_ = calls_[macros_ - 1].behind;
    leave_macro();
  }
}

// What could be an error or a warning is left to the general path.
bool Scanner::call(Term& out, int depth) {
  out.terms = 1;
  double& r = out.v[0];
  double v[2];
  Vec3 a[2];
  switch (at_->word) {
    case Word::x:
      advance();
      return vector({1, 0, 0}, out);
    case Word::y:
      advance();
      return vector({0, 1, 0}, out);
    case Word::z:
      advance();
      return vector({0, 0, 1}, out);
    case Word::pi:
      return constant(std::numbers::pi, out);
    case Word::clock:
      return constant(static_cast<double>(static_cast<float>(p_.options.clock)), out);
    case Word::true_:
    case Word::yes:
    case Word::on:
      return constant(1, out);
    case Word::false_:
    case Word::no:
    case Word::off:
      return constant(0, out);
    case Word::sqrt:
      return arguments(v, 1, depth) && v[0] >= 0 && (r = std::sqrt(v[0]), true);
    case Word::ln:
      return arguments(v, 1, depth) && v[0] > 0 && (r = std::log(v[0]), true);
    case Word::log:
      return arguments(v, 1, depth) && v[0] > 0 && (r = std::log10(v[0]), true);
    case Word::asin:
      return arguments(v, 1, depth) && v[0] >= -1 && v[0] <= 1 && (r = std::asin(v[0]), true);
    case Word::acos:
      return arguments(v, 1, depth) && v[0] >= -1 && v[0] <= 1 && (r = std::acos(v[0]), true);
    case Word::atan2:
      return arguments(v, 2, depth) && (std::fabs(v[0]) > kEps || std::fabs(v[1]) > kEps) &&
             (r = std::atan2(v[0], v[1]), true);
    case Word::mod:
      return arguments(v, 2, depth) && (r = std::fmod(v[0], v[1]), true);
    case Word::div:
      return arguments(v, 2, depth) && (r = to_int(v[0] / v[1]), true);
    case Word::pow:
      return arguments(v, 2, depth) && (v[0] != 0 || v[1] != 0) && (r = std::pow(v[0], v[1]), true);
    case Word::min:
      return arguments(v, 2, depth) && (r = v[1] < v[0] ? v[1] : v[0], true);
    case Word::max:
      return arguments(v, 2, depth) && (r = v[1] > v[0] ? v[1] : v[0], true);
    case Word::vlength:
      return arguments(a, 1, depth) && (r = length(a[0]), at_->punctuation != '.');
    case Word::vdot:
      return arguments(a, 2, depth) && (r = dot(a[0], a[1]), at_->punctuation != '.');
    case Word::vcross:
      return arguments(a, 2, depth) && vector(cross(a[0], a[1]), out);
    case Word::vnormalize:
      return arguments(a, 1, depth) && a[0] != Vec3(0, 0, 0) && vector(normalize(a[0]), out);
    case Word::vrotate:
      return arguments(a, 2, depth) && vector(Transform::rotation(a[1]).point(a[0]), out);
    case Word::vaxis_rotate:
      return arguments(a, 2, depth, v) &&
             vector(Transform::axis_rotation(a[1], v[0] * (std::numbers::pi / 180)).point(a[0]), out);
    case Word::rand: {
      if (!arguments(v, 1, depth)) return false;
      const int stream = to_int(v[0]);
      if (stream < 0 || static_cast<std::size_t>(stream) >= p_.random_streams.size() || drawn_ == std::size(draws_))
        return false;
      std::uint32_t& state = p_.random_streams[static_cast<std::size_t>(stream)];
      draws_[drawn_++] = {static_cast<std::uint32_t>(stream), state};
      state = next_random(state);
      r = random_of(state);
      return true;
    }
    default: {
      const auto function = unary_function(at_->word);
      return function && arguments(v, 1, depth) && (r = function(v[0]), true);
    }
  }
}

}  // namespace verisim::parser
