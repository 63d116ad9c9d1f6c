// Radiosity's rays in wavefronts: what surfaces show to each other (spec 07 sections 2.6 and 2.11).
#include <algorithm>
#include <utility>

#include "tracer/shading/wavefront/wavefront.h"

namespace verisim::shading {

bool Wavefront::can_gather() const {
  const double bailout = scene_.scene.settings.radiosity.adc_bailout;
  return usable_ && bailout >= 0 && bailout < 1;
}

void Wavefront::add_gathering(const Ray& ray, RandomSource::Key key, const shapes::Hit* hit, FinalGatherNotes& notes) {
  const int i = gathering_++;
  packet_.rays.origin.set(i, ray.origin), packet_.rays.direction.set(i, ray.direction);
  keys_[i] = key;
  found_[i] = hit != nullptr;
  if (hit) hits_[i] = *hit;
  notes_[i] = &notes;
}

void Wavefront::shade_gathering(const RayState& common, Color* out) {
  if (tracer_.cancel_ && tracer_.cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  state_ = common;
  std::fill_n(weights_, gathering_, common.weight);
  shade(std::exchange(gathering_, 0), out);
}

}  // namespace verisim::shading
