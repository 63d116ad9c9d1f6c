// Directives: the dispatch and the conditionals (spec 01 sections 4 and 16).
#include <cmath>

#include "parser/language/impl.h"
#include "parser/language/blocks.h"
#include "parser/lexer/directive_links.h"

namespace verisim::parser {

using ConditionKind = Condition::Kind;

void Parser::Impl::directive() {
  if (!depth) mark_statement();
  const Token token = *position;
  skip_token();
  // Nearly all of what loops and macros execute.
  if ((token.word == Word::declare || token.word == Word::local) && declare_fast(token.word == Word::local)) return;
  if (token.word == Word::end && !conditions.empty() && conditions.back().kind == ConditionKind::macro &&
      conditions.back().frames == frames.size())
    return end_macro();
  const Nesting nesting(*this);
  const Live live(*this);
  execute(token);
}

namespace {

// False: the word is none.
bool file_directive(Parser::Impl& p, Word word) {
  switch (word) {
    case Word::fopen:
      p.fopen();
      return true;
    case Word::fclose:
      p.fclose();
      return true;
    case Word::read:
      p.read();
      return true;
    case Word::write:
      p.write();
      return true;
    default:
      return false;
  }
}

}  // namespace

void Parser::Impl::execute(const Token& token) {
  const TokenFile* in = file;
  const std::uint32_t link = token.link();
  switch (token.word) {
    case Word::if_: {
      open_condition(ConditionKind::if_, index(position) - 1);
      if_chain(condition_value(), in, link);
      break;
    }
    case Word::ifdef:
    case Word::ifndef: {
      open_condition(ConditionKind::if_, index(position) - 1);
      const std::size_t open = conditions.size();
      const bool defined = defined_argument();
      refuse_ended(open);
      if_chain(defined == (token.word == Word::ifdef), in, link);
      break;
    }
    case Word::else_:
    case Word::elseif:
      else_branch(token);
      break;
    case Word::end:
      end_directive(token);
      break;
    case Word::switch_:
      switch_directive(token);
      break;
    case Word::case_:
    case Word::range:
      if (conditions.empty() ||
          (conditions.back().kind != ConditionKind::switch_ && conditions.back().kind != ConditionKind::switch_else))
        stray_branch(token.word);
      case_matches(token.word, 0);  // evaluated, but a case that ran goes on (spec 01 section 16)
      break;
    case Word::while_:
      while_directive(token);
      break;
    case Word::for_:
      for_directive(token);
      break;
    case Word::break_:
      break_directive();
      break;
    case Word::macro:
      define_macro(token);
      break;
    case Word::declare:
      declare(false);
      break;
    case Word::local:
      declare(true);
      break;
    case Word::undef:
      undef();
      break;
    case Word::include:
      include();
      break;
    case Word::default_:
      parse_default(parser);
      break;
    case Word::version:
      version_directive();
      break;
    case Word::debug:
    case Word::warning:
    case Word::error:
    case Word::render:
    case Word::statistics:
      text_directive(token.word);
      break;
    default:
      if (!file_directive(*this, token.word)) error(Code::unknown_directive, "Unknown directive.");
  }
}

void Parser::Impl::open_condition(ConditionKind kind, std::uint32_t opener) {
  if (conditions.size() >= static_cast<std::size_t>(options.limits.max_depth))
    fatal(Code::nesting_limit, "Conditionals, loops and macro calls are nested too deeply.",
          "--max-depth raises this limit.");
  Condition condition{};
  condition.kind = kind;
  condition.file = file;
  condition.opener = opener;
  condition.frames = frames.size();
  conditions.push_back(condition);
}

// Finds the next #else, #elseif, #case, #range or #end of the construct that is open here. A link found while the file
// was tokenised is a jump; otherwise the pair spans files and the text is searched, leaving include files at their end.
Token Parser::Impl::skip(const TokenFile* in, std::uint32_t link) {
  if (link && file == in) {
    refuse_strays(index(position), link);
    go_to(in, link);
    const Token token = *position;
    skip_token();
    return token;
  }
  ready = false;
  for (int nested = 0;; ++position) {
    count_steps(1);
    while (position->kind == TokenKind::end)
      if (!end_of_file()) unclosed_condition();
    if (position->kind == TokenKind::error) lex_error(*position);
    if (position->kind != TokenKind::directive) continue;
    if (opens_construct(position->word)) {
      ++nested;
      continue;
    }
    switch (position->word) {
      case Word::else_:
      case Word::elseif:
      case Word::case_:
      case Word::range:
        if (!nested) return *position++;
        break;
      case Word::end:
        if (!nested--) return *position++;
        break;
      default:
        break;
    }
  }
}

void Parser::Impl::skip_to_end(const TokenFile* in, std::uint32_t link) {
  Token token = skip(in, link);
  while (token.word != Word::end) token = skip(file, token.link());
}

// What stands in a directive's parentheses may be directives, too, but not those that end it (`open`: how many
// constructs were open before).
void Parser::Impl::refuse_ended(std::size_t open) {
  if (conditions.size() < open) error(Code::stray_branch, "A directive inside parentheses ends what these belong to.");
}

bool Parser::Impl::condition_value() {
  if (double value; condition_fast(value)) return std::fabs(value) > kEps;
  const std::size_t open = conditions.size();
  const Live operators(*this, true);
  if (!accept_operator('(')) expected("(");
  Numeric value;
  full(value);
  if (value.terms > 1) error(Code::wrong_terms, "Expected a float in the condition, but a vector or colour was found.");
  expect_operator(')');
  refuse_ended(open);
  return std::fabs(value.v[0]) > kEps;
}

// The condition of #if or #elseif is known; `link` is that directive's.
void Parser::Impl::if_chain(bool taken, const TokenFile* in, std::uint32_t link) {
  while (!taken) {
    const Token token = skip(in, link);
    in = file;
    link = token.link();
    if (token.word == Word::end) {
      conditions.pop_back();
      return;
    }
    if (token.word == Word::else_) {
      conditions.back().kind = ConditionKind::else_;
      return;
    }
    if (token.word != Word::elseif) stray_branch(token.word);
    taken = condition_value();
  }
}

void Parser::Impl::else_branch(const Token& token) {
  if (conditions.empty()) stray_branch(token.word);
  switch (conditions.back().kind) {
    case ConditionKind::if_:
      skip_to_end(file, token.link());
      conditions.pop_back();
      break;
    case ConditionKind::switch_:
      if (token.word == Word::elseif) stray_branch(token.word);
      conditions.back().kind = ConditionKind::switch_else;  // falls through into it
      break;
    case ConditionKind::switch_else:
      if (token.word == Word::elseif) stray_branch(token.word);  // a further #else changes nothing (measured)
      break;
    default:
      stray_branch(token.word);
  }
}

void Parser::Impl::stray_branch(Word word) {
  error(Code::stray_branch, word == Word::else_    ? "#else without #if."
                            : word == Word::elseif ? "#elseif without #if."
                                                   : "#case or #range without #switch.");
}

// Macros between two tokens of this file, which are read or passed over.
void Parser::Impl::refuse_strays(std::uint32_t begin, std::uint32_t end) {
  for (const std::uint32_t stray : file->stray_branches)
    if (begin <= stray && stray < end) {
      go_to(file, stray + 1);
      stray_branch(file->tokens[stray].word);
    }
}

void Parser::Impl::end_directive(const Token&) {
  if (conditions.empty()) error(Code::stray_branch, "#end without #if, #while, #for, #switch or #macro.");
  Condition& condition = conditions.back();
  switch (condition.kind) {
    case ConditionKind::while_:
    case ConditionKind::for_:
      if (condition.file != file || condition.frames != frames.size())
        error(Code::stray_branch, "#end of a loop is not in the file of its beginning.");
      count_steps(index(position) - condition.test);
      if (condition.kind == ConditionKind::while_)
        test_while();
      else
        end_for();
      break;
    case ConditionKind::macro:
      if (frames.size() != condition.frames)
        error(Code::stray_branch, "#end of a macro is not in the file of its beginning.");
      end_macro();
      break;
    default:
      conditions.pop_back();
  }
}

void Parser::Impl::end_macro() {
  require_macros(*this);
  conditions.pop_back();
  leave_frame();
}

void Parser::Impl::switch_directive(const Token&) {
  open_condition(ConditionKind::switch_, index(position) - 1);
  const std::size_t open = conditions.size();
  double value;
  {
    const Live operators(*this, true);
    if (!accept_operator('(')) expected("(");
    value = full_scalar();
    expect_operator(')');
  }
  refuse_ended(open);
  const Token& first = peek_blocked();
  if (first.kind != TokenKind::directive || (first.word != Word::case_ && first.word != Word::range))
    expected("#case or #range");
  Token branch = first;
  skip_token();
  for (;;) {
    if (branch.word == Word::end) {
      conditions.pop_back();
      return;
    }
    if (branch.word == Word::else_) {
      conditions.back().kind = ConditionKind::switch_else;
      return;
    }
    if (branch.word == Word::elseif) stray_branch(branch.word);
    const TokenFile* at = file;
    if ((branch.word == Word::case_ || branch.word == Word::range) && case_matches(branch.word, value)) return;
    branch = skip(at, branch.link());
  }
}

bool Parser::Impl::case_matches(Word word, double value) {
  const std::size_t open = conditions.size();
  const Live operators(*this, true);
  if (!accept_operator('(')) expected("(");
  const double low = full_scalar();
  if (word == Word::case_) {
    expect_operator(')');
    refuse_ended(open);
    return std::fabs(value - low) < kEps;
  }
  comma_operator();
  const double high = full_scalar();
  expect_operator(')');
  refuse_ended(open);
  return low <= value && value <= high;
}

// One token in parentheses, with subscripts when it names an array (spec 01 section 5).
bool Parser::Impl::defined_argument() {
  if (take_raw().punctuation != '(') error(Code::unexpected_token, "Expected '(' before the name.");
  const Token token = take_raw();
  bool defined = false;
  if (token.kind == TokenKind::identifier) {
    Symbol* symbol = names[token.id()].symbol;
    defined = symbol != nullptr;
    if (symbol && !symbol->is_macro && at_subscript()) {
      const std::shared_ptr<Array>* array = std::get_if<std::shared_ptr<Array>>(&symbol->value());
      if (!array) error(Code::not_an_array, "Subscripts behind a name that is not an array.");
      const std::shared_ptr<Array> held = *array;
      std::size_t element = subscripts(*held);
      const Value* value = &held->elements[element];
      std::shared_ptr<Array> inner;
      while (at_subscript() && std::holds_alternative<std::shared_ptr<Array>>(*value)) {
        inner = std::get<std::shared_ptr<Array>>(*value);
        value = &inner->elements[subscripts(*inner)];
      }
      defined = value->index() != 0;
    }
  } else if (token.kind == TokenKind::string) {
    const std::uint32_t name = names.find(utf8(decode(token, false)));
    defined = name && names[name].symbol;
  } else if (token.kind != TokenKind::word && token.kind != TokenKind::number) {
    error(Code::unexpected_token, "Expected a name.");
  }
  if (peek_blocked().punctuation != ')') expected(")");
  skip_token();
  return defined;
}

}  // namespace verisim::parser
