// Boxes beside colours, and what a colour picker writes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/lsp/features.h"

namespace verisim::cli::lsp {
namespace {

using parser::Token;
using parser::TokenKind;
using parser::Word;

// A colour as it is written: its word and up to five numbers; rgbf has the filter fourth, rgbt the transmit, rgbft
// both.
struct Written {
  std::size_t begin = 0, end = 0;
  std::string word;
  std::vector<double> numbers;
};

std::vector<Written> colors_of(const parser::TokenFile& file) {
  std::vector<Written> colors;
  const parser::Tokens& tokens = file.tokens;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].kind != TokenKind::word || !starts_color(tokens[i].word)) continue;
    const Token& value = tokens[i + 1];
    Written color{
        tokens[i].offset, value.offset + file.length(value), std::string(parser::spelling(tokens[i].word)), {}};
    const std::size_t wanted = color.word.size() - (color.word[0] == 's');
    if (value.kind == TokenKind::vector) {
      color.numbers.assign(file.vector(value), file.vector(value) + value.terms());
      if (color.numbers.size() < 3 || color.numbers.size() > 5) continue;
      color.numbers.resize(std::max(color.numbers.size(), wanted));
    } else if (value.kind == TokenKind::number && wanted == 3) {
      // One number stands for three; a factor behind it would change it.
      const char next = i + 2 < tokens.size() ? tokens[i + 2].punctuation : char{0};
      if (next == '*' || next == '/' || next == '+' || next == '-') continue;
      color.numbers.assign(3, value.number());
    } else {
      continue;
    }
    colors.push_back(std::move(color));
  }
  return colors;
}

double encoded(double linear) {
  linear = std::clamp(linear, 0.0, 1.0);
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linear(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

// Whether the numbers of rgb are light: with assumed_gamma 1, which is the default, they are; with 2.2 they are what a
// screen shows.
bool is_linear(const parser::TokenFile& file) {
  for (std::size_t i = 0; i + 1 < file.tokens.size(); ++i)
    if (file.tokens[i].word == Word::assumed_gamma)
      return file.tokens[i + 1].kind != TokenKind::number || file.tokens[i + 1].number() < 1.5;
  return true;
}

std::string number(double value) {
  std::string text = fmt::format("{:.3f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

Json document_colors(const Workspace& workspace, const Document& document) {
  Json found = Json::array();
  const parser::TokenFile& file = document.index().tokens();
  const bool light = is_linear(file);
  constexpr std::size_t kMax = 5000;
  for (const Written& color : colors_of(file)) {
    if (found.size() == kMax) break;
    const auto shown = [&](double v) { return color.word[0] == 's' || !light ? std::clamp(v, 0.0, 1.0) : encoded(v); };
    double through = 0;
    for (std::size_t i = 3; i < color.numbers.size(); ++i) through += color.numbers[i];
    found.push_back({{"range", range_json(*document.text, color.begin, color.end, workspace.columns())},
                     {"color",
                      {{"red", shown(color.numbers[0])},
                       {"green", shown(color.numbers[1])},
                       {"blue", shown(color.numbers[2])},
                       {"alpha", std::clamp(1 - through, 0.0, 1.0)}}}});
  }
  return found;
}

Json color_presentations(const Workspace& workspace, const Document& document, const Json& params) {
  const Json& color = params.at("color");
  double c[3] = {color.at("red").get<double>(), color.at("green").get<double>(), color.at("blue").get<double>()};
  const double through = 1 - color.at("alpha").get<double>();
  const Json& range = params.at("range");
  const std::size_t begin = document.text->offset(as_point(range.at("start")), workspace.columns());
  const parser::TokenFile& file = document.index().tokens();
  const bool light = is_linear(file);
  // The kind of transparency stays what it was; where there was none, what is picked shines through unfiltered.
  bool filter = false;
  for (const Written& written : colors_of(file))
    if (written.begin == begin) filter = written.word.find('f') != std::string::npos;
  const std::string suffix = through < 0.0005 ? "" : filter ? "f" : "t";
  const std::string last = suffix.empty() ? "" : ", " + number(through);
  const auto text = [&](const std::string& word, auto&& convert) {
    return fmt::format("{}{} <{}, {}, {}{}>", word, suffix, number(convert(c[0])), number(convert(c[1])),
                       number(convert(c[2])), last);
  };
  const std::string rgb = text("rgb", [&](double v) { return light ? linear(v) : v; });
  const std::string srgb = text("srgb", [](double v) { return v; });
  const bool was_srgb = document.text->str().compare(begin, 4, "srgb") == 0;
  Json presentations = Json::array();
  for (const std::string& label : {was_srgb ? srgb : rgb, was_srgb ? rgb : srgb})
    presentations.push_back({{"label", label}, {"textEdit", {{"range", range}, {"newText", label}}}});
  return presentations;
}

}  // namespace verisim::cli::lsp
