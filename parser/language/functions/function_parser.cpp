#include "parser/language/functions/function_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace verisim::parser {

using namespace functions;

// A function that calls itself. POV-Ray calls that unsupported and lets it be; it crashes when the calls do not end,
// here the value is then NaN.
class Recursive : public Function {
 public:
  explicit Recursive(int parameters) : parameters_(parameters) {}
  void set(FunctionPtr program) { program_ = std::move(program); }
  int parameters() const override { return parameters_; }
  int components() const override { return 1; }
  void evaluate(std::span<const double> arguments, double* result) const override {
    constexpr int kMaxNested = 1000, kMaxCalls = 10'000'000;
    static thread_local int nested = 0, calls = 0;
    if (!nested) calls = 0;
    if (!program_ || nested >= kMaxNested || ++calls > kMaxCalls) {
      *result = std::numeric_limits<double>::quiet_NaN();
      return;
    }
    ++nested;
    program_->evaluate(arguments, result);
    --nested;
  }

 private:
  int parameters_;
  FunctionPtr program_;
};

namespace {

// Parameters and loop variables in scope. Reserved names (x, u ...) and identifiers share one key space.
std::uint32_t key(Word word) { return static_cast<std::uint32_t>(word); }
std::uint32_t key(std::uint32_t identifier) { return 0x10000u + identifier; }

// How a recursive function sees itself: without owning itself.
class SelfCall : public Function {
 public:
  explicit SelfCall(const Recursive& target) : target_(target) {}
  int parameters() const override { return target_.parameters(); }
  int components() const override { return 1; }
  void evaluate(std::span<const double> arguments, double* result) const override {
    target_.evaluate(arguments, result);
  }

 private:
  const Recursive& target_;
};

struct BuiltinEntry {
  Word word;
  Builtin builtin;
  int arguments;  // -1: two or more; -2: three or four
};

constexpr BuiltinEntry kBuiltins[] = {
    {Word::abs, Builtin::abs_, 1},     {Word::acos, Builtin::acos_, 1},       {Word::acosh, Builtin::acosh_, 1},
    {Word::asin, Builtin::asin_, 1},   {Word::asinh, Builtin::asinh_, 1},     {Word::atan, Builtin::atan_, 1},
    {Word::atan2, Builtin::atan2_, 2}, {Word::atanh, Builtin::atanh_, 1},     {Word::ceil, Builtin::ceil_, 1},
    {Word::cos, Builtin::cos_, 1},     {Word::cosh, Builtin::cosh_, 1},       {Word::degrees, Builtin::degrees_, 1},
    {Word::div, Builtin::div_, 2},     {Word::exp, Builtin::exp_, 1},         {Word::floor, Builtin::floor_, 1},
    {Word::int_, Builtin::int_, 1},    {Word::ln, Builtin::ln_, 1},           {Word::log, Builtin::log_, 1},
    {Word::max, Builtin::max_, -1},    {Word::min, Builtin::min_, -1},        {Word::mod, Builtin::mod_, 2},
    {Word::pow, Builtin::pow_, 2},     {Word::radians, Builtin::radians_, 1}, {Word::select, Builtin::select_, -2},
    {Word::sin, Builtin::sin_, 1},     {Word::sinh, Builtin::sinh_, 1},       {Word::sqrt, Builtin::sqrt_, 1},
    {Word::tan, Builtin::tan_, 1},     {Word::tanh, Builtin::tanh_, 1},
};
}  // namespace

void FunctionParser::open() {
  if (p_.peek().punctuation != '(') p_.expected("(");
  p_.skip_token();
}

void FunctionParser::close() {
  if (p_.peek().punctuation != ')') p_.expected(")");
  p_.skip_token();
}

