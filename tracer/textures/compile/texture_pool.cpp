#include "tracer/textures/compile/texture_pool.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>

#include "tracer/textures/compile/pattern_signature.h"

namespace verisim::textures {
namespace {

constexpr std::size_t kPlaces = 256;

bool is_plain(const scene::Pattern& p) { return p.kind == scene::PatternKind::plain; }

bool equal(const Color& a, const Color& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool equal(const scene::Pattern& a, const scene::Pattern& b) {
  if (a.kind != b.kind || a.warps.size() != b.warps.size()) return false;
  if (is_plain(a) && a.warps.empty() && !a.params && !b.params && !a.turbulence && !b.turbulence) return true;
  return pattern_signature(a) == pattern_signature(b);
}

// Layers of old versions change the filter of a map for all that share it (spec 05 11.2): only maps without one may
// become shared.
bool equal(const std::shared_ptr<const scene::ColorMap>& a, const std::shared_ptr<const scene::ColorMap>& b) {
  if (a == b) return true;
  return a && b && std::ranges::equal(*a, *b, [](const auto& x, const auto& y) {
           return x.position == y.position && x.value.f == 0 && equal(x.value, y.value);
         });
}

bool equal(const scene::Pigment& a, const scene::Pigment& b) {
  return equal(a.color, b.color) && a.quick_color == b.quick_color && a.pigment_map == b.pigment_map &&
         a.image_filters == b.image_filters && equal(a.color_map, b.color_map) && equal(a.pattern, b.pattern);
}

bool equal(const scene::Normal& a, const scene::Normal& b) {
  return a.amount == b.amount && a.accuracy == b.accuracy && a.no_bump_scale == b.no_bump_scale &&
         a.slope_map == b.slope_map && a.normal_map == b.normal_map && equal(a.pattern, b.pattern);
}

template <class T>
bool equal(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && equal(*a, *b));
}

bool equal(const scene::TextureLayer& a, const scene::TextureLayer& b) {
  return equal(a.pigment, b.pigment) && equal(a.normal, b.normal) && a.finish == b.finish;
}

// Patterned textures are left alone: their maps are large, and hardly anybody writes one again and again.
bool comparable(const scene::Texture& t) { return !t.patterned(); }

bool equal(const scene::Texture& a, const scene::Texture& b) {
  return a.no_bump_scale == b.no_bump_scale &&
         std::ranges::equal(a.layers, b.layers, [](const auto& x, const auto& y) { return equal(x, y); });
}

std::size_t hash_of(const scene::Texture& texture) {
  std::size_t hash = texture.layers.size();
  const auto mix = [&hash](const auto& value) {
    hash = (hash ^ std::hash<std::remove_cvref_t<decltype(value)>>()(value)) * 0x9e3779b97f4a7c15u;
  };
  for (const scene::TextureLayer& layer : texture.layers) {
    const scene::Pigment& pigment = *layer.pigment;
    const Color& c = pigment.color;
    for (const float part : {c.r, c.g, c.b, c.f, c.t, pigment.pattern.frequency, layer.finish->diffuse}) mix(part);
    mix(static_cast<int>(pigment.pattern.kind));
    if (layer.normal) mix(layer.normal->amount);
  }
  return hash >> 32;
}

}  // namespace

scene::TexturePtr TexturePool::one(scene::TexturePtr texture) {
  // What others hold, too, has been declared, and is one already.
  if (!texture || texture.use_count() > 1 || !comparable(*texture)) return texture;
  if (last_.empty()) last_.resize(kPlaces);
  scene::TexturePtr& known = last_[hash_of(*texture) % kPlaces];
  if (!known || !equal(*known, *texture)) known = std::move(texture);
  return known;
}

}  // namespace verisim::textures
