// The recursive trace: what a ray sees (spec 06 sections 2 and 3). One Tracer per thread; it owns the thread's scratch
// memory, random streams and counts.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <span>

#include "tracer/world/coherent_rays.h"
#include "tracer/film/statistics.h"
#include "tracer/shading/finish.h"
#include "tracer/shading/explain.h"
#include "tracer/shading/random.h"
#include "tracer/shading/ray_state.h"
#include "tracer/shading/scene_data.h"
#include "tracer/shading/texture_parts.h"
#include "tracer/shading/shuffle.h"
#include "tracer/shapes/implicit/last_miss.h"

namespace verisim::path {
class PathTracer;
}

namespace verisim::shading {

inline constexpr double kNearestHit = 1e-4;  // of camera, reflected and transmitted rays

// The render was cancelled while a ray was being traced.
struct Cancelled {};

struct ShadowBatch;

// What textures know of a hit, which outlives it; `normal`: the geometric one, turned towards the ray.
textures::SurfacePoint texture_point(const shapes::Hit& hit, const Vec3& normal, const Vec3& direction);

// One hit while it is being shaded.
struct SurfaceHit {
  SurfaceHit(const shapes::Hit& h, const Vec3& direction, std::size_t cache, int child_level)
      : SurfaceHit(h, h.shape->normal(h), direction, cache, child_level) {}
  SurfaceHit(const shapes::Hit& h, const Vec3& normal, const Vec3& direction, std::size_t cache, int child_level);
  // Where textures are evaluated: the point, or its surface coordinates (spec 06 3.1).
  Vec3 pattern_point() const { return surface.uv_mapping ? textures::uv_point(texture_point) : hit.point; }

  const shapes::Hit& hit;
  const shapes::Surface& surface;
  Vec3 geometric_normal;  // towards the viewer
  bool inside_hit;        // the surface was hit from within
  textures::SurfacePoint texture_point;
  std::size_t light_cache;   // where this hit's results per global light start
  bool keeps_lights = true;  // several layers may ask for them
  int level;                 // of the rays it sends out
  int textures = 0;          // that were shaded here so far

  // Answers that the layers of this hit share: irradiance on either side; whether photons were gathered, and along
  // which normal: the first layer's.
  struct Indirect {
    bool known = false;
    Rgb light;
  };
  Indirect indirect{}, indirect_back{};
  bool photons_gathered = false;
  std::optional<Vec3> photon_normal{};
};

// What blocked each global light last, for camera hits and for deeper ones: POV-Ray's shadow cache (spec 06 9.2, 08 D).
using LastBlockers = std::vector<std::array<const shapes::Shape*, 2>>;

class Tracer {
 public:
  Tracer(const SceneData& scene, const RandomSource& random, const std::atomic<bool>* cancel = nullptr);

  // Traces a ray; colour with t = see-through. t_max limits the search for the first surface (mesh_camera).
  Color trace(const RayState& ray, double t_max = accel::kFarthestHit, const accel::WorldEntry* entry = nullptr);
  // The two halves of trace, for callers that need to know what was hit: the nearest surface this ray sees, and what it
  // looks like (null: nothing hit).
  bool nearest(const RayState& ray, shapes::Hit& hit, double t_min = 1e-4, double t_max = accel::kFarthestHit,
               const accel::WorldEntry* entry = nullptr) const;
  Color resolve(const RayState& ray, const shapes::Hit* hit);
  // The same of a ray that is not cut_off(), but for the media and volumes on its way to the surface.
  Color resolve_surface(const RayState& ray, const shapes::Hit& hit);
  // Camera rays of the radiosity pretrace ask for irradiance only: no direct light, no volumes.
  void set_pretrace(bool on) { pretrace_ = on; }
  // What is remembered of rays that go the same way; without a camera every ray searches for itself.
  accel::CoherentRays& coherent() { return coherent_; }
  // What is traced hangs on what was traced before: in replay, and where the shadow cache shows.
  bool in_order() const { return in_order_; }
  // Forgets what was traced before, so that a block does not hang on others. Not in replay.
  void begin_block();
  void remember_blockers(const LastBlockers& blockers) { last_blockers_ = blockers; }
  const LastBlockers& remembered_blockers() const { return last_blockers_; }
  // While it lives, rays are those that radiosity gathers: random streams, shadow cache and the last miss of
  // isosurfaces are not those of the rays that ask for them (spec 07 1).
  class GatherScope {
   public:
    // Depth 0: not itself gathered for others.
    GatherScope(Tracer& tracer, int depth) : tracer_(depth == 0 && tracer.in_order_ ? &tracer : nullptr) { exchange(); }
    ~GatherScope() { exchange(); }
    GatherScope(const GatherScope&) = delete;
    GatherScope& operator=(const GatherScope&) = delete;

