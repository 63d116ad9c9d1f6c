// Modifiers that every pattern has, and the parameters that belong to one kind of pattern (spec 05 sections 2, 3, 8 and
// 9).
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

#include "parser/scene/common/common.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::Pattern;
using scene::PatternKind;

namespace {

template <class Params>
Params& params_of(Parser& parser, Pattern& pattern, Word word, std::string_view where) {
  if (auto* params = std::get_if<Params>(&pattern.params.edit())) return *params;
  error_only_in(parser, word, where);
}

scene::FractalParams& fractal(Parser& parser, Pattern& pattern, Word word) {
  return params_of<scene::FractalParams>(parser, pattern, word, "a fractal pattern");
}

bool parse_wave(Parser& parser, Pattern& pattern) {
  const auto set = [&](scene::Wave wave) {
    parser.next();
    pattern.wave = wave;
    return true;
  };
  switch (word_at(parser)) {
    case Word::ramp_wave:
      return set(scene::Wave::ramp);
    case Word::sine_wave:
      return set(scene::Wave::sine);
    case Word::triangle_wave:
      return set(scene::Wave::triangle);
    case Word::scallop_wave:
      return set(scene::Wave::scallop);
    case Word::cubic_wave:
      return set(scene::Wave::cubic);
    case Word::poly_wave:
      set(scene::Wave::poly);
      pattern.exponent = to_float(parser.parse_optional_float(pattern.exponent));
      return true;
    default:
      return false;
  }
}

// exterior and interior: of fractals with a type and a factor, of pavements with one number.
void parse_exterior(Parser& parser, Pattern& pattern, PatternOwner owner) {
  parser.next();
  if (auto* tiles = std::get_if<scene::PavementParams>(&pattern.params.edit())) {
    tiles->exterior = parser.parse_int();
    return;
  }
  scene::FractalParams& params = fractal(parser, pattern, Word::exterior);
  params.exterior_type = parser.parse_int();
  const int last = owner == PatternOwner::function ? 6 : 8;
  if (params.exterior_type < 0 || params.exterior_type > last)
    parser.error(Code::bad_value,
                 "Invalid fractal pattern exterior type. Valid types are 0 to " + std::to_string(last) + ".");
  parser.optional_comma();
  params.exterior_factor = parser.parse_float();
}

void parse_interior_type(Parser& parser, Pattern& pattern) {
  parser.next();
  if (auto* tiles = std::get_if<scene::PavementParams>(&pattern.params.edit())) {
    tiles->interior = parser.parse_int();
    return;
  }
  scene::FractalParams& params = fractal(parser, pattern, Word::interior);
  params.interior_type = parser.parse_int();
  if (params.interior_type < 0 || params.interior_type > 6)
    parser.error(Code::bad_value, "Invalid fractal pattern interior type. Valid types are 0 to 6.");
  parser.optional_comma();
  params.interior_factor = parser.parse_float();
}

void parse_exponent(Parser& parser, Pattern& pattern) {
  auto* params = std::get_if<scene::FractalParams>(&pattern.params.edit());
  if (!params || params->magnet) error_only_in(parser, Word::exponent, "a mandel or julia statement");
  parser.next();
  params->exponent = parser.parse_int();
  if (params->exponent < 2 || params->exponent > 33) {
    parser.warning(Code::adjusted_value, "Invalid fractal exponent: it must be 2 to 33. Using 2.");
    params->exponent = 2;
  }
}

void parse_form(Parser& parser, Pattern& pattern) {
  parser.next();
  if (auto* tiles = std::get_if<scene::PavementParams>(&pattern.params.edit())) {
    tiles->form = parser.parse_int();
    return;
  }
  params_of<scene::CrackleParams>(parser, pattern, Word::form, "a crackle or pavement statement").form =
      parser.parse_vec3();
}

void parse_metric(Parser& parser, Pattern& pattern) {
  parser.next();
  const double metric = parser.parse_vec3().x;
  if (auto* crackle = std::get_if<scene::CrackleParams>(&pattern.params.edit())) {
    crackle->metric = metric;
  } else {
    params_of<scene::FacetsParams>(parser, pattern, Word::metric, "a facets or crackle statement").metric = metric;
  }
}

scene::Turbulence& turbulence(Pattern& pattern) { return pattern.turbulence.edit(); }

// A parameter of single kinds of pattern, read as what its member is.
template <class Params, class T>
bool set(Parser& parser, Pattern& pattern, T Params::*member, std::string_view where) {
  T& value = params_of<Params>(parser, pattern, word_at(parser), where).*member;
  parser.next();
  if constexpr (std::is_same_v<T, bool>)
    value = true;  // the word alone
  else if constexpr (std::is_same_v<T, int>)
    value = parser.parse_int();
  else if constexpr (std::is_same_v<T, float>)
    value = to_float(parser.parse_float());
  else if constexpr (std::is_same_v<T, double>)
    value = parser.parse_float();
  else
    value = parser.parse_vec3();
  return true;
}

bool parse_parameter(Parser& parser, Pattern& pattern, PatternOwner owner) {
  using namespace scene;
  const auto parameter = [&](auto member, std::string_view where) { return set(parser, pattern, member, where); };
  constexpr std::string_view kPavement = "a pavement statement";
  switch (word_at(parser)) {
    case Word::agate_turb:
      return parameter(&AgateParams::turbulence, "an agate statement");
    case Word::brick_size:
      return parameter(&BrickParams::size, "a brick statement");
    case Word::mortar:
      return parameter(&BrickParams::mortar, "a brick statement");
    case Word::control0:
      return parameter(&QuiltedParams::control0, "a quilted statement");
    case Word::control1:
      return parameter(&QuiltedParams::control1, "a quilted statement");
    case Word::offset:
      return parameter(&CrackleParams::offset, "a crackle statement");
    case Word::solid:
      return parameter(&CrackleParams::solid, "a crackle statement");
    case Word::size:
      return parameter(&FacetsParams::size, "a facets statement");
    case Word::coords:
      return parameter(&FacetsParams::coords, "a facets statement");
    case Word::interpolate:
      return parameter(&DensityFileParams::interpolate, "a density_file statement");
    case Word::number_of_sides:
      return parameter(&PavementParams::sides, kPavement);
    case Word::number_of_tiles:
      return parameter(&PavementParams::tiles, kPavement);
    case Word::pattern:
      return parameter(&PavementParams::pattern, kPavement);
    case Word::form:
      parse_form(parser, pattern);
      return true;
    case Word::metric:
      parse_metric(parser, pattern);
      return true;
    case Word::exponent:
      parse_exponent(parser, pattern);
      return true;
    case Word::exterior:
      parse_exterior(parser, pattern, owner);
      return true;
    case Word::interior:
      parse_interior_type(parser, pattern);
      return true;
    default:
      return false;
  }
}

// What only another statement of a texture takes; its own items a statement has read before.
void refuse_items_of_others(Parser& parser) {
  const Word word = word_at(parser);
  switch (word) {
    case Word::color_map:
    case Word::pigment_map:
    case Word::quick_color:
      error_only_in(parser, word, "a pigment statement");
    case Word::slope_map:
    case Word::normal_map:
    case Word::bump_size:
    case Word::accuracy:
      error_only_in(parser, word, "a normal statement");
    case Word::density_map:
      error_only_in(parser, word, "a density statement");
    case Word::texture_map:
      error_only_in(parser, word, "a texture statement");
    default:
      break;
  }
}

}  // namespace

