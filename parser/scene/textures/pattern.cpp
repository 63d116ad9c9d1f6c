// Pattern keywords and their parameters (spec 05 sections 2, 8 and 9).
#include "parser/scene/textures/pattern.h"

#include <cmath>

#include "parser/scene/common/common.h"
#include "tracer/image/density_file.h"

namespace verisim::parser {

using scene::Pattern;
using scene::PatternInfo;
using scene::PatternKind;

namespace {

// The pattern that a word names; none: no pattern does.
PatternKind kind_of(Word word) {
  switch (word) {
#define VERISIM_PATTERN(name, params, list, traits) \
  case Word::name:                                  \
    return PatternKind::name;
    VERISIM_PATTERNS_WITH_KEYWORD(VERISIM_PATTERN)
#undef VERISIM_PATTERN
    default:
      return PatternKind::none;
  }
}

bool allowed(PatternKind kind, PatternOwner owner) {
  const PatternInfo& info = scene::info(kind);
  if (info.is(PatternInfo::kNormalsOnly)) return owner == PatternOwner::normal;
  if (info.is(PatternInfo::kPigmentsOnly)) return owner == PatternOwner::pigment;
  return owner != PatternOwner::function || !info.is(PatternInfo::kNotInFunctions);
}

void set_kind(Pattern& pattern, PatternKind kind) {
  // A brick that follows a brick keeps its sizes (spec 08 E); any other pattern starts from its own defaults.
  const bool keep = kind == PatternKind::brick && pattern.kind == PatternKind::brick;
  pattern.kind = kind;
  if (!keep) pattern.params.reset();
  const PatternInfo& info = scene::info(kind);
  if (info.is(PatternInfo::kNoFrequency)) pattern.frequency = 0;
  if (info.is(PatternInfo::kTriangleWave)) pattern.wave = scene::Wave::triangle;
  if (scene::PatternParams defaults = default_params(kind); !keep && defaults.index() != 0)
    pattern.params = std::move(defaults);
}

scene::SlopeParams parse_slope(Parser& parser) {
  scene::SlopeParams slope;
  if (!parser.accept('{')) {
    slope.direction = parser.parse_vec3();
  } else {
    slope.point_at = parser.accept(Word::point_at);
    slope.direction = parser.parse_vec3();
    const auto range = [&parser](double& low, double& high) {
      if (!accept_comma_or_number(parser)) return;
      low = parser.parse_float();
      parser.optional_comma();
      high = parser.parse_float();
      if (low == high && low != 0) {
        parser.warning(Code::adjusted_value, "Zero slope range, ignoring.");
        low = high = 0;
      }
    };
    range(slope.slope_low, slope.slope_high);
    if (parser.accept(Word::altitude)) {
      if (slope.point_at) parser.error(Code::incompatible, "'altitude' cannot be used together with 'point_at'.");
      slope.altitude = parser.parse_vec3();
      parser.warning(Code::experimental, "A slope pattern with altitude is an experimental feature of POV-Ray.");
      range(slope.altitude_low, slope.altitude_high);
    }
    close_block(parser);
  }
  if (!slope.point_at && length(slope.direction) == 0 && length(slope.altitude) == 0)
    parser.error(Code::bad_value, "Zero length for both slope and gradient.");
  return slope;
}

Vec2 parse_complex(Parser& parser) {
  const Vec2 result = parser.parse_vec2();
  parser.optional_comma();
  return result;
}

// mandel N, julia <a,b>, N, magnet 1|2 followed by one of them.
void parse_fractal(Parser& parser, Pattern& pattern) {
  scene::FractalParams fractal;
  const bool magnet = parser.accept(Word::magnet);
  if (magnet) {
    fractal.magnet = parser.parse_int();
    if (fractal.magnet != 1 && fractal.magnet != 2)
      parser.error(Code::bad_value, "Invalid magnet type: it must be 1 or 2.");
  }
  PatternKind kind = PatternKind::none;
  if (parser.accept(Word::mandel)) {
    kind = magnet ? PatternKind::magnet_mandel : PatternKind::mandel;
  } else if (parser.accept(Word::julia)) {
    kind = magnet ? PatternKind::magnet_julia : PatternKind::julia;
    fractal.julia = parse_complex(parser);
  } else {
    parser.error_expected("mandel or julia");
  }
  fractal.iterations = parser.parse_int();
  set_kind(pattern, kind);
  pattern.params = fractal;
}

void parse_density_file(Parser& parser, Pattern& pattern) {
  parser.expect(Word::df3);
  const std::string name = parser.parse_path();
  if (const auto memory = parser.memory_file(name); memory && memory->voxels()) {
    pattern.params = *memory->voxels();
    return;
  }
  const std::filesystem::path path = parser.find_file(name);
  scene::DensityFileParams density;
  try {
    density = load_density_file(path);
  } catch (const std::runtime_error& failure) {
    parser.error(Code::bad_file, failure.what());
  }
  pattern.params = density;
}

scene::TilingParams parse_tiling(Parser& parser) {
  const int number = parser.parse_int();
  if (number < 1 || number > 27) parser.error(Code::bad_value, "Tiling number must be between 1 and 27.");
  return {number};
}

scene::PigmentPatternParams parse_pigment_pattern(Parser& parser) {
  parser.expect('{');
  scene::PigmentPatternParams params{parse_pigment_body(parser, blank_pigment())};
  close_block(parser);
  return params;
}

void parse_object_pattern(Parser& parser, Pattern& pattern, const ListReader& read_list) {
  parser.expect('{');
  std::shared_ptr<scene::Object> object = parse_object(parser);
  if (!object) parser.error_expected("object");
  scene::complete(*object);
  pattern.params = scene::ObjectParams{object};
  read_list(2);
  close_block(parser);
}

scene::ImageParams parse_image_block(Parser& parser, ImageUse use) {
  parser.expect('{');
  scene::ImageParams image = parse_image(parser, use);
  close_block(parser);
  return image;
}

}  // namespace

int list_size(PatternKind kind) { return scene::info(kind).list; }

bool parse_pattern_type(Parser& parser, Pattern& pattern, PatternOwner owner, const ListReader& read_list) {
  const Word word = word_at(parser);
  const PatternKind named = kind_of(word);
  if (word == Word::none || !allowed(named, owner)) return false;
  const Parser::Depth depth(parser);
  if (scene::info(named).is(PatternInfo::kBare)) {
    parser.next();
    set_kind(pattern, named);
    if (const int size = list_size(named)) read_list(size);
    return true;
  }
  const auto take = [&](PatternKind kind) {
    parser.next();
    set_kind(pattern, kind);
  };
  switch (word) {
    case Word::gradient: {
      take(PatternKind::gradient);
      pattern.params = scene::GradientParams{parser.parse_vec3()};
      return true;
    }
    case Word::spiral1:
    case Word::spiral2:
      take(word == Word::spiral1 ? PatternKind::spiral1 : PatternKind::spiral2);
      pattern.params = scene::SpiralParams{static_cast<std::int16_t>(parser.parse_int())};
      return true;
    case Word::slope:
      take(PatternKind::slope);
      pattern.params = parse_slope(parser);
      return true;
    case Word::tiling:
      take(PatternKind::tiling);
      pattern.params = parse_tiling(parser);
      return true;
    case Word::mandel:
    case Word::julia:
    case Word::magnet:
      parse_fractal(parser, pattern);
      return true;
    case Word::function:
      take(PatternKind::function);
      if (!parser.at('{')) parser.error_expected("{");  // always in x, y, z
      pattern.params = scene::FunctionParams{parser.parse_function_body()};
      return true;
    case Word::density_file:
      take(PatternKind::density_file);
      parse_density_file(parser, pattern);
      return true;
    case Word::pigment_pattern:
      take(PatternKind::pigment_pattern);
      pattern.params = parse_pigment_pattern(parser);
      return true;
    case Word::object:
      take(PatternKind::object);
      parse_object_pattern(parser, pattern, read_list);
      return true;
    case Word::image_pattern:
      take(PatternKind::image_pattern);
      pattern.params = parse_image_block(parser, ImageUse::image_pattern);
      return true;
    case Word::image_map:
      take(PatternKind::image_map);
      pattern.params = parse_image_block(parser, ImageUse::image_map);
      return true;
    default:
      return false;  // bump_map, material_map and uv_mapping: their owners read them
  }
}

}  // namespace verisim::parser
