// Camera rays of neighbouring pixels, and the rays of radiosity samples, shaded together: what most pixels of most
// scenes show, an opaque surface, is worked on with wide instructions; every other hit takes the common way
// (Tracer::resolve). Both give the same bits. What is seen in their mirrors and through them are wavefronts of their
// own.
#pragma once

#include <optional>
#include <unordered_map>

#include "tracer/shading/highlights.h"
#include "tracer/shading/tracer.h"
#include "tracer/shading/wavefront/wavefront_kernels.h"
#include "tracer/textures/point_batch.h"

namespace verisim::shading {

inline bool is_finite(const Rgb& c) { return std::fabs(c.r) + std::fabs(c.g) + std::fabs(c.b) < 1e30f; }

class Wavefront {
 public:
  static constexpr int kMax = WavefrontPacket::kMax;

  // `asks_around`: surfaces get light from radiosity, if there is any.
  explicit Wavefront(Tracer& tracer, bool asks_around = true);

  // False: hits of this scene have to be shaded one after another (random numbers in order, an observer ...).
  bool usable() const { return usable_ && !tracer_.observer_ && !tracer_.pretrace_; }

  // `rays` of the lanes and what random numbers hang on are to be filled first: the samples' places in the picture, and
  // for those that have several rays the numbers of these.
  WavefrontPacket& packet() { return packet_; }
  Vec2* places() { return places_; }
  std::uint32_t* numbers() { return numbers_; }
  // Traces the camera rays of the first lanes: `count` <= kMax colours. The same objects are around all their origins.
  // Ray i enters the world at entries[i] (null: unknown).
  void trace(int count, const accel::WorldEntry* const* entries, Color* out);

  // ---- wavefront_gather.cpp: radiosity's rays
  // False: they have to be shaded one after another, in their own order.
  bool can_gather() const;
  // Takes one more ray, its random numbers and what it hits (null: nothing).
  void add_gathering(const Ray& ray, RandomSource::Key key, const shapes::Hit* hit, FinalGatherNotes& notes);
  bool full() const { return gathering_ == kMax; }
  // Shades the rays that were taken, which are like `common` but for their ways and notes.
  void shade_gathering(const RayState& common, Color* out);

 private:
  // ---- wavefront_surfaces.cpp: what shows where rays hit, before lights are asked
  // A layer as far as it is the same everywhere.
  struct Material {
    const textures::CompiledLayer* layer = nullptr;
    bool constant = false;  // the pigment has one colour
    bool only = false;      // the texture has no other layer
    bool mirror = false;
    // Alone, opaque, without a mirror: where it shows nothing else does, and only its colour and normal may vary.
    bool single = false;
    Color color;
    Highlight highlight;  // Phong's, or where there is none Blinn's
    unsigned lobes = 0;   // how it responds to light, as bits
  };
  static constexpr unsigned kPhong = 1, kBlinn = 2, kMetallic = 4, kBothHighlights = 8, kBrilliance = 16, kFilm = 32,
                            kGrain = 64;
  // The layers of a texture; none: its hits go the common way. A texture of textures has one layer that stands for
  // them.
  using Materials = std::vector<Material>;
  // A layer as it shows at a hit.
  struct Part {
    const Material* material = nullptr;
    Vec3 normal;
    Color color;
    double opacity = 0;
    double thickness = 0;  // of an iridescent film
    Rgb filter;            // of the layers above
    int index = 0;         // in its texture
    int next = -1;         // the layer below
    int mirror = -1;       // its branch
  };
  // The entries that show of a texture which is itself an entry of another: their sum counts there.
  struct Group {
    int outer;
    double weight;
  };
  static constexpr int kNoGroup = -1;
  // One of the textures that show at a hit.
  struct Leaf {
    int ray = 0;
    const Materials* materials = nullptr;
    int group = kNoGroup;             // of the texture of textures that it is an entry of
    int first_frame = 0, frames = 0;  // textures around it, and others that were looked into before
    Vec3 point;
    double weight = 1;
    Rgb filter{1};
    float translucency = 1;  // below the layers known so far
    int first = -1, last = -1, parts = 0;
    int behind = -1;  // the branch that goes on through the surface
  };
  struct Met {
    bool together;           // false: the common way
    const Material* single;  // all that shows; null: see leaves
    Vec3 normal, point;      // with `single`: to shade with, and where its patterns are asked
    Rgb color;
    int first = 0, leaves = 0, parts = 0;  // leaves and all their parts
    int first_frame = 0;                   // of the leaves
    std::optional<SurfaceHit> at;          // with leaves
  };

  bool shaded_together(const textures::CompiledTexture& texture, int depth, int& rest) const;
  Materials find_materials(const textures::CompiledTexture& texture) const;
  const Materials& materials(const textures::CompiledTexture& texture);
  void meet(int i);
  void take_single(int i, const Material& material, const Vec3& normal);
  void find_singles();
  void find_singles(const Material& material, const int* rays, int n);
  void add_leaves(int i, const textures::CompiledTexture& texture, const Materials& found);
  void add_weighted_leaves(int i);
  template <class Key>
  static int take_group(int* waiting, int& n, int* group, const Key& key);
  void find_parts(int count);
  void find_layers(int* leaves, int n);
  void find_thickness(const Material& material, const int* leaves, int n, double* thickness) const;
  void find_colors_and_normals(const Material& material, const int* leaves, int n);
  bool faces_finitely(int i, const Vec3& normal) const;
  Leaf& add_leaf(int i, const Materials& found, const Vec3& point, double weight);
  bool sees_left_normal(int i, const textures::CompiledTexture& texture) const;
  void add_entries(int i, const textures::CompiledTexture& texture, const Vec3& p, int group, TextureFrames* frames);
  const textures::CompiledTexture& frame(const Leaf& leaf, int f) const {
    return *frames_[static_cast<std::size_t>(leaf.first_frame + f)];
  }
  Part& begin_part(Leaf& leaf);
  Rgb add_mirror(const Leaf& leaf, Part& part);

