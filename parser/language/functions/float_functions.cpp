// Float functions and constants (spec 01 section 10).
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "parser/language/impl.h"
#include "parser/language/scanner.h"

namespace verisim::parser {

void Parser::Impl::open_arguments() {
  if (!accept_operator('(')) expected("(");
}

void Parser::Impl::close_arguments() {
  if (peek().punctuation != ')') expected(")");
  skip_token();
}

double Parser::Impl::argument() {
  open_arguments();
  const Live live(*this);
  const double value = full_scalar();
  close_arguments();
  return value;
}

double (*unary_function(Word word))(double) {
  switch (word) {
    case Word::abs:
      return [](double v) { return std::fabs(v); };
    case Word::sin:
      return [](double v) { return std::sin(v); };
    case Word::cos:
      return [](double v) { return std::cos(v); };
    case Word::tan:
      return [](double v) { return std::tan(v); };
    case Word::atan:
      return [](double v) { return std::atan(v); };
    case Word::sinh:
      return [](double v) { return std::sinh(v); };
    case Word::cosh:
      return [](double v) { return std::cosh(v); };
    case Word::tanh:
      return [](double v) { return std::tanh(v); };
    case Word::asinh:
      return [](double v) { return std::asinh(v); };
    case Word::acosh:
      return [](double v) { return std::acosh(v); };
    case Word::atanh:
      return [](double v) { return std::atanh(v); };
    case Word::exp:
      return [](double v) { return std::exp(v); };
    case Word::ceil:
      return [](double v) { return std::ceil(v); };
    case Word::floor:
      return [](double v) { return std::floor(v); };
    case Word::int_:
      return [](double v) { return static_cast<double>(to_int(v)); };
    case Word::degrees:
      return [](double v) { return v / (std::numbers::pi / 180); };
    case Word::radians:
      return [](double v) { return v * (std::numbers::pi / 180); };
    default:
      return nullptr;
  }
}

namespace {

double clamped(Parser::Impl& p, double value) {
  if (value >= -1 && value <= 1) return value;
  if (value < -1) {
    p.message(Severity::warning, Code::domain_error,
              "Domain error: an argument below -1 of acos or asin is taken as -1.");
    return -1;
  }
  if (value > 1) {
    p.message(Severity::warning, Code::domain_error,
              "Domain error: an argument above 1 of acos or asin is taken as 1.");
    return 1;
  }
  return value;  // NaN
}

// Calls f for every argument of a list of at least one; the first one is passed with `first` set.
template <class F>
void each_argument(Parser::Impl& p, F&& f) {
  p.open_arguments();
  const Live live(p);
  f(p.scalar(), true);
  while (p.peek().punctuation == ',') {  // commas are not optional here
    p.skip_token();
    f(p.scalar(), false);
  }
  p.close_arguments();
}

template <class F>
double bitwise(Parser::Impl& p, F&& f) {
  int result = 0;
  each_argument(p, [&](double value, bool first) { result = first ? to_int(value) : f(result, to_int(value)); });
  return result;
}

struct Pair {
  double a, b;
};

Pair two_arguments(Parser::Impl& p) {
  p.open_arguments();
  const Live live(p);
  const double a = p.scalar();
  if (p.peek().punctuation == ',') p.skip_token();
  const double b = p.scalar();
  p.close_arguments();
  return {a, b};
}

double select(Parser::Impl& p) {
  p.open_arguments();
  const Live live(p);
  double v[4];
  int count = 0;
  for (; count < 4; ++count) {
    if (count == 3 && p.peek().punctuation == ')') break;
    v[count] = p.scalar();
    if (p.peek().punctuation == ',') p.skip_token();
  }
  p.close_arguments();
  if (v[0] < 0) return v[1];
  if (count == 3) return v[2];
  return v[0] == 0 ? v[2] : v[3];
}

// One stream for each seed().
double random_number(Parser::Impl& p) {
  const int stream = to_int(p.argument());
  if (stream < 0 || static_cast<std::size_t>(stream) >= p.random_streams.size())
    p.error(Code::missing_item, "rand() of a stream that seed() never made.");
  std::uint32_t& state = p.random_streams[static_cast<std::size_t>(stream)];
  state = next_random(state);
  return random_of(state);
}

double days_since_2000() {
  using namespace std::chrono;
  const auto epoch = sys_days{year{2000} / 1 / 1};
  return static_cast<double>(duration_cast<microseconds>(system_clock::now() - epoch).count()) / 86400e6;
}

double dimension(Parser::Impl& p, bool size) {
  p.open_arguments();
  const Live live(p);
  const Value* value = p.peek_value();
  if (!value || !std::holds_alternative<std::shared_ptr<Array>>(*value)) p.expected("array identifier");
  const auto resolved = p.resolve();
  const std::shared_ptr<Array> array = std::get<std::shared_ptr<Array>>(resolved.value());
  double result = static_cast<double>(array->sizes.size());
  if (size) {
    if (p.peek().punctuation == ',') p.skip_token();
    const int n = to_int(p.scalar());
    result = n >= 1 && static_cast<std::size_t>(n) <= array->sizes.size()
                 ? array->sizes[static_cast<std::size_t>(n) - 1]
                 : 0;
  }
  p.close_arguments();
  return result;
}

std::uint32_t new_stream(Parser::Impl& p) {
  const auto state = static_cast<std::uint32_t>(to_int(p.argument()));
  if (p.random_streams.size() * sizeof(state) > p.options.limits.max_memory_bytes / 16)
    p.error(Code::size_limit, "Too many random streams.");
  p.random_streams.push_back(state);
  return static_cast<std::uint32_t>(p.random_streams.size() - 1);
}

double square_root(Parser::Impl& p) {
  const double v = p.argument();
  if (v < 0) p.error(Code::domain_error, "Domain error in sqrt: the argument is negative.");
  return std::sqrt(v);
}

double logarithm(Parser::Impl& p, Word word) {
  const double v = p.argument();
  if (v <= 0)
    p.error(Code::domain_error, fmt::format("Domain error in {}: the argument must be positive.", spelling(word)));
  return word == Word::ln ? std::log(v) : std::log10(v);
}

double arc_tangent(Parser::Impl& p) {
  const auto [a, b] = two_arguments(p);
  if (std::fabs(a) <= kEps && std::fabs(b) <= kEps)
    p.error(Code::domain_error, "Domain error in atan2: both arguments are zero.");
  return std::atan2(a, b);
}

double power(Parser::Impl& p) {
  const auto [a, b] = two_arguments(p);
  if (a == 0 && b == 0) p.error(Code::domain_error, "Domain error in pow: both arguments are zero.");
  return std::pow(a, b);
}

// Each of the groups below: false, if the word is none of it. The cursor is behind the word.

bool function_of_numbers(Parser::Impl& p, Word word, double& out) {
  if (const auto function = unary_function(word)) {
    out = function(p.argument());
    return true;
  }
  switch (word) {
    case Word::asin:
      out = std::asin(clamped(p, p.argument()));
      return true;
    case Word::acos:
      out = std::acos(clamped(p, p.argument()));
      return true;
    case Word::sqrt:
      out = square_root(p);
      return true;
    case Word::ln:
    case Word::log:
      out = logarithm(p, word);
      return true;
    case Word::atan2:
      out = arc_tangent(p);
      return true;
    case Word::pow:
      out = power(p);
      return true;
    case Word::div: {
      const auto [a, b] = two_arguments(p);
      out = to_int(a / b);
      return true;
    }
    case Word::mod: {
      const auto [a, b] = two_arguments(p);
      out = std::fmod(a, b);
      return true;
    }
    case Word::min:
      each_argument(p, [&](double v, bool first) { out = first || v < out ? v : out; });
      return true;
    case Word::max:
      each_argument(p, [&](double v, bool first) { out = first || v > out ? v : out; });
      return true;
    case Word::bitwise_and:
      out = bitwise(p, [](int a, int b) { return a & b; });
      return true;
    case Word::bitwise_or:
      out = bitwise(p, [](int a, int b) { return a | b; });
      return true;
    case Word::bitwise_xor:
      out = bitwise(p, [](int a, int b) { return a ^ b; });
      return true;
    case Word::select:
      out = select(p);
      return true;
    case Word::seed:
      out = new_stream(p);
      return true;
    case Word::rand:
      out = random_number(p);
      return true;
    default:
      return false;
  }
}

double difference(const std::u16string& a, const std::u16string& b) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const int p = i < a.size() ? a[i] : 0, q = i < b.size() ? b[i] : 0;
    if (p != q) return p - q;
  }
  return 0;
}

