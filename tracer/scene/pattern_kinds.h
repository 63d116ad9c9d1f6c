// The patterns of SDL (spec 05 sections 2 and 8): one list of what each is called, takes and does, and the parameters
// of those that have some. Keywords, the parser's table, formulas, names in dumps and tags follow from the list
// (docs/add-a-pattern.md).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include "tracer/base/fields.h"
#include "tracer/math/vec.h"

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

// Parameters, under the words of SDL.
using NoParams = std::monostate;
struct AgateParams {
  float turbulence = 1;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("agate_turb", turbulence);
  }
};
struct BrickParams {
  Vec3 size{8, 3, 4.5};
  float mortar = 0.5;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("brick_size", size), visit("mortar", mortar);
  }
};
struct CrackleParams {
  Vec3 form{-1, 1, 0};
  double metric = 2, offset = 0;
  bool solid = false;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("form", form), visit("metric", metric), visit("offset", offset), visit("solid", solid);
  }
};
struct FacetsParams {
  double size = 0.1, coords = 0, metric = 2;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("size", size), visit("coords", coords), visit("metric", metric);
  }
};
struct FractalParams {
  Vec2 julia{0, 0};
  int iterations = 0, exponent = 2, magnet = 0;  // magnet 1 or 2
  int exterior_type = 1, interior_type = 0;
  double exterior_factor = 1, interior_factor = 1;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("julia", julia), visit("iterations", iterations), visit("exponent", exponent), visit("magnet", magnet);
    visit("exterior", exterior_type, exterior_factor), visit("interior", interior_type, interior_factor);
  }
};
struct GradientParams {
  Vec3 direction{0, 0, 0};
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("direction", direction);
  }
};
struct QuiltedParams {
  float control0 = 1, control1 = 1;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("control0", control0), visit("control1", control1);
  }
};
struct SlopeParams {
  Vec3 direction{0, 0, 0}, altitude{0, 0, 0};
  bool point_at = false;  // direction is a point to look at
  double slope_low = 0, slope_high = 0, altitude_low = 0, altitude_high = 0;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("direction", direction), visit("point_at", point_at), visit("slope", slope_low, slope_high);
    visit("altitude", altitude), visit("altitude_range", altitude_low, altitude_high);
  }
};
struct SpiralParams {
  int arms = 0;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("arms", arms);
  }
};
struct TilingParams {
  int number = 1;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("tiling", number);
  }
};
struct PavementParams {
  int sides = 3, tiles = 1, pattern = 1, exterior = 0, interior = 0, form = 0;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("number_of_sides", sides), visit("number_of_tiles", tiles), visit("pattern", pattern);
    visit("exterior", exterior), visit("interior", interior), visit("form", form);
  }
};
struct FunctionParams {
  FunctionPtr function;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("function", function);
  }
};
struct ObjectParams {
  ObjectPtr object;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("object", object);
  }
};
struct PigmentPatternParams {
  PigmentPtr pigment;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("pigment", pigment);
  }
};
struct DensityFileParams {
  std::shared_ptr<const std::vector<std::uint32_t>> samples;  // x fastest, then y, z
  int size[3] = {0, 0, 0};
  int bytes = 1;  // per sample
  int interpolate = 0;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit(Unnamed{}, samples), visit("size", size[0], size[1], size[2]);
    visit("bytes", bytes), visit("interpolate", interpolate);
  }
};
// image_map, image_pattern, bump_map, material_map and the image of a height_field (spec 05 section 12).
struct ImageParams {
  ImagePtr image;
  int map_type = 0, interpolate = 0;
  bool once = false, use_alpha = false, use_index = false;
  Vec2 repeat{1, 1}, offset{0, 0};
  float filter_all = 0, transmit_all = 0;
  // `filter` or `transmit` is written, be it of 0; of no other meaning than Pigment::image_filters.
  bool filters = false;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("image", image), visit("map_type", map_type), visit("interpolate", interpolate), visit("once", once);
    visit("use_alpha", use_alpha), visit("use_index", use_index), visit("repeat", repeat), visit("offset", offset);
    visit("filter_all", filter_all), visit("transmit_all", transmit_all), visit("filters", filters);
  }
};

// X(name, parameters, how many entries its list has (checker A, B: 2; none: 0), PatternInfo::Trait bits). Without a
// keyword of their own: no type was given (opaque black, its chain does not displace); a solid colour; magnet julia and
// magnet mandel.
// clang-format off
#define VERISIM_PATTERNS_WITHOUT_KEYWORD(X) \
  X(none,          NoParams,      0, kUndisplaced | kNoValue) \
  X(plain,         NoParams,      0, kNoValue) \
  X(magnet_julia,  FractalParams, 0, kSlow) \
  X(magnet_mandel, FractalParams, 0, kSlow)
