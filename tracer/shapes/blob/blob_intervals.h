// A ray through a blob: the pieces that lie within reach of a part, and the intervals between their ends.
#pragma once

#include <cmath>
#include <cstdint>

#include "tracer/shapes/blob/blob_packet.h"

namespace verisim::shapes::blob {

inline constexpr double kShortest = 1e-10;  // of a interval, beside all of them

// Within reach of a part for t0 < t < t1.
struct Piece {
  double t0, t1;
  const BlobPart* part;
  double scale2;         // the square of its parameter's scale, beside the part's squared radius
  double peak = 0;       // no more than this does it add to the field, but for rounding
  double power[5] = {};  // what it adds to the field, in powers of the parameter that all pieces of a ray share
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
  // `pieces`: with their powers.
  Intervals(const Event* events, std::size_t count, const Piece* pieces, double threshold)
      : events_(events), pieces_(pieces), count_(count), start(events[0].t), span(events[count - 1].t - start) {
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

 private:
  void update(const Event& event) {
    const Piece& piece = pieces_[event.piece];
    const double sign = event.enters ? 1 : -1;
    active_ += event.enters ? 1 : -1;
    for (int i = 0; i < 5; ++i) power[i] += sign * piece.power[i];
    peak += sign * piece.peak;
  }

  const Event* events_;
  const Piece* pieces_;
  std::size_t count_, next_ = 0, active_ = 0;

 public:
  double start, span;
  double from = 0, to = 0;
  double power[5] = {};  // constant term first
  double peak = 0;       // no more than this is the field, but for rounding
};

}  // namespace verisim::shapes::blob
