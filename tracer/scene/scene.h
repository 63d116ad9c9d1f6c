// The whole scene as SDL describes it: what a parser delivers and the renderer compiles.
#pragma once

#include <string>

#include "tracer/scene/camera.h"
#include "tracer/scene/object.h"

namespace verisim::scene {

struct Fog {  // spec 06 11.4
  int type = 1;
  Color color;
  double distance = 0, altitude = 0, offset = 0;
  Vec3 up{0, 1, 0};
  std::optional<Turbulence> turbulence;
  double turbulence_depth = 0.5;
};

struct Rainbow {  // spec 06 11.6
  Vec3 direction{0, 0, 0}, up{0, 1, 0};
  double angle = 0, width = 0, distance = 1e7, jitter = 0;
  std::optional<double> arc_angle, falloff_angle;
  PigmentPtr colors;  // a gradient-like map: only its color_map or pigment_map is used
};

struct SkySphere {
  std::vector<PigmentPtr> pigments;  // the last is on top
  Rgb emission{1};
  Transform transform;
};

struct Radiosity {  // spec 07 section 2
  bool enabled = false;
  SourceLocation place;
  double pretrace_start = 0.08, pretrace_end = 0.04, error_bound = 1.8, low_error_factor = 0.5, gray_threshold = 0,
         minimum_reuse = 0.015, maximum_reuse = 0.2, max_sample = -1, brightness = 1, adc_bailout = 0.01,
         default_importance = 1;
  int count = 35, count_directions = 1600, nearest_count = 5, adaptive_nearest_count = 0, recursion_limit = 2;
  bool always_sample = false, media = false, normal = false, subsurface = false;
  bool minimum_reuse_given = false, maximum_reuse_given = false;  // the other one is then adjusted (spec 07 2.1)
  std::string load_file, save_file;
};

struct Photons {  // spec 07 section 3
  bool enabled = false;
  SourceLocation place;
  double spacing = 1;
  int count = 0, gather_min = 20, gather_max = 100, max_trace_level = -1, media_count = 0;
  double media_factor = 1, jitter = 0.4, autostop = 0.5, radius = 0, radius_gather_multiplier = 1, media_radius = 0,
         media_radius_gather_multiplier = 1, expand_increase = 0.2, adc_bailout = -1;
  int expand_min = 35;
  std::string load_file, save_file;
};

enum class Gamma : std::uint8_t { none, power, srgb };  // the working space (spec 02 4.1); none: values pass unchanged

struct Settings {
  float adc_bailout = 1.0f / 255;
  Rgb ambient_light{1};
  Gamma gamma = Gamma::none;
  bool gamma_given = false;
  double assumed_gamma = 1;
  Rgb irid_wavelength{0.70f, 0.52f, 0.48f};
  int max_trace_level = 5;
  double mm_per_unit = 10;
  int noise_generator = 2;
  int number_of_waves = 10;
  bool subsurface = false;
  int subsurface_samples_diffuse = 50, subsurface_samples_single = 50;
  bool subsurface_radiosity = false;
  bool no_bump_scale = false;  // of some normal or texture
  Radiosity radiosity;
  Photons photons;
};

struct Scene {
  std::string source_name;
  int version = 370;  // effective, at the end of parsing: 362 when no #version was seen (spec 01 section 20)
  std::vector<ObjectPtr> objects;  // top level, in order; light sources and light groups included
  Camera camera;
  bool camera_given = false;
  Settings settings;
  Color background;
  bool background_given = false;
  bool background_fades = true;  // written from 3.7 on: its transmit counts; before, it is clear and has its full color
  std::vector<Fog> fogs;
  std::vector<Rainbow> rainbows;
  std::optional<SkySphere> sky_sphere;
  std::vector<Media> atmosphere;
};

// Makes all children of copies (see object.h), so that threads may look at the scene.
void complete(const Scene& scene);

}  // namespace verisim::scene
