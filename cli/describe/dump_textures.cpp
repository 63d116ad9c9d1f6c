// Textures, pigments, patterns, interiors and media of the scene dump.
#include "cli/describe/dump_fields.h"

namespace verisim::cli {

using DumpJson = SceneDump::Json;

namespace {

constexpr const char* kWaves[] = {"ramp_wave", "sine_wave", "triangle_wave", "scallop_wave", "cubic_wave", "poly_wave"};

struct WarpDump {
  DumpJson operator()(const Transform& t) const { return {{"matrix", dump(t)}}; }
  DumpJson operator()(const scene::TurbulenceWarp& w) const {
    return {{"turbulence", dump(static_cast<const scene::Turbulence&>(w))}};
  }
  DumpJson operator()(const scene::RepeatWarp& w) const {
    return {{"repeat", {{"axis", w.axis}, {"width", w.width}, {"flip", dump(w.flip)}, {"offset", dump(w.offset)}}}};
  }
  DumpJson operator()(const scene::BlackHoleWarp& w) const {
    return {{"black_hole",
             {{"center", dump(w.center)},
              {"radius", w.radius},
              {"strength", w.strength},
              {"falloff", w.falloff},
              {"type", w.type},
              {"inverse", w.inverse},
              {"repeat", w.repeats ? dump(w.repeat) : DumpJson(nullptr)},
              {"turbulence", w.turbulent ? dump(w.turbulence) : DumpJson(nullptr)}}}};
  }
  DumpJson operator()(const scene::ProjectionWarp& w) const {
    static constexpr const char* kKinds[] = {"cylindrical", "spherical", "toroidal", "planar"};
    return {{kKinds[static_cast<std::size_t>(w.kind)],
             {{"orientation", dump(w.orientation)},
              {"dist_exp", w.distance_exponent},
              {"major_radius", w.major_radius},
              {"offset", w.offset}}}};
  }
  DumpJson operator()(const scene::CubicWarp&) const { return {{"cubic", true}}; }
};

DumpJson parameters(SceneDump& dumper, const scene::PatternParams& params) {
  DumpJson out = nullptr;
  const auto add = [&](const auto& p) {
    if constexpr (HasFields<std::remove_cvref_t<decltype(p)>>) add_fields(out, p, dumper);
  };
  std::visit(add, params);
  return out;
}

template <class T, class F>
DumpJson map(const scene::BlendMap<T>& entries, const F& convert) {
  DumpJson out = DumpJson::array();
  for (const scene::MapEntry<T>& entry : entries) out.push_back({entry.position, convert(entry.value)});
  return out;
}

DumpJson finish(const scene::Finish& f) {
  DumpJson out{{"ambient", dump(f.ambient)},
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
  out["subsurface"] = f.subsurface
                          ? DumpJson{{"translucency", dump(f.translucency)}, {"anisotropy", dump(f.anisotropy)}}
                          : DumpJson(nullptr);
  return out;
}

// What pigments and densities have in common.
template <class Colored>
void colors(DumpJson& out, const Colored& c) {
  if (c.pattern.kind == scene::PatternKind::plain) out["color"] = dump(c.color);
  if (c.color_map) out["color_map"] = map(*c.color_map, [](const Color& color) { return dump(color); });
}

}  // namespace

void SceneDump::pattern(DumpJson& out, const scene::Pattern& p) {
  out["type"] = pattern_name(p.kind);
  if (p.kind == scene::PatternKind::plain || p.kind == scene::PatternKind::none) return;
  if (p.params) out["parameters"] = parameters(*this, *p.params);
  out["wave"] = kWaves[static_cast<std::size_t>(p.wave)];
  out["frequency"] = p.frequency;
  out["phase"] = p.phase;
  if (p.wave == scene::Wave::poly) out["exponent"] = p.exponent;
  if (p.noise_generator) out["noise_generator"] = p.noise_generator;
  if (!p.warps.empty()) {
    out["warps"] = DumpJson::array();
    for (const scene::Warp& warp : p.warps) out["warps"].push_back(std::visit(WarpDump{}, warp));
  }
  if (p.turbulence) out["turbulence"] = dump(*p.turbulence);
}

DumpJson SceneDump::pigment(const scene::Pigment& p) {
  DumpJson out = DumpJson::object();
  pattern(out, p.pattern);
  colors(out, p);
  if (p.pigment_map)
    out["pigment_map"] = map(*p.pigment_map, [this](const scene::PigmentPtr& q) { return pigment(*q); });
  if (p.quick_color) out["quick_color"] = dump(*p.quick_color);
  return out;
}

DumpJson SceneDump::normal(const scene::Normal& n) {
  DumpJson out = DumpJson::object();
  pattern(out, n.pattern);
  out["bump_size"] = n.amount;
  out["accuracy"] = n.accuracy;
  out["no_bump_scale"] = n.no_bump_scale;
  if (n.slope_map)
    out["slope_map"] = map(*n.slope_map, [](const scene::SlopeEntry& e) { return DumpJson{e.height, e.slope}; });
  if (n.normal_map)
    out["normal_map"] =
        map(*n.normal_map, [this](const scene::NormalPtr& q) { return q ? normal(*q) : DumpJson(nullptr); });
  return out;
}

DumpJson SceneDump::texture(const scene::TexturePtr& t) {
  if (!t) return nullptr;
  const auto known = texture_index_.find(t.get());
  if (known != texture_index_.end()) return known->second;
  DumpJson out = DumpJson::object();
  if (t->patterned()) {
    pattern(out, t->pattern);
    if (t->texture_map)
      out["texture_map"] = map(*t->texture_map, [this](const scene::TexturePtr& q) { return texture(q); });
  } else {
    out["layers"] = DumpJson::array();
    for (const scene::TextureLayer& layer : t->layers) {
      DumpJson entry{{"pigment", pigment(*layer.pigment)}};
      entry["normal"] = layer.normal ? normal(*layer.normal) : DumpJson(nullptr);
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

DumpJson SceneDump::density(const scene::Density& d) {
  DumpJson out = DumpJson::object();
  pattern(out, d.pattern);
  colors(out, d);
  if (d.density_map)
    out["density_map"] = map(*d.density_map, [this](const scene::DensityPtr& q) { return density(*q); });
  return out;
}

DumpJson SceneDump::media(const scene::Media& m) {
  DumpJson out{{"method", m.method},
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
  out["scattering"] = m.has_scattering ? DumpJson{{"type", m.scattering_type},
                                                  {"color", dump(m.scattering)},
                                                  {"eccentricity", m.eccentricity},
                                                  {"extinction", m.extinction}}
                                       : DumpJson(nullptr);
  out["collect"] = m.collect;
  out["density"] = DumpJson::array();
  for (const scene::DensityPtr& d : m.densities) out["density"].push_back(density(*d));
  return out;
}

DumpJson SceneDump::interior(const scene::InteriorPtr& i) {
  if (!i) return nullptr;
  const auto known = interior_index_.find(i.get());
  if (known != interior_index_.end()) return known->second;
  DumpJson out{{"ior", i->ior},
               {"dispersion", i->dispersion},
               {"dispersion_samples", i->dispersion_samples},
               {"caustics", i->caustics},
               {"fade_distance", i->fade_distance},
               {"fade_power", i->fade_power},
               {"fade_color", dump(i->fade_color)},
               {"hollow", i->hollow}};
  out["media"] = DumpJson::array();
  for (const scene::Media& m : i->media) out["media"].push_back(media(m));
  const std::size_t index = interiors_.size();
  interiors_.push_back(std::move(out));
  interior_index_[i.get()] = index;
  return index;
}

}  // namespace verisim::cli
