// Shapes of which POV-Ray keeps one hit only, outside CSG: where that is nearer than a shadow ray begins, all that lies
// behind it is lost, and light comes through (spec 03 4.15).
#pragma once

#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

// How near the hit that is kept may be.
constexpr double kFirstHit = 1e-4;

template <class Sink>
bool keeps_first_hit(const Sink& sink) {
  if constexpr (Sink::kNearest) return sink.lower() > kFirstHit && !sink.clipped_from_outside();
  return false;
}

// Reports the first one of the hits that `intersections` reports to the sink it is given.
template <class Sink, class Intersections>
void add_first_hit(const Shape& shape, const Guards* guards, Sink& sink, Intersections&& intersections) {
  Hit first;
  NearestHit nearest(shape, guards, kFirstHit, sink.upper(), first);
  intersections(nearest);
  if (nearest.found())
    sink.add(
        first.t, [&] { return first.point; }, first.part, first.u, first.v);
}

}  // namespace verisim::shapes