   private:
    void exchange() {
      if (!tracer_) return;
      Memory& others = tracer_->memory_of_others_;
      std::swap(others.streams, tracer_->random_.streams());
      others.last_blockers.swap(tracer_->last_blockers_);
      shapes::exchange_last_miss(others.last_miss);
    }
    Tracer* const tracer_;
  };
  // Null: nobody watches.
  void set_observer(Observer* observer) { observer_ = observer; }
  bool observed() const { return observer_ != nullptr; }
  // A camera ray, with the interiors around its origin; `origin_varies`: they must be looked up again.
  // `entry`: where it enters the world, if known.
  Color trace_camera(const Ray& ray, bool origin_varies, double t_max = accel::kFarthestHit,
                     const accel::WorldEntry* entry = nullptr);

  // The state of such a ray, before it is traced.
  RayState camera_state(const Ray& ray, bool origin_varies);
  // All camera rays start in this box. False: within the same interiors.
  bool expect_origins(const Box3& box) {
    camera_holders_ = scene_.world.holders(box);
    return !camera_holders_->empty();
  }
  // Of the rays through a lens for one place: once one of them starts in something that is not hollow, so do all that
  // follow (spec 02 2.1).
  bool& lens_is_hollow() { return lens_is_hollow_; }

  // Light of `light` that arrives at p after attenuation and shadows, for things that are not surfaces (media, whose
  // points lie `in_air`, and what is below a surface); sets the unit direction towards it.
  Rgb light_at(const Light& light, const Vec3& p, const RayState& ray, bool in_air, Vec3& to_light);
  // The same for a point of a surface, with area sampling; `lit` may be null.
  Rgb shadowed(const Light& light, const Vec3& p, const LightDirection& centre, const RayState& ray,
               const shapes::Surface* lit, Rgb color);
  // Diffuse reflection, highlights and iridescence of one layer for light of colour `intensity` from unit direction l
  // (spec 06 4.2.4 to 4.2.6). `diffuse`: coefficient to use; <= 0: none.
  Rgb layer_response(const SurfaceHit& at, const LayerContext& layer, const Vec3& view, const Vec3& l,
                     const Rgb& intensity, float diffuse, bool highlights);
  // The same without iridescence.
  Rgb response_below_film(const LayerContext& layer, const Vec3& view, const Vec3& l, const Rgb& intensity,
                          float diffuse, bool highlights);

  // Filters the light of all rays of a batch; `eye`: the ray that asks, but for its own way and weight.
  void cast_shadows(const Light& light, const RayState& eye, ShadowBatch& batch);
  // The same for places in space, as far as rays may go side by side and no number is drawn that counts: the others are
  // not known.
  void look_for_light(const Light& light, const RayState& eye, ShadowBatch& batch, bool* known);

