// What shows in the mirrors of a wave: the reflected rays are a wave, too.
#include "tracer/shading/finish.h"
#include "tracer/shading/wave.h"

namespace verisim::shading {
namespace {

constexpr int kFewest = 3;   // rays that are worth a wave
constexpr int kDeepest = 8;  // levels of waves: each has its own room

}  // namespace

RayState Wave::ray_state(int i) const {
  RayState ray = state_;
  ray.ray = lanes_.rays.at(i);
  ray.weight = weights_[i];
  return ray;
}

// Traces those that are the only one of their ray: where there are several, random numbers of one would follow those of another.
void Wave::trace_mirrors() {
  if (mirrors_.size() < kFewest || state_.level >= kDeepest) return;
  int of_ray[kMost], alone[kMost], n = 0;
  std::fill_n(of_ray, kMost, 0);
  for (const Mirror& mirror : mirrors_) ++of_ray[mirror.ray];
  for (std::size_t i = 0; i < mirrors_.size(); ++i)
    if (of_ray[mirrors_[i].ray] == 1 && met_[mirrors_[i].ray].together) alone[n++] = static_cast<int>(i);
  if (n >= kFewest) trace_mirrored(alone, n);
}

void Wave::trace_mirrored(const int* mirrors, int count) {
  if (!reflected_) reflected_ = std::make_unique<Wave>(tracer_);
  Wave& child = *reflected_;
  child.state_ = state_;
  child.state_.primary = false;
  child.state_.reflected = true;
  child.state_.level = state_.level + 1;
  int traced[kMost], n = 0;
  tracer_.statistics_.reflected_rays += static_cast<std::uint64_t>(count);
  for (int k = 0; k < count; ++k) {
    Mirror& mirror = mirrors_[static_cast<std::size_t>(mirrors[k])];
    const SurfaceHit& at = *met_[mirror.ray].at;
    mirror.seen = true;
    mirror.color = Rgb();
    child.state_.weight = weights_[mirror.ray] * mirror.layer.translucency * tracer_.mirror_strength(mirror.layer);
    if (tracer_.cut_off(child.state_)) continue;
    child.weights_[n] = child.state_.weight;
    child.places_[n] = places_[mirror.ray];
    child.numbers_[n] = numbers_[mirror.ray];
    child.lanes_.rays.origin.set(n, at.hit.point);
    child.lanes_.rays.direction.set(n, reflected_direction(lanes_.rays.direction.at(mirror.ray), mirror.layer.normal, at.raw));
    traced[n++] = mirrors[k];
  }
  const accel::WorldEntry* const unknown[kMost] = {};
  Color colors[kMost];
  if (n > 0) child.run(n, unknown, colors);
  for (int k = 0; k < n; ++k) mirrors_[static_cast<std::size_t>(traced[k])].color = colors[k].rgb();
}

void Wave::add_mirrored(const Leaf& leaf, Rgb& color) {
  bool drawing = false;
  for (int k = leaf.first; k >= 0; k = parts_[static_cast<std::size_t>(k)].next) {
    const int i = parts_[static_cast<std::size_t>(k)].mirror;
    if (i < 0) continue;
    const Mirror& mirror = mirrors_[static_cast<std::size_t>(i)];
    if (mirror.seen) {
      color += tracer_.mirror_image(mirror.layer, mirror.color);
    } else {
      if (!drawing) begin_sample(leaf.ray);
      drawing = true;
      color += tracer_.mirrored(ray_state(leaf.ray), *met_[leaf.ray].at, mirror.layer);
    }
  }
}

}  // namespace verisim::shading
