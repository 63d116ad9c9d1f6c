// Float functions and constants (spec 01 section 10).
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "parser/language/impl.h"

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

// 32-bit linear congruential streams, one for each seed() (spec 01 section 10).
double random_number(Parser::Impl& p) {
  const int stream = to_int(p.argument());
  if (stream < 0 || static_cast<std::size_t>(stream) >= p.random_streams.size())
    p.error(Code::missing_item, "rand() of a stream that seed() never made.");
  std::uint32_t& state = p.random_streams[static_cast<std::size_t>(stream)];
  state = 1812433253u * state + 12345u;
  return state / 4294967295.0;
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

}  // namespace

// The word is at the cursor; false: it is no float function.
bool Parser::Impl::float_function(Word word, double& out) {
  if (word_class(word) != WordClass::float_function) return false;
  const Nesting nesting(*this);
  skip_token();
  switch (word) {
    case Word::abs:
      out = std::fabs(argument());
      break;
    case Word::sin:
      out = std::sin(argument());
      break;
    case Word::cos:
      out = std::cos(argument());
      break;
    case Word::tan:
      out = std::tan(argument());
      break;
    case Word::asin:
      out = std::asin(clamped(*this, argument()));
      break;
    case Word::acos:
      out = std::acos(clamped(*this, argument()));
      break;
    case Word::atan:
      out = std::atan(argument());
      break;
    case Word::sinh:
      out = std::sinh(argument());
      break;
    case Word::cosh:
      out = std::cosh(argument());
      break;
    case Word::tanh:
      out = std::tanh(argument());
      break;
    case Word::asinh:
      out = std::asinh(argument());
      break;
    case Word::acosh:
      out = std::acosh(argument());
      break;
    case Word::atanh:
      out = std::atanh(argument());
      break;
    case Word::exp:
      out = std::exp(argument());
      break;
    case Word::ceil:
      out = std::ceil(argument());
      break;
    case Word::floor:
      out = std::floor(argument());
      break;
    case Word::int_:
      out = to_int(argument());
      break;
    case Word::degrees:
      out = argument() / (std::numbers::pi / 180);
      break;
    case Word::radians:
      out = argument() * (std::numbers::pi / 180);
      break;
    case Word::sqrt: {
      const double v = argument();
      if (v < 0) error(Code::domain_error, "Domain error in sqrt: the argument is negative.");
      out = std::sqrt(v);
      break;
    }
    case Word::ln:
    case Word::log: {
      const double v = argument();
      if (v <= 0)
        error(Code::domain_error, fmt::format("Domain error in {}: the argument must be positive.", spelling(word)));
      out = word == Word::ln ? std::log(v) : std::log10(v);
      break;
    }
    case Word::atan2: {
      const auto [a, b] = two_arguments(*this);
      if (std::fabs(a) <= kEps && std::fabs(b) <= kEps)
        error(Code::domain_error, "Domain error in atan2: both arguments are zero.");
      out = std::atan2(a, b);
      break;
    }
    case Word::pow: {
      const auto [a, b] = two_arguments(*this);
      if (a == 0 && b == 0) error(Code::domain_error, "Domain error in pow: both arguments are zero.");
      out = std::pow(a, b);
      break;
    }
    case Word::div: {
      const auto [a, b] = two_arguments(*this);
      out = to_int(a / b);
      break;
    }
    case Word::mod: {
      const auto [a, b] = two_arguments(*this);
      out = std::fmod(a, b);
      break;
    }
    case Word::min:
      each_argument(*this, [&](double v, bool first) { out = first || v < out ? v : out; });
      break;
    case Word::max:
      each_argument(*this, [&](double v, bool first) { out = first || v > out ? v : out; });
      break;
    case Word::bitwise_and:
      out = bitwise(*this, [](int a, int b) { return a & b; });
      break;
    case Word::bitwise_or:
      out = bitwise(*this, [](int a, int b) { return a | b; });
      break;
    case Word::bitwise_xor:
      out = bitwise(*this, [](int a, int b) { return a ^ b; });
      break;
    case Word::select:
      out = select(*this);
      break;
    case Word::seed: {
      const double v = argument();
      const auto state = static_cast<std::uint32_t>(to_int(v));
      if (random_streams.size() * sizeof(state) > options.limits.max_memory_bytes / 16)
        error(Code::size_limit, "Too many random streams.");
      random_streams.push_back(state);
      out = static_cast<double>(random_streams.size() - 1);
      break;
    }
    case Word::rand:
      out = random_number(*this);
      break;
    case Word::vdot: {
      open_arguments();
      const Live live(*this);
      const Vec3 a = vector_argument();
      if (peek().punctuation == ',') skip_token();
      const Vec3 b = vector_argument();
      close_arguments();
      out = dot(a, b);
      break;
    }
    case Word::vlength: {
      open_arguments();
      const Live live(*this);
      out = length(vector_argument());
      close_arguments();
      break;
    }
    case Word::strlen: {
      open_arguments();
      const Live live(*this);
      out = static_cast<double>(string(false).size());
      close_arguments();
      break;
    }
    case Word::asc: {
      open_arguments();
      const Live live(*this);
      const std::u16string text = string(false);
      out = text.empty() ? 0 : text[0];
      close_arguments();
      break;
    }
    case Word::val: {
      open_arguments();
      const Live live(*this);
      std::string bytes;
      for (const char16_t c : string(false)) bytes += c > 127 ? ' ' : static_cast<char>(c);
      out = std::strtod(bytes.c_str(), nullptr);
      close_arguments();
      break;
    }
    case Word::strcmp: {
      open_arguments();
      const Live live(*this);
      const std::u16string a = string(false);
      if (peek().punctuation == ',') skip_token();
      const std::u16string b = string(false);
      close_arguments();
      out = 0;
      for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        const int p = i < a.size() ? a[i] : 0, q = i < b.size() ? b[i] : 0;
        if (p != q) {
          out = p - q;
          break;
        }
      }
      break;
    }
    case Word::file_exists: {
      open_arguments();
      const Live live(*this);
      const auto found = search->find_exact(utf8(string(true)));
      out = found && search->may_read(*found);
      close_arguments();
      break;
    }
    case Word::dimensions:
      out = dimension(*this, false);
      break;
    case Word::dimension_size:
      out = dimension(*this, true);
      break;
    case Word::defined:
      out = defined_argument();
      break;
    case Word::inside: {
      open_arguments();
      const Live live(*this);
      const scene::ObjectPtr object = object_argument();
      const query::Target& target = query_target(object);
      if (!target.has_inside()) error(Code::missing_item, "inside() needs an object that has an inside.");
      if (peek().punctuation == ',') skip_token();
      const Vec3 at = vector_argument();
      close_arguments();
      within_budget("inside()", [&] { out = target.inside(at); });
      break;
    }
    case Word::now:
      out = days_since_2000();
      break;
    case Word::pi:
      out = std::numbers::pi;
      break;
    case Word::clock:
      out = static_cast<double>(static_cast<float>(options.clock));
      break;
    case Word::clock_on:
      out = options.clock_on;
      break;
    case Word::version:
      out = language_version / 100.0;
      break;
    case Word::true_:
    case Word::yes:
    case Word::on:
      out = 1;
      break;
    case Word::false_:
    case Word::no:
    case Word::off:
      out = 0;
      break;
    default:
      --position;
      error(Code::function_syntax, fmt::format("'{}' can only be used inside user functions.", spelling(word)));
  }
  return true;
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
