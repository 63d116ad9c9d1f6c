// text { ttf "font" "string" depth, offset } (spec 04 section 9).
#include "parser/scene/objects.h"

namespace verisim::parser {

ObjectRef parse_text(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto text = std::make_shared<scene::Text>();
    std::string font;
    if (parser.accept(Word::ttf)) {
      font = parser.parse_path();
    } else if (parser.accept(Word::internal)) {
      text->builtin_font = parser.parse_int();
      // Any other number means the font of the logo (spec 04 section 9).
      if (text->builtin_font < 1 || text->builtin_font > 3) text->builtin_font = 4;
    } else {
      parser.error_expected("ttf or internal");
    }
    parser.optional_comma();
    text->text = parser.parse_string();
    text->unicode = parser.charset() != Parser::Charset::ascii;
    parser.optional_comma();
    text->thickness = parser.parse_float();
    parser.optional_comma();
    text->offset = parser.parse_vec3();
    parser.peek();  // POV-Ray looks for the font here: a missing one is an error of the line that follows
    if (!text->builtin_font) text->font = parser.find_font(font);
    object.shape = std::shared_ptr<const scene::Text>(text);
  });
}

}  // namespace verisim::parser