double number_in(const std::u16string& text) {
  std::string bytes;
  for (const char16_t c : text) bytes += c > 127 ? ' ' : static_cast<char>(c);
  return std::strtod(bytes.c_str(), nullptr);
}

bool function_of_text(Parser::Impl& p, Word word, double& out) {
  if (word != Word::strlen && word != Word::asc && word != Word::val && word != Word::strcmp &&
      word != Word::file_exists)
    return false;
  p.open_arguments();
  const Live live(p);
  const std::u16string text = p.string(word == Word::file_exists);
  if (word == Word::strlen) {
    out = static_cast<double>(text.size());
  } else if (word == Word::asc) {
    out = text.empty() ? 0 : text[0];
  } else if (word == Word::val) {
    out = number_in(text);
  } else if (word == Word::strcmp) {
    if (p.peek().punctuation == ',') p.skip_token();
    out = difference(text, p.string(false));
  } else {
    const auto found = p.search->find_exact(p.utf8(text));
    out = found && p.search->may_read(*found);
  }
  p.close_arguments();
  return true;
}

bool function_of_vectors(Parser::Impl& p, Word word, double& out) {
  if (word != Word::vdot && word != Word::vlength) return false;
  p.open_arguments();
  const Live live(p);
  const Vec3 a = p.vector_argument();
  if (word == Word::vlength) {
    out = length(a);
  } else {
    if (p.peek().punctuation == ',') p.skip_token();
    out = dot(a, p.vector_argument());
  }
  p.close_arguments();
  return true;
}

