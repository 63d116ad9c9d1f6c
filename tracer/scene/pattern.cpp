#include "tracer/scene/pattern.h"

namespace verisim::scene {

void Pattern::prepend(const Transform& t) {
  if (!warps.empty()) {
    if (auto* front = std::get_if<Transform>(&warps.front())) {
      *front = front->then(t);
      return;
    }
  }
  warps.prepend(t);
}

void Pattern::prepend(Warp warp) {
  if (const auto* t = std::get_if<Transform>(&warp)) return prepend(*t);
  warps.prepend(std::move(warp));
}

}  // namespace verisim::scene
