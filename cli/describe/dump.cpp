// The scene around the objects: camera, settings, atmosphere.
#include "cli/describe/dump.h"

#include <nlohmann/json.hpp>

#include "tracer/functions/function.h"

namespace verisim::cli {

using DumpJson = SceneDump::Json;

DumpJson dump(const Vec2& v) { return {v.x, v.y}; }
DumpJson dump(const Vec3& v) { return {v.x, v.y, v.z}; }
DumpJson dump(const Rgb& c) { return {c.r, c.g, c.b}; }
DumpJson dump(const Color& c) { return {c.r, c.g, c.b, c.f, c.t}; }

DumpJson dump(const Transform& t) {
  DumpJson result = DumpJson::array();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) result.push_back(t.m[row][column]);
  return result;
}

DumpJson dump(const scene::SourceLocation& place) {
  if (!place.file) return nullptr;
  return {{"file", *place.file}, {"line", place.line}, {"column", place.column}};
}

DumpJson dump(const scene::Turbulence& t) {
  return {{"turbulence", dump(t.amount)}, {"octaves", t.octaves}, {"lambda", t.lambda}, {"omega", t.omega}};
}

DumpJson dump(const FunctionPtr& function) {
  if (!function) return nullptr;
  return {{"parameters", function->parameters()}, {"components", function->components()}};
}

const char* dump_flag(scene::Flag flag) {
  return flag == scene::Flag::unset ? "unset" : flag == scene::Flag::on ? "on" : "off";
}

