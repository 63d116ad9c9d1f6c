// Limits to how deep declared pigments, normals, densities and textures may stand in one another's maps. Written out,
// the nesting of blocks is limited by the parser; but a loop can declare a pigment with a map of itself any number of
// times.
#pragma once

#include "parser/language/blocks.h"

namespace verisim::parser {

// An error at the cursor when maps are nested deeper than --max-depth, or when one point could need more than
// kMaxEvaluations evaluations: twice as many with every level, if a map holds the level before twice.
constexpr double kMaxEvaluations = 1e7;
void check_nesting(Parser& parser, const scene::Pigment& pigment);
void check_nesting(Parser& parser, const scene::Normal& normal);
void check_nesting(Parser& parser, const scene::Density& density);
void check_nesting(Parser& parser, const scene::Texture& texture);

}  // namespace verisim::parser
