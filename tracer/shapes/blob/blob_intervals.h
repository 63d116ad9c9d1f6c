// A ray through a blob: the pieces that lie within reach of a part, and the intervals between their ends.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "tracer/shapes/blob/blob_packet.h"

namespace verisim::shapes::blob {

inline constexpr double kShortest = 1e-10;  // of a interval, beside all of them

// D = a t^2 + 2 b t + c along a ray, valid for t0 < t < t1.
struct Piece {
  double t0, t1, a, b, c;
  const BlobPart* part;
  double peak = 0;  // no more than this does it add to the field, but for rounding
  bool expanded = false;
  double power[5] =
      {};  // what it adds to the field, in powers of the parameter that all pieces of a ray share; if expanded
};

struct Event {
  double t;
  std::int32_t piece;
  bool enters;
  bool operator<(const Event& other) const { return t < other.t; }
};

// The intervals of a ray between the ends of pieces, from near to far, with the pieces that are valid there. The ray's
// parameter is rescaled to 0 .. 1.
class Intervals {
 public:
  // `active`: room for as many as there are pieces.
  Intervals(const Event* events, std::size_t count, std::int32_t* active)
      : events_(events), active_(active), count_(count), start(events[0].t), span(events[count - 1].t - start) {}

  bool valid() const { return span > 0 && std::isfinite(span); }
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
      if (active_count_ == 0) continue;
      ++next_;
      return true;
    }
    return false;
  }
  std::span<const std::int32_t> active() const { return {active_, active_count_}; }

 private:
  void update(const Event& event) {
    if (event.enters) {
      active_[active_count_++] = event.piece;
      return;
    }
    std::size_t i = 0;
    while (active_[i] != event.piece) ++i;
    active_[i] = active_[--active_count_];
  }

  const Event* events_;
  std::int32_t* active_;
  std::size_t count_, next_ = 0, active_count_ = 0;

 public:
  double start, span;
  double from = 0, to = 0;
};

}  // namespace verisim::shapes::blob
