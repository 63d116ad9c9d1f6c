// #macro and calls (spec 01 section 15). A call binds its arguments and moves the cursor to the body's tokens; #end
// brings it back.
#include <fmt/format.h>

#include "parser/language/impl.h"

namespace verisim::parser {

namespace {

bool looks_like_expression(const TokenFile& file, std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t kLongest = 64;
  if (begin == end || end - begin > kLongest) return false;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Token& token = file.tokens[i];
    const bool plain = token.kind == TokenKind::number || token.kind == TokenKind::identifier ||
                       token.kind == TokenKind::vector ||
                       (token.kind == TokenKind::word && word_class(token.word) != WordClass::keyword) ||
                       (token.kind == TokenKind::punctuation && token.punctuation != '{' && token.punctuation != '}' &&
                        token.punctuation != ';');
    if (!plain) return false;
  }
  return true;
}

}  // namespace

void require_macros(Parser::Impl& parser) {
  if (parser.language_version < Macro::kSince)
    parser.error(Code::version_limits, "Macros need #version 3.1 or later.",
                 "The version also counts where macros of include files are called, and where they end.");
}

// An identifier; of a reserved word it says that it cannot be `what`.
Token Parser::Impl::take_own_name(const char* what) {
  const Token name = take_raw();
  if (name.kind == TokenKind::identifier) return name;
  if (name.kind == TokenKind::word)
    error(Code::reserved_word, fmt::format("'{}' is a reserved word: it cannot be {}.", spelling(name.word), what));
  if (name.kind != TokenKind::end) --position;
  expected("identifier");
}

void Parser::Impl::define_macro(const Token& token) {
  require_macros(*this);
  auto macro = std::make_shared<Macro>();
  macro->file = file->shared_from_this();
  macro->definition = index(position) - 1;
  const Token name = take_own_name("the name of a macro");
  macro->name = name.id();
  Symbol* symbol = names[name.id()].symbol;
  if (symbol && !symbol->is_macro && !symbol->is_parameter)
    error(Code::redeclared,
          fmt::format("'{}' is declared as something else: it cannot become a macro.", names[name.id()].text));
  while (symbol && symbol->level > 0) symbol = symbol->below;
  if (peek_blocked().punctuation != '(') expected("(");
  skip_token();
  while (peek_blocked().punctuation != ')') {
    macro->parameters.push_back(take_own_name("a parameter").id());
    if (peek_blocked().punctuation == ',') skip_token();
  }
  skip_token();
  if (file != macro->file.get() || !token.link()) {
    if (!file->tokens.empty() && file->tokens.back().kind == TokenKind::error) {
      position = &file->tokens.back();
      lex_error(*position);
    }
    error_at({macro->file.get(), &macro->file->tokens[macro->definition]}, Code::unclosed_condition,
             fmt::format("Macro '{}' has no #end: the file ends first.", names[macro->name].text));
  }
  refuse_strays(index(position), token.link());
  macro->body = index(position);
  macro->end = token.link();
  macro->is_expression = looks_like_expression(*file, macro->body, macro->end);
  go_to(file, token.link() + 1);
  if (!symbol) symbol = &symbols.create(name.id(), 0);
  symbol->is_macro = true;
  symbol->value() = Shared<Macro>(std::move(macro));
}

// POV-Ray takes the reference from the token behind a lone number: where the comma is missing, as in M(p q), both
// arguments become q.
void Parser::Impl::refer_to_follower(Resolved& resolved) const {
  if (position->kind != TokenKind::identifier || position[1].punctuation == '[') return;
  Symbol* symbol = names[position->id()].symbol;
  if (symbol && !symbol->is_macro) resolved = Resolved::named(*symbol);
}

