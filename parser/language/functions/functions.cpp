// User functions with their parameters and the special bodies: patterns, pigments, transforms, splines (spec 01 section
// 23).
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "parser/language/blocks.h"
#include "parser/language/functions/function_parser.h"
#include "tracer/functions/scene_noise.h"
#include "tracer/textures/texture.h"

namespace verisim::parser {
namespace {

using namespace functions;

constexpr int kNoise3d = 76;  // internal(76)

// transform{...} as a function of a point.
class TransformFunction : public Function {
 public:
  explicit TransformFunction(const Transform& transform) : transform_(transform) {}
  int parameters() const override { return 3; }
  int components() const override { return 3; }
  void evaluate(std::span<const double> a, double* result) const override {
    const Vec3 p = transform_.point({a[0], a[1], a[2]});
    result[0] = p.x, result[1] = p.y, result[2] = p.z;
  }

 private:
  Transform transform_;
};

class SplineFunction : public Function {
 public:
  explicit SplineFunction(Shared<Spline> spline) : spline_(std::move(spline)) {}
  int parameters() const override { return 1; }
  int components() const override { return spline_->terms(); }
  void evaluate(std::span<const double> a, double* result) const override {
    const Spline::Value v = spline_->evaluate(a[0]);
    std::copy(v.begin(), v.begin() + spline_->terms(), result);
  }

 private:
  Shared<Spline> spline_;
};

}  // namespace

// The keyword `function` is consumed.
FunctionPtr Parser::Impl::function() {
  const Nesting nesting(*this);
  const Live live(*this);
  FunctionParser expression(*this, std::exchange(declaring, 0));
  expression.parameters();
  if (peek().punctuation != '{') expected("{");
  skip_token();
  const Word word = peek().kind == TokenKind::word ? peek().word : Word::none;
  const bool fixed = word == Word::pattern || word == Word::pigment || word == Word::transform || word == Word::spline;
  if (fixed && !expression.default_parameters())
    error(Code::wrong_type, fmt::format("A function of a {} has no parameter list.", spelling(word)));
  textures::Settings settings;
  settings.number_of_waves = scene.settings.number_of_waves;
  settings.version = parser.effective_version();
  const auto of_generator = [&](std::function<FunctionPtr(int)> make) {
    return follow_generator(noise_generator, std::move(make));
  };
  const auto with = [settings](int generator) {
    textures::Settings result = settings;
    result.noise_generator = generator;
    return result;
  };
  FunctionPtr result;
  switch (word) {
    case Word::internal: {
      skip_token();
      const int n = to_int(argument());
      try {
        result = n == kNoise3d ? of_generator([](int generator) { return internal_function(kNoise3d, generator); })
                               : internal_function(n, *noise_generator);
      } catch (const std::invalid_argument& e) {
        error(Code::bad_value, e.what());
      }
      break;
    }
    case Word::pattern: {
      skip_token();
      if (peek().punctuation != '{') expected("{");
      skip_token();
      const scene::Pattern pattern = parse_pattern_body(parser);
      result =
          of_generator([=](int generator) { return textures::pattern_function(pattern, nullptr, with(generator)); });
      break;
    }
    case Word::pigment: {
      const scene::PigmentPtr pigment = parse_independent_pigment(parser);
      result = of_generator([=](int generator) { return textures::pigment_function(pigment, with(generator)); });
      break;
    }
    case Word::transform:
      result = std::make_shared<TransformFunction>(parse_transform(parser));
      break;
    case Word::spline:
      skip_token();
      result = std::make_shared<SplineFunction>(spline());
      break;
    default:
      result = expression.body();
  }
  if (peek().punctuation != '}') expected("}");
  skip_token();
  return result;
}

// The keyword `spline` is consumed.
Shared<Spline> Parser::Impl::spline() {
  const Nesting nesting(*this);
  const Live live(*this);
  spline_used = true;
  if (peek().punctuation != '{') expected("{");
  skip_token();
  auto result = std::make_shared<Spline>();
  if (const Value* value = peek_value();
      value && std::holds_alternative<Shared<Spline>>(*value) && (&peek())[1].punctuation != '(')
    *result = *std::get<Shared<Spline>>(resolve().value());
  switch (peek().word) {
    case Word::linear_spline:
      result->set_kind(Spline::Kind::linear), skip_token();
      break;
    case Word::quadratic_spline:
      result->set_kind(Spline::Kind::quadratic), skip_token();
      break;
    case Word::cubic_spline:
      result->set_kind(Spline::Kind::cubic), skip_token();
      break;
    case Word::natural_spline:
      result->set_kind(Spline::Kind::natural), skip_token();
      break;
    default:
      break;
  }
  while (peek().punctuation != '}') {
    const double t = scalar();
    if (peek().punctuation == ',') skip_token();
    Numeric value;
    full(value);
    if (value.terms == 1) fit(value, 2, position);
    result->insert(t, value.v, value.terms);
    count_steps(1);
    if (peek().punctuation == ',') skip_token();
  }
  skip_token();
  if (result->empty()) error(Code::too_few, "A spline needs at least one point.");
  return result;
}

// ---- The public face ----

FunctionPtr Parser::parse_function_body() { return impl_->function(); }

FunctionPtr Parser::parse_function_or_identifier() {
  if (accept(Word::function)) return impl_->function();
  if (const FunctionPtr* function = accept_value<FunctionPtr>()) return *function;
  error_expected("function");
}

}  // namespace verisim::parser
