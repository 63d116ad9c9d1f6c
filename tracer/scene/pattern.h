// Patterns as SDL describes them (spec 05): a scalar field with its warps and wave form. Plain data; tracer/textures
// compiles it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "tracer/math/color.h"
#include "tracer/math/transform.h"
#include "tracer/scene/source_location.h"
#include "tracer/scene/sharing.h"

namespace verisim {
class Function;  // tracer/functions/function.h
class Image;     // tracer/image/image.h
using FunctionPtr = std::shared_ptr<const Function>;
using ImagePtr = std::shared_ptr<const Image>;
}  // namespace verisim

namespace verisim::scene {

struct Object;
struct Pigment;
using ObjectPtr = std::shared_ptr<const Object>;
using PigmentPtr = std::shared_ptr<const Pigment>;

enum class PatternKind : std::uint8_t {
  none,   // a pigment whose type was never given: opaque black, its chain does not displace
  plain,  // a solid colour
  agate,
  aoi,
  average,
  boxed,
  bozo,
  brick,
  bump_map,
  bumps,
  cells,
  checker,
  crackle,
  cubic,
  cylindrical,
  density_file,
  dents,
  facets,
  function,
  gradient,
  granite,
  hexagon,
  image_map,
  image_pattern,
  julia,
  leopard,
  magnet_julia,
  magnet_mandel,
  mandel,
  marble,
  object,
  onion,
  pavement,
  pigment_pattern,
  planar,
  quilted,
  radial,
  ripples,
  slope,
  spherical,
  spiral1,
  spiral2,
  spotted,
  square,
  tiling,
  triangular,
  uv_mapping,
  waves,
  wood,
  wrinkles,
};

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

// Parameters of the patterns that have some (spec 05 section 8).
struct AgateParams {
  float turbulence = 1;
};
struct BrickParams {
  Vec3 size{8, 3, 4.5};
  float mortar = 0.5;
};
struct CrackleParams {
  Vec3 form{-1, 1, 0};
  double metric = 2, offset = 0;
  bool solid = false;
};
struct FacetsParams {
  double size = 0.1, coords = 0, metric = 2;
};
struct FractalParams {
  Vec2 julia{0, 0};
  int iterations = 0, exponent = 2, magnet = 0;  // magnet 1 or 2
  int exterior_type = 1, interior_type = 0;
  double exterior_factor = 1, interior_factor = 1;
};
struct GradientParams {
  Vec3 direction{0, 0, 0};
};
struct QuiltedParams {
  float control0 = 1, control1 = 1;
};
struct SlopeParams {
  Vec3 direction{0, 0, 0}, altitude{0, 0, 0};
  bool point_at = false;  // direction is a point to look at
  double slope_low = 0, slope_high = 0, altitude_low = 0, altitude_high = 0;
};
struct SpiralParams {
  int arms = 0;
};
struct TilingParams {
  int number = 1;
};
struct PavementParams {
  int sides = 3, tiles = 1, pattern = 1, exterior = 0, interior = 0, form = 0;
};
struct FunctionParams {
  FunctionPtr function;
};
struct ObjectParams {
  ObjectPtr object;
};
struct PigmentPatternParams {
  PigmentPtr pigment;
};
struct DensityFileParams {
  std::shared_ptr<const std::vector<std::uint32_t>> samples;  // x fastest, then y, z
  int size[3] = {0, 0, 0};
  int bytes = 1;  // per sample
  int interpolate = 0;
};
// image_map, image_pattern, bump_map, material_map and the image of a height_field (spec 05 section 12).
struct ImageParams {
  ImagePtr image;
  int map_type = 0, interpolate = 0;
  bool once = false, use_alpha = false, use_index = false;
  Vec2 repeat{1, 1}, offset{0, 0};
  float filter_all = 0, transmit_all = 0;
};
using PatternParams =
    std::variant<std::monostate, AgateParams, BrickParams, CrackleParams, FacetsParams, FractalParams, GradientParams,
                 QuiltedParams, SlopeParams, SpiralParams, TilingParams, PavementParams, FunctionParams, ObjectParams,
                 PigmentPatternParams, DensityFileParams, ImageParams>;

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

  void prepend(const Transform& t);  // merges into a transform that is already at the front
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
