#include "cli/describe/contributions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tracer/shading/tracer.h"

namespace verisim::cli {

std::string light_name(const shading::Light& light) {
  const scene::LightSource& source = light.source();
  const char* kind = source.area                             ? "area_light"
                     : source.parallel && !source.has_beam() ? "parallel light"
                                                             : scene::info(source.kind).words;
  return fmt::format("{} at <{:.4g}, {:.4g}, {:.4g}>", kind, source.position.x, source.position.y, source.position.z);
}

Rgb Contributions::share(const Rgb& light) const {
  const Frame& frame = open_.back();
  Rgb out = frame.filter * light;
  for (float weight : frame.weights) out *= weight;
  return out;
}

void Contributions::add(const std::string& kind, const std::string& name, const Rgb& light) {
  if (light != Rgb()) open_.back().terms[{kind, name}] += light;
}

void Contributions::ray_started(const shading::RayState& ray, const shapes::Hit* hit) {
  Frame& frame = open_.emplace_back();
  frame.hit = hit != nullptr, frame.reflected = ray.reflected, frame.gather = ray.gather;
}

void Contributions::layer(const shading::SurfaceHit&, const shading::LayerContext& layer, const Rgb&) {
  if (!open_.empty()) open_.back().filter = layer.filter;
}

void Contributions::light(const shading::Light& light, const shading::LightDirection&, bool, const Rgb&,
                          const Rgb& added, const Rgb& highlight) {
  if (open_.empty()) return;
  add("light", light_name(light), share(added));
  add("highlights", "phong and specular", share(highlight));
  open_.back().known += share(added);
}

void Contributions::indirect(const char* effect, const Rgb& light) {
  if (open_.empty()) return;
  add(effect, "", share(light));
  open_.back().known += share(light);
}

void Contributions::texture_started(float weight) {
  if (!open_.empty()) open_.back().weights.push_back(weight);
}

void Contributions::texture_ended() {
  if (!open_.empty() && !open_.back().weights.empty()) open_.back().weights.pop_back();
}

// A secondary ray's terms count as much as its colour does.
void Contributions::rays_added(const Rgb& seen) {
  if (open_.empty()) return;
  Frame& frame = open_.back();
  std::vector<Frame> rays = std::exchange(frame.rays, {});
  std::erase_if(rays, [](const Frame& ray) { return ray.gather; });
  Rgb added = seen, all;
  for (float weight : frame.weights) added *= weight;
  frame.known += added;
  if (rays.empty()) return;
  for (const Frame& ray : rays) all += ray.color;
  const auto scaled = [&](const Rgb& term) {
    const auto one = [](float t, float a, float s) { return s > 1e-9f ? t * a / s : 0.0f; };
    return Rgb(one(term.r, added.r, all.r), one(term.g, added.g, all.g), one(term.b, added.b, all.b));
  };
  const char* way = rays.back().reflected ? "reflection" : "transparency";
  for (const Frame& ray : rays)
    for (const auto& [key, term] : ray.terms) {
      if (key.first == way || key.first == "light elsewhere") continue;
      add(key.first, key.second, scaled(term));
      if (key.first == "light") add("light elsewhere", key.second, scaled(term));
    }
  add(way, "", added);
}

void Contributions::air(const Color& without, const Color& with, float passed) {
  if (open_.empty()) return;
  Frame& frame = open_.back();
  for (auto& [key, term] : frame.terms) term *= passed;
  frame.known *= passed, frame.air *= passed;
  frame.air += with.rgb() - without.rgb() * passed;
}

void Contributions::ray_ended(const shading::RayState&, const Color& color) {
  if (open_.empty()) return;
  Frame& frame = open_.back();
  frame.color = color.rgb();
  if (frame.hit)
    add("own light", "ambient and emission", frame.color - frame.air - frame.known);
  else
    add("background", "sky", frame.color - frame.air);
  add(air_, "", frame.air);
  frame.rays.clear();
  Frame done = std::move(open_.back());
  open_.pop_back();
  if (!open_.empty()) {
    open_.back().rays.push_back(std::move(done));
  } else {
    pixel_ = std::move(done.terms);
  }
}

void Contributions::take() {
  constexpr float kNothing = 1e-6f;
  for (const auto& [key, light] : pixel_) {
    if (light.max_abs() < kNothing) continue;
    std::vector<float>& plane = planes_[key];
    plane.resize(3 * pixels_);
    plane.insert(plane.end(), {light.r, light.g, light.b});
  }
  ++pixels_;
  pixel_.clear(), open_.clear();
}

std::vector<compare::PixelTags::Part> Contributions::parts() const {
  std::vector<compare::PixelTags::Part> out;
  for (const auto& [key, plane] : planes_) {
    out.push_back({key.first, key.second, plane});
    out.back().light.resize(3 * pixels_);
  }
  return out;
}

}  // namespace verisim::cli
