#include "tracer/render/evaluation_watch.h"

#include <stdexcept>
#include <string>

#include "tracer/film/errors.h"
#include "tracer/shading/tracer.h"
#include "tracer/textures/evaluation/evaluation_faults.h"

namespace verisim::render {

EvaluationWatch::EvaluationWatch(const std::atomic<bool>* cancel) : cancel_(cancel), end_(cancel) {
  functions::EvaluationBudget::take_overrun(), textures::MissingSurface::take(),
      textures::UnusableNormal::take();  // of what this thread did before
}

// Neither has a place: which function or pigment it was is not known.
void EvaluationWatch::check() const {
  if (textures::MissingSurface::take())
    throw std::runtime_error(
        "uv_mapping was asked for where there is no surface: in a sky_sphere, media or a function");
  if (textures::UnusableNormal::take())
    throw std::runtime_error(
        "a normal of type bump_map or facets has the normal_map of another normal statement or of #default: write its "
        "type and its map in one statement");
  if (!functions::EvaluationBudget::take_overrun()) return;
  if (cancel_ && cancel_->load(std::memory_order_relaxed)) throw shading::Cancelled();
  throw LimitExceeded("A function of the scene needs more than " + std::to_string(functions::kMaxPasses) +
                      " passes of sum and prod and calls of functions for one value: more than a picture has time for");
}

}  // namespace verisim::render
