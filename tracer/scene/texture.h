// Pigments, normals, finishes, textures, interiors and media as SDL describes them (specs 05, 06, 07).
#pragma once

#include "tracer/scene/pattern.h"

namespace verisim::scene {

struct Normal;
struct Texture;
struct Density;
using NormalPtr = std::shared_ptr<const Normal>;
using TexturePtr = std::shared_ptr<const Texture>;
using ColorMap = BlendMap<Color>;

struct Pigment {
  Pattern pattern;
  Color color;  // of a plain pigment
  // At most one of the maps is not empty; both empty: the pattern's built-in map (spec 05 4.3). Lists (checker ...)
  // have position i at entry i.
  std::shared_ptr<const ColorMap> color_map;
  std::shared_ptr<const BlendMap<PigmentPtr>> pigment_map;  // also average, and the single child of uv_mapping
  Rare<Color> quick_color;                                  // with filter and transmit
  // An image_map with `filter` or `transmit` was ever written in it, whatever has taken its place (spec 06 9.3).
  bool image_filters = false;
};

struct SlopeEntry {
  double height = 0, slope = 0;
};

struct Normal {
  Pattern pattern;
  float amount = 0.5f;
  float accuracy = 0.02f;
  bool no_bump_scale = false;
  std::shared_ptr<const BlendMap<SlopeEntry>> slope_map;
  std::shared_ptr<const BlendMap<NormalPtr>> normal_map;  // also lists, average, and the single child of uv_mapping
};

struct Reflection {
  Rgb minimum, maximum;
  float falloff = 1, exponent = 1, metallic = 0;
  bool fresnel = false;
  friend bool operator==(const Reflection&, const Reflection&) = default;
};

struct Finish {  // spec 06 section 4.1; albedo forms are already scaled
  Rgb ambient{0.1f}, emission;
  float diffuse = 0.6f, diffuse_back = 0, brilliance = 1, crand = 0;
  float raw_diffuse = 0.6f, raw_diffuse_back = 0;                     // before the albedo scaling; radiosity uses these
  float phong = 0, phong_size = 40, specular = 0, roughness = 0.05f;  // roughness 0: exponent 0
  float metallic = 0;
  Reflection reflection;
  float irid = 0, irid_thickness = 0, irid_turbulence = 0;
  bool conserve_energy = false;
  bool subsurface = false;
  SourceLocation place;  // of subsurface{}
  Rgb translucency, anisotropy;
  // Legacy keywords, moved into the interior when the scene is finished (spec 06 6.6).
  std::optional<float> ior, caustics, refraction;
  friend bool operator==(const Finish&, const Finish&) = default;
};

struct TextureLayer {
  PigmentPtr pigment;   // never null
  NormalPtr normal;     // null: none
  Rare<Finish> finish;  // mostly shared with other textures
};

// Either layers (bottom first, as written) or a pattern over textures.
struct Texture {
  std::vector<TextureLayer> layers;  // empty: patterned
  Pattern pattern;                   // of a patterned texture; kind image_map stands for material_map
  std::shared_ptr<const BlendMap<TexturePtr>>
      texture_map;  // also lists, average, material_map's textures, the child of uv_mapping
  bool no_bump_scale = false;

  bool patterned() const { return layers.empty(); }
};

struct Density {
  Pattern pattern;
  Color color{1, 1, 1};  // of a plain density
  std::shared_ptr<const ColorMap> color_map;
  std::shared_ptr<const BlendMap<std::shared_ptr<const Density>>> density_map;
};
using DensityPtr = std::shared_ptr<const Density>;

struct Media {  // spec 07
  SourceLocation place;
  int method = 3, intervals = 1, samples_min = 10, samples_max = 10,
      aa_level = 3;  // of #version 3.5 and later (spec 07 4.1)
  double aa_threshold = 0.1, ratio = 0.9, confidence = 0.9, variance = 1.0 / 128, jitter = 0;
  Rgb absorption, emission;
  int scattering_type = 1;  // 1 .. 5
  Rgb scattering;
  double eccentricity = 0, extinction = 1;
  bool has_scattering = false;
  bool collect = true;  // photons
  std::vector<DensityPtr> densities;
};

struct Interior {
  float ior = 1, dispersion = 1, caustics = 0, fade_distance = 0, fade_power = 0,
        refraction = 1;  // caustics: 45 * the number written
  int dispersion_samples = 7;
  Rgb fade_color;
  List<Media> media;
  bool ior_given = false;  // without an ior there is no dispersion, either (spec 06 6.1)
  bool hollow = false;     // of the objects that share this interior; the last one written wins (spec 06 6.1)
};
// Identity matters: entering and leaving is decided by which Interior an object has, not by its values.
using InteriorPtr = std::shared_ptr<Interior>;

// Append transformations of an object to a texture (copy on write; a solid colour without normal is returned
// unchanged).
TexturePtr transformed(const TexturePtr& texture, Transforms steps);
PigmentPtr transformed(const PigmentPtr& pigment, Transforms steps);
NormalPtr transformed(const NormalPtr& normal, Transforms steps);
// The same for solid colours, too: for a pattern that goes on from one.
PigmentPtr moved(const PigmentPtr& pigment, const Transform& t);
bool ends_in_solid_color(const Texture& texture);  // the pigment of its top layer

template <class T>
std::shared_ptr<const T> transformed(const std::shared_ptr<const T>& description, const Transform& t) {
  const Transform* const one = &t;
  return transformed(description, Transforms(&one, 1));
}

}  // namespace verisim::scene