namespace {

DumpJson camera(SceneDump& dumper, const scene::Camera& c) {
  static constexpr const char* kKinds[] = {"perspective", "orthographic", "fisheye",    "ultra_wide_angle",
                                           "omnimax",     "panoramic",    "cylinder 1", "cylinder 2",
                                           "cylinder 3",  "cylinder 4",   "spherical",  "mesh_camera"};
  DumpJson out{{"type", kKinds[static_cast<std::size_t>(c.kind)]},
               {"location", dump(c.location)},
               {"direction", dump(c.direction)},
               {"up", dump(c.up)},
               {"right", dump(c.right)},
               {"sky", dump(c.sky)},
               {"look_at", dump(c.look_at)},
               {"angle", c.angle},
               {"horizontal_angle", c.horizontal_angle},
               {"vertical_angle", c.vertical_angle},
               {"aperture", c.aperture},
               {"focal_distance", c.focal_distance},
               {"blur_samples", c.blur_samples},
               {"blur_samples_min", c.blur_samples_min},
               {"confidence", c.confidence},
               {"variance", c.variance}};
  out["bokeh"] = c.bokeh ? dumper.pigment(*c.bokeh) : DumpJson(nullptr);
  out["normal"] = c.normal ? dumper.normal(*c.normal) : DumpJson(nullptr);
  if (c.kind == scene::CameraKind::mesh_camera)
    out["mesh_camera"] = {{"rays_per_pixel", c.rays_per_pixel},
                          {"distribution", c.distribution},
                          {"max_distance", c.max_distance},
                          {"smooth", c.smooth},
                          {"meshes", c.meshes.size()}};
  return out;
}

DumpJson radiosity(const scene::Radiosity& r) {
  return {{"enabled", r.enabled},
          {"pretrace_start", r.pretrace_start},
          {"pretrace_end", r.pretrace_end},
          {"error_bound", r.error_bound},
          {"low_error_factor", r.low_error_factor},
          {"gray_threshold", r.gray_threshold},
          {"minimum_reuse", r.minimum_reuse},
          {"maximum_reuse", r.maximum_reuse},
          {"max_sample", r.max_sample},
          {"brightness", r.brightness},
          {"adc_bailout", r.adc_bailout},
          {"importance", r.default_importance},
          {"count", {r.count, r.count_directions}},
          {"nearest_count", {r.nearest_count, r.adaptive_nearest_count}},
          {"recursion_limit", r.recursion_limit},
          {"always_sample", r.always_sample},
          {"media", r.media},
          {"normal", r.normal},
          {"subsurface", r.subsurface},
          {"load_file", r.load_file},
          {"save_file", r.save_file}};
}

DumpJson photons(const scene::Photons& p) {
  return {{"enabled", p.enabled},
          {"spacing", p.spacing},
          {"count", p.count},
          {"gather", {p.gather_min, p.gather_max}},
          {"max_trace_level", p.max_trace_level},
          {"media", {p.media_count, p.media_factor}},
          {"jitter", p.jitter},
          {"autostop", p.autostop},
          {"radius", {p.radius, p.radius_gather_multiplier, p.media_radius, p.media_radius_gather_multiplier}},
          {"expand_thresholds", {p.expand_increase, p.expand_min}},
          {"adc_bailout", p.adc_bailout},
          {"load_file", p.load_file},
          {"save_file", p.save_file}};
}

DumpJson settings(const scene::Settings& s) {
  DumpJson gamma = s.gamma == scene::Gamma::none   ? DumpJson(nullptr)
                   : s.gamma == scene::Gamma::srgb ? DumpJson("srgb")
                                                   : DumpJson(s.assumed_gamma);
  DumpJson out{{"adc_bailout", s.adc_bailout},
               {"ambient_light", dump(s.ambient_light)},
               {"assumed_gamma", gamma},
               {"irid_wavelength", dump(s.irid_wavelength)},
               {"max_trace_level", s.max_trace_level},
               {"mm_per_unit", s.mm_per_unit},
               {"noise_generator", s.noise_generator},
               {"number_of_waves", s.number_of_waves}};
  out["subsurface"] = s.subsurface ? DumpJson{{"samples", {s.subsurface_samples_diffuse, s.subsurface_samples_single}},
                                              {"radiosity", s.subsurface_radiosity}}
                                   : DumpJson(nullptr);
  out["radiosity"] = radiosity(s.radiosity);
  out["photons"] = photons(s.photons);
  return out;
}

DumpJson fog(const scene::Fog& f) {
  DumpJson out{{"fog_type", f.type},    {"color", dump(f.color)}, {"distance", f.distance},
               {"fog_alt", f.altitude}, {"fog_offset", f.offset}, {"up", dump(f.up)}};
  if (f.turbulence) {
    out["turbulence"] = dump(*f.turbulence);
    out["turb_depth"] = f.turbulence_depth;
  }
  return out;
}

DumpJson rainbow(SceneDump& dumper, const scene::Rainbow& r) {
  DumpJson out{{"direction", dump(r.direction)}, {"up", dump(r.up)},  {"angle", r.angle}, {"width", r.width},
               {"distance", r.distance},         {"jitter", r.jitter}};
  out["arc_angle"] = r.arc_angle ? DumpJson(*r.arc_angle) : DumpJson(nullptr);
  out["falloff_angle"] = r.falloff_angle ? DumpJson(*r.falloff_angle) : DumpJson(nullptr);
  out["colors"] = r.colors ? dumper.pigment(*r.colors) : DumpJson(nullptr);
  return out;
}

template <class T, class F>
DumpJson list(const std::vector<T>& items, const F& convert) {
  DumpJson out = DumpJson::array();
  for (const T& item : items) out.push_back(convert(item));
  return out;
}

}  // namespace

DumpJson SceneDump::scene(const scene::Scene& s) {
  scene::complete(s);
  DumpJson out{{"format", "verisim scene"},
               {"format_version", kFormatVersion},
               {"source", s.source_name},
               {"version", s.version / 100.0}};
  out["global_settings"] = settings(s.settings);
  out["camera"] = camera(*this, s.camera);
  out["background"] = dump(s.background);
  out["fog"] = list(s.fogs, fog);
  out["rainbow"] = list(s.rainbows, [this](const scene::Rainbow& r) { return rainbow(*this, r); });
  out["sky_sphere"] = nullptr;
  if (s.sky_sphere) {
    out["sky_sphere"] = {{"emission", dump(s.sky_sphere->emission)}, {"transform", dump(s.sky_sphere->transform)}};
    out["sky_sphere"]["pigments"] =
        list(s.sky_sphere->pigments, [this](const scene::PigmentPtr& p) { return pigment(*p); });
  }
  out["atmosphere"] = list(s.atmosphere, [this](const scene::Media& m) { return media(m); });
  out["objects"] = list(s.objects, [this](const scene::ObjectPtr& o) { return object(*o); });
  out["textures"] = std::move(textures_);
  out["interiors"] = std::move(interiors_);
  return out;
}

}  // namespace verisim::cli
