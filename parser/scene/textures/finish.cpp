// finish { ... } (spec 06 section 4.1).
#include <cmath>
#include <utility>

#include "parser/scene/common/common.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

using scene::Finish;

namespace {

// Which amounts were written as albedo, once or last: they are scaled when the block ends, with its final exponents.
struct Albedo {
  bool diffuse = false, phong = false, specular = false;
};

void parse_reflection(Parser& parser, scene::Reflection& reflection) {
  parser.next();
  if (!parser.accept('{')) {
    reflection.minimum = reflection.maximum = parser.parse_rgb();
    reflection.falloff = 1;
    reflection.fresnel = false;
    return;
  }
  bool two_colors = false, fresnel_written = false;
  if (parser.at_number_start() || parser.at_color_keyword()) {
    reflection.minimum = reflection.maximum = parser.parse_rgb();
    parser.accept(',');  // also before what is no color
    if (parser.at_number_start() || parser.at_color_keyword()) {
      reflection.maximum = parser.parse_rgb();
      two_colors = true;
    }
  } else {
    reflection.minimum = reflection.maximum = Rgb();
  }
  for (;;) {
    switch (word_at(parser)) {
      case Word::fresnel: {
        parser.next();
        const double fresnel = parser.parse_optional_float(1);
        if (!(fresnel >= 0 && fresnel <= 1)) parser.error(Code::bad_value, "fresnel must be true or false.");
        reflection.fresnel = fresnel_written = fresnel > 0;
        continue;
      }
      case Word::falloff:
        parser.next();
        reflection.falloff = to_float(parser.parse_float());
        continue;
      case Word::exponent:
        parser.next();
        reflection.exponent = to_float(parser.parse_float());
        continue;
      case Word::metallic:
        parser.next();
        reflection.metallic = to_float(parser.parse_optional_float(1));
        continue;
      default:
        break;
    }
    break;
  }
  // Not where it is an earlier block's.
  if (fresnel_written && !two_colors) reflection.minimum = Rgb();
  close_block(parser);
}

void parse_irid(Parser& parser, Finish& finish) {
  parser.next();
  parser.expect('{');
  finish.irid = to_float(parser.parse_float());
  for (;;) {
    if (parser.accept(Word::thickness)) {
      finish.irid_thickness = to_float(parser.parse_float());
    } else if (parser.accept(Word::turbulence)) {
      finish.irid_turbulence = to_float(parser.parse_vec3().x);
    } else {
      break;
    }
  }
  close_block(parser);
}

void parse_subsurface(Parser& parser, Finish& finish) {
  finish.place = parser.place();
  parser.next();
  parser.expect('{');
  parser.warning(Code::experimental, "subsurface is an experimental feature of POV-Ray.");
  finish.subsurface = true;
  for (;;) {
    if (parser.accept(Word::translucency)) {
      finish.translucency = parser.parse_rgb();
    } else if (parser.accept(Word::anisotropy)) {
      finish.anisotropy = parser.parse_rgb();
    } else {
      break;
    }
  }
  close_block(parser);
}

void parse_diffuse(Parser& parser, Finish& finish, Albedo& albedo) {
  parser.next();
  albedo.diffuse = parser.accept(Word::albedo) || albedo.diffuse;
  finish.diffuse = to_float(parser.parse_float());
  finish.diffuse_back = 0;
  if (accept_comma_or_number(parser)) finish.diffuse_back = to_float(parser.parse_float());
  if (finish.diffuse_back != 0)
    parser.warning(Code::experimental, "Diffuse reflection on the back is an experimental feature of POV-Ray.");
}

void warn_compatibility(Parser& parser, const char* keyword) {
  parser.warning(Code::misplaced_keyword,
                 std::string("'") + keyword +
                     "' belongs into the interior of an object; in a finish it is kept for compatibility only.");
}

bool parse_number(Parser& parser, Finish& finish, Word word, Albedo& albedo) {
  float* const number = finish_number(finish, word);
  if (!number) return false;
  parser.next();
  if (word == Word::phong) albedo.phong = parser.accept(Word::albedo) || albedo.phong;
  if (word == Word::specular) albedo.specular = parser.accept(Word::albedo) || albedo.specular;
  *number = to_float(parser.parse_float());
  if (word == Word::roughness && *number == 0) parser.warning(Code::adjusted_value, "Zero roughness used.");
  return true;
}

bool parse_item(Parser& parser, Finish& finish, Albedo& albedo) {
  const auto optional_number = [&](std::optional<float>& target, const char* keyword) {
    parser.next();
    target = to_float(parser.parse_float());
    warn_compatibility(parser, keyword);
    return true;
  };
  const Word word = word_at(parser);
  switch (word) {
    case Word::ambient:
      parser.next();
      finish.ambient = parser.parse_rgb();
      return true;
    case Word::emission:
      parser.next();
      finish.emission = parser.parse_rgb();
      return true;
    case Word::diffuse:
      parse_diffuse(parser, finish, albedo);
      return true;
    case Word::metallic:
      parser.next();
      finish.metallic = to_float(parser.parse_optional_float(1));
      return true;
    case Word::reflection:
      parse_reflection(parser, finish.reflection);
      return true;
    case Word::reflection_exponent:
      parser.next();
      finish.reflection.exponent = to_float(parser.parse_float());
      return true;
    case Word::irid:
      parse_irid(parser, finish);
      return true;
    case Word::conserve_energy:
      parser.next();
      finish.conserve_energy = true;
      return true;
    case Word::subsurface:
      parse_subsurface(parser, finish);
      return true;
    case Word::ior:
      return optional_number(finish.ior, "ior");
    case Word::caustics:
      return optional_number(finish.caustics, "caustics");
    case Word::refraction:
      return optional_number(finish.refraction, "refraction");
    default:
      return parse_number(parser, finish, word, albedo);
  }
}

void scale_albedo(Finish& finish, const Albedo& albedo) {
  finish.raw_diffuse = finish.diffuse;
  finish.raw_diffuse_back = finish.diffuse_back;
  if (albedo.diffuse) {
    const double factor = (finish.brilliance + 1.0) / 2.0;
    finish.diffuse = to_float(finish.diffuse * factor);
    finish.diffuse_back = to_float(finish.diffuse_back * factor);
  }
  if (albedo.phong) finish.phong = to_float(finish.phong * (finish.phong_size + 1.0) / 2.0);
  if (albedo.specular) {
    const double n = finish.roughness != 0 ? 1.0 / finish.roughness : 0.0;
    finish.specular = to_float(finish.specular * (n + 2.0) / (4.0 * (2.0 - std::pow(2.0, -n / 2.0))));
  }
}

}  // namespace

float* finish_number(Finish& finish, Word word) {
  constexpr std::pair<Word, float Finish::*> kNumbers[] = {
      {Word::brilliance, &Finish::brilliance}, {Word::crand, &Finish::crand},
      {Word::phong, &Finish::phong},           {Word::phong_size, &Finish::phong_size},
      {Word::roughness, &Finish::roughness},   {Word::specular, &Finish::specular}};
  for (const auto& [item, member] : kNumbers)
    if (item == word) return &(finish.*member);
  return nullptr;
}

scene::Finish parse_finish(Parser& parser, const scene::Finish& start) {
  Block block(parser);
  Finish finish = start;
  if (const auto* value = parser.accept_value<Shared<Finish>>()) finish = **value;
  Albedo albedo;
  while (parse_item(parser, finish, albedo)) {
  }
  scale_albedo(finish, albedo);
  block.close();
  return finish;
}

}  // namespace verisim::parser
