// Patterns as SDL describes them (spec 05): a scalar field with its warps and wave form. Plain data; tracer/textures
// compiles it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "tracer/math/color.h"
#include "tracer/math/transform.h"
#include "tracer/scene/pattern_kinds.h"
#include "tracer/scene/source_location.h"
#include "tracer/scene/sharing.h"

namespace verisim::scene {

enum class Wave : std::uint8_t { ramp, sine, triangle, scallop, cubic, poly };

struct Turbulence {
  Vec3 amount{0, 0, 0};
  int octaves = 6;
  float lambda = 2, omega = 0.5;
};

// Warps (spec 05 section 6).
struct TurbulenceWarp : Turbulence {};
struct RepeatWarp {
  int axis = 0;
  float width = 1;
  Vec3 flip{0, 0, 0}, offset{0, 0, 0};
};
struct BlackHoleWarp {
  Vec3 center{0, 0, 0}, repeat{0, 0, 0}, turbulence{0, 0, 0};
  double radius = 1, strength = 1, falloff = 2;
  int type = 0;
  bool inverse = false, repeats = false, turbulent = false;
};
enum class ProjectionWarpKind : std::uint8_t { cylindrical, spherical, toroidal, planar };
struct ProjectionWarp {
  ProjectionWarpKind kind = ProjectionWarpKind::planar;
  Vec3 orientation{0, 0, 1};
  double distance_exponent = 0, major_radius = 1, offset = 0;  // offset: of planar
};
struct CubicWarp {};
using Warp = std::variant<Transform, TurbulenceWarp, RepeatWarp, BlackHoleWarp, ProjectionWarp, CubicWarp>;

// The colours of checker, brick ... where a scene writes none (spec 05 4.3); empty: its pattern has no list.
std::span<const Color> built_in_list(PatternKind kind);

// Transformations one after the other; at least one.
using Transforms = std::span<const Transform* const>;

struct Pattern {
  PatternKind kind = PatternKind::none;
  Wave wave = Wave::ramp;
  float frequency = 1, phase = 0, exponent = 1;
  int noise_generator = 0;  // 0: the scene's
  Rare<PatternParams> params;
  // Evaluated first to last; SDL puts each new item at the front, and consecutive transforms are merged (spec 05 3.1).
  List<Warp> warps;
  // The "classic" turbulence, always after all warps; absent until one of its keywords is written.
  Rare<Turbulence> turbulence;

  void prepend(Transforms steps);  // merge into a transform that is already at the front
  void prepend(const Transform& t) {
    const Transform* const one = &t;
    prepend(Transforms(&one, 1));
  }
  void prepend(Warp warp);
};

// Entries in the order written; never sorted (spec 05 4.1). Average maps use `position` as the weight.
template <class T>
struct MapEntry {
  float position = 0;
  T value;
};
template <class T>
using BlendMap = std::vector<MapEntry<T>>;

}  // namespace verisim::scene