  const SceneData& scene() const { return scene_; }
  RandomSource& random() { return random_; }
  render::Statistics& statistics() { return statistics_; }
  EffectsState* effects_state() { return effects_state_.get(); }
  // Radiosity's own value is a double in POV-Ray: weights rounded to single precision may fall below it (spec 07 2.6).
  double bailout(const RayState& ray) const {
    return ray.gather ? scene_.scene.settings.radiosity.adc_bailout : scene_.adc_bailout;
  }
  // The relative ior by which fresnel mirrors and subsurface light go at a surface of x (spec 06 5.2).
  double fresnel_ratio(const RayState& ray, const scene::Interior& x) const;
  std::span<const scene::Interior* const> interiors(const InteriorRange& range) const {
    return {interiors_.data() + range.begin, range.count};
  }

  // Restores the interior stack when a child ray is finished.
  class InteriorScope {
   public:
    explicit InteriorScope(Tracer& tracer) : tracer_(tracer), size_(tracer.interiors_.size()) {}
    ~InteriorScope() { tracer_.interiors_.resize(size_); }
    InteriorScope(const InteriorScope&) = delete;
    InteriorScope& operator=(const InteriorScope&) = delete;

   private:
    Tracer& tracer_;
    std::size_t size_;
  };
  // Copies a list to the top of the stack with `x` removed where it is (the newest or the first one found) or appended.
  InteriorRange crossed(const InteriorRange& from, const scene::Interior* x);
  InteriorRange copied(std::span<const scene::Interior* const> list);
  bool all_hollow(const InteriorRange& range) const;

 private:
  friend class Wavefront;         // camera rays shaded together
  friend class PhotonWalk;        // photons cross surfaces by the same rules
  friend class path::PathTracer;  // and so do paths
  struct ShadedLayer {
    const textures::CompiledLayer* layer;
    Color pigment;
    Vec3 normal;
    Mirror mirror;
    float translucency;  // t_i: what remains above this layer
  };
  struct CachedLight {
    enum class Stage : unsigned char { unknown, located, shadowed } stage = Stage::unknown;
    LightDirection direction;
    Rgb color;
  };
  struct Refraction {
    double ratio, dispersion;  // from over to
    InteriorRange interiors;
    bool hollow;
    int samples;
    bool straight() const { return std::fabs(ratio - 1) < kEpsilon; }
    bool disperses() const { return !(std::fabs(dispersion - 1) < kEpsilon); }
    void enter(RayState& ray) const { ray.interiors = interiors, ray.hollow = hollow, ray.refracted = true; }
  };

  // ---- tracer.cpp
  bool cut_off(const RayState& ray) const;
  Color seen_if_important(const RayState& ray, const shapes::Hit* hit);
  Color seen_along(const RayState& ray, const shapes::Hit* hit);
  void apply_volumes(const RayState& ray, double length, const shapes::Surface* end, Color& color);
  // Lets fog or media change a colour, and tells a witness.
  template <class Apply>
  void through_air(Color& color, Apply&& apply) {
    if (!observer_) return apply();
    const Color without = color;
    color.t = 1;  // what is left of it has passed
    apply();
    const float passed = std::exchange(color.t, without.t * color.t);
    observer_->air(without, color, passed);
  }
  void apply_fog(std::span<const MediaSegment> segments) const;

  // ---- surface.cpp
  Color shade(const RayState& ray, const shapes::Hit& hit);
  Color shade_surface(const RayState& ray, const shapes::Hit& hit);  // without the media on the way to it
  Color shade_texture(const RayState& ray, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p,
                      TextureFrames* frames);
  Color shade_layers(const RayState& ray, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p,
                     TextureFrames* frames);
  Vec3 layer_normal(SurfaceHit& at, const textures::CompiledLayer& layer, const Vec3& p, TextureFrames* frames);
  Color shade_unlit(SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p);

