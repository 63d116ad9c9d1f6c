// Every block of SDL: one function a keyword family, each in a file of its name. The opening keyword is at the cursor
// unless noted.
#pragma once

#include "parser/language/parser.h"

namespace verisim::parser {

// One top-level statement (object, camera, global_settings, ...). False: the next token starts none (the caller reports
// it).
bool parse_statement(Parser& parser);
// The value of #declare/#local when it is a block: pigment{}, texture{} layers, objects, maps, transform{} ... nullopt:
// not a block.
std::optional<Value> parse_block_value(Parser& parser);

std::shared_ptr<scene::Object> parse_object(Parser& parser);  // null: no object starts here
scene::PigmentPtr parse_pigment(Parser& parser);              // pigment { ... }
// pigment { ... } of a sky or a function: #default does not reach it.
scene::PigmentPtr parse_independent_pigment(Parser& parser);
scene::NormalPtr parse_normal(Parser& parser);
scene::Finish parse_finish(Parser& parser, const scene::Finish& start);
scene::TexturePtr parse_texture(Parser& parser);  // one texture { ... }
scene::DensityPtr parse_density(Parser& parser);
scene::Media parse_media(Parser& parser);
// interior { ... }; a second one goes on from the earlier.
scene::InteriorPtr parse_interior(Parser& parser, const scene::InteriorPtr& earlier = nullptr);
Transform parse_transform(Parser& parser);  // transform { ... } or transform ID
bool parse_transform_item(Parser& parser,
                          Transform& item);  // translate, rotate, scale, matrix, transform: one item; false: none here
scene::Camera parse_camera(Parser& parser);
scene::Fog parse_fog(Parser& parser);
scene::Rainbow parse_rainbow(Parser& parser);
scene::SkySphere parse_sky_sphere(Parser& parser);
void parse_global_settings(Parser& parser);
void parse_default(Parser& parser);  // #default { ... }; the directive word is consumed
scene::Pattern parse_pattern_body(
    Parser& parser);  // inside function { pattern { ... } }: after the opening brace, up to the closing one

// Checks that POV-Ray makes when the whole scene has been read; call once at the end of the main file.
void finish_scene(Parser& parser);

}  // namespace verisim::parser
