// Textures, pigments, patterns, interiors and media of the scene dump.
#include <nlohmann/json.hpp>

#include "cli/describe/dump.h"
#include "tracer/image/image.h"

namespace verisim::cli {

using Json = SceneDump::Json;

namespace {

constexpr const char* kPatterns[] = {
    "none",        "plain",        "agate",         "aoi",        "average",    "boxed",           "bozo",
    "brick",       "bump_map",     "bumps",         "cells",      "checker",    "crackle",         "cubic",
    "cylindrical", "density_file", "dents",         "facets",     "function",   "gradient",        "granite",
    "hexagon",     "image_map",    "image_pattern", "julia",      "leopard",    "magnet julia",    "magnet mandel",
    "mandel",      "marble",       "object",        "onion",      "pavement",   "pigment_pattern", "planar",
    "quilted",     "radial",       "ripples",       "slope",      "spherical",  "spiral1",         "spiral2",
    "spotted",     "square",       "tiling",        "triangular", "uv_mapping", "waves",           "wood",
    "wrinkles"};
static_assert(std::size(kPatterns) == static_cast<std::size_t>(scene::PatternKind::wrinkles) + 1);
constexpr const char* kWaves[] = {"ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", "poly_wave"};

struct WarpDump {
  Json operator()(const Transform& t) const { return {{"matrix", dump(t)}}; }
  Json operator()(const scene::TurbulenceWarp& w) const {
    return {{"turbulence", dump(static_cast<const scene::Turbulence&>(w))}};
  }
  Json operator()(const scene::RepeatWarp& w) const {
    return {{"repeat", {{"axis", w.axis}, {"width", w.width}, {"flip", dump(w.flip)}, {"offset", dump(w.offset)}}}};
  }
  Json operator()(const scene::BlackHoleWarp& w) const {
    return {{"black_hole",
             {{"center", dump(w.center)},
              {"radius", w.radius},
              {"strength", w.strength},
              {"falloff", w.falloff},
              {"type", w.type},
              {"inverse", w.inverse},
              {"repeat", w.repeats ? dump(w.repeat) : Json(nullptr)},
              {"turbulence", w.turbulent ? dump(w.turbulence) : Json(nullptr)}}}};
  }
  Json operator()(const scene::ProjectionWarp& w) const {
    static constexpr const char* kKinds[] = {"cylindrical", "spherical", "toroidal", "planar"};
    return {{kKinds[static_cast<std::size_t>(w.kind)],
             {{"orientation", dump(w.orientation)},
              {"dist_exp", w.distance_exponent},
              {"major_radius", w.major_radius},
              {"offset", w.offset}}}};
  }
  Json operator()(const scene::CubicWarp&) const { return {{"cubic", true}}; }
};

struct ParameterDump {
  SceneDump& dumper;
  Json operator()(const std::monostate&) const { return nullptr; }
  Json operator()(const scene::AgateParams& p) const { return {{"agate_turb", p.turbulence}}; }
  Json operator()(const scene::BrickParams& p) const { return {{"brick_size", dump(p.size)}, {"mortar", p.mortar}}; }
  Json operator()(const scene::CrackleParams& p) const {
    return {{"form", dump(p.form)}, {"metric", p.metric}, {"offset", p.offset}, {"solid", p.solid}};
  }
  Json operator()(const scene::FacetsParams& p) const {
    return {{"size", p.size}, {"coords", p.coords}, {"metric", p.metric}};
  }
  Json operator()(const scene::FractalParams& p) const {
    return {{"julia", dump(p.julia)},
            {"iterations", p.iterations},
            {"exponent", p.exponent},
            {"magnet", p.magnet},
            {"exterior", {p.exterior_type, p.exterior_factor}},
            {"interior", {p.interior_type, p.interior_factor}}};
  }
  Json operator()(const scene::GradientParams& p) const { return {{"direction", dump(p.direction)}}; }
  Json operator()(const scene::QuiltedParams& p) const { return {{"control0", p.control0}, {"control1", p.control1}}; }
  Json operator()(const scene::SlopeParams& p) const {
    return {{"direction", dump(p.direction)},
            {"point_at", p.point_at},
            {"slope", {p.slope_low, p.slope_high}},
            {"altitude", dump(p.altitude)},
            {"altitude_range", {p.altitude_low, p.altitude_high}}};
  }
  Json operator()(const scene::SpiralParams& p) const { return {{"arms", p.arms}}; }
  Json operator()(const scene::TilingParams& p) const { return {{"tiling", p.number}}; }
  Json operator()(const scene::PavementParams& p) const {
    return {{"number_of_sides", p.sides}, {"number_of_tiles", p.tiles}, {"pattern", p.pattern},
            {"exterior", p.exterior},     {"interior", p.interior},     {"form", p.form}};
  }
  Json operator()(const scene::FunctionParams& p) const { return {{"function", dump(p.function)}}; }
  Json operator()(const scene::ObjectParams& p) const {
    return {{"object", p.object ? dumper.object(*p.object) : Json(nullptr)}};
  }
  Json operator()(const scene::PigmentPatternParams& p) const {
    return {{"pigment", p.pigment ? dumper.pigment(*p.pigment) : Json(nullptr)}};
  }
  Json operator()(const scene::DensityFileParams& p) const {
    return {{"size", {p.size[0], p.size[1], p.size[2]}}, {"bytes", p.bytes}, {"interpolate", p.interpolate}};
  }
  Json operator()(const scene::ImageParams& p) const {
    return {{"image", p.image ? Json{p.image->width, p.image->height} : Json(nullptr)},
            {"map_type", p.map_type},
            {"interpolate", p.interpolate},
            {"once", p.once},
            {"use_alpha", p.use_alpha},
            {"use_index", p.use_index},
            {"repeat", dump(p.repeat)},
            {"offset", dump(p.offset)},
            {"filter_all", p.filter_all},
            {"transmit_all", p.transmit_all}};
  }
};

template <class T, class F>
Json map(const scene::BlendMap<T>& entries, const F& convert) {
  Json out = Json::array();
  for (const scene::MapEntry<T>& entry : entries) out.push_back({entry.position, convert(entry.value)});
  return out;
}

Json finish(const scene::Finish& f) {
  Json out{{"ambient", dump(f.ambient)},
           {"emission", dump(f.emission)},
           {"diffuse", {f.diffuse, f.diffuse_back}},
           {"brilliance", f.brilliance},
           {"crand", f.crand},
           {"phong", f.phong},
           {"phong_size", f.phong_size},
           {"specular", f.specular},
           {"roughness", f.roughness},
           {"metallic", f.metallic}};
  const scene::Reflection& r = f.reflection;
  out["reflection"] = {{"minimum", dump(r.minimum)}, {"maximum", dump(r.maximum)}, {"falloff", r.falloff},
                       {"exponent", r.exponent},     {"metallic", r.metallic},     {"fresnel", r.fresnel}};
  out["irid"] = {{"amount", f.irid}, {"thickness", f.irid_thickness}, {"turbulence", f.irid_turbulence}};
  out["conserve_energy"] = f.conserve_energy;
  out["subsurface"] =
      f.subsurface ? Json{{"translucency", dump(f.translucency)}, {"anisotropy", dump(f.anisotropy)}} : Json(nullptr);
  return out;
}

}  // namespace

void SceneDump::pattern(Json& out, const scene::Pattern& p) {
  out["type"] = kPatterns[static_cast<std::size_t>(p.kind)];
  if (p.kind == scene::PatternKind::plain || p.kind == scene::PatternKind::none) return;
  if (p.params) out["parameters"] = std::visit(ParameterDump{*this}, *p.params);
  out["wave"] = kWaves[static_cast<std::size_t>(p.wave)];
  out["frequency"] = p.frequency;
  out["phase"] = p.phase;
  if (p.wave == scene::Wave::poly) out["exponent"] = p.exponent;
  if (p.noise_generator) out["noise_generator"] = p.noise_generator;
  if (!p.warps.empty()) {
    out["warps"] = Json::array();
    for (const scene::Warp& warp : p.warps) out["warps"].push_back(std::visit(WarpDump{}, warp));
  }
  if (p.turbulence) out["turbulence"] = dump(*p.turbulence);
}

Json SceneDump::pigment(const scene::Pigment& p) {
  Json out = Json::object();
  pattern(out, p.pattern);
  if (p.pattern.kind == scene::PatternKind::plain) out["color"] = dump(p.color);
  if (p.color_map) out["color_map"] = map(*p.color_map, [](const Color& c) { return dump(c); });
  if (p.pigment_map)
    out["pigment_map"] = map(*p.pigment_map, [this](const scene::PigmentPtr& q) { return pigment(*q); });
  if (p.quick_color) out["quick_color"] = dump(*p.quick_color);
  return out;
}

Json SceneDump::normal(const scene::Normal& n) {
  Json out = Json::object();
  pattern(out, n.pattern);
  out["bump_size"] = n.amount;
  out["accuracy"] = n.accuracy;
  out["no_bump_scale"] = n.no_bump_scale;
  if (n.slope_map)
    out["slope_map"] = map(*n.slope_map, [](const scene::SlopeEntry& e) { return Json{e.height, e.slope}; });
  if (n.normal_map)
    out["normal_map"] =
        map(*n.normal_map, [this](const scene::NormalPtr& q) { return q ? normal(*q) : Json(nullptr); });
  return out;
}

Json SceneDump::texture(const scene::TexturePtr& t) {
  if (!t) return nullptr;
  const auto known = texture_index_.find(t.get());
  if (known != texture_index_.end()) return known->second;
  Json out = Json::object();
  if (t->patterned()) {
    pattern(out, t->pattern);
    if (t->texture_map)
      out["texture_map"] = map(*t->texture_map, [this](const scene::TexturePtr& q) { return texture(q); });
  } else {
    out["layers"] = Json::array();
    for (const scene::TextureLayer& layer : t->layers) {
      Json entry{{"pigment", pigment(*layer.pigment)}};
      entry["normal"] = layer.normal ? normal(*layer.normal) : Json(nullptr);
      entry["finish"] = finish(*layer.finish);
      out["layers"].push_back(std::move(entry));
    }
  }
  const std::size_t index = textures_.size();
  textures_.push_back(std::move(out));
  texture_index_[t.get()] = index;
  keep_.push_back(t);
  return index;
}

Json SceneDump::density(const scene::Density& d) {
  Json out = Json::object();
  pattern(out, d.pattern);
  if (d.pattern.kind == scene::PatternKind::plain) out["color"] = dump(d.color);
  if (d.color_map) out["color_map"] = map(*d.color_map, [](const Color& c) { return dump(c); });
  if (d.density_map)
    out["density_map"] = map(*d.density_map, [this](const scene::DensityPtr& q) { return density(*q); });
  return out;
}

Json SceneDump::media(const scene::Media& m) {
  Json out{{"method", m.method},
           {"intervals", m.intervals},
           {"samples", {m.samples_min, m.samples_max}},
           {"aa_level", m.aa_level},
           {"aa_threshold", m.aa_threshold},
           {"ratio", m.ratio},
           {"confidence", m.confidence},
           {"variance", m.variance},
           {"jitter", m.jitter},
           {"absorption", dump(m.absorption)},
           {"emission", dump(m.emission)}};
  out["scattering"] = m.has_scattering ? Json{{"type", m.scattering_type},
                                              {"color", dump(m.scattering)},
                                              {"eccentricity", m.eccentricity},
                                              {"extinction", m.extinction}}
                                       : Json(nullptr);
  out["collect"] = m.collect;
  out["density"] = Json::array();
  for (const scene::DensityPtr& d : m.densities) out["density"].push_back(density(*d));
  return out;
}

Json SceneDump::interior(const scene::InteriorPtr& i) {
  if (!i) return nullptr;
  const auto known = interior_index_.find(i.get());
  if (known != interior_index_.end()) return known->second;
  Json out{{"ior", i->ior},
           {"dispersion", i->dispersion},
           {"dispersion_samples", i->dispersion_samples},
           {"caustics", i->caustics},
           {"fade_distance", i->fade_distance},
           {"fade_power", i->fade_power},
           {"fade_color", dump(i->fade_color)},
           {"hollow", i->hollow}};
  out["media"] = Json::array();
  for (const scene::Media& m : i->media) out["media"].push_back(media(m));
  const std::size_t index = interiors_.size();
  interiors_.push_back(std::move(out));
  interior_index_[i.get()] = index;
  return index;
}

}  // namespace verisim::cli
