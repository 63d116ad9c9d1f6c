// Compiled textures: what a description of tracer/scene/texture.h becomes for rendering (spec 05).
//
// Made once by `Compiler`, immutable afterwards, evaluated without virtual calls from any thread.
#pragma once

#include <memory>
#include <span>

#include "tracer/scene/texture.h"
#include "tracer/textures/lookup/blend_map.h"

namespace verisim::textures {

struct CompiledPattern;  // pattern.h
struct CompiledPigment;  // pigment.h
struct CompiledNormal;   // normal.h
struct CompiledTexture;

// What slope, aoi, uv_mapping and object patterns need to know of the hit. `normal` is POV-Ray's "perturbed normal" of
// the intersection: it starts as the geometric normal turned towards the ray and every normal evaluation overwrites it
// (spec 05 3.4).
struct SurfacePoint {
  Vec3 point;  // the hit, unwarped
  Vec3 normal;
  Vec3 ray_direction;
  // Surface coordinates are computed when they are asked for: few textures do, and some shapes need inverse
  // trigonometry for them.
  Vec2 (*uv_function)(const void* context) = nullptr;
  const void* uv_context = nullptr;
  bool is_hit = true;  // false: a camera's normal is evaluated, where slope and aoi are 0

  Vec2 uv() const { return uv_function ? uv_function(uv_context) : Vec2(0, 0); }
};

inline Vec3 uv_point(const SurfacePoint& surface) {
  const Vec2 uv = surface.uv();
  return {uv.x, uv.y, 0};
}

struct Settings {
  int noise_generator = 2;
  int number_of_waves = 10;
  int version = 370;
  bool use_quick_color = false;  // quality 5 and below
};

struct CompiledLayer {
  const CompiledPigment* pigment;
  const CompiledNormal* normal;  // null: none
  const scene::Finish& finish;   // the description's, which the compiler keeps
};

struct WeightedTexture {
  const CompiledTexture* texture;
  double weight;
};

struct CompiledTexture {
  std::vector<CompiledLayer> layers;         // top first; empty: patterned
  const CompiledPattern* pattern = nullptr;  // of a patterned texture
  bool average = false, uv_mapping = false, material_map = false, no_bump_scale = false;
  std::vector<scene::MapEntry<const CompiledTexture*>> map;
  MapPositions positions;  // of map, ready for lookup
  bool opaque = false;     // POV-Ray's flag: what hits such an object blocks all light (spec 06 9.3)
  bool solid = false;  // no colour of it lets light through; images in maps may, and are flagged opaque all the same
  bool images_filter = false;  // some image in an entry of a pigment's map does
  bool patterned() const { return layers.empty(); }
};
// POV-Ray's flag of one pigment, where nothing is known of images in its map.
bool flagged_opaque(const scene::Pigment& description, const CompiledPigment& compiled);
// It is an image that filters or transmits, or was one.
bool image_filters(const scene::Pigment& description, const CompiledPigment& compiled);

// Owns everything it compiles; pointers stay valid as long as it lives. Equal descriptions (by address) are compiled
// once.
class MapsWithoutBumpScale;

class Compiler {
 public:
  explicit Compiler(const Settings& settings);
  Compiler(const Settings& settings, MapsWithoutBumpScale maps);
  ~Compiler();
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  const CompiledTexture* texture(const scene::TexturePtr& description);
  const CompiledPigment* pigment(const scene::PigmentPtr& description);
  const CompiledNormal* normal(const scene::NormalPtr& description);
  const CompiledPattern* pattern(const scene::Pattern& description);
  // Density of a media: the pattern point is in world space; null entries give constant 1.
  const CompiledPigment* density(const scene::DensityPtr& description);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The colour at p. False: the pigment "produced no colour" (outside a `once` image), color is then rgb 1 transmit 1.
bool evaluate(const CompiledPigment& pigment, const Vec3& p, const SurfacePoint* surface, Color& color);
// The scalar value after wave form (spec 05 3.2).
double evaluate(const CompiledPattern& pattern, const Vec3& p, const SurfacePoint* surface);
// Perturbs n at p and returns the normal to shade with; surface.normal becomes the same, but with `no_bump_scale` only
// the returned one has unit length (what slope and aoi see later is not normalised, spec 05 10.1).
Vec3 perturb(const CompiledNormal& normal, const Vec3& p, const Vec3& n, SurfacePoint& surface);
// Which textures of a patterned texture show at p, in POV-Ray's order of work (upper map entry first), and the warped
// point for them. Returns at most 2 entries for a map, all of them for an average; `storage` must hold
// texture.map.size() entries (and at least 2). Before the children are shaded the normal must be taken into the
// pattern's frame, afterwards back (spec 05 10.1): enter_frame / leave_frame.
std::span<const WeightedTexture> select(const CompiledTexture& texture, const Vec3& p, const SurfacePoint* surface,
                                        std::span<WeightedTexture> storage, Vec3& warped);
Vec3 enter_frame(const CompiledTexture& texture, const Vec3& normal);
Vec3 leave_frame(const CompiledTexture& texture, const Vec3& normal);

// For SDL: `function { pattern {...} }`, `function { pigment {...} }`, eval_pigment. Each owns its compiled form.
FunctionPtr pattern_function(const scene::Pattern& description, const scene::ColorMap* unused,
                             const Settings& settings);
FunctionPtr pigment_function(const scene::PigmentPtr& description, const Settings& settings);

}  // namespace verisim::textures
