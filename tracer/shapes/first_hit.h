// Shapes of segments, through which POV-Ray goes from near to far, outside CSG until one has a hit: where that is
// nearer than a shadow ray begins, what other segments have behind it is lost, and light comes through (spec 03 4.15).
#pragma once

#include "tracer/shapes/primitive.h"

namespace verisim::shapes {

// How near the hit that ends it may be.
constexpr double kFirstHit = 1e-4;

template <class Sink>
bool keeps_first_hit(const Sink& sink) {
  if constexpr (Sink::kNearest) return sink.lower() > kFirstHit && !sink.clipped_from_outside();
  return false;
}

// search(sink, from, to) reports the hits of all segments that the ray comes to between these distances.
template <class Sink, class Search>
void add_first_hit(const Shape& shape, const Guards* guards, Sink& sink, Search&& search) {
  Hit first;
  NearestHit nearest(shape, guards, kFirstHit, sink.upper(), first);
  search(nearest, kFirstHit, sink.upper());
  if (!nearest.found()) return;
  if (first.t < sink.lower())
    search(sink, kFirstHit, first.t);
  else
    sink.add(
        first.t, [&] { return first.point; }, first.part, first.u, first.v);
}

}  // namespace verisim::shapes
