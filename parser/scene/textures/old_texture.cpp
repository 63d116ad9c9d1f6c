// Items of pigments, normals and finishes that stand in the texture itself, as before version 3.0 (spec 05 section 13).
#include "parser/scene/common/common.h"
#include "parser/scene/textures/maps.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::Normal;
using scene::Pigment;

namespace {

void belongs_into(Parser& parser, Word word, const char* statement) {
  if (parser.version() >= 150) return;
  parser.warning(Code::misplaced_keyword,
                 "Found '" + std::string(spelling(word)) + "' that should be in a " + statement + " statement.");
}

bool at_single_number(Parser& parser) {
  if (!parser.at_number_start() || parser.at('<')) return false;
  if (const Value* value = parser.peek_value()) {
    const auto* number = std::get_if<Numeric>(value);
    return number && number->terms == 1;
  }
  return parser.peek().kind != TokenKind::word || word_class(word_at(parser)) == WordClass::float_function;
}

// A number that follows nothing.
bool parse_crand(Parser& parser, scene::TextureLayer& layer) {
  if (!at_single_number(parser)) return false;
  layer.finish.edit().crand = to_float(parser.parse_float());
  if (parser.version() > 150) parser.warning(Code::discontinued, "Should use crand keyword in finish statement.");
  return true;
}

std::shared_ptr<Normal> copy_of(const scene::NormalPtr& normal) {
  return normal ? std::make_shared<Normal>(*normal) : std::make_shared<Normal>();
}

// Bumps and the like with their amount; a bump map has none.
scene::NormalPtr parse_old_bumps(Parser& parser, const scene::NormalPtr& start) {
  const bool bump_map = parser.at(Word::bump_map);
  const std::shared_ptr<Normal> normal = copy_of(start);
  parse_normal_type(parser, *normal);
  if (!bump_map) normal->amount = to_float(parser.parse_float());
  return normal;
}

bool parse_old_normal(Parser& parser, scene::NormalPtr& normal) {
  const Word word = word_at(parser);
  switch (word) {
    case Word::bumps:
    case Word::dents:
    case Word::ripples:
    case Word::waves:
    case Word::wrinkles:
    case Word::bump_map:
      belongs_into(parser, word, "normal");
      normal = parse_old_bumps(parser, normal);
      return true;
    case Word::frequency:
    case Word::phase: {
      belongs_into(parser, word, "normal");
      const std::shared_ptr<Normal> changed = copy_of(normal);
      parse_pattern_modifier(parser, changed->pattern, PatternOwner::normal);
      normal = changed;
      return true;
    }
    default:
      return false;
  }
}

// One number each: no colors, blocks, backs or albedo, and none of the items that came with later versions.
bool parse_old_finish(Parser& parser, scene::Finish& finish) {
  const Word word = word_at(parser);
  const auto number = [&parser] {
    parser.next();
    return to_float(parser.parse_float());
  };
  switch (word) {
    case Word::ambient:
      finish.ambient = Rgb(number());
      break;
    case Word::diffuse:
      finish.diffuse = finish.raw_diffuse = number();
      break;
    case Word::ior:
      finish.ior = number();
      break;
    case Word::metallic:
      parser.next();
      finish.metallic = 1;
      break;
    case Word::reflection:
      finish.reflection.minimum = finish.reflection.maximum = Rgb(number());
      break;
    case Word::refraction:
      finish.refraction = number();
      break;
    default: {
      float* const member = finish_number(finish, word);
      if (!member) return false;
      *member = number();
    }
  }
  belongs_into(parser, word, "finish");
  return true;
}

bool of_version_1(Word pattern) {
  switch (pattern) {
    case Word::color:
    case Word::agate:
    case Word::bozo:
    case Word::checker:
    case Word::gradient:
    case Word::granite:
    case Word::hexagon:
    case Word::image_map:
    case Word::leopard:
    case Word::mandel:
    case Word::marble:
    case Word::onion:
    case Word::spotted:
    case Word::wood:
      return true;
    default:
      return false;
  }
}

// The pattern alone: the wave stays what it was (a ramp, for marble and wood, too), and a fractal is 0 everywhere.
bool parse_old_type(Parser& parser, Pigment& pigment) {
  const scene::Wave wave = pigment.pattern.wave;
  if (!parse_pigment_type(parser, pigment)) return false;
  pigment.pattern.wave = wave;
  if (auto* fractal = std::get_if<scene::FractalParams>(&pigment.pattern.params.edit())) {
    fractal->exterior_type = 0;
    fractal->exterior_factor = fractal->interior_factor = 0;
  }
  return true;
}

bool parse_old_pigment_item(Parser& parser, Pigment& pigment) {
  const Word word = at_color(parser) ? Word::color : word_at(parser);
  switch (word) {
    case Word::turbulence:
    case Word::octaves:
    case Word::omega:
    case Word::lambda:
      return parse_turbulence_item(parser, pigment.pattern.turbulence.edit());
    case Word::color_map:
      pigment.color_map = parse_color_map(parser);
      pigment.pigment_map = nullptr;
      break;
    case Word::quick_color:
      parser.next();
      pigment.quick_color = parser.parse_color();
      break;
    default:
      if (!of_version_1(word) || !parse_old_type(parser, pigment)) return false;
  }
  belongs_into(parser, word, "pigment");
  return true;
}

bool parse_old_pigment(Parser& parser, scene::PigmentPtr& pigment) {
  if (word_at(parser) == Word::none && !at_color(parser)) return false;
  auto changed = std::make_shared<Pigment>(*pigment);
  if (!parse_old_pigment_item(parser, *changed)) return false;
  pigment = changed;
  return true;
}

}  // namespace

bool parse_old_item(Parser& parser, scene::TextureLayer& layer) {
  if (parser.at(Word::uv_mapping)) return false;
  if (parse_crand(parser, layer) || parse_old_normal(parser, layer.normal)) return true;
  scene::Finish finish = layer.finish;
  if (parse_old_finish(parser, finish)) {
    layer.finish = finish;
    return true;
  }
  return parse_old_pigment(parser, layer.pigment);
}

}  // namespace verisim::parser
