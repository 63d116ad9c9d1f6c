// Materials and transformations of media.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

// Goes on from what the object has so far.
Material parse_material(Parser& parser, const Material& earlier = {});
// Transforms the densities that a medium has so far (spec 07 4.1).
void transform_media(scene::Media& media, const Transform& t);

}  // namespace verisim::parser
