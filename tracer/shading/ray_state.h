// What a ray carries through the recursion (spec 06 section 2.1).
#pragma once

#include "tracer/math/vec.h"
#include "tracer/shapes/shape.h"

namespace verisim::shading {

// The interiors a ray is inside, newest last: a part of its Tracer's stack (Tracer::interiors).
struct InteriorRange {
  std::uint32_t begin = 0, count = 0;
};

// What a radiosity ray learns on its way of the samples that are asked for along it.
struct FinalGatherNotes {
  float quality = 1;  // the worst of the answers
  // Of what the last ray of the last sample that was taken on the way hit first; below 0: none was taken. POV-Ray
  // weighs a ray by it (measured with 3.7.0.10).
  float importance = -1;
  // The importance that the last ray of the last sample asked for, which rays that start from the same surface ask for,
  // too (spec 07 2.6); below 0: none was taken.
  float threshold = -1;
};

struct RayState {
  Ray ray;
  InteriorRange interiors;
  bool hollow = true;  // every interior in the list belongs to hollow objects
  bool primary = true;
  bool reflected = false, refracted = false;  // sticky
  bool continuation = false;                  // goes straight on through a surface: does not raise the level
  bool monochromatic = false;
  bool volumes = true;       // sees media, fog and rainbows (radiosity gather rays may not)
  bool gather = false;       // radiosity: area lights as points, no highlights, background without alpha
  bool direct_light = true;  // false: only what emits (radiosity pretrace without vain direct lighting)
  float wavelength = 0;      // nm, when monochromatic
  float weight = 1;          // importance for adc_bailout
  int level = 0;
  int level_limit = 5;  // max_trace_level, or what a gather ray is allowed
  // Radiosity bookkeeping of whoever started this ray; inherited by all descendants.
  int gather_depth = 0;
  FinalGatherNotes* notes = nullptr;

  // Of the surface that it meets, 1 for what the camera sees: max_trace_level counts these.
  int surface_level() const { return level + (continuation ? 0 : 1); }

  // What goes on from a surface on this ray's way.
  RayState spawn(const Ray& onward, int level_of_surface, float child_weight) const {
    RayState child = *this;
    child.ray = onward, child.level = level_of_surface, child.weight = child_weight;
    child.primary = child.continuation = false;
    return child;
  }

  shapes::RayKind kind() const {
    using shapes::RayKind;
    if (reflected) return gather ? RayKind::radiosity_reflected : RayKind::reflected;
    if (gather) return refracted ? RayKind::radiosity_refracted : RayKind::radiosity;
    return primary ? RayKind::camera : RayKind::refracted;
  }
};

}  // namespace verisim::shading
