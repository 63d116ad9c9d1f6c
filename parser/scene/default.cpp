// #default { ... } (spec 01 section 21).
#include "parser/scene/camera.h"
#include "parser/scene/common/common.h"
#include "parser/scene/textures/pattern.h"
#include "parser/scene/textures/texture.h"

namespace verisim::parser {

void parse_default(Parser& parser) {
  const Parser::Depth depth(parser);
  parser.expect('{');
  for (;;) {
    if (parser.at(Word::texture)) {
      const scene::TexturePtr texture = in_block(parser, [&] { return parse_texture_body(parser, true); });
      if (texture->patterned()) parser.error(Code::incompatible, "Default texture cannot be material map or tiles.");
      if (texture->layers.size() > 1) parser.error(Code::incompatible, "Default texture cannot be layered.");
      parser.default_texture() = texture;
    } else if (parse_texture_part(parser, parser.default_texture())) {
      continue;
    } else if (parser.accept(Word::radiosity)) {
      parser.expect('{');
      while (parser.accept(Word::importance)) {
        const double importance = parser.parse_float();
        if (!(importance > 0 && importance <= 1))
          parser.error(Code::bad_value, "Radiosity importance must be greater than 0 and not larger than 1.");
        parser.scene().settings.radiosity.default_importance = importance;
      }
      close_block(parser);
    } else if (parser.at(Word::camera)) {
      parser.default_camera() = parse_camera(parser, parser.default_camera());
    } else {
      break;
    }
  }
  close_block(parser);
}

}  // namespace verisim::parser
