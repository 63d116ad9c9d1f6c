// A part of this thread's hit list: queries nest (clips, bounds, CSG) and each takes the end of one growing list,
// so nothing is allocated per ray.
#pragma once

#include "tracer/shapes/shape.h"

namespace verisim::shapes {

HitList& thread_hits();

class ScratchHits {
 public:
  ScratchHits() : hits_(thread_hits()), begin_(hits_.size()) {}
  ~ScratchHits() { hits_.resize(begin_); }
  ScratchHits(const ScratchHits&) = delete;
  ScratchHits& operator=(const ScratchHits&) = delete;

  HitList& list() { return hits_; }  // append only; what stands before begin() belongs to callers
  std::size_t begin() const { return begin_; }
  std::size_t end() const { return hits_.size(); }
  Hit& operator[](std::size_t i) { return hits_[i]; }

 private:
  HitList& hits_;
  const std::size_t begin_;
};

}  // namespace verisim::shapes
