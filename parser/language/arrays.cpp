// array[..]{..}, subscripts, and identifiers with their subscripts (spec 01 section 13).
#include <fmt/format.h>

#include "parser/language/impl.h"

namespace verisim::parser {

// Blanks, but no comment, may stand between the name and '['. Only the token as written counts: to look further could
// end the macro whose local the name is.
bool Parser::Impl::at_subscript() { return position->punctuation == '[' && position->id() == 0; }

std::shared_ptr<Array> Parser::Impl::array() {
  auto result = std::make_shared<Array>();
  double product = 1;
  if (peek().punctuation != '[') expected("[");
  while (peek_blocked().punctuation == '[') {
    skip_token();
    const Live live(*this);
    const int size = to_int(scalar() + kEps);
    if (peek().punctuation != ']') expected("]");
    skip_token();
    if (size < 1) error(Code::array_size, "The size of an array must be at least 1.");
    if (result->sizes.size() == kMaxDimensions) error(Code::array_size, "An array has at most 5 dimensions.");
    result->sizes.push_back(size);
    product *= size;
  }
  if (product * sizeof(Value) > static_cast<double>(options.limits.max_memory_bytes))
    error(Code::size_limit, "The array needs more memory than --max-memory allows.");
  result->elements.set_size(static_cast<std::size_t>(product));
  if (peek_blocked().punctuation == '{') {
    std::size_t element = 0;
    initialise(*result, 0, element);
  }
  return result;
}

void Parser::Impl::initialise(Array& array, std::size_t dimension, std::size_t& element) {
  const Nesting nesting(*this);
  if (peek_blocked().punctuation != '{') expected("{");
  skip_token();
  for (int i = 0; i < array.sizes[dimension]; ++i) {
    if (dimension + 1 < array.sizes.size()) {
      initialise(array, dimension + 1, element);
    } else {
      // A directive or a macro name cannot begin an element (spec 01 section 4, B5).
      const Token& token = peek_blocked();
      if (token.kind == TokenKind::directive)
        error(Code::misplaced_directive, "A directive cannot stand here.", "Put the value in parentheses.");
      if (token.kind == TokenKind::identifier)
        if (const Symbol* symbol = names[token.id()].symbol; symbol && symbol->is_macro)
          error(Code::misplaced_directive, fmt::format("Macro '{}' cannot be called here.", names[token.id()].text),
                "Put the call in parentheses.");
      if (token.punctuation == '}')
        error(Code::array_size, fmt::format("Too few values in the array initialiser: {} expected, {} found.",
                                            array.sizes[dimension], i));
      Value value;
      right_hand_side(value);
      store_element(array, element++, std::move(value));
    }
    if (peek_blocked().punctuation == ',') skip_token();
  }
  if (peek_blocked().punctuation != '}')
    error(Code::array_size, "Too many values in the array initialiser, or a missing '}'.");
  skip_token();
}

void Parser::Impl::store_element(Array& array, std::size_t element, Value&& value) {
  const int type = type_key(value);
  if (array.type && array.type != type)
    error(Code::array_type, "All elements of an array have the same type; this value has another.");
  array.type = type;
  if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&value)) {
    array.nesting = std::max(array.nesting, (*inner)->nesting + 1);
    if (array.nesting >= options.limits.max_depth)
      error(Code::nesting_limit, "Arrays of arrays are nested too deeply.", "--max-depth raises this limit.");
  }
  array.elements.at(element) = std::move(value);
}

// All subscripts of one array; returns the index of the element.
std::size_t Parser::Impl::subscripts(const Array& array) {
  std::size_t element = 0;
  for (const int size : array.sizes) {
    if (peek_blocked().punctuation != '[') expected("[");
    skip_token();
    const Live live(*this);
    const double value = scalar();
    if (peek().punctuation != ']') expected("]");
    const int i = subscripted(value, size);
    if (i < 0) error(Code::subscript_range, fmt::format("Array subscript out of range: {} of {}.", value, size));
    skip_token();
    element = element * static_cast<std::size_t>(size) + static_cast<std::size_t>(i);
  }
  return element;
}

Parser::Impl::Resolved Parser::Impl::resolve() {
  if (pending.at && pending.at == position) {
    Resolved resolved = std::move(pending.resolved);
    position = pending.behind;
    ready = false;
    pending = {};
    return resolved;
  }
  const std::uint32_t name = position->id();
  Symbol* symbol = names[name].symbol;
  if (!symbol) undeclared(name);
  check_deprecated(*symbol);
  skip_token();
  Resolved resolved = Resolved::named(*symbol);
  while (std::holds_alternative<std::shared_ptr<Array>>(resolved.value()) && at_subscript()) {
    std::shared_ptr<Array> array = std::get<std::shared_ptr<Array>>(resolved.value());
    resolved.element = subscripts(*array);
    resolved.array = std::move(array);
    if (resolved.value().index() == 0)
      error(Code::no_value, fmt::format("This element of array '{}' has no value yet.", names[name].text));
  }
  return resolved;
}

const Value* Parser::Impl::peek_value() {
  const Token& token = peek();
  if (token.kind != TokenKind::identifier) return nullptr;
  if (pending.at != position) {
    Symbol* symbol = names[token.id()].symbol;
    if (!symbol) return nullptr;
    if (!std::holds_alternative<std::shared_ptr<Array>>(symbol->value())) return &symbol->value();
    const Token* at = position;
    const TokenFile* in = file;
    Resolved resolved = resolve();
    if (file != in) error(Code::array_size, "An array reference must end in the file in which it begins.");
    pending.resolved = std::move(resolved);
    pending.behind = position;
    pending.at = position = at;
    ready = true;
  }
  return &pending.resolved.value();
}

// ---- The public face ----

const Value* Parser::peek_value() { return impl_->stopped() ? nullptr : impl_->peek_value(); }

const Value& Parser::take_value() {
  Impl& impl = *impl_;
  const Token& token = impl.peek();
  if (token.kind != TokenKind::identifier) error_expected("identifier");
  Value& slot = impl.handed_out[impl.next_handed_out++ % impl.handed_out.size()];
  slot = impl.resolve().value();
  return slot;
}

}  // namespace verisim::parser
