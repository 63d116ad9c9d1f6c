// A ray through a blob: the pieces that lie within reach of a part, and the intervals between their ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracer/shapes/blob/blob_packet.h"
#include "tracer/shapes/intersections.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes::blob {

namespace field {
using namespace one_ray;
#include "tracer/shapes/blob/blob_field.inc"
}  // namespace field

// Within reach of a part for t0 < t < t1. Of a half sphere behind the ray t0 < 0, and t1 <= 0.
struct Piece {
  double t0, t1;
  const BlobPart* part;
  double scale2;         // the square of its parameter's scale, beside the part's squared radius
  double peak = 0;       // no more than this does it add to the field, but for rounding
  double power[5] = {};  // what it adds to the field, in powers of the parameter that all pieces of a ray share

  // Finds those along origin + u direction, 0 <= u <= 1; `span` is the length of the direction.
  void expand(const Vec3& origin, const Vec3& direction, double span) {
    const Vec3 q = (part->moved ? part->transform->inverse_point(origin) : origin) - part->center;
    const Vec3 d = part->moved ? part->transform->inverse_direction(direction) : direction;
    field::field_powers(*part, q, d, span, power);
  }
};

struct Event {
  double t;
  std::int32_t piece;
  bool enters;
  const BlobPart* part;
  // Events at one place come in the order of parts: it decides the last digits of the running sum.
  bool operator<(const Event& other) const {
    if (t != other.t) return t < other.t;
    return part != other.part ? part < other.part : enters && !other.enters;
  }
};

// Some of the way of a ray, and the field less the threshold there, in powers of a place between 0 and 1.
struct Interval {
  double start, span, scale;  // a place u is at (u span + start) / scale, in the world
  double from = 0, to = 0;
  double power[5] = {};  // the constant term first

  double depth(double place) const { return (place * span + start) / scale; }
};

// The field less the threshold between the ends of pieces, from near to far: POV-Ray's running sum, to which pieces are
// added where they begin, and from which they are taken where they end. The ray's parameter is rescaled to 0 .. 1.
class Intervals : public Interval {
 public:
  // Pieces get their powers when they are come to.
  Intervals(const LocalRay& ray, const Event* events, std::size_t count, Piece* pieces, double threshold)
      : Intervals(ray, events, count, pieces, threshold, std::max(events[0].t, 0.0)) {}

  // The next one with any piece.
  bool next() {
    for (; next_ + 1 < count_; ++next_) {
      update(events_[next_]);
      from = (events_[next_].t - start) / span;
      to = (events_[next_ + 1].t - start) / span;
      while (to - from < kShortestInterval && next_ + 2 < count_) {
        update(events_[++next_]);
        to = (events_[next_ + 1].t - start) / span;
      }
      if (active_ == 0) continue;
      ++next_;
      return true;
    }
    return false;
  }

  double peak = 0;  // no more than this is the field, but for rounding

 private:
  Intervals(const LocalRay& ray, const Event* events, std::size_t count, Piece* pieces, double threshold, double first)
      : Interval{first, events[count - 1].t - first, ray.scale},
        events_(events),
        pieces_(pieces),
        count_(count),
        origin_(ray.origin + start * ray.direction),
        direction_(span * ray.direction) {
    power[0] = -threshold;
  }

  void update(const Event& event) {
    Piece& piece = pieces_[event.piece];
    if (event.enters) piece.expand(origin_, direction_, span);
    const double sign = event.enters ? 1 : -1;
    active_ += event.enters ? 1 : -1;
    for (int i = 0; i < 5; ++i) power[i] += sign * piece.power[i];
    peak += sign * piece.peak;
  }

  const Event* events_;
  Piece* pieces_;
  std::size_t count_, next_ = 0, active_ = 0;
  Vec3 origin_, direction_;
};

}  // namespace verisim::shapes::blob
