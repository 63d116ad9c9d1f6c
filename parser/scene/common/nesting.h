// Limits to how deep declared pigments, normals, densities and textures may stand in one another's maps, and objects in
// one another. Written out, the nesting of blocks is limited by the parser; but a loop can declare a pigment with a map
// of itself, or a union of two copies of itself, any number of times.
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

// An error at the cursor when objects are within objects deeper than kMaxObjectLevels, or when there would be more of
// them, with their copies written out, than fit into --max-memory.
constexpr int kMaxObjectLevels = 10000;
void check_nesting(Parser& parser, const scene::Object& object);
// The same for how many objects a scene has.
void check_object_count(Parser& parser, double objects);

}  // namespace verisim::parser