bool parse_turbulence_item(Parser& parser, scene::Turbulence& turbulence) {
  switch (word_at(parser)) {
    case Word::turbulence:
      parser.next();
      turbulence.amount = parser.parse_vec3();
      return true;
    case Word::octaves:
      parser.next();
      turbulence.octaves = std::clamp(parser.parse_int(), 1, 10);
      return true;
    case Word::omega:
      parser.next();
      turbulence.omega = to_float(parser.parse_float());
      return true;
    case Word::lambda:
      parser.next();
      turbulence.lambda = to_float(parser.parse_float());
      return true;
    default:
      return false;
  }
}

bool parse_pattern_modifier(Parser& parser, Pattern& pattern, PatternOwner owner) {
  switch (word_at(parser)) {
    case Word::translate:
    case Word::rotate:
    case Word::scale:
    case Word::matrix:
    case Word::transform: {
      Transform item;
      parse_transform_item(parser, item);
      pattern.prepend(item);
      return true;
    }
    case Word::turbulence:
    case Word::octaves:
    case Word::omega:
    case Word::lambda:
      return parse_turbulence_item(parser, turbulence(pattern));
    case Word::warp:
      pattern.prepend(parse_warp(parser));
      return true;
    case Word::frequency:
      parser.next();
      pattern.frequency = to_float(parser.parse_float());
      return true;
    case Word::phase:
      parser.next();
      pattern.phase = to_float(parser.parse_float());
      return true;
    case Word::noise_generator: {
      parser.next();
      const int generator = parser.parse_int();
      if (generator < 0 || generator > 3)
        parser.error(Code::bad_value, "Noise generator is 0 (the scene's), 1, 2 or 3.");
      pattern.noise_generator |= generator;  // repeated ones are combined (spec 05 5.4)
      return true;
    }
    default:
      if (parse_wave(parser, pattern) || parse_parameter(parser, pattern, owner)) return true;
      if (owner != PatternOwner::function) refuse_items_of_others(parser);
      return false;
  }
}

void check_pattern(Parser& parser, const Pattern& pattern) {
  const auto* tiles = std::get_if<scene::PavementParams>(&*pattern.params);
  if (!tiles) return;
  constexpr int kTriangles[] = {1, 1, 1, 3, 4, 12}, kSquares[] = {1, 1, 2, 5, 12, 35}, kHexagons[] = {1, 1, 3, 7, 22};
  if (tiles->sides != 3 && tiles->sides != 4 && tiles->sides != 6)
    parser.error(Code::bad_value, "Pavement: number_of_sides must be 3, 4 or 6.");
  const int most = tiles->sides == 6 ? 5 : 6;
  if (tiles->tiles < 1 || tiles->tiles > most)
    parser.error(Code::bad_value, "Pavement: number_of_tiles must be between 1 and " + std::to_string(most) + ".");
  const int patterns = (tiles->sides == 3 ? kTriangles : tiles->sides == 4 ? kSquares : kHexagons)[tiles->tiles - 1];
  if (tiles->pattern < 1 || tiles->pattern > patterns)
    parser.error(Code::bad_value, "Pavement: pattern must be between 1 and " + std::to_string(patterns) + ".");
}

}  // namespace verisim::parser
