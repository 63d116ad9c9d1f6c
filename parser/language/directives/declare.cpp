// #declare, #local, #undef and the values on their right-hand sides (spec 01 sections 5 to 7).
#include <fmt/format.h>

#include <functional>
#include <utility>

#include "parser/language/impl.h"
#include "parser/language/blocks.h"

namespace verisim::parser {
namespace {

void to_single_precision(Numeric& n) {
  for (double& v : n.v) v = static_cast<double>(static_cast<float>(v));
}

bool string_word(Word word) { return word_class(word) == WordClass::string_function; }

// `count` gets the number of elements of an array and of each array within it.
void each_array(const Array& array, const std::function<void(std::size_t)>& count) {
  count(array.elements.size());
  array.elements.for_each([&](const Value& element) {
    if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&element); inner && *inner) each_array(**inner, count);
  });
}

}  // namespace

void Parser::Impl::declare(bool local) {
  std::unique_ptr<Deprecation> deprecation;
  if (peek_blocked().word == Word::deprecated && peek_blocked().kind == TokenKind::word) {
    skip_token();
    deprecation = std::make_unique<Deprecation>();
    if (peek().word == Word::once) {
      skip_token();
      deprecation->once = true;
    }
    if (at_string()) deprecation->message = utf8(string(false));
  }
  const Spot name = next();
  std::optional<Target> target;
  Symbol* created = nullptr;
  declare_target(local, target, created);
  if (deprecation && created) {
    if (deprecation->message.empty())
      deprecation->message = fmt::format("Identifier '{}' was declared deprecated.", names[created->name].text);
    created->deprecation = std::move(deprecation);
  }
  const Token equals = take_raw();
  if (equals.punctuation != '=') {
    if (equals.kind != TokenKind::end) --position;
    expected("=");
  }
  Value value;
  const std::uint32_t outer = std::exchange(declaring, created ? created->name : 0);
  const bool layer = std::exchange(in_further_layer, false), operators = std::exchange(blocked, false);
  const Ending ending = right_hand_side(value);
  declaring = outer, in_further_layer = layer, blocked = operators;
  if (options.recorder) record(name, value);
  if (options.origins) name_object(name, value);
  if (target) assign(*target, std::move(value));
  if (peek_blocked().punctuation == ';') {
    skip_token();
    if (ending == Ending::free) return;
  } else if (ending == Ending::semicolon) {
    if (language_version >= 350) missing_semicolon();
    if (language_version >= 310)
      message_at(here(), Severity::possible_error, Code::missing_semicolon,
                 "A semicolon ';' is missing at the end of a #declare or #local.", {}, semicolon_behind(here()));
    return;
  }
  if (peek_blocked().punctuation == ';') skip_token();
}

Fix Parser::Impl::semicolon_behind(Spot value) {
  return {"put ';' behind the value", value.file->source->name(),
          value.token->offset + value.file->length(*value.token), 0, ";"};
}

void Parser::Impl::missing_semicolon() {
  const Spot at = here();
  Diagnostic d = diagnostic(
      Severity::error, Code::missing_semicolon,
      "Float, vector and colour declarations and identifiers of functions and splines need a semicolon ';' at the end.",
      "Put ';' behind the value.", at);
  d.fix = semicolon_behind(at);
  throw ParseError{std::move(d)};
}

// SDL's form of numbers and strings; of other values only what they are.
void Parser::Impl::record(Spot name, const Value& value) {
  if (name.token->kind != TokenKind::identifier) return;
  std::string text;
  if (const auto* n = std::get_if<Numeric>(&value)) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(n->terms); ++i)
      text += fmt::format("{}{:.6g}", i ? ", " : "", n->v[i]);
    if (n->terms > 1) text = "<" + text + ">";
  } else if (const auto* s = std::get_if<std::u16string>(&value)) {
    text = '"' + utf8(std::u16string_view(*s).substr(0, 100)) + '"';
  } else if (const auto* array = std::get_if<std::shared_ptr<Array>>(&value); array && *array) {
    for (const int size : (*array)->sizes) text += fmt::format("[{}]", size);
  }
  options.recorder->declared(name.file->source->name(), name.token->offset, names[name.token->id()].text,
                             kind_of(value), text);
}