// x and u are one slot, y and v another; the later one in the list wins.
void FunctionParser::parameters() {
  const auto add = [this](std::uint32_t name) { variables_.push_back({name, count_}); };
  const auto add_word = [&](Word word) {
    add(key(word));
    if (word == Word::x) add(key(Word::u));
    if (word == Word::u) add(key(Word::x));
    if (word == Word::y) add(key(Word::v));
    if (word == Word::v) add(key(Word::y));
  };
  if (p_.peek().punctuation == '(') {
    p_.skip_token();
    while (p_.peek().punctuation != ')') {
      const Token token = p_.peek();
      if (count_ == kMaxFunctionParameters)
        p_.error(Code::function_syntax, fmt::format("A function has at most {} parameters.", kMaxFunctionParameters));
      if (token.kind == TokenKind::identifier) {
        if (p_.names[token.id()].symbol)
          p_.error(Code::redeclared, fmt::format("'{}' is declared: it cannot be the name of a function's parameter.",
                                                 p_.names[token.id()].text));
        add(key(token.id()));
      } else if (token.kind == TokenKind::word &&
                 (token.word == Word::x || token.word == Word::y || token.word == Word::z || token.word == Word::u ||
                  token.word == Word::v)) {
        add_word(token.word);
      } else {
        p_.expected("parameter name");
      }
      p_.skip_token();
      ++count_;
      if (p_.peek().punctuation == ',') p_.skip_token();
    }
    if (count_ == 0) p_.expected("parameter name");
    p_.skip_token();
  } else {
    default_ = true;
    for (const Word word : {Word::x, Word::y, Word::z}) {
      add_word(word);
      ++count_;
    }
  }
  slots_ = count_;
}

FunctionPtr FunctionParser::body() {
  const Node root = logic_or();
  try {
    FunctionPtr program = compile(root, count_, slots_);
    if (!recursive_) return program;
    recursive_->set(std::move(program));
    return recursive_;
  } catch (const std::invalid_argument& e) {
    p_.error(Code::function_syntax, e.what());
  }
}

template <FunctionParser::Level next>
Node FunctionParser::chain(std::initializer_list<std::pair<char, Op>> operators) {
  Node first = (this->*next)();
  const auto find = [&] {
    const char c = p_.peek().punctuation;
    return c ? std::find_if(operators.begin(), operators.end(), [c](const auto& o) { return o.first == c; })
             : operators.end();
  };
  auto operation = find();
  if (operation == operators.end()) return first;
  Chain result;
  result.operands.push_back(std::move(first));
  for (; operation != operators.end(); operation = find()) {
    p_.skip_token();
    result.operators.push_back(operation->second);
    result.operands.push_back((this->*next)());
  }
  return {std::move(result), false};
}

// One sign at most.
Node FunctionParser::sign() {
  const char c = p_.peek().punctuation;
  if (c != '-' && c != '+') return primary();
  p_.skip_token();
  Node operand = primary();
  if (c == '+') return operand;
  Negate negate;
  negate.operand.push_back(std::move(operand));
  return {std::move(negate), false};
}

Node FunctionParser::variable(std::uint32_t name) const {
  const auto found =
      std::find_if(variables_.rbegin(), variables_.rend(), [name](const Variable& v) { return v.name == name; });
  if (found == variables_.rend()) return {Zero{}, false};
  return {Parameter{found->slot}, false};
}

Node FunctionParser::primary() {
  const Token token = p_.peek();
  switch (token.kind) {
    case TokenKind::number:
      p_.skip_token();
      return {Constant{token.number()}, false};
    case TokenKind::identifier:
      return identifier_primary();
    case TokenKind::word:
      return word_primary(token.word);
    case TokenKind::punctuation:
      if (token.punctuation == '(') {
        const Nesting nesting(p_);
        p_.skip_token();
        Node inner = logic_or();
        close();
        inner.parenthesised = true;
        return inner;
      }
      [[fallthrough]];
    default:
      p_.expected("function expression");
  }
}

std::vector<Node> FunctionParser::arguments(int expected, std::string_view name) {
  const Nesting nesting(p_);
  std::vector<Node> result;
  open();
  while (p_.peek().punctuation != ')') {
    if (static_cast<int>(result.size()) == expected)
      p_.error(Code::function_arguments, fmt::format("Too many arguments: '{}' has {}.", name, expected));
    result.push_back(logic_or());
    if (p_.peek().punctuation == ')') break;
    separator();
    if (p_.peek().punctuation == ')') p_.expected("function expression");
  }
  if (expected >= 0 && static_cast<int>(result.size()) != expected)
    p_.error(Code::function_arguments,
             fmt::format("'{}' needs {} arguments, {} found.", name, expected, result.size()));
  p_.skip_token();
  return result;
}