double inside(Parser::Impl& p) {
  p.open_arguments();
  const Live live(p);
  const scene::ObjectPtr object = p.object_argument();
  const query::Target& target = p.query_target(object);
  if (!target.has_inside()) p.error(Code::missing_item, "inside() needs an object that has an inside.");
  if (p.peek().punctuation == ',') p.skip_token();
  const Vec3 at = p.vector_argument();
  p.close_arguments();
  bool within = false;
  p.within_budget("inside()", [&] { within = target.inside(at); });
  return within;
}

bool question_or_constant(Parser::Impl& p, Word word, double& out) {
  switch (word) {
    case Word::dimensions:
      out = dimension(p, false);
      return true;
    case Word::dimension_size:
      out = dimension(p, true);
      return true;
    case Word::defined:
      out = p.defined_argument();
      return true;
    case Word::inside:
      out = inside(p);
      return true;
    case Word::now:
      out = days_since_2000();
      return true;
    case Word::pi:
      out = std::numbers::pi;
      return true;
    case Word::clock:
      out = static_cast<double>(static_cast<float>(p.options.clock));
      return true;
    case Word::clock_on:
      out = p.options.clock_on;
      return true;
    case Word::version:
      out = p.language_version / 100.0;
      return true;
    case Word::true_:
    case Word::yes:
    case Word::on:
      out = 1;
      return true;
    case Word::false_:
    case Word::no:
    case Word::off:
      out = 0;
      return true;
    default:
      return false;
  }
}

}  // namespace

// The word is at the cursor; false: it is no float function.
bool Parser::Impl::float_function(Word word, double& out) {
  if (word_class(word) != WordClass::float_function) return false;
  const Nesting nesting(*this);
  skip_token();
  if (function_of_numbers(*this, word, out) || question_or_constant(*this, word, out) ||
      function_of_vectors(*this, word, out) || function_of_text(*this, word, out))
    return true;
  --position;
  error(Code::function_syntax, fmt::format("'{}' can only be used inside user functions.", spelling(word)));
}

bool Parser::Impl::word_operand(Word word, Numeric& out) {
  if (double value; float_function(word, value)) {
    out.v[0] = value;
    out.terms = 1;
    return true;
  }
  return vector_function(word, out);
}

}  // namespace verisim::parser