// The name is the keyword.
#define VERISIM_PATTERNS_WITH_KEYWORD(X) \
  X(agate,           AgateParams,          0, kBare | kNoise | kFormulaWithNoise | kSlow) \
  X(aoi,             NoParams,             0, kBare | kNotInFunctions | kNotRemembered) \
  X(average,         NoParams,             0, kBare | kNotInFunctions | kNoValue) \
  X(boxed,           NoParams,             0, kBare) \
  X(bozo,            NoParams,             0, kBare | kNoise | kFormulaWithNoise | kSlow) \
  X(brick,           BrickParams,          2, kBare | kNoFrequency) \
  X(bump_map,        ImageParams,          0, kNormalsOnly | kNoFrequency) \
  X(bumps,           NoParams,             0, kBare | kNoise | kFormulaWithNoise | kSlow) \
  X(cells,           NoParams,             0, kBare) \
  X(checker,         NoParams,             2, kBare | kNoFrequency) \
  X(crackle,         CrackleParams,        0, kBare | kSlow) \
  X(cubic,           NoParams,             6, kBare | kNoFrequency) \
  X(cylindrical,     NoParams,             0, kBare) \
  X(density_file,    DensityFileParams,    0, kSlow) \
  X(dents,           NoParams,             0, kBare | kNoise | kSlow) \
  X(facets,          FacetsParams,         0, kBare | kNormalsOnly | kNoValue) \
  X(function,        FunctionParams,       0, kSlow) \
  X(gradient,        GradientParams,       0, 0) \
  X(granite,         NoParams,             0, kBare | kNoise | kFormulaWithNoise | kSlow) \
  X(hexagon,         NoParams,             3, kBare | kNoFrequency) \
  X(image_map,       ImageParams,          0, kPigmentsOnly | kNoFrequency | kNotRemembered) \
  X(image_pattern,   ImageParams,          0, kNoFrequency) \
  X(julia,           FractalParams,        0, kSlow) \
  X(leopard,         NoParams,             0, kBare) \
  X(mandel,          FractalParams,        0, kSlow) \
  X(marble,          NoParams,             0, kBare | kTriangleWave | kUndisplaced | kFormulaWithNoise) \
  X(object,          ObjectParams,         2, kNoFrequency | kSlow) \
  X(onion,           NoParams,             0, kBare) \
  X(pavement,        PavementParams,       0, kBare | kNotInFunctions | kSlow) \
  X(pigment_pattern, PigmentPatternParams, 0, kNotRemembered) \
  X(planar,          NoParams,             0, kBare) \
  X(quilted,         QuiltedParams,        0, kBare | kNoFrequency) \
  X(radial,          NoParams,             0, kBare) \
  X(ripples,         NoParams,             0, kBare | kSlow) \
  X(slope,           SlopeParams,          0, kNotInFunctions | kNotRemembered) \
  X(spherical,       NoParams,             0, kBare) \
  X(spiral1,         SpiralParams,         0, kTriangleWave) \
  X(spiral2,         SpiralParams,         0, kTriangleWave) \
  X(spotted,         NoParams,             0, kBare | kNoise | kFormulaWithNoise | kSlow) \
  X(square,          NoParams,             4, kBare | kNotInFunctions | kNoFrequency) \
  X(tiling,          TilingParams,         0, kNotInFunctions | kSlow) \
  X(triangular,      NoParams,             6, kBare | kNotInFunctions | kNoFrequency) \
  X(uv_mapping,      NoParams,             0, kNoValue) \
  X(waves,           NoParams,             0, kBare | kSlow) \
  X(wood,            NoParams,             0, kBare | kTriangleWave | kUndisplaced | kFormulaWithNoise) \
  X(wrinkles,        NoParams,             0, kBare | kNoise | kFormulaWithNoise | kSlow)
// clang-format on
#define VERISIM_PATTERNS(X) VERISIM_PATTERNS_WITHOUT_KEYWORD(X) VERISIM_PATTERNS_WITH_KEYWORD(X)

#define VERISIM_PATTERN(name, params, list, traits) name,
enum class PatternKind : std::uint8_t { VERISIM_PATTERNS(VERISIM_PATTERN) };
#undef VERISIM_PATTERN

#define VERISIM_PATTERN(name, params, list, traits) , params
using PatternParams = DistinctVariant<std::variant<NoParams> VERISIM_PATTERNS(VERISIM_PATTERN)>;
#undef VERISIM_PATTERN

struct PatternInfo {
  enum Trait : unsigned {
    kBare = 1 << 0,              // its keyword needs nothing behind it
    kNormalsOnly = 1 << 1,       // only normals may have it
    kPigmentsOnly = 1 << 2,      // only pigments may have it
    kNotInFunctions = 1 << 3,    // function { pattern { ... } } may not have it (spec 05 section 2)
    kNoFrequency = 1 << 4,       // no wave by default: the value is a number of steps
    kTriangleWave = 1 << 5,      // a triangle wave by default
    kUndisplaced = 1 << 6,       // the classic turbulence does not displace the point (spec 05 3.1)
    kNoise = 1 << 7,             // made of noise, whatever its turbulence
    kFormulaWithNoise = 1 << 8,  // its formula is beside the noise, in textures/evaluation/evaluation.inc
    kNoValue = 1 << 9,           // nobody asks for a value
    kNotRemembered = 1 << 10,    // may look at the surface, or has its value at hand
    kSlow = 1 << 11,             // takes longer than looking up what was found for the same point
  };

  const char* name;
  int list;
  unsigned traits;
  constexpr bool is(unsigned any_of) const { return (traits & any_of) != 0; }
};

inline constexpr auto kPatternInfo = [] {
  using enum PatternInfo::Trait;
#define VERISIM_PATTERN(name, params, list, traits) PatternInfo{#name, list, traits},
  return std::array{VERISIM_PATTERNS(VERISIM_PATTERN)};
#undef VERISIM_PATTERN
}();
constexpr const PatternInfo& info(PatternKind kind) { return kPatternInfo[static_cast<std::size_t>(kind)]; }

// As SDL has it: "granite", "magnet julia".
constexpr const char* pattern_name(PatternKind kind) {
  return kind == PatternKind::magnet_julia    ? "magnet julia"
         : kind == PatternKind::magnet_mandel ? "magnet mandel"
                                              : info(kind).name;
}
// What holds where a scene writes no parameters.
PatternParams default_params(PatternKind kind);

}  // namespace verisim::scene
