// Which CSG objects have an inside.
#pragma once

#include <algorithm>

#include "tracer/scene/object.h"

namespace verisim::scene {

// False: a patch, or a light source that shows none with an inside, is among its parts; one is enough to deny a CSG
// object its inside. An inverted one has an inside whatever its parts are (spec 03 5.1).
inline bool has_only_solid_parts(const Object& object) {
  if (const auto* light = object.as<LightSource>())
    return light->projected_through || (light->looks_like && has_only_solid_parts(*light->looks_like));
  if (is_patch(object)) return false;
  if (!object.as<Csg>() || object.inverted) return true;
  return std::ranges::all_of(declared_children(object),
                             [](const ObjectPtr& part) { return has_only_solid_parts(*part); });
}

}  // namespace verisim::scene