  // ---- wavefront_branches.cpp: what is seen in mirrors and behind surfaces
  // A ray that a texture sends out: a layer's mirror, or what goes on through the surface.
  struct Branch {
    Tracer::ShadedLayer layer;  // of the mirror, or the top one
    int ray, leaf;
    bool behind;
    RandomSource::Key key;
    double thickness = 0;  // of an iridescent film
    float weight = 0;      // behind, until it is aimed: relative to that of its ray
    bool total = false;    // reflected where it might have gone on
    bool seen = false;     // `color` is known
    int group = -1;        // which wavefront it is part of; -1: none, 0: mirrors
    Vec3 direction{};
    Color color{};
  };
  struct Crossing {
    const scene::Interior* interior;
    Tracer::Refraction refraction;
    int group = 0;
  };
  RayState ray_state(int i) const;
  void begin_branch(int i, std::uint32_t number) { tracer_.random_.begin(RandomSource::branch_key(keys_[i], number)); }
  int add_branch(const Leaf& leaf, const Tracer::ShadedLayer& layer, bool behind);
  const Crossing& crossing(const scene::Interior& interior);
  void aim_behind(Branch& branch);
  bool hidden(const Leaf& leaf, const Branch& mirror) const;
  void trace_branches();
  void trace_group(int group, const Tracer::Refraction* refraction);
  void add_branches(const Leaf& leaf, Color& color);
  Color mirrored_by_film(const Branch& branch, const Color& color) const;
  Color seen_behind(const Branch& branch, bool& total);

  // ---- wavefront.cpp
  void run(int count, const accel::WorldEntry* const* entries, Color* out);
  void shade(int count, Color* out);
  MediaSegment segment(int i, std::uint32_t branch, Color& color) const;
  void apply_volumes(int count, const bool* cut_off, Color* out);
  void show_sky(int count, Color* out);
  bool add_surface(int i);
  int add_lane(int i, const Material& m, const Vec3& normal);
  void set_material(int k, const Material& m);
  void set_opacity(int k, double opacity);
  void set_color(int k, const Rgb& color, double opacity);
  void add_single(int i);
  void add_part(int i, const Part& part, int texture);
  static LayerContext layer_context(const Part& part);
  void add_photons();
  void show(Color* out);
  void sum_layers(Color* out);
  Color shown(const Leaf& leaf, int& lane);
  Color sum_of(int group, int& leaf, int end, int& lane);
  int child_around(int group, int outer) const;
  void light(const Light& light);
  void aim(const Light& light);
  bool reach(const Light& light);
  void share_asking(int* asks);
  void cast_shadows(const Light& light);
  void evaluate_lobes();
  void evaluate_special_lobes();
  void tint_by_films();
  std::array<double, 2> highlights(int k) const;  // Phong's and Blinn's

  Tracer& tracer_;
  const SceneData& scene_;
  const WavefrontKernels& kernels_;
  bool usable_, indirect_, photons_;  // with light from radiosity, from photons
  Color sky_[2];                      // where there is no sky_sphere; without alpha
  bool plain_sky_;
  std::unordered_map<const textures::CompiledTexture*, Materials> materials_;
  std::pair<const textures::CompiledTexture*, const Materials*> last_materials_[16]{};  // by address
  std::pair<const shapes::Shape*, const Material*> last_single_[2]{};                   // met from outside, from inside
  std::vector<textures::WeightedTexture> weighted_;                                     // of one hit
  std::vector<Leaf> leaves_;
  std::vector<Group> groups_;
  std::vector<const textures::CompiledTexture*> frames_;
  std::vector<Part> parts_;
  std::vector<Branch> branches_;
  std::vector<Crossing> crossings_;
  std::unique_ptr<Wavefront> branch_wavefront_;  // made when it is needed
  int depth_ = 0;                                // wavefronts around this one
  textures::SurfacePoint texture_points_[kMax];  // of hits with single materials that vary
  int varying_[kMax], varying_count_ = 0;        // which these are
  Vec3 normals_[kMax];                           // of one layer at some hits
  Color colors_[kMax];
  bool colored_[kMax];
  RayState state_;  // of all rays, but for the ray itself and its weight
  float weights_[kMax];
  FinalGatherNotes* notes_[kMax];  // of radiosity's rays
  int gathering_ = 0;
  Vec2 places_[kMax];
  std::uint32_t numbers_[kMax] = {};
  RandomSource::Key keys_[kMax];
  int count_ = 0;                                             // of surfaces
  unsigned lobes_ = 0;                                        // of all surfaces
  bool tinted_ = false, filmed_ = false, attenuated_ = true;  // false: all tints, films, attenuations are 1
  bool layered_ = false;                                      // a hit has several surfaces here
  WavefrontPacket packet_;
  shapes::Hit hits_[kMax];
  Met met_[kMax];
  bool found_[kMax];
  int pixel_[kMax];                      // several lanes in a row may be of one
  std::uint32_t grains_[kMax];           // how many random numbers of crand were drawn for it
  const Material* material_[kMax] = {};  // whose numbers stand in the lane
  const Part* part_[kMax];               // null: single
  const shapes::Surface* surface_[kMax];
  const scene::Finish* finish_[kMax];
};

}  // namespace verisim::shading
