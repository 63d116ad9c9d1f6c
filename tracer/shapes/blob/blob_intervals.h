// A ray through a blob: the pieces that lie within reach of a part, and the intervals between their ends.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tracer/shapes/blob/blob_packet.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes::blob {

inline constexpr double kShortest = 1e-10;  // of a interval, beside all of them

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
    const bool flat = part->kind == BlobPartKind::cylinder;
    const double a = flat ? d.x * d.x + d.y * d.y : part->moved ? dot(d, d) : span * span;
    const double b = flat ? q.x * d.x + q.y * d.y : dot(q, d), c = flat ? q.x * q.x + q.y * q.y : dot(q, q);
    power[4] = part->k0 * a * a;
    power[3] = 4 * part->k0 * b * a;
    power[2] = 2 * part->k0 * (2 * b * b + a * c) + part->k1 * a;
    power[1] = 2 * b * (2 * part->k0 * c + part->k1);
    power[0] = c * (part->k0 * c + part->k1) + part->k2;
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

// The field less the threshold between the ends of pieces, from near to far: POV-Ray's running sum, to which pieces are
// added where they begin, and from which they are taken where they end. The ray's parameter is rescaled to 0 .. 1.
class Intervals {
 public:
  // Pieces get their powers when they are come to.
  Intervals(const LocalRay& ray, const Event* events, std::size_t count, Piece* pieces, double threshold)
      : events_(events),
        pieces_(pieces),
        count_(count),
        scale_(ray.scale),
        start(std::max(events[0].t, 0.0)),
        span(events[count - 1].t - start),
        origin_(ray.origin + start * ray.direction),
        direction_(span * ray.direction) {
    power[0] = -threshold;
  }

  // The next one with any piece.
  bool next() {
    for (; next_ + 1 < count_; ++next_) {
      update(events_[next_]);
      from = (events_[next_].t - start) / span;
      to = (events_[next_ + 1].t - start) / span;
      while (to - from < kShortest && next_ + 2 < count_) {
        update(events_[++next_]);
        to = (events_[next_ + 1].t - start) / span;
      }
      if (active_ == 0) continue;
      ++next_;
      return true;
    }
    return false;
  }

  // Of a place, in the world.
  double depth(double place) const { return (place * span + start) / scale_; }

 private:
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
  double scale_;

 public:
  double start, span;
  double from = 0, to = 0;
  double power[5] = {};  // constant term first
  double peak = 0;       // no more than this is the field, but for rounding

 private:
  Vec3 origin_, direction_;
};

}  // namespace verisim::shapes::blob
