// What POV-Ray ends with an error for when it is evaluated.
#pragma once

#include <utility>

namespace verisim::textures {

// Noted by the thread that evaluates, which goes on, since functions may be native code; whoever asked makes an error
// of it.
template <class Which>
class EvaluationFault {
 public:
  static void note() { noted_ = true; }
  // True once after this thread evaluated such a thing.
  static bool take() { return std::exchange(noted_, false); }

 private:
  static inline constinit thread_local bool noted_ = false;
};

// uv_mapping means something on surfaces only: asked for where there is none, in a sky_sphere, media or a function of
// SDL (spec 05 11.3). The point in space is taken.
using MissingSurface = EvaluationFault<struct MissingSurfaceFault>;
// A bump_map or facets that another normal statement left a normal_map (spec 05 10.5). The normal is left as it is.
using UnusableNormal = EvaluationFault<struct UnusableNormalFault>;

}  // namespace verisim::textures
