// cubic, quartic, poly and polynomial (spec 03 4.9). Coefficients: exponent of x descending, then of y, then of z.
#include "parser/scene/objects.h"

namespace verisim::parser {

namespace {

constexpr int kMaxOrder = 35;

std::size_t term_count(int order) { return static_cast<std::size_t>((order + 1) * (order + 2) * (order + 3) / 6); }

// Position of x^i y^j z^k in the list.
std::size_t term_index(int order, int i, int j, int k) {
  std::size_t index = 0;
  for (int a = order; a > i; --a) index += static_cast<std::size_t>((order - a + 1) * (order - a + 2) / 2);
  const int rest = order - i;
  for (int b = rest; b > j; --b) index += static_cast<std::size_t>(rest - b + 1);
  return index + static_cast<std::size_t>(rest - j - k);
}

int parse_order(Parser& parser) {
  const int order = parser.parse_int();
  if (order < 2 || order > kMaxOrder) parser.error(Code::bad_value, "Order of poly is out of range.");
  parser.optional_comma();
  return order;
}

}  // namespace

ObjectRef parse_poly(Parser& parser) {
  const Word word = word_at(parser);
  return shape_block(parser, [&](scene::Object& object) {
    scene::Poly poly{word == Word::cubic ? 3 : word == Word::quartic ? 4 : parse_order(parser), {}};
    poly.coefficients.resize(term_count(poly.order));
    parser.expect('<');
    for (double& coefficient : poly.coefficients) {
      coefficient = parser.parse_float();
      parser.optional_comma();
    }
    parser.expect('>');
    object.shape = std::move(poly);
  });
}

ObjectRef parse_polynomial(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    scene::Poly poly{parse_order(parser), {}};
    poly.coefficients.resize(term_count(poly.order));
    while (parser.accept(Word::xyz)) {
      parser.expect('(');
      int exponents[3];
      for (int& exponent : exponents) {
        exponent = parser.parse_int();
        parser.optional_comma();
      }
      parser.expect(')');
      parser.expect(':');
      const double value = parser.parse_float();
      parser.optional_comma();
      const auto [i, j, k] = exponents;
      if (i < 0 || j < 0 || k < 0 || i > poly.order || j > poly.order || k > poly.order || i + j + k > poly.order)
        parser.error(Code::bad_value, "Coefficient of polynom is out of range.");
      poly.coefficients[term_index(poly.order, i, j, k)] = value;
    }
    object.shape = std::move(poly);
  });
}

}  // namespace verisim::parser
