// background, fog, rainbow, sky_sphere (spec 06 section 11).
#include <cmath>

#include "parser/scene/atmosphere.h"
#include "parser/scene/common/common.h"
#include "parser/scene/textures/maps.h"
#include "parser/scene/textures/pattern.h"

namespace verisim::parser {

Color parse_background(Parser& parser) {
  return in_block(parser, [&] { return parser.at('}') ? Color() : parser.parse_color(); });
}

scene::Fog parse_fog(Parser& parser) {
  Block block(parser);
  scene::Fog fog;
  if (const auto* value = parser.accept_value<Shared<scene::Fog>>()) fog = **value;
  const auto turbulence = [&]() -> scene::Turbulence& {
    if (!fog.turbulence) fog.turbulence.emplace();
    return *fog.turbulence;
  };
  const auto number = [&](double& target) {
    parser.next();
    target = parser.parse_float();
  };
  for (;;) {
    if (at_color(parser)) {
      fog.color = parser.parse_color();
      continue;
    }
    switch (word_at(parser)) {
      case Word::distance:
        number(fog.distance);
        continue;
      case Word::fog_type:
        parser.next();
        fog.type = parser.parse_int();
        if (fog.type != 1 && fog.type != 2) {
          parser.warning(Code::bad_value, "Unknown fog type.");
          fog.type = 1;
        }
        continue;
      case Word::fog_alt:
        number(fog.altitude);
        continue;
      case Word::fog_offset:
        number(fog.offset);
        continue;
      case Word::turb_depth:
        number(fog.turbulence_depth);
        continue;
      case Word::turbulence:
      case Word::octaves:
      case Word::omega:
      case Word::lambda:
        parse_turbulence_item(parser, turbulence());
        continue;
      case Word::up:
        parser.next();
        fog.up = parser.parse_vec3();
        if (!(length(fog.up) >= kEpsilon)) parser.error(Code::bad_value, "The up vector of fog must not be zero.");
        fog.up = normalize(fog.up);
        continue;
      case Word::translate:
        parser.next();
        parser.parse_vec3();
        parser.warning(Code::incompatible, "A fog's up-vector can't be translated.");
        continue;
      default:
        break;
    }
    Transform item;
    if (parse_transform_item(parser, item)) {
      fog.up = normalize(item.direction(fog.up));
      continue;
    }
    if (parser.at_number_start()) {
      fog.distance = parser.parse_float();
      if (parser.version() > 150)
        parser.warning(Code::discontinued, "Should use keyword 'distance' in a fog statement.");
      continue;
    }
    break;
  }
  block.close();
  return fog;
}

scene::Rainbow parse_rainbow(Parser& parser) {
  Block block(parser);
  scene::Rainbow rainbow;
  if (const auto* value = parser.accept_value<Shared<scene::Rainbow>>()) rainbow = **value;
  const auto number = [&](double& target) {
    parser.next();
    target = parser.parse_float();
  };
  const auto angle = [&](std::optional<double>& target, const char* name) {
    parser.next();
    target = parser.parse_float();
    if (!(*target >= 0 && *target <= 360))
      parser.error(Code::bad_value, std::string("The ") + name + " of a rainbow must be between 0 and 360 degrees.");
  };
  for (;;) {
    switch (word_at(parser)) {
      case Word::direction:
        parser.next();
        rainbow.direction = parser.parse_vec3();
        continue;
      case Word::up:
        parser.next();
        rainbow.up = parser.parse_vec3();
        continue;
      case Word::angle:
        number(rainbow.angle);
        continue;
      case Word::width:
        number(rainbow.width);
        continue;
      case Word::distance:
        number(rainbow.distance);
        continue;
      case Word::jitter:
        number(rainbow.jitter);
        continue;
      case Word::arc_angle:
        angle(rainbow.arc_angle, "arc_angle");
        continue;
      case Word::falloff_angle:
        angle(rainbow.falloff_angle, "falloff_angle");
        continue;
      case Word::color_map: {
        auto pigment = std::make_shared<scene::Pigment>();
        pigment->pattern.kind = scene::PatternKind::gradient;
        pigment->pattern.params = scene::GradientParams{Vec3(1, 0, 0)};
        pigment->color_map = parse_color_map(parser);
        rainbow.colors = pigment;
        continue;
      }
      default:
        break;
    }
    break;
  }
  block.close();
  if (length(rainbow.direction) < kEpsilon) parser.error(Code::bad_value, "Rainbow's direction vector is zero.");
  if (length(rainbow.up) < kEpsilon) parser.error(Code::bad_value, "Rainbow's up vector is zero.");
  if (length(cross(normalize(rainbow.up), normalize(rainbow.direction))) < kEpsilon)
    parser.error(Code::bad_value, "Rainbow's direction and up vectors are co-linear.");
  if (rainbow.arc_angle && rainbow.falloff_angle && *rainbow.arc_angle < *rainbow.falloff_angle)
    parser.error(Code::bad_value, "Rainbow's arc angle is smaller than its falloff angle.");
  return rainbow;
}

scene::SkySphere parse_sky_sphere(Parser& parser) {
  Block block(parser);
  scene::SkySphere sky;
  if (const auto* value = parser.accept_value<Shared<scene::SkySphere>>()) sky = **value;
  for (;;) {
    Transform item;
    if (parser.at(Word::pigment)) {
      sky.pigments.push_back(parse_independent_pigment(parser));
    } else if (parser.accept(Word::emission)) {
      sky.emission = parser.parse_rgb();
    } else if (parse_transform_item(parser, item)) {
      sky.transform = sky.transform.then(item);
    } else {
      break;
    }
  }
  block.close();
  if (sky.pigments.empty()) parser.error(Code::missing_item, "Sky_sphere without pigment.");
  return sky;
}

}  // namespace verisim::parser
