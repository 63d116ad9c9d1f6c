// translate, rotate, scale, matrix, transform (spec 03 section 1).
#include <cmath>
#include <stdexcept>

#include "parser/scene/common/common.h"
#include "parser/scene/common/transform.h"
#include "tracer/scene/transform_steps.h"

namespace verisim::parser {

Vec3 parse_scale_vector(Parser& parser) {
  Vec3 s = parser.parse_vec3();
  constexpr char kAxis[] = {'X', 'Y', 'Z'};
  for (unsigned i = 0; i < 3; ++i) {
    if (s[i] != 0) continue;
    s[i] = 1;
    parser.warning(Code::adjusted_value, std::string("Illegal Value: Scale ") + kAxis[i] + " by 0.0. Changed to 1.0.");
  }
  return s;
}

namespace {

Transform parse_matrix(Parser& parser) {
  parser.expect('<');
  Mat4 m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) {
      m[row][column] = parser.parse_float();
      parser.optional_comma();
    }
  }
  parser.expect('>');
  for (int column = 0; column < 3; ++column) {
    if (std::fabs(m[0][column]) < kEpsilon && std::fabs(m[1][column]) < kEpsilon &&
        std::fabs(m[2][column]) < kEpsilon) {
      m[column][column] = 1;
      parser.warning(Code::adjusted_value, "Illegal matrix column: Scale by 0.0. Changed to 1.0.");
    }
  }
  try {
    return Transform::from_matrix(m);
  } catch (const std::domain_error&) {
    parser.error(Code::domain_error, "Singular matrix: it cannot be inverted.");
  }
}

}  // namespace

bool parse_transform_item(Parser& parser, Transform& item) {
  switch (word_at(parser)) {
    case Word::translate:
      parser.next();
      item = Transform::translation(parser.parse_vec3());
      return true;
    case Word::rotate:
      parser.next();
      item = Transform::rotation(parser.parse_vec3());
      return true;
    case Word::scale:
      parser.next();
      item = Transform::scaling(parse_scale_vector(parser));
      return true;
    case Word::matrix:
      parser.next();
      item = parse_matrix(parser);
      return true;
    case Word::transform:
      item = parse_transform(parser);
      return true;
    default:
      return false;
  }
}

Transform parse_transform(Parser& parser) {
  const Parser::Depth depth(parser);
  parser.expect(Word::transform);
  if (const auto* value = parser.accept_value<Shared<Transform>>()) return **value;
  if (!parser.accept('{')) parser.error_expected("transform identifier or {");
  Transform result;
  bool inverted = false;
  for (;;) {
    Transform item;
    if (const auto* value = parser.accept_value<Shared<Transform>>()) {
      result = result.then(**value);
    } else if (parse_transform_item(parser, item)) {
      result = result.then(item);
    } else if (parser.accept(Word::inverse)) {
      inverted = true;  // the whole block, wherever the word stands
    } else {
      break;
    }
  }
  close_block(parser);
  if (!inverted) return result;
  try {
    return {Transform::from_matrix(result.m.whole()).inv, Transform::from_matrix(result.inv.whole()).inv};
  } catch (const std::domain_error&) {
    parser.error(Code::domain_error, "Singular matrix: it cannot be inverted.");
  }
}

void move_while_read(scene::Object& object, const scene::TransformSteps& steps) {
  scene::apply(object, steps);
  if (object.texture && !object.uv_mapping && scene::ends_in_solid_color(*object.texture))
    steps.add_to(object.solid_steps, 0);
}

bool parse_object_transform(Parser& parser, scene::Object& object) {
  const auto parse_into = [&](scene::TransformSteps& steps) {
    switch (word_at(parser)) {
      case Word::translate:
        parser.next();
        steps.translate(parser.parse_vec3());
        return true;
      case Word::rotate:
        parser.next();
        steps.rotate(parser.parse_vec3());
        return true;
      case Word::scale:
        parser.next();
        steps.scale(parse_scale_vector(parser));
        return true;
      case Word::matrix:
      case Word::transform: {
        Transform item;
        parse_transform_item(parser, item);
        steps.transform(item);
        return true;
      }
      default:
        return false;
    }
  };
  scene::TransformSteps steps;
  while (!steps.full() && parse_into(steps)) {
  }
  if (!steps.size()) return false;
  move_while_read(object, steps);
  return true;
}

}  // namespace verisim::parser