Node FunctionParser::word_primary(Word word) {
  switch (word) {
    case Word::x:
    case Word::y:
    case Word::z:
    case Word::u:
    case Word::v:
      p_.skip_token();
      return variable(key(word));
    case Word::pi:
      p_.skip_token();
      return {Constant{std::numbers::pi}, false};
    case Word::clock:
      p_.skip_token();
      return {Constant{static_cast<double>(static_cast<float>(p_.options.clock))}, false};
    case Word::sum:
    case Word::prod:
      p_.skip_token();
      return loop(word == Word::prod);
    default:
      break;
  }
  const auto* entry = std::find_if(std::begin(kBuiltins), std::end(kBuiltins),
                                   [word](const BuiltinEntry& b) { return b.word == word; });
  if (entry == std::end(kBuiltins)) p_.expected("function expression");
  p_.skip_token();
  BuiltinCall call{entry->builtin, arguments(entry->arguments, spelling(word))};
  const std::size_t count = call.arguments.size();
  if (entry->arguments == -1 && count < 2)
    p_.error(Code::function_arguments, fmt::format("'{}' needs at least 2 arguments in a function.", spelling(word)));
  if (entry->builtin == Builtin::pow_) {
    const auto* power = std::get_if<Constant>(&call.arguments[1].value);
    if (power && !call.arguments[1].parenthesised && power->value == 0)
      p_.message(Severity::warning, Code::no_effect, "Zero power optimised to constant 1.0!");
  }
  if (entry->arguments == -2 && count != 3 && count != 4)
    p_.error(Code::function_arguments, "'select' needs 3 or 4 arguments.");
  return {std::move(call), false};
}

// sum(i, first, last, body): i is a new name.
Node FunctionParser::loop(bool product) {
  const Nesting nesting(p_);
  open();
  const Token name = p_.peek();
  const bool letter =
      name.kind == TokenKind::word && (name.word == Word::x || name.word == Word::y || name.word == Word::z ||
                                       name.word == Word::u || name.word == Word::v);
  if (!letter && (name.kind != TokenKind::identifier || p_.names[name.id()].symbol))
    p_.expected("a new name for the loop variable");
  p_.skip_token();
  separator();
  Loop result;
  result.product = product;
  result.parts.push_back(logic_or());
  separator();
  result.parts.push_back(logic_or());
  separator();
  result.variable = slots_++;
  variables_.push_back({letter ? key(name.word) : key(name.id()), result.variable});
  result.parts.push_back(logic_or());
  variables_.pop_back();
  close();
  return {std::move(result), false};
}

Node FunctionParser::identifier_primary() {
  const Token token = p_.peek();
  const std::uint32_t name = key(token.id());
  if (std::any_of(variables_.begin(), variables_.end(), [name](const Variable& v) { return v.name == name; })) {
    p_.skip_token();
    return variable(name);
  }
  const Value* value = p_.peek_value();
  if (!value) p_.undeclared(token.id());
  if (value->index() == 0 && token.id() == self_) {
    if (!recursive_) {
      recursive_ = std::make_shared<Recursive>(count_);
      p_.message(Severity::possible_error, Code::function_syntax,
                 "Recursive function calls are not supported by POV-Ray, which does not check them.");
    }
    p_.resolve();
    return user_call(std::make_shared<SelfCall>(*recursive_));
  }
  if (const auto* function = std::get_if<FunctionPtr>(value)) {
    const FunctionPtr held = *function;
    p_.resolve();
    return user_call(held);
  }
  const auto* numeric = std::get_if<Numeric>(value);
  if (!numeric || numeric->terms != 1) p_.expected("function expression");
  const double constant = numeric->v[0];
  p_.resolve();
  return {Constant{constant}, false};
}

Node FunctionParser::user_call(const FunctionPtr& function) {
  UserCall call;
  call.function = function;
  call.arguments = arguments(function->parameters(), "function");
  if (function->components() > 1) {
    if (p_.peek().punctuation != '.') p_.expected(".");
    p_.skip_token();
    const Token token = p_.peek();
    const std::string_view text = token.kind == TokenKind::identifier ? p_.names[token.id()].text : std::string_view{};
    switch (token.word) {
      case Word::x:
      case Word::u:
      case Word::red:
        call.component = 0;
        break;
      case Word::y:
      case Word::v:
      case Word::green:
        call.component = 1;
        break;
      case Word::z:
      case Word::blue:
        call.component = 2;
        break;
      case Word::t:
      case Word::filter:
        call.component = 3;
        break;
      case Word::transmit:
        call.component = 4;
        break;
      case Word::gray:
        call.grey = true;
        break;
      default:
        if (text == "grey")
          call.grey = true;
        else if (text == "hf")
          call.hf = true;
        else
          p_.expected("a component: x, y, z, t, u, v, red, green, blue, filter, transmit, gray or hf");
    }
    p_.skip_token();
  }
  return {std::move(call), false};
}
}  // namespace verisim::parser
