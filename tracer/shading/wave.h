// Camera rays of neighbouring pixels, shaded together: what most pixels of most scenes show, an opaque surface, is worked on
// with wide instructions; every other hit takes the common way (Tracer::resolve). Both give the same bits. What their mirrors show is a wave of its own.
#pragma once

#include <optional>
#include <unordered_map>

#include "tracer/shading/tracer.h"
#include "tracer/shading/wave_kernels.h"
#include "tracer/textures/point_row.h"

namespace verisim::shading {

class Wave {
 public:
  static constexpr int kMost = WaveLanes::kMost;

  explicit Wave(Tracer& tracer);

  // False: hits of this scene have to be shaded one after another (volumes, random numbers in order, an observer ...).
  bool usable() const { return usable_ && !tracer_.observer_ && !tracer_.pretrace_; }

  // `rays` of the lanes and what random numbers hang on are to be filled first: the samples' places in the picture, and for those that have several rays
  // the numbers of these.
  WaveLanes& lanes() { return lanes_; }
  Vec2* places() { return places_; }
  std::uint32_t* numbers() { return numbers_; }
  // Traces the camera rays of the first lanes: `count` <= kMost colours. The same objects are around all their origins. Ray i enters the world at entries[i]
  // (null: unknown).
  void trace(int count, const accel::WorldEntry* const* entries, Color* out);

 private:
  // ---- wave_surfaces.cpp: what shows where rays hit, before lights are asked
  // A layer as far as it is the same everywhere.
  struct Material {
    const textures::CompiledLayer* layer = nullptr;
    bool constant = false;  // the pigment has one colour
    bool only = false;      // the texture has no other layer
    bool mirror = false;
    bool plain = false;     // constant, alone, without a mirror or a normal of its own
    Color color;
    float opacity = 0;      // of the constant colour
    Rgb glow;               // ambient and emission
    double exponent = 0, amount = 0, base_limit = 0, phong = 0;
    unsigned shine = 0;     // how it responds to light, as bits
  };
  static constexpr unsigned kPhong = 1, kBlinn = 2, kMetallic = 4, kBothHighlights = 8, kBrilliance = 16;
  // The layers of a texture; none: its hits go the common way. A texture of textures has one layer that stands for them.
  using Materials = std::vector<Material>;
  // A layer as it shows at a hit.
  struct Part {
    const Material* material = nullptr;
    Vec3 normal;
    Color color;
    float opacity = 0;
    Rgb filter;     // of the layers above
    int next = -1;  // the layer below
    int mirror = -1;
  };
  // One of the textures that show at a hit.
  struct Leaf {
    int ray = 0;
    const Materials* materials = nullptr;
    const textures::CompiledTexture* around = nullptr;  // the texture it is part of
    Vec3 point;
    float weight = 1;
    Rgb filter{1};
    float translucency = 1;  // below the layers known so far
    int first = -1, last = -1;
  };
  struct Met {
    bool together;                 // false: the common way
    const Material* plain;         // the only layer, of one colour and without a normal of its own; null: see leaves
    Vec3 normal;                   // with `plain`
    int first = 0, leaves = 0, parts = 0;  // leaves and all their parts
    std::optional<SurfaceHit> at;  // where the surface varies
  };

  static bool shaded_together(const textures::CompiledTexture& texture);
  Materials find_materials(const textures::CompiledTexture& texture) const;
  const Materials& materials(const textures::CompiledTexture& texture);
  void meet(int i);
  void add_leaves(int i, const textures::CompiledTexture& texture, const Materials& found);
  void find_parts(int count);
  void find_layers(int* leaves, int n);
  void find_colors_and_normals(const Material& material, const int* leaves, int n);
  void add_leaf(int i, const Materials& found, const textures::CompiledTexture* around, const Vec3& point, float weight);
  Part& add_part(Leaf& leaf);
  Rgb add_mirror(const Leaf& leaf, Part& part);

  // ---- wave_mirrors.cpp: what mirrors show
  struct Mirror {
    Tracer::ShadedLayer layer;
    int ray;
    bool seen = false;  // `color` is known
    Rgb color;
  };
  RayState ray_state(int i) const;
  void begin_sample(int i) { tracer_.random_.begin_sample(places_[i].x, places_[i].y, numbers_[i]); }
  void trace_mirrors();
  void trace_mirrored(const int* mirrors, int count);
  void add_mirrored(const Leaf& leaf, Rgb& color);

  // ---- wave.cpp
  void run(int count, const accel::WorldEntry* const* entries, Color* out);
  void apply_fog(int count, const bool* resolved, Color* out);
  void show_sky(int count, Color* out);
  bool add_surface(int i);
  void add_lane(int i, const Material& m, const Vec3& normal, const Color& color, float opacity);
  void show(Color* out);
  void sum_layers(Color* out);
  Rgb shown(const Leaf& leaf, int& lane);
  void light(const Light& light);
  void aim(const Light& light);
  bool reach(const Light& light);
  void share_asking(int* asks);
  void cast_shadows(const Light& light);
  void respond();
  void respond_specially();
  double highlight(int k) const;

  Tracer& tracer_;
  const SceneData& scene_;
  const WaveKernels& kernels_;
  bool usable_;
  Color sky_[2];        // where there is no sky_sphere; in mirrors
  bool plain_sky_;
  std::unordered_map<const textures::CompiledTexture*, Materials> materials_;
  std::pair<const textures::CompiledTexture*, const Materials*> last_materials_[16]{};  // by address
  std::pair<const shapes::Shape*, const Material*> last_plain_[2]{};  // met from outside, from inside
  std::vector<Leaf> leaves_;
  std::vector<Part> parts_;
  std::vector<Mirror> mirrors_;
  std::unique_ptr<Wave> reflected_;  // made when it is needed
  Vec3 normals_[kMost];   // of one layer at some leaves
  Color colors_[kMost];
  bool colored_[kMost];
  RayState state_;          // of all rays, but for the ray itself and its weight
  float weights_[kMost];
  Vec2 places_[kMost];
  std::uint32_t numbers_[kMost] = {};
  int count_ = 0;       // of surfaces
  unsigned shine_ = 0;  // of all surfaces
  bool tinted_ = false, attenuated_ = true;  // false: all tints, all attenuations are 1
  bool layered_ = false;  // a hit has several surfaces here
  WaveLanes lanes_;
  shapes::Hit hits_[kMost];
  Met met_[kMost];
  bool found_[kMost];
  int pixel_[kMost];    // several lanes in a row may be of one
  const Material* material_[kMost] = {};  // whose numbers stand in the lane
  const shapes::Surface* surface_[kMost];
  const scene::Finish* finish_[kMost];
};

}  // namespace verisim::shading
