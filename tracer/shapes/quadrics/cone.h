// Which cones are cylinders: shared by the shape and by what asks about the room within it (spec 03 4.3).
#pragma once

#include "tracer/scene/object.h"

namespace verisim::shapes {

bool cone_is_cylinder(const scene::Cone& cone);

}  // namespace verisim::shapes
