// interior { ... } and material { ... } (spec 06 section 6, 03 section 6.4).
#include "parser/scene/interior.h"

#include "parser/scene/common/common.h"
#include "parser/scene/textures/texture.h"

namespace verisim::parser {

using scene::Interior;

scene::InteriorPtr parse_interior(Parser& parser, const scene::InteriorPtr& earlier) {
  Block block(parser);
  // A second statement goes on from the first; an identifier replaces all of it.
  auto interior = earlier ? std::make_shared<Interior>(*earlier) : std::make_shared<Interior>();
  if (const auto* value = parser.accept_value<Shared<Interior>>()) *interior = **value;
  bool ior_given = interior->ior_given;
  const auto number = [&](float& target) {
    parser.next();
    target = to_float(parser.parse_float());
  };
  for (;;) {
    switch (word_at(parser)) {
      case Word::ior:
        number(interior->ior);
        ior_given = interior->ior != 0;
        if (!ior_given) interior->ior = 1;
        continue;
      case Word::dispersion:
        number(interior->dispersion);
        continue;
      case Word::dispersion_samples:
        parser.next();
        interior->dispersion_samples = parser.parse_int();
        if (interior->dispersion_samples < 2) parser.error(Code::bad_value, "Dispersion samples minimum is 2.");
        continue;
      case Word::caustics:
        number(interior->caustics);
        interior->caustics *= 45;
        continue;
      case Word::fade_distance:
        number(interior->fade_distance);
        continue;
      case Word::fade_power:
        number(interior->fade_power);
        continue;
      case Word::fade_color:
        parser.next();
        interior->fade_color = parser.parse_rgb();
        continue;
      case Word::refraction:
        number(interior->refraction);
        parser.warning(
            Code::discontinued,
            "Refraction value unnecessary to turn on refraction. To attenuate, use fade_power and fade_distance in "
            "'interior'.");
        continue;
      case Word::media:
        interior->media.push_back(parse_media(parser));
        continue;
      default:
        break;
    }
    break;
  }
  block.close();
  interior->ior_given = ior_given;
  return interior;
}

Material parse_material(Parser& parser, const Material& earlier) {
  Block block(parser);
  Material material = earlier;
  // An identifier adds its layers to what is there, but replaces the interior, by none if it has none.
  if (const auto* value = parser.accept_value<Shared<Material>>()) {
    if ((*value)->texture) {
      add_layers(parser, material.texture, (*value)->texture);
      material.solid_steps = (*value)->solid_steps;
    }
    if ((*value)->interior_texture) add_layers(parser, material.interior_texture, (*value)->interior_texture);
    material.interior = (*value)->interior;
  }
  for (;;) {
    Transform item;
    if (parser.at(Word::texture)) {
      add_layers(parser, material.texture, parse_texture(parser));
      material.solid_steps = {};
    } else if (parser.at(Word::interior_texture)) {
      add_layers(parser, material.interior_texture, parse_texture(parser));
    } else if (parser.at(Word::interior)) {
      material.interior = parse_interior(parser, material.interior);
    } else if (parse_transform_item(parser, item)) {
      if (material.texture && scene::ends_in_solid_color(*material.texture))
        material.solid_steps = material.solid_steps ? material.solid_steps->then(item) : item;
      material.texture = scene::transformed(material.texture, item);
      // The interior_texture stays where it is (spec 05 11).
      if (material.interior) {
        material.interior = std::make_shared<Interior>(*material.interior);
        for (scene::Media& media : material.interior->media) transform_media(media, item);
      }
    } else {
      break;
    }
  }
  block.close();
  if (material.interior_texture && !material.texture)
    parser.error(Code::missing_item, "Interior texture requires an exterior texture.");
  return material;
}

}  // namespace verisim::parser
