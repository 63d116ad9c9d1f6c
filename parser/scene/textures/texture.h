// Textures of objects and materials (spec 03 5.3, 05 sections 2 and 11).
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

// Puts the layers of `added` over those of `texture` (null: nothing yet); errors when one of them is patterned.
void add_layers(Parser& parser, scene::TexturePtr& texture, const scene::TexturePtr& added);
// `pigment`, `normal` or `finish` at the cursor: changes the top layer of `texture` (null: a copy of the default
// texture). False: none of them. `moves`: what has moved that layer while its pigment was a solid colour; a new pigment
// goes on from there.
bool parse_texture_part(Parser& parser, scene::TexturePtr& texture, scene::Rare<Transform>* steps = nullptr,
                        bool* replaced = nullptr);

}  // namespace verisim::parser
