// blob { [threshold T] components } (spec 03 4.13).
#include <cmath>

#include "parser/scene/objects.h"
#include "parser/scene/textures/texture.h"

namespace verisim::parser {

using scene::BlobComponent;

namespace {

constexpr std::size_t kMaxComponents = 1000000;  // a cylinder counts for three (spec 03 4.13)

// What POV-Ray does to a sphere's own numbers as long as it has no matrix.
bool absorb(BlobComponent& sphere, Word word, const Transform& move) {
  const Affine& m = move.m;
  if (sphere.cylinder || sphere.transform) return false;
  if (word == Word::translate)
    sphere.a += Vec3(m[3][0], m[3][1], m[3][2]);
  else if (word == Word::rotate)
    sphere.a = move.point(sphere.a);
  else if (word == Word::scale && m[0][0] == m[1][1] && m[0][0] == m[2][2])
    sphere.a *= m[0][0], sphere.radius *= std::fabs(m[0][0]);
  else
    return false;
  sphere.b = sphere.a;
  return true;
}

bool parse_component_modifier(Parser& parser, BlobComponent& component, scene::Rare<Transform>& solid_steps) {
  Transform item;
  const Word word = word_at(parser);
  if (parse_transform_item(parser, item)) {
    if (!absorb(component, word, item))
      component.transform = component.transform ? component.transform->then(item) : item;
    component.texture = scene::transformed(component.texture, item);
    if (component.texture && scene::ends_in_solid_color(*component.texture))
      solid_steps = solid_steps ? solid_steps->then(item) : item;
    return true;
  }
  if (parser.at(Word::texture)) {
    add_layers(parser, component.texture, parse_texture(parser));
    solid_steps = {};
    return true;
  }
  return parse_texture_part(parser, component.texture, &solid_steps);
}

BlobComponent parse_component(Parser& parser, bool cylinder) {
  Block block(parser);
  BlobComponent component;
  component.cylinder = cylinder;
  component.a = parser.parse_vec3();
  parser.optional_comma();
  component.b = component.a;
  if (cylinder) {
    component.b = parser.parse_vec3();
    parser.optional_comma();
    if (length(component.b - component.a) < kEpsilon)
      parser.error(Code::degenerate, "Degenerate cylindrical component in blob.");
  }
  component.radius = parser.parse_float();
  parser.optional_comma();
  parser.accept(Word::strength);
  component.strength = parser.parse_float();
  scene::Rare<Transform> solid_steps;
  while (parse_component_modifier(parser, component, solid_steps)) {
  }
  block.close();
  return component;
}

// component strength radius <center>: the oldest form.
BlobComponent parse_old_component(Parser& parser) {
  parser.next();
  BlobComponent component;
  component.strength = parser.parse_float();
  parser.optional_comma();
  component.radius = parser.parse_float();
  parser.optional_comma();
  component.a = component.b = parser.parse_vec3();
  return component;
}

// As a blob's statement ends, POV-Ray copies its texture, and a copy of a solid colour has neither its transformations
// nor its turbulence: a pattern that a later pigment { } makes of it does not have them (spec 08 E).
void settle_color(scene::Object& blob) {
  blob.solid_steps = {};
  if (!blob.texture || !scene::ends_in_solid_color(*blob.texture)) return;
  auto pigment = std::make_shared<scene::Pigment>(*blob.texture->layers.back().pigment);
  if (pigment->pattern.warps.empty() && !pigment->pattern.turbulence) return;
  pigment->pattern.warps = {};
  pigment->pattern.turbulence = {};
  auto texture = std::make_shared<scene::Texture>(*blob.texture);
  texture->layers.back().pigment = std::move(pigment);
  blob.texture = std::move(texture);
}

}  // namespace

ObjectRef parse_blob(Parser& parser) {
  const ObjectRef read = shape_block(parser, [&](scene::Object& object) {
    auto blob = std::make_shared<scene::Blob>();
    std::size_t entries = 0;
    for (;;) {
      const Word word = word_at(parser);
      if (word == Word::threshold) {
        parser.next();
        blob->threshold = parser.parse_float();
      } else if (word == Word::sphere || word == Word::cylinder) {
        blob->components.push_back(parse_component(parser, word == Word::cylinder));
        entries += word == Word::cylinder ? 3 : 1;
      } else if (word == Word::component) {
        blob->components.push_back(parse_old_component(parser));
        ++entries;
      } else {
        break;
      }
      if (entries > kMaxComponents)
        parser.error(Code::too_many, "There are more than the maximum supported number of components in a blob.");
    }
    if (blob->components.empty()) parser.error(Code::too_few, "Need at least one component in a blob.");
    blob->components.shrink_to_fit();
    object.shape = std::shared_ptr<const scene::Blob>(blob);
  });
  if (!read->copied) {  // so nobody else has this blob yet
    settle_color(*read);
    auto& blob = const_cast<scene::Blob&>(**read->as<std::shared_ptr<const scene::Blob>>());
    blob.first_texture = read->texture;
    blob.hierarchy = read->hierarchy;
  }
  return read;
}

}  // namespace verisim::parser