  // ---- direct_light.cpp
  // Adds what lights add to a layer, one after another: what the layer sends out by itself comes first, as in POV-Ray.
  void add_direct_light(const RayState& ray, SurfaceHit& at, const LayerContext& layer, Rgb& sum);
  // All global lights may be tested by one batch of shadow rays from the point.
  bool lights_go_together(const RayState& ray) const;
  void add_lights_together(const RayState& ray, SurfaceHit& at, const LayerContext& layer, Rgb& sum);
  // What arrives before shadows are known; false: nothing that counts. `back`: on the side that faces away.
  bool locate(SurfaceHit& at, const LayerContext& layer, const Light& light, CachedLight& cache, bool& back) const;
  void add_light(const RayState& ray, SurfaceHit& at, const LayerContext& layer, const Light& light, CachedLight& cache,
                 Rgb& sum);
  void tell_light(const RayState& ray, const SurfaceHit& at, const LayerContext& layer, const Light& light,
                  const CachedLight& cache, const Rgb& added);
  void add_area_illumination(const RayState& ray, SurfaceHit& at, const LayerContext& layer, const Light& light,
                             CachedLight& cache, Rgb& sum);
  // The thickness of an iridescent film at a point, and the tint that it gives light.
  double film_thickness(const scene::Finish& finish, const Vec3& p) const;
  Rgb film_tint(const scene::Finish& finish, double thickness, double cosines) const;
  // That of a layer's film for light from unit direction l; white where there is none.
  Rgb film_tint(const SurfaceHit& at, const LayerContext& layer, const Vec3& view, const Vec3& l) const;

  // ---- transmission.cpp
  Color transmit(const RayState& ray, SurfaceHit& at, const ShadedLayer& top, float weight, bool& total_reflection);
  Refraction cross_surface(const RayState& ray, const scene::Interior& x);
  Color attenuated(const Color& seen, const InteriorRange& interiors, const SurfaceHit& at,
                   bool total_reflection) const;
  Color refracted_ray(const RayState& ray, SurfaceHit& at, const ShadedLayer& top, const Refraction& refraction,
                      double ratio, float wavelength, float weight, bool& total_reflection);
  Color split_spectrum(const RayState& ray, SurfaceHit& at, const ShadedLayer& top, const Refraction& refraction,
                       float weight);
  Rgb reflect(const RayState& ray, SurfaceHit& at, const ShadedLayer& layer, float weight);
  // Of a total reflection this layer's mirror would show the same once more.
  static bool hidden_by_total_reflection(const Vec3& top_normal, const Vec3& normal);
  Rgb mirrored(const RayState& ray, SurfaceHit& at, const ShadedLayer& layer);
  static Rgb mirror_image(const ShadedLayer& layer, Rgb seen);
  Rgb fade_factor(const InteriorRange& list, const scene::Interior& interior, double distance) const;

