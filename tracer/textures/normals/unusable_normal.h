// A bump_map or facets that another normal statement left a normal_map: where it is asked for, POV-Ray ends with an
// error (spec 05 10.5).
#pragma once

#include <utility>

namespace verisim::textures {

// Evaluation goes on without the normal; whoever asked makes an error of it (as of MissingSurface).
class UnusableNormal {
 public:
  static void note() { unusable_ = true; }
  // True once after this thread evaluated such a thing.
  static bool take() { return std::exchange(unusable_, false); }

 private:
  static inline constinit thread_local bool unusable_ = false;
};

}  // namespace verisim::textures
