// Symbols of SDL: a dynamic stack of tables, one for the main file, one more for every active include and macro call
// (spec 01 section 5).
//
// Each name keeps the list of its symbols, newest first, so a look-up is one array access; a table is only the list of
// what must be removed at its end.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "parser/language/value.h"
#include "parser/lexer/names.h"

namespace verisim::parser {

// What an identifier holds. By-reference parameters share the caller's variable.
struct Variable {
  Value value;
  std::uint32_t uses = 0;
};

struct Deprecation {
  std::string message;
  bool once = false, warned = false;
};

struct Symbol {
  std::uint32_t name = 0;  // 0: removed by #undef while its table is still open
  int level = 0;           // of the table
  Variable* variable = nullptr;
  std::shared_ptr<Array> element_of;  // a parameter bound to an array element
  std::size_t element = 0;
  Symbol* below = nullptr;  // the next older symbol of this name
  bool is_macro = false, is_parameter = false, is_reference = false;
  std::unique_ptr<Deprecation> deprecation;

  Value& value();
};

class SymbolTables {
 public:
  explicit SymbolTables(Names& names) : names_(names) {}
  ~SymbolTables();

  int level() const { return static_cast<int>(marks_.size()); }
  void push() { marks_.push_back(open_.size()); }
  void pop();

  Symbol* find(std::uint32_t name) { return names_[name].symbol; }
  // Adds an empty symbol to the table of `level` (0 or the current one), hiding or hidden by others of its name by
  // level.
  Symbol& create(std::uint32_t name, int level) { return bind(name, level, new_variable()); }
  Symbol& bind(std::uint32_t name, int level, Variable* variable);
  // Removes the newest symbol of this name.
  void remove(std::uint32_t name);

  Variable* new_variable();
  void release(Variable* variable);

 private:
  void unlink(Symbol& symbol);
  void free(Symbol& symbol);

  Names& names_;
  std::deque<Symbol> symbols_;
  std::deque<Variable> variables_;
  std::vector<Symbol*> free_symbols_;
  std::vector<Variable*> free_variables_;
  std::vector<Symbol*> open_;       // symbols of all tables above the main one, oldest first
  std::vector<std::size_t> marks_;  // where each of them starts
};

// Where #declare writes: a variable or an array element, kept alive while the value is read.
class Target {
 public:
  Target(SymbolTables& tables, Variable* variable) : tables_(&tables), variable_(variable) { ++variable_->uses; }
  Target(std::shared_ptr<Array> array, std::size_t element) : array_(std::move(array)), element_(element) {}
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  ~Target() {
    if (variable_) tables_->release(variable_);
  }
  bool is_element() const { return array_ != nullptr; }
  const std::shared_ptr<Array>& array() const { return array_; }
  std::size_t element() const { return element_; }
  Value& value();

 private:
  SymbolTables* tables_ = nullptr;
  Variable* variable_ = nullptr;
  std::shared_ptr<Array> array_;
  std::size_t element_ = 0;
};

}  // namespace verisim::parser