  // ---- shadow.cpp
  struct ShadowQuery {
    const RayState& eye;
    const shapes::Surface* lit;
    const Light& light;
  };
  // From where on an opaque surface blocks this light.
  double contact_tolerance(const Light& light) const {
    return &light - scene_.lights().data() < static_cast<std::ptrdiff_t>(scene_.global_lights()) ? kContactTolerance
                                                                                                 : kShadowTolerance;
  }
  // The one of LastBlockers that counts; null: none does for this light, or order does not matter.
  const shapes::Shape** last_blocker(const ShadowQuery& query);
  // The first surface of the remembered object, whatever lies before it. True when nothing passes.
  bool filter_by_remembered(const ShadowQuery& query, const shapes::Shape& remembered, double distance, RayState& ray,
                            Rgb& color);
  // A shadow ray as far as the light, or as what the light is projected through: that is `beyond` from the light.
  struct ShadowSegment {
    Ray ray;
    double length = 0, beyond = 0;
  };
  // `rest`: takes what lies behind the last surface; its atmosphere then does not act here.
  void cast_shadow(const ShadowQuery& query, ShadowSegment segment, Rgb& color, ShadowSegment* rest = nullptr);
  // Fog or media may take from this light on its way, in what `eye` sees.
  bool light_on_way_changes(const Light& light, const RayState& eye) const;
  // Shadow rays that start there meet nothing but opaque objects; null: from anywhere.
  bool only_opaque(const accel::WorldEntry* entry) const {
    return entry ? entry->only_opaque : !scene_.world.has_transparent_shadows();
  }
  // No transparent object is on the way, so that any one decides.
  bool any_object_decides(const accel::WorldEntry* entry, const Ray& ray, double length) const;
  void filter_along(const ShadowQuery& query, ShadowSegment segment, const accel::WorldEntry* entry, Rgb& color,
                    ShadowSegment* rest);
  // Where shadow rays from p to this light start in the world; null: nothing is known.
  accel::WorldEntry* shadow_entry(const ShadowQuery& query, const Vec3& p);
  static accel::CoherentRays::Viewer viewer(const ShadowQuery& query);
  // ---- shadow_batch.cpp
  bool rays_alone(const Light& light, const RayState& eye) const;
  template <class Opaque, class Mixed>
  void by_cells(const Light& light, const RayState& eye, const ShadowBatch& batch, Opaque&& opaque, Mixed&& mixed);
  void dim(const Light& light, const RayState& eye, const int* index, int count, ShadowBatch& batch);
  void filter_batch(const Light& light, const RayState& eye, const accel::WorldEntry* entry, const int* index,
                    int count, ShadowBatch& batch);
  bool filter_through(const ShadowQuery& query, const RayState& ray, const shapes::Hit& hit, Rgb& color);
  // What of the light from `towards` passes a surface's textures.
  Rgb filter_at(const shapes::Hit& hit, const Vec3& towards);
  Rgb texture_filter(SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p, const Vec3& towards,
                     TextureFrames* frames);
  void shadow_volumes(const ShadowQuery& query, const RayState& ray, double length, bool to_surface, Rgb& color);

  // ---- area_light.cpp
  Rgb area_shadow(const ShadowQuery& query, const Vec3& p, const LightDirection& centre, const Rgb& color);
  struct AreaGrid;
  Rgb area_corner(AreaGrid& grid, int u, int v);
  Rgb area_region(AreaGrid& grid, int u1, int v1, int u2, int v2, int depth);
  Rgb area_sample(AreaGrid& grid, int column, int row);
  void area_volumes(const AreaGrid& grid, Rgb& color);
  // The light that all of them let arrive; nothing: they differ.
  std::optional<Rgb> ask_corners(const AreaGrid& grid, std::span<const int> columns, std::span<const int> rows);
  std::optional<Rgb> ask_first_corners(const AreaGrid& grid);

  const SceneData& scene_;
  RandomSource random_;
  const std::atomic<bool>* cancel_;
  const bool in_order_;
  accel::CoherentRays coherent_;
  std::unique_ptr<EffectsState> effects_state_;
  render::Statistics statistics_;
  Observer* observer_ = nullptr;
  int nesting_ = 0;
  bool pretrace_ = false;
  bool has_volumes_;  // in the air
  bool lights_in_batches_, area_lights_ = false;
  std::vector<const scene::Interior*> interiors_;
  std::optional<std::vector<std::uint32_t>> camera_holders_;  // where expect_origins() was told
  std::size_t camera_interiors_ = 0;
  bool camera_interiors_known_ = false, lens_is_hollow_ = true;
  std::vector<ShadedLayer> layers_;
  std::vector<CachedLight> light_cache_;
  std::vector<textures::WeightedTexture> weighted_, selection_;
  struct CornerResult {
    Rgb color;
    std::uint64_t stamp = 0;
  };
  LastBlockers last_blockers_;
  struct Memory {
    RandomSource::Streams streams;
    LastBlockers last_blockers;
    shapes::LastMiss::Search last_miss;
  };
  Memory memory_of_others_;  // of gathered rays while others are traced, and of those while rays are gathered
  std::vector<CornerResult> corners_;
  Shuffle area_rows_, area_columns_;
  std::vector<int>
      area_lines_[2];  // the columns and rows that the quartering of a grid of these sizes and levels asks for first
  std::array<int, 3> area_lines_of_{};
  std::uint64_t corner_stamp_ = 0;
};

}  // namespace verisim::shading