// By reference: a lone identifier, with subscripts or without, that is no function. By value: everything else.
void Parser::Impl::macro_argument() {
  const Token& token = peek();
  Argument argument;
  if (token.kind == TokenKind::identifier && (position[1].punctuation == ',' || position[1].punctuation == ')') &&
      pending.at != position) {
    // A plain variable.
    Symbol* symbol = names[token.id()].symbol;
    if (symbol && !symbol->element_of && !symbol->deprecation &&
        std::holds_alternative<Numeric>(symbol->variable->value)) {
      argument.variable = symbol->variable;
      ++argument.variable->uses;
      skip_token();
      arguments.push_back(std::move(argument));
      return;
    }
  }
  if (token.kind == TokenKind::identifier) {
    const Value* held = peek_value();
    if (!held) undeclared(token.id());
    const Token* behind = pending.at == position ? pending.behind : position + 1;
    const char c = behind->punctuation;
    const bool lone = behind->kind != TokenKind::end && behind->kind != TokenKind::directive && c != '+' && c != '-' &&
                      c != '*' && c != '/' && c != '.' && c != '(' && !std::holds_alternative<FunctionPtr>(*held);
    if (lone) {
      if (held->index() == 0) error(Code::no_value, fmt::format("'{}' has no value.", names[token.id()].text));
      const bool number = std::holds_alternative<Numeric>(*held);
      Resolved resolved = resolve();
      if (number) refer_to_follower(resolved);
      argument.array = std::move(resolved.array);
      argument.element = resolved.element;
      if (!argument.array) {
        argument.variable = resolved.variable;
        ++argument.variable->uses;
      }
      arguments.push_back(std::move(argument));
      return;
    }
  }
  right_hand_side(argument.value);
  arguments.push_back(std::move(argument));
}

void Parser::Impl::call_macro(Symbol& symbol) {
  require_macros(*this);
  if (!depth) mark_statement();
  const Nesting nesting(*this);
  if (static_cast<int>(frames.size()) >= options.limits.max_depth)
    fatal(Code::nesting_limit, "Too many nested macro calls.", "--max-depth raises this limit.");
  const Shared<Macro> macro = std::get<Shared<Macro>>(symbol.value());
  const TokenFile* in = file;
  const std::uint32_t call = index(position);
  // Arguments of calls that an error cut short are dropped with the parser.
  const std::size_t first = arguments.size();
  skip_token();
  {
    const Live live(*this);
    if (peek().punctuation != '(')
      error_at({in, in->tokens.data() + call}, Code::macro_arguments,
               fmt::format("Macro '{}' is called without parentheses.", names[macro->name].text),
               "A call without arguments is written with empty ones: NAME().");
    skip_token();
    for (std::size_t i = 0; i < macro->parameters.size(); ++i) {
      if (peek().punctuation == ')')
        error(Code::macro_arguments, fmt::format("Macro '{}' needs {} arguments, {} found.", names[macro->name].text,
                                                 macro->parameters.size(), i));
      macro_argument();
      if (peek().punctuation == ',') skip_token();
    }
    if (peek().punctuation != ')')
      error(Code::macro_arguments, fmt::format("Expected ')' behind the {} arguments of macro '{}', {} found instead.",
                                               macro->parameters.size(), names[macro->name].text, describe(*position)));
    skip_token();
  }
  Frame frame;
  frame.macro = macro;
  frame.file = file;
  frame.position = index(position);
  frame.call = file == in ? call : frame.position;
  frames.push_back(std::move(frame));
  symbols.push();
  for (std::size_t i = 0; i < macro->parameters.size(); ++i) {
    Argument& argument = arguments[first + i];
    Variable* variable = argument.variable ? argument.variable : symbols.new_variable();
    Symbol& parameter = symbols.bind(macro->parameters[i], symbols.level(), variable);
    parameter.is_parameter = true;
    parameter.is_reference = argument.variable || argument.array;
    if (argument.variable) {
      --variable->uses;  // the binding holds it now
    } else if (argument.array) {
      parameter.element_of = std::move(argument.array);
      parameter.element = argument.element;
    } else {
      variable->value = std::move(argument.value);
    }
  }
  arguments.resize(first);
  count_steps(macro->end - macro->body);
  go_to(macro->file.get(), macro->body);
  open_condition(Condition::Kind::macro, macro->definition);
}

}  // namespace verisim::parser
