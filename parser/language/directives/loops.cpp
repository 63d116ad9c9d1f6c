// #while, #for and #break (spec 01 section 16). A pass of a loop is a jump back in the token array.
#include <cmath>

#include "parser/language/impl.h"

namespace verisim::parser {

using ConditionKind = Condition::Kind;

void Parser::Impl::while_directive(const Token&) {
  open_condition(ConditionKind::while_, index(position) - 1);
  conditions.back().test = index(position);
  const std::uint32_t link = (position - 1)->link();
  const TokenFile* in = file;
  if (condition_value()) return;
  skip_to_end(in, link);
  conditions.pop_back();
}

void Parser::Impl::test_while() {
  const TokenFile* in = file;
  const std::uint32_t behind = index(position);
  go_to(in, conditions.back().test);
  if (condition_value()) return;
  conditions.pop_back();
  if (file != in) error(Code::stray_branch, "#end of a loop is not in the file of its beginning.");
  go_to(in, behind);
}

void Parser::Impl::for_directive(const Token& token) {
  open_condition(ConditionKind::for_, index(position) - 1);
  const std::size_t open = conditions.size();
  const TokenFile* in = file;
  if (peek().punctuation != '(') expected("(");
  skip_token();
  const Token name = take_raw();
  if (name.kind != TokenKind::identifier) {
    --position;
    expected("identifier");
  }
  Symbol* symbol = names[name.id()].symbol;
  if (symbol && symbol->is_macro) error(Code::macro_arguments, "A macro cannot be the variable of #for.");
  if (!symbol || symbol->level != symbols.level()) symbol = &symbols.create(name.id(), symbols.level());
  if (std::holds_alternative<FunctionPtr>(symbol->value()) || peek().punctuation == '[')
    error(Code::unexpected_token, "The variable of #for must be a plain name.");
  Target target(symbols, symbol->variable);
  comma_operator();
  const double start = scalar();
  comma_operator();
  const double end = scalar();
  comma_operator();
  double step = 1;
  if (peek().punctuation != ')') step = scalar();
  if (peek().punctuation != ')') expected(")");
  skip_token();
  refuse_ended(open);
  if (std::fabs(step) < kEps) error(Code::bad_value, "The step of #for must not be zero.");
  target.value() = Numeric{{start}, 1};
  Condition& condition = conditions.back();
  condition.variable = name.id();
  condition.end = end;
  condition.step = step;
  condition.test = index(position);
  condition.file = file;
  if ((step > 0 && start < end + kEps) || (step < 0 && start > end - kEps)) return;
  skip_to_end(in, token.link());
  conditions.pop_back();
}

void Parser::Impl::end_for() {
  const Condition condition = conditions.back();
  Symbol* symbol = names[condition.variable].symbol;
  Numeric* value = nullptr;
  if (symbol && symbol->level == symbols.level() && !symbol->is_reference)
    value = std::get_if<Numeric>(&symbol->value());
  if (!value || value->terms != 1) error(Code::bad_value, "The variable of #for is no longer a float at #end.");
  value->v[0] += condition.step;
  const double now = value->v[0];
  if (condition.step > 0 ? now > condition.end + kEps : now < condition.end - kEps) {
    conditions.pop_back();
    return;
  }
  go_to(file, condition.test);
}

void Parser::Impl::break_directive() {
  for (; !conditions.empty(); conditions.pop_back()) {
    const Condition condition = conditions.back();
    if (condition.kind == ConditionKind::if_ || condition.kind == ConditionKind::else_) continue;
    // Include files between the construct and here end with it.
    while (frames.size() > condition.frames) leave_frame();
    if (condition.kind == ConditionKind::macro) return end_macro();
    const TokenFile* in = condition.file;
    if (file != in) error(Code::stray_branch, "#break is not in the file of its loop.");
    const std::uint32_t link = in->tokens[condition.opener].link();
    if (!link) unclosed_condition();
    skip_to_end(in, link);
    conditions.pop_back();
    return;
  }
  error(Code::stray_branch, "#break outside of a loop, a #switch and a macro.");
}

}  // namespace verisim::parser
