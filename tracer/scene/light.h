// Light sources as SDL describes them (spec 06 sections 7 and 8).
#pragma once

#include "tracer/scene/pattern.h"

namespace verisim::scene {

// Tri-state keywords remember whether the scene wrote them: parents only override what a child left open (spec 03 5.4).
enum class Flag : std::int8_t { unset = -1, off = 0, on = 1 };

// X(name, what people call it, whether its light is stronger in some directions or places than in others). The name is
// the keyword (docs/add-a-light.md); without one: point.
#define VERISIM_LIGHTS(X)             \
  X(point, "light", false)            \
  X(spotlight, "spotlight", true)     \
  X(cylinder, "cylinder light", true) \
  X(shadowless, "shadowless light", false)

#define VERISIM_LIGHT(name, words, beam) name,
enum class LightKind : std::uint8_t { VERISIM_LIGHTS(VERISIM_LIGHT) };
#undef VERISIM_LIGHT

struct LightInfo {
  const char* name;
  const char* words;
  bool has_beam;
};
#define VERISIM_LIGHT(name, words, beam) {#name, words, beam},
inline constexpr LightInfo kLightInfo[] = {VERISIM_LIGHTS(VERISIM_LIGHT)};
#undef VERISIM_LIGHT
constexpr const LightInfo& info(LightKind kind) { return kLightInfo[static_cast<std::size_t>(kind)]; }

struct LightSource {
  Vec3 position{0, 0, 0};
  Rgb color;
  LightKind kind = LightKind::point;
  bool parallel = false;
  Vec3 point_at{0, 0, 1};
  Vec3 direction{0, 0,
                 0};  // unit, towards point_at; fixed at the end of the statement, then transformed as a direction
  double radius = 0, falloff = 0, tightness = 0;  // degrees for a spotlight, lengths for a cylinder
  double fade_distance = 0, fade_power = 0;
  bool area = false;
  Vec3 axis1{0, 0, 0}, axis2{0, 0, 0};
  int size1 = 0, size2 = 0, adaptive = 100;
  bool jitter = false, circular = false, orient = false, area_illumination = false;
  bool media_interaction = true, media_attenuation = false;
  ObjectPtr looks_like, projected_through;
  // photons{} of the light
  bool photons_given = false, photon_area = false;
  Flag photon_reflection = Flag::unset, photon_refraction = Flag::unset;

  bool has_beam() const { return info(kind).has_beam; }
  bool fades() const { return fade_power > 0 && std::fabs(fade_distance) > kEpsilon; }
};

}  // namespace verisim::scene
