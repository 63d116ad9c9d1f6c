#include "parser/language/symbols.h"

#include "parser/language/array.h"
#include "parser/language/file_handle.h"
#include "parser/language/macro.h"

namespace verisim::parser {

int type_key(const Value& value) {
  if (const auto* numeric = std::get_if<Numeric>(&value)) return 100 + numeric->terms;
  return static_cast<int>(value.index());
}

std::shared_ptr<Array> deep_copy(const Array& array) {
  auto copy = std::make_shared<Array>(array);
  for (std::size_t i = 0; copy->nesting > 1 && i < copy->elements.size(); ++i)
    if (const auto* inner = std::get_if<std::shared_ptr<Array>>(&copy->elements[i]); inner && *inner)
      copy->elements.at(i) = deep_copy(**inner);
  return copy;
}

Value& Symbol::value() { return element_of ? element_of->elements.at(element) : variable->value; }

Value& Target::value() { return array_ ? array_->elements.at(element_) : variable_->value; }

SymbolTables::~SymbolTables() = default;

Variable* SymbolTables::new_variable() {
  if (free_variables_.empty()) return &variables_.emplace_back();
  Variable* variable = free_variables_.back();
  free_variables_.pop_back();
  return variable;
}

void SymbolTables::release(Variable* variable) {
  if (--variable->uses) return;
  if (variable->value.index() > 1)
    variable->value = std::monostate{};
  else
    variable->value.emplace<std::monostate>();
  free_variables_.push_back(variable);
}

Symbol& SymbolTables::bind(std::uint32_t name, int level, Variable* variable) {
  Symbol* symbol;
  if (free_symbols_.empty()) {
    symbol = &symbols_.emplace_back();
  } else {
    symbol = free_symbols_.back();
    free_symbols_.pop_back();
  }
  symbol->name = name;
  symbol->level = level;
  symbol->variable = variable;
  ++variable->uses;
  Symbol** at = &names_[name].symbol;
  while (*at && (*at)->level > level) at = &(*at)->below;
  symbol->below = *at;
  *at = symbol;
  if (level) open_.push_back(symbol);
  return *symbol;
}

void SymbolTables::unlink(Symbol& symbol) {
  Symbol** at = &names_[symbol.name].symbol;
  while (*at != &symbol) at = &(*at)->below;
  *at = symbol.below;
  symbol.name = 0;
}

void SymbolTables::free(Symbol& symbol) {
  release(symbol.variable);
  symbol.variable = nullptr;
  symbol.element_of.reset();
  symbol.deprecation.reset();
  symbol.is_macro = symbol.is_parameter = symbol.is_reference = false;
  free_symbols_.push_back(&symbol);
}

void SymbolTables::remove(std::uint32_t name) {
  Symbol* symbol = names_[name].symbol;
  if (!symbol) return;
  unlink(*symbol);
  if (symbol->level == 0) free(*symbol);  // others are freed with their table, which still lists them
}

void SymbolTables::pop() {
  for (std::size_t i = open_.size(); i-- > marks_.back();) {
    Symbol* symbol = open_[i];
    if (symbol->name) unlink(*symbol);
    free(*symbol);
  }
  open_.resize(marks_.back());
  marks_.pop_back();
}

}  // namespace verisim::parser
