// height_field { image [water_level L] [smooth] } (spec 04 section 5).
#include "parser/scene/objects.h"
#include "parser/scene/textures/pattern.h"
#include "tracer/shapes/heights/height_map.h"

namespace verisim::parser {

ObjectRef parse_height_field(Parser& parser) {
  return shape_block(parser, [&](scene::Object& object) {
    auto field = std::make_shared<scene::HeightField>();
    if (const ImagePtr image = parse_image(parser, ImageUse::height_field).image)
      field->map = shapes::height_map(*image);
    for (;;) {
      if (parser.accept(Word::water_level)) {
        field->water_level = parser.parse_float();
        if (parser.version() < 200) field->water_level /= 256;
      } else if (parser.accept(Word::smooth)) {
        field->smooth = true;
      } else {
        break;
      }
    }
    object.shape = std::shared_ptr<const scene::HeightField>(field);
  });
}

}  // namespace verisim::parser
