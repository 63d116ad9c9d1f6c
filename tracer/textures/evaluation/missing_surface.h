// uv_mapping means something on surfaces only. Asked for where there is none, in a sky_sphere, media or a function of
// SDL, POV-Ray ends with an error (spec 05 11.3).
#pragma once

#include <utility>

namespace verisim::textures {

// Evaluation goes on with the point in space, since functions may be native code; whoever asked makes an error of it.
class MissingSurface {
 public:
  static void note() { missing_ = true; }
  // True once after this thread evaluated such a thing.
  static bool take() { return std::exchange(missing_, false); }

 private:
  static inline constinit thread_local bool missing_ = false;
};

}  // namespace verisim::textures
