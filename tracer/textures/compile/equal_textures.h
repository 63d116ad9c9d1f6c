// What tells that two textures look alike.
//
// Programs write the same few colours and finishes for each of thousands of objects. What looks alike is one texture:
// it takes less memory, and hits of all those objects are shaded together.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>

#include "tracer/textures/normals/normal.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {

// Colours are equal where their bits are.
struct SolidColor {
  std::array<std::uint32_t, 5> bits;
  explicit SolidColor(const Color& c) : bits(std::bit_cast<std::array<std::uint32_t, 5>>(c)) {}
  friend bool operator==(const SolidColor&, const SolidColor&) = default;
};
// Of textures of one layer.
struct EqualLayers {
  bool operator()(const CompiledTexture* s, const CompiledTexture* t) const {
    const CompiledLayer &a = s->layers[0], &b = t->layers[0];
    return a.pigment == b.pigment && a.normal == b.normal && s->no_bump_scale == t->no_bump_scale &&
           s->opaque == t->opaque && a.finish == b.finish;
  }
};
// A normal without maps.
struct PlainNormal {
  const CompiledPattern* pattern;
  double amount, accuracy;
  CompiledNormal::Method method;
  bool no_bump_scale;
  explicit PlainNormal(const CompiledNormal& c)
      : pattern(c.pattern), amount(c.amount), accuracy(c.accuracy), method(c.method), no_bump_scale(c.no_bump_scale) {}
  friend bool operator==(const PlainNormal&, const PlainNormal&) = default;
};
struct EqualTexturesHash {
  template <class T>
  static std::size_t mix(std::size_t seed, const T& value) {
    return (seed ^ std::hash<T>()(value)) * 0x9e3779b97f4a7c15u;
  }
  std::size_t operator()(const SolidColor& color) const {
    std::size_t seed = 0;
    for (const std::uint32_t bits : color.bits) seed = mix(seed, bits);
    return seed ^ seed >> 32;
  }
  std::size_t operator()(const PlainNormal& normal) const {
    const std::size_t seed = mix(mix(normal.no_bump_scale, normal.pattern), normal.amount);
    return seed ^ seed >> 32;
  }
  // Of a texture of one layer. It throws nothing, so that a table need not keep it.
  std::size_t operator()(const CompiledTexture* texture) const noexcept {
    const CompiledLayer& layer = texture->layers[0];
    const scene::Finish& f = layer.finish;
    std::size_t seed = mix(mix(texture->no_bump_scale, layer.pigment), layer.normal);
    for (const float part : {f.ambient.r, f.diffuse, f.phong, f.specular, f.reflection.maximum.r})
      seed = mix(seed, part);
    return seed ^ seed >> 32;
  }
};

}  // namespace verisim::textures
