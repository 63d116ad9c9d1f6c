// Materials and transformations of media.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

Material parse_material(Parser& parser);
// Transforms the densities that a medium has so far (spec 07 4.1).
void transform_media(scene::Media& media, const Transform& t);

}  // namespace verisim::parser
