// From tokens of a user function to the tree of tracer/functions/expression.h (spec 01 section 23).
//
// The expression language differs from that of scene code: no vectors, no '?:', '&' binds tighter than '|', and
// comparisons need no parentheses.
#pragma once

#include <initializer_list>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/language/impl.h"
#include "tracer/functions/expression.h"

namespace verisim::parser {

class Recursive;  // a function that calls itself

class FunctionParser {
 public:
  // `self`: the name under which the function may call itself; 0: none.
  FunctionParser(Parser::Impl& impl, std::uint32_t self) : p_(impl), self_(self) {}

  void parameters();
  FunctionPtr body();
  int count() const { return count_; }
  bool default_parameters() const { return default_; }

 private:
  struct Variable {
    std::uint32_t name;
    int slot;
  };
  using Level = functions::Node (FunctionParser::*)();

  functions::Node logic_or() { return chain<&FunctionParser::logic_and>({{'|', functions::Op::logic_or}}); }
  functions::Node logic_and() { return chain<&FunctionParser::comparison>({{'&', functions::Op::logic_and}}); }
  functions::Node comparison() {
    return chain<&FunctionParser::sum>({{'<', functions::Op::less},
                                        {kLessEqual, functions::Op::less_equal},
                                        {'=', functions::Op::equal},
                                        {kNotEqual, functions::Op::not_equal},
                                        {kGreaterEqual, functions::Op::greater_equal},
                                        {'>', functions::Op::greater}});
  }
  functions::Node sum() {
    return chain<&FunctionParser::product>({{'+', functions::Op::add}, {'-', functions::Op::subtract}});
  }
  functions::Node product() {
    return chain<&FunctionParser::sign>({{'*', functions::Op::multiply}, {'/', functions::Op::divide}});
  }
  template <Level next>
  functions::Node chain(std::initializer_list<std::pair<char, functions::Op>> operators);
  functions::Node sign();
  functions::Node primary();
  functions::Node word_primary(Word word);
  functions::Node identifier_primary();
  functions::Node user_call(const FunctionPtr& function);
  functions::Node loop(bool product);
  functions::Node variable(std::uint32_t name) const;
  std::vector<functions::Node> arguments(int expected, std::string_view name);
  void open();
  void close();
  // Commas are optional in a parameter list, but not in expressions.
  void separator() {
    if (p_.peek().punctuation != ',') p_.expected(",");
    p_.skip_token();
  }

  Parser::Impl& p_;
  std::uint32_t self_;
  std::vector<Variable> variables_;
  int count_ = 0, slots_ = 0;
  bool default_ = false;
  std::shared_ptr<Recursive> recursive_;  // not null: the body calls the function that is being declared
};

}  // namespace verisim::parser
