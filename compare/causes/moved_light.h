// Where a light must be so that it makes of the surfaces in view what another picture shows of it.
#pragma once

#include <optional>

#include "compare/causes/case.h"
#include "tracer/math/vec.h"

namespace verisim::compare {

// Of each pixel, as PixelTags::Surfaces; `normal` is zero where no surface is to be judged.
struct SeenSurfaces {
  Pixels point, normal, diffuse;
};

struct MovedLight {
  Vec3 position;
  Pixels light;  // linear: what it adds to each pixel, nothing where it is hidden
};

// `light` is what the light at `from` adds to each pixel, `wanted` what it has to add, both linear. Diffuse light goes
// with the cosine of its direction; a pixel that is dark where light is expected is in a shadow. Nothing where no other
// position is clearly better.
std::optional<MovedLight> moved_light(const Vec3& from, const Pixels& light, const Pixels& wanted,
                                      const SeenSurfaces& surfaces);

}  // namespace verisim::compare
