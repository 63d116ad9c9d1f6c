// Patterns: keywords with their parameters, and the modifiers that pigments, normals, textures and densities share
// (spec 05 sections 2 to 9).
#pragma once

#include <functional>

#include "parser/language/blocks.h"

namespace verisim::parser {

enum class PatternOwner : unsigned char { pigment, normal, texture, density, function };

// Reads the entries of checker, brick, object ...; the argument is how many there can be.
using ListReader = std::function<void(int)>;

// A pattern keyword with its parameters. False: the next token is none that `owner` can have; nothing is consumed.
bool parse_pattern_type(Parser& parser, scene::Pattern& pattern, PatternOwner owner, const ListReader& read_list);
// One modifier that every owner has: transformation, warp, turbulence, wave ... False: none here.
bool parse_pattern_modifier(Parser& parser, scene::Pattern& pattern, PatternOwner owner);
// At the end of the statement: ranges that depend on several modifiers.
void check_pattern(Parser& parser, const scene::Pattern& pattern);
// checker, brick ...: patterns whose entries are a list. 0: none of them.
int list_size(scene::PatternKind kind);

scene::Warp parse_warp(Parser& parser);  // warp { ... }
// turbulence, octaves, omega or lambda. False: none of them.
bool parse_turbulence_item(Parser& parser, scene::Turbulence& turbulence);

enum class ImageUse : unsigned char { image_map, image_pattern, bump_map, material_map, height_field };
// Inside the braces of image_map and the like (spec 05 section 12); stops at the first token that is no image item.
// `bump_size`, if not null, receives the number of that keyword.
scene::ImageParams parse_image(Parser& parser, ImageUse use, float* bump_size = nullptr);

// Body of a pigment, normal, texture or density: items up to the first token that is none. `start` is what is modified.
scene::PigmentPtr parse_pigment_body(Parser& parser, const scene::PigmentPtr& start);
scene::NormalPtr parse_normal_body(Parser& parser, const scene::NormalPtr& start);
scene::TexturePtr parse_texture_body(Parser& parser, bool is_default = false);
scene::DensityPtr parse_density_body(Parser& parser);
// What the pigments of skies, pigment functions and pigment patterns start from: #default does not reach them.
const scene::PigmentPtr& blank_pigment();
// A color, a pattern or a bump map alone, without modifiers. False: none of them.
bool parse_pigment_type(Parser& parser, scene::Pigment& pigment);
bool parse_normal_type(Parser& parser, scene::Normal& normal);
// `no_bump_scale` at the cursor: the scene is told that it has one (tracer/textures/compile/shared_maps.cpp). False:
// none.
bool parse_no_bump_scale(Parser& parser);
// Whole blocks that modify something.
scene::PigmentPtr parse_pigment(Parser& parser, const scene::PigmentPtr& start);
scene::NormalPtr parse_normal(Parser& parser, const scene::NormalPtr& start);

// Before 3.0: one item of a pigment, normal or finish that stands in the texture itself (old_texture.cpp). False: none.
bool parse_old_item(Parser& parser, scene::TextureLayer& layer);

// The member that an item of a finish sets which is one number, in all versions. Null: no such item.
float* finish_number(scene::Finish& finish, Word word);

// Up to version 3.1: what a pigment becomes in a layer that is not the bottom one (old_layers.cpp).
scene::PigmentPtr filter_to_transmit(const scene::PigmentPtr& pigment);

// What map entries and new statements start from: the parts of the default texture. A copy, for `#default` may stand in
// the midst of any of them.
scene::TextureLayer default_layer(Parser& parser);

}  // namespace verisim::parser
