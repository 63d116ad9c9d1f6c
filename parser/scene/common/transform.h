// Transformations of blocks and objects.
#pragma once

#include "parser/language/blocks.h"
#include "tracer/scene/transform_steps.h"

namespace verisim::parser {

// The vector after `scale`; zeros become 1 with a warning.
Vec3 parse_scale_vector(Parser& parser);
// Moves an object whose statement goes on: a pattern that is still to come may go the same way (Object::solid_steps).
void move_while_read(scene::Object& object, const scene::TransformSteps& steps);
// One transformation, applied to the object at once (shapes absorb elementary ones into their numbers). False: none
// here.
bool parse_object_transform(Parser& parser, scene::Object& object);

}  // namespace verisim::parser