void Parser::Impl::declare_target(bool local, std::optional<Target>& target, Symbol*& created) {
  const Token name = take_raw();
  if (name.kind != TokenKind::identifier) {
    if (name.kind == TokenKind::word)
      error(Code::reserved_word, fmt::format("'{}' is a reserved word: it cannot be declared.", spelling(name.word)));
    if (name.kind != TokenKind::end) --position;
    expected("identifier");
  }
  Symbol* symbol = names[name.id()].symbol;
  if (symbol && symbol->is_macro)
    error(Code::redeclared,
          fmt::format("'{}' is a macro: it cannot be declared as something else.", names[name.id()].text));
  if (at_subscript()) {
    if (!symbol) undeclared(name.id());
    const auto* held = std::get_if<std::shared_ptr<Array>>(&symbol->value());
    if (!held) error(Code::not_an_array, fmt::format("'{}' is not an array.", names[name.id()].text));
    std::shared_ptr<Array> array = *held;
    // An outer array is written by #local only while it has no type; else the value is lost (spec 01 section 5).
    const bool lost = local && symbol->level != symbols.level() && array->type != 0;
    std::size_t element = subscripts(*array);
    while (at_subscript() && std::holds_alternative<std::shared_ptr<Array>>(array->elements[element])) {
      array = std::get<std::shared_ptr<Array>>(array->elements[element]);
      element = subscripts(*array);
    }
    if (!lost) target.emplace(std::move(array), element);
    return;
  }
  if (symbol && (!local || symbol->level == symbols.level())) {
    check_deprecated(*symbol);
    if (symbol->element_of)
      target.emplace(symbol->element_of, symbol->element);
    else
      target.emplace(symbols, symbol->variable);
    return;
  }
  created = &symbols.create(name.id(), local ? symbols.level() : 0);
  target.emplace(symbols, created->variable);
}

bool Parser::Impl::starts_numeric(const Token& token) {
  switch (token.kind) {
    case TokenKind::number:
    case TokenKind::vector:
      return true;
    case TokenKind::punctuation:
      return token.punctuation == '(' || token.punctuation == '<' || token.punctuation == '+' ||
             token.punctuation == '-' || token.punctuation == '!';
    case TokenKind::word: {
      const WordClass c = word_class(token.word);
      return c == WordClass::float_function || c == WordClass::vector_function ||
             (c == WordClass::color && token.word != Word::filter);
    }
    case TokenKind::identifier: {
      const Symbol* symbol = names[token.id()].symbol;
      if (!symbol) return false;
      const Value* value = &const_cast<Symbol*>(symbol)->value();
      if (const auto* array = std::get_if<std::shared_ptr<Array>>(value)) {
        const int type = (*array)->type;
        if (type > 100) return &token == position && (&token)[1].punctuation == '[';
        if (type == 0) return false;
        value = peek_value();
      }
      return value && (std::holds_alternative<Numeric>(*value) || std::holds_alternative<FunctionPtr>(*value) ||
                       std::holds_alternative<Shared<Spline>>(*value));
    }
    default:
      return false;
  }
}

namespace {

// What begins with an identifier; `numeric` reads an expression.
template <class Read>
Parser::Impl::Ending identifier_value(Parser::Impl& p, const Token& token, Value& value, const Read& numeric) {
  const Value* held = p.peek_value();
  if (!held) p.undeclared(token.id());
  if (const auto* n = std::get_if<Numeric>(held)) {
    const bool color_first = n->terms == 5;
    // Before 1.5 only what begins with a color has operators without parentheses.
    p.depth_of_parentheses += color_first;
    const Parser::Impl::Ending ending = numeric();
    p.depth_of_parentheses -= color_first;
    if (p.language_version < 350 && color_first && std::get<Numeric>(value).terms == 1) {
      const double v = std::get<Numeric>(value).v[0];
      value = Numeric{{v, v, v, v, v}, 5};
    }
    return ending;
  }
  if (std::holds_alternative<std::u16string>(*held)) {
    value = p.string(false);
    return Parser::Impl::Ending::free;
  }
  if (std::holds_alternative<FunctionPtr>(*held) || std::holds_alternative<Shared<Spline>>(*held)) {
    const Token* behind = p.pending.at == p.position ? p.pending.behind : p.position + 1;
    if (behind->punctuation == '(') return numeric();
    p.copy_identifier(value);
    return Parser::Impl::Ending::semicolon;
  }
  p.copy_identifier(value);
  return Parser::Impl::Ending::free;
}

}  // namespace

