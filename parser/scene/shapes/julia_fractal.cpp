// julia_fractal (spec 04 section 8).
#include <algorithm>
#include <cmath>

#include "parser/scene/objects.h"

namespace verisim::parser {

using scene::JuliaFunction;

namespace {

struct FunctionWord {
  Word word;
  JuliaFunction function;
};

constexpr FunctionWord kFunctionNames[] = {
    {Word::sqr, JuliaFunction::sqr},   {Word::cube, JuliaFunction::cube},
    {Word::exp, JuliaFunction::exp},   {Word::reciprocal, JuliaFunction::reciprocal},
    {Word::sin, JuliaFunction::sin},   {Word::asin, JuliaFunction::asin},
    {Word::sinh, JuliaFunction::sinh}, {Word::asinh, JuliaFunction::asinh},
    {Word::cos, JuliaFunction::cos},   {Word::acos, JuliaFunction::acos},
    {Word::cosh, JuliaFunction::cosh}, {Word::acosh, JuliaFunction::acosh},
    {Word::tan, JuliaFunction::tan},   {Word::atan, JuliaFunction::atan},
    {Word::tanh, JuliaFunction::tanh}, {Word::atanh, JuliaFunction::atanh},
    {Word::ln, JuliaFunction::ln},     {Word::pwr, JuliaFunction::pwr},
};

std::array<double, 4> parse_vec4(Parser& parser) {
  const Numeric n = parser.parse_numeric(4);
  return {n.v[0], n.v[1], n.v[2], n.v[3]};
}

bool parse_function(Parser& parser, scene::JuliaFractal& fractal) {
  const Word word = word_at(parser);
  for (const FunctionWord& entry : kFunctionNames) {
    if (entry.word != word) continue;
    parser.next();
    fractal.function = entry.function;
    if (word == Word::pwr) {
      parser.expect('(');
      fractal.exponent.x = parser.parse_float();
      parser.optional_comma();
      fractal.exponent.y = parser.parse_float();
      parser.expect(')');
    }
    return true;
  }
  return false;
}

void parse_slice(Parser& parser, scene::JuliaFractal& fractal) {
  parser.next();
  fractal.slice = parse_vec4(parser);
  parser.optional_comma();
  fractal.slice_distance = parser.parse_float();
  double square = 0;
  for (const double s : fractal.slice) square += s * s;
  if (!(square >= kEpsilon)) parser.error(Code::bad_value, "Slice vector is zero.");
  if (!(std::fabs(fractal.slice[3]) >= kEpsilon)) parser.error(Code::bad_value, "Slice t component is zero.");
  // A reciprocal, as in POV-Ray: the last bits decide where the fractal's surface is found.
  const double by = 1 / std::sqrt(square);
  for (double& s : fractal.slice) s *= by;
}

}  // namespace

ObjectRef parse_julia_fractal(Parser& parser) {
  const ObjectRef read = shape_block(parser, [&](scene::Object& object) {
    auto fractal = std::make_shared<scene::JuliaFractal>();
    fractal->parameter = parse_vec4(parser);
    for (;;) {
      switch (word_at(parser)) {
        case Word::quaternion:
          parser.next();
          fractal->hypercomplex = false;
          continue;
        case Word::hypercomplex:
          parser.next();
          fractal->hypercomplex = true;
          continue;
        case Word::max_iteration:
          parser.next();
          fractal->max_iteration = std::max(1, parser.parse_int());
          continue;
        case Word::precision:
          parser.next();
          fractal->precision = std::max(1.0, parser.parse_float());
          continue;
        case Word::slice:
          parse_slice(parser, *fractal);
          continue;
        default:
          break;
      }
      if (!parse_function(parser, *fractal)) break;
    }
    if (!fractal->hypercomplex && fractal->function != JuliaFunction::sqr && fractal->function != JuliaFunction::cube)
      parser.error(Code::bad_value, "Illegal function: quaternion only supports sqr and cube.");
    object.shape = std::shared_ptr<const scene::JuliaFractal>(fractal);
  });
  read->inverted = false;  // `inverse` within the braces has no effect (spec 04 section 8)
  return read;
}

}  // namespace verisim::parser
