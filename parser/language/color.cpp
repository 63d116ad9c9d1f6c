// Colours (spec 01 section 9).
#include <cmath>

#include "parser/language/impl.h"

namespace verisim::parser {
namespace {

int component_of(Word word) {
  switch (word) {
    case Word::red:
      return 0;
    case Word::green:
      return 1;
    case Word::blue:
      return 2;
    case Word::filter:
    case Word::alpha:
      return 3;
    case Word::transmit:
      return 4;
    default:
      return -1;
  }
}

// The sRGB transfer function, also applied outside 0..1; in single precision, as measured to the last bit.
float decode_srgb(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

}  // namespace

void Parser::Impl::to_working_space(Numeric& value) {
  const scene::Settings& settings = scene.settings;
  if (!settings.gamma_given)
    error(Code::missing_gamma, "srgb needs assumed_gamma to be set before.",
          "Put global_settings { assumed_gamma 1.0 } at the beginning of the scene.");
  if (settings.gamma == scene::Gamma::srgb) return;
  for (std::size_t i = 0; i < 3; ++i) {
    float c = decode_srgb(static_cast<float>(value.v[i]));
    if (settings.assumed_gamma != 1) c = std::pow(c, 1 / static_cast<float>(settings.assumed_gamma));
    value.v[i] = static_cast<double>(c);
  }
}

Numeric Parser::Impl::color_base() {
  const Word word = peek().word;
  skip_token();
  Numeric value;
  full(value);
  int width = 3;
  if (word == Word::rgbf || word == Word::srgbf || word == Word::rgbt || word == Word::srgbt) width = 4;
  if (word == Word::rgbft || word == Word::srgbft) width = 5;
  const int found = value.terms;
  if (found == 1)
    for (int i = 1; i < width; ++i) value.v[static_cast<std::size_t>(i)] = value.v[0];
  const int used = found == 1 ? width : found;
  for (int i = used; i < 5; ++i) value.v[static_cast<std::size_t>(i)] = 0;
  if (found > width)
    message(Severity::warning, Code::adjusted_value,
            "The colour has more terms than its keyword names; they are kept as filter and transmit.");
  if (width == 4 && (word == Word::rgbt || word == Word::srgbt)) {
    value.v[4] = value.v[3];
    value.v[3] = 0;
  }
  if (word == Word::srgb || word == Word::srgbf || word == Word::srgbt || word == Word::srgbft) to_working_space(value);
  value.terms = 5;
  return value;
}

void Parser::Impl::color_items(Numeric& out) {
  for (;;) {
    const Token& token = peek_operator();
    if (token.kind != TokenKind::word) return;
    const int component = component_of(token.word);
    if (component < 0) return;
    if (token.word == Word::alpha && language_version > 155)
      message(Severity::warning, Code::discontinued, "Keyword 'alpha' is discontinued: use 'filter' or 'transmit'.");
    skip_token();
    // Not its components.
    --depth_of_parentheses;
    out.v[static_cast<std::size_t>(component)] = scalar();
    ++depth_of_parentheses;
  }
}

Numeric Parser::Impl::color(ColorTerms terms) {
  const Nesting nesting(*this);
  // Colors have operators in every version; elsewhere those before 1.5 need parentheses (measured).
  struct Parenthesis {
    int& depth;
    ~Parenthesis() { --depth; }
  } const operators{++depth_of_parentheses};
  const bool keyword = peek().word == Word::color && peek().kind == TokenKind::word;
  if (keyword) skip_token();
  const Token& token = peek();
  Numeric value{{}, 5};
  if (token.kind == TokenKind::word && starts_color(token.word)) {
    value = color_base();
  } else if (token.kind == TokenKind::word && token.word == Word::gray) {
    skip_token();  // accepted, and black (measured)
  } else if (token.kind == TokenKind::word && token.word == Word::color) {
    // `color color C`: the first is black (measured), the second the next item of the place, if it can have one.
  } else if (token.kind == TokenKind::identifier ||
             (starts_numeric(token) && !(token.kind == TokenKind::word && component_of(token.word) >= 0))) {
    const Token* const start = position;
    full(value);
    // A number on its own fills what the place has: all five terms, or red, green and blue only.
    if (terms == ColorTerms::rgb && value.terms == 1) value = {{value.v[0], value.v[0], value.v[0], 0, 0}, 5};
    fit(value, 5, start);
  }  // else: no colour at all, which is black (measured)
  color_items(value);
  return value;
}

// ---- The public face ----

bool Parser::at_color_keyword() {
  const Token& token = impl_->peek_item();
  return token.kind == TokenKind::word && word_class(token.word) == WordClass::color && token.word != Word::gray;
}

Color Parser::parse_color() {
  const Numeric n = impl_->color();
  const auto f = [&n](std::size_t i) { return static_cast<float>(n.v[i]); };
  return {f(0), f(1), f(2), f(3), f(4)};
}

Rgb Parser::parse_rgb() {
  const Numeric n = impl_->color(Impl::ColorTerms::rgb);
  const auto f = [&n](std::size_t i) { return static_cast<float>(n.v[i]); };
  const Color c{f(0), f(1), f(2), f(3), f(4)};
  if (c.f != 0 || c.t != 0)
    warning(Code::wrong_terms, "Expected a pure RGB colour: filter and transmit mean nothing here.");
  return c.rgb();
}

}  // namespace verisim::parser