Parser::Impl::Ending Parser::Impl::right_hand_side(Value& value) {
  const Token token = peek();
  const auto numeric = [&] {
    const Live operators(*this, true);
    Numeric n;
    additive(1, n);
    if (n.terms == 5) to_single_precision(n);
    value = n;
    return Ending::semicolon;
  };
  switch (token.kind) {
    case TokenKind::number:
    case TokenKind::vector:
    case TokenKind::punctuation:
      if (token.kind == TokenKind::punctuation && !starts_numeric(token))
        expected("float, vector, colour, string or a block");
      return numeric();
    case TokenKind::string:
      value = string(false);
      return Ending::free;
    case TokenKind::identifier:
      return identifier_value(*this, token, value, numeric);
    case TokenKind::word: {
      const WordClass c = word_class(token.word);
      if (token.word == Word::t)
        error(Code::unexpected_token, "A value cannot begin with 't' here.", "Write (t) or 1*t.");
      if (c == WordClass::color) {
        const Live operators(*this, true);
        Numeric n = color();
        to_single_precision(n);
        n.terms = 5;
        value = n;
        return Ending::semicolon;
      }
      if (c == WordClass::float_function || c == WordClass::vector_function) return numeric();
      if (string_word(token.word)) {
        value = string(false);
        return Ending::free;
      }
      if (token.word == Word::function) {
        skip_token();
        value = function();
        return Ending::free;
      }
      if (token.word == Word::spline) {
        skip_token();
        value = spline();
        return Ending::free;
      }
      if (token.word == Word::array) {
        skip_token();
        value = array();
        return Ending::free;
      }
      std::optional<Value> block = parse_block_value(parser);
      if (!block) expected("a value for the identifier");
      value = std::move(*block);
      return Ending::free;
    }
    default:
      expected("a value for the identifier");
  }
}

// The identifier at the cursor as a whole: arrays are copied, other values are immutable and shared.
void Parser::Impl::copy_identifier(Value& value) {
  const Token token = peek();
  const Resolved source = resolve();
  const Value& held = source.value();
  if (held.index() == 0) error(Code::no_value, fmt::format("'{}' has no value.", names[token.id()].text));
  if (std::holds_alternative<std::shared_ptr<FileHandle>>(held))
    error(Code::wrong_type, "A file identifier cannot be used as a value.");
  if (const auto* array = std::get_if<std::shared_ptr<Array>>(&held)) {
    // An array of two copies of itself, sixty times: what is copied is work like any other.
    each_array(**array, [this](std::size_t elements) { count_steps(elements); });
    value = deep_copy(**array);
  } else {
    value = held;
  }
}

void Parser::Impl::check_type(const Target& target, const Value& value) {
  if (target.is_element()) {
    const Array& array = *target.array();
    if (array.type && array.type != type_key(value))
      error(Code::array_type, "All elements of an array have the same type; this value has another.");
    if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&value);
        inner && (*inner)->nesting >= options.limits.max_depth)
      error(Code::nesting_limit, "Arrays of arrays are nested too deeply.", "--max-depth raises this limit.");
  }
  const Value& old = const_cast<Target&>(target).value();
  if (std::holds_alternative<FunctionPtr>(old))
    error(Code::redeclared, "A function cannot be declared again.", "#undef it first.");
  if (std::holds_alternative<FunctionPtr>(value) && old.index() != 0)
    error(Code::redeclared, "An identifier that has a value cannot become a function.", "#undef it first.");
}

void Parser::Impl::assign(Target& target, Value&& value) {
  check_type(target, value);
  if (target.is_element()) {
    Array& array = *target.array();
    array.type = type_key(value);
    if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&value))
      array.nesting = std::max(array.nesting, (*inner)->nesting + 1);
  }
  Value& place = target.value();
  if (auto* from = std::get_if<Numeric>(&value)) {
    if (auto* to = std::get_if<Numeric>(&place)) {
      *to = *from;
      return;
    }
  }
  // The old value dies after the new one is in place: it may own what the new one was made from.
  const Value old = std::exchange(place, std::move(value));
}

void Parser::Impl::undef() {
  const Token name = take_raw();
  if (name.kind == TokenKind::word)
    error(Code::reserved_word, fmt::format("'{}' is a reserved word.", spelling(name.word)));
  if (name.kind != TokenKind::identifier) {
    if (name.kind != TokenKind::end) --position;
    expected("identifier");
  }
  Symbol* symbol = names[name.id()].symbol;
  if (!symbol) {
    message(Severity::warning, Code::unknown_undef,
            fmt::format("Attempt to undef unknown identifier '{}'.", names[name.id()].text));
    return;
  }
  check_deprecated(*symbol);
  if (!at_subscript()) {
    symbols.remove(name.id());
    return;
  }
  const auto* held = std::get_if<std::shared_ptr<Array>>(&symbol->value());
  if (!held) error(Code::not_an_array, fmt::format("'{}' is not an array.", names[name.id()].text));
  std::shared_ptr<Array> array = *held;
  std::size_t element = subscripts(*array);
  while (at_subscript() && std::holds_alternative<std::shared_ptr<Array>>(array->elements[element])) {
    array = std::get<std::shared_ptr<Array>>(array->elements[element]);
    element = subscripts(*array);
  }
  array->elements.at(element) = std::monostate{};
}

}  // namespace verisim::parser
