// Objects and lights of the scene dump.
#include "cli/describe/dump_fields.h"
#include "cli/describe/object_names.h"

namespace verisim::cli {

using DumpJson = SceneDump::Json;

namespace {

const char* spline(scene::SplineKind kind) {
  static constexpr const char* kNames[] = {"linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline",
                                           "b_spline"};
  return kNames[static_cast<std::size_t>(kind)];
}

template <class Points>
DumpJson points(const Points& items) {
  DumpJson out = DumpJson::array();
  for (const auto& p : items) out.push_back(dump(p));
  return out;
}

DumpJson container(const scene::Contained& c) {
  if (c.sphere) return {{"sphere", {dump(c.center), c.radius}}};
  return {{"box", {dump(c.low), dump(c.high)}}};
}

std::string to_utf8(const std::u16string& text) {
  std::string out;
  for (const char16_t unit : text) {
    const unsigned c = unit;
    if (c < 0x80)
      out += static_cast<char>(c);
    else if (c < 0x800)
      out += {static_cast<char>(0xc0 | c >> 6), static_cast<char>(0x80 | (c & 0x3f))};
    else
      out += {static_cast<char>(0xe0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3f)),
              static_cast<char>(0x80 | (c & 0x3f))};
  }
  return out;
}

// The numbers of a shape, under the words of SDL.
struct ShapeDump {
  SceneDump& dumper;
  const scene::Object& object;
  DumpJson& out;

  void children() const {
    out["children"] = DumpJson::array();
    for (const scene::ObjectPtr& child : scene::children_of(object)) out["children"].push_back(dumper.object(*child));
  }

  template <HasFields Held>
  void operator()(const Held& shape) const {
    add_fields(out, shape, dumper);
  }
  void operator()(const scene::Boxed<scene::Quadric>& q) const { add_fields(out, *q, dumper); }
  void operator()(const scene::Triangle& t) const { out["corners"] = points(t.p); }
  void operator()(const scene::Boxed<scene::SmoothTriangle>& t) const {
    out["corners"] = points(t->p), out["normals"] = points(t->n);
  }
  void operator()(const scene::Polygon& p) const { out["points"] = points(p.points); }
  void operator()(const scene::Poly& p) const { out["order"] = p.order, out["coefficients"] = p.coefficients; }
  void operator()(const std::shared_ptr<const scene::Blob>& b) const {
    out["threshold"] = b->threshold;
    out["components"] = DumpJson::array();
    for (const scene::BlobComponent& c : b->components) {
      DumpJson part{{"type", c.cylinder ? "cylinder" : "sphere"}, {"a", dump(c.a)}};
      if (c.cylinder) part["b"] = dump(c.b);
      part["radius"] = c.radius, part["strength"] = c.strength;
      if (c.transform) part["matrix"] = dump(*c.transform);
      part["texture"] = dumper.texture(c.texture);
      out["components"].push_back(std::move(part));
    }
  }
  void operator()(const std::shared_ptr<const scene::Lathe>& l) const {
    out["spline"] = spline(l->spline), out["points"] = points(l->points);
  }
  void operator()(const std::shared_ptr<const scene::Sor>& s) const {
    out["points"] = points(s->points), out["open"] = s->open;
  }
  void operator()(const std::shared_ptr<const scene::Prism>& p) const {
    out["spline"] = spline(p->spline), out["sweep"] = p->conic ? "conic_sweep" : "linear_sweep", out["open"] = p->open;
    out["heights"] = {p->low, p->high}, out["points"] = points(p->points);
  }
  void operator()(const std::shared_ptr<const scene::SphereSweep>& s) const {
    out["spline"] = spline(s->spline), out["centers"] = points(s->centers), out["radii"] = s->radii,
    out["tolerance"] = s->tolerance;
  }
  void operator()(const std::shared_ptr<const scene::BicubicPatch>& p) const {
    out["type"] = p->type, out["steps"] = {p->u_steps, p->v_steps}, out["flatness"] = p->flatness,
    out["points"] = points(p->points);
    if (p->uv) out["uv_vectors"] = points(*p->uv);
  }
  void operator()(const std::shared_ptr<const scene::HeightField>& h) const {
    out["water_level"] = h->water_level, out["smooth"] = h->smooth;
  }
  void operator()(const std::shared_ptr<const scene::Isosurface>& i) const {
    out["function"] = dump(i->function), out["contained_by"] = container(i->container), out["threshold"] = i->threshold,
    out["accuracy"] = i->accuracy;
    out["max_gradient"] = i->max_gradient, out["evaluate"] = i->evaluate ? dump(*i->evaluate) : DumpJson(nullptr),
    out["max_trace"] = i->max_trace, out["open"] = i->open;
  }
  void operator()(const std::shared_ptr<const scene::Parametric>& p) const {
    out["functions"] = {dump(p->function[0]), dump(p->function[1]), dump(p->function[2])}, out["low"] = dump(p->low),
    out["high"] = dump(p->high);
    out["contained_by"] = container(p->container), out["accuracy"] = p->accuracy, out["max_gradient"] = p->max_gradient;
  }
  void operator()(const std::shared_ptr<const scene::JuliaFractal>& j) const {
    out["parameter"] = j->parameter, out["slice"] = j->slice, out["slice_distance"] = j->slice_distance,
    out["exponent"] = dump(j->exponent);
    out["algebra"] = j->hypercomplex ? "hypercomplex" : "quaternion", out["function"] = static_cast<int>(j->function);
    out["max_iteration"] = j->max_iteration, out["precision"] = j->precision;
  }
  void operator()(const std::shared_ptr<const scene::Text>& t) const {
    out["font"] = t->font, out["builtin_font"] = t->builtin_font, out["text"] = to_utf8(t->text),
    out["thickness"] = t->thickness, out["offset"] = dump(t->offset);
  }
  void operator()(const scene::Mesh& m) const {
    const scene::MeshData& d = *m.data;
    out["vertices"] = points(d.vertices), out["normals"] = points(d.normals), out["uv_vectors"] = points(d.uvs);
    out["inside_vector"] = d.inside_vector ? dump(*d.inside_vector) : DumpJson(nullptr);
    out["textures"] = DumpJson::array();
    for (const scene::TexturePtr& t : m.textures.empty() ? d.textures : m.textures)
      out["textures"].push_back(dumper.texture(t));
    out["faces"] = DumpJson::array();
    for (const scene::MeshTriangle& t : d.triangles) {
      DumpJson face{{"vertices", t.vertex}};
      if (t.smooth) face["normals"] = t.normal;
      if (t.has_uv) face["uv"] = t.uv;
      for (const std::int32_t texture : t.texture)
        if (texture >= 0) face["textures"].push_back(texture);
      out["faces"].push_back(std::move(face));
    }
  }
  void operator()(const scene::Csg&) const { children(); }
  void operator()(const scene::LightGroup& g) const {
    out["global_lights"] = g.global_lights;
    children();
  }
  void operator()(const scene::Boxed<scene::LightSource>& l) const { out.update(dumper.light(*l)); }
};

}  // namespace

DumpJson SceneDump::light(const scene::LightSource& l) {
  DumpJson out{{"kind", info(l.kind).name},
               {"location", dump(l.position)},
               {"color", dump(l.color)},
               {"parallel", l.parallel},
               {"point_at", dump(l.point_at)},
               {"direction", dump(l.direction)},
               {"radius", l.radius},
               {"falloff", l.falloff},
               {"tightness", l.tightness},
               {"fade_distance", l.fade_distance},
               {"fade_power", l.fade_power},
               {"media_interaction", l.media_interaction},
               {"media_attenuation", l.media_attenuation}};
  out["area_light"] = l.area ? DumpJson{{"axis1", dump(l.axis1)},     {"axis2", dump(l.axis2)},
                                        {"size", {l.size1, l.size2}}, {"adaptive", l.adaptive},
                                        {"jitter", l.jitter},         {"circular", l.circular},
                                        {"orient", l.orient},         {"area_illumination", l.area_illumination}}
                             : DumpJson(nullptr);
  out["looks_like"] = l.looks_like ? object(*l.looks_like) : DumpJson(nullptr);
  out["projected_through"] = l.projected_through ? object(*l.projected_through) : DumpJson(nullptr);
  if (l.photons_given)
    out["photons"] = {{"reflection", dump_flag(l.photon_reflection)},
                      {"refraction", dump_flag(l.photon_refraction)},
                      {"area_light", l.photon_area}};
  return out;
}

DumpJson SceneDump::object(const scene::Object& o) {
  DumpJson out{{"type", object_keyword(o)}, {"place", dump(o.place)}};
  std::visit(ShapeDump{*this, o, out}, o.shape);
  out["matrix"] = o.transform ? dump(*o.transform) : DumpJson(nullptr);
  out["bounds"] = {{"corner", o.bounds.low}, {"size", o.bounds.size}};
  for (const auto& [name, limits] : {std::pair{"bounded_by", &o.bounded_by}, std::pair{"clipped_by", &o.clipped_by}}) {
    if (limits->empty()) continue;
    out[name] = DumpJson::array();
    for (const scene::ObjectPtr& limit : *limits) out[name].push_back(object(*limit));
  }
  out["texture"] = texture(o.texture);
  out["interior_texture"] = texture(o.interior_texture);
  out["interior"] = interior(o.interior);
  DumpJson flags = DumpJson::array();
  const auto flag = [&flags](bool on, const char* name) {
    if (on) flags.push_back(name);
  };
  flag(o.inverted, "inverse");
  flag(o.is_hollow(), "hollow");
  flag(o.no_shadow, "no_shadow");
  flag(o.no_image, "no_image");
  flag(o.no_reflection, "no_reflection");
  flag(o.no_radiosity, "no_radiosity");
  flag(o.double_illuminate, "double_illuminate");
  flag(o.uv_mapping, "uv_mapping");
  flag(o.sturm, "sturm");
  flag(!o.hierarchy, "hierarchy off");
  flag(!o.split_union, "split_union off");
  flag(o.cutaway_textures, "cutaway_textures");
  out["flags"] = std::move(flags);
  if (o.radiosity_importance >= 0) out["radiosity_importance"] = o.radiosity_importance;
  if (o.photons) {
    const scene::PhotonFlags& p = *o.photons;
    out["photons"] = {{"target", p.target ? DumpJson(p.target_spacing) : DumpJson(nullptr)},
                      {"reflection", dump_flag(p.reflection)},
                      {"refraction", dump_flag(p.refraction)},
                      {"pass_through", p.pass_through},
                      {"collect", p.collect}};
  }
  return out;
}

}  // namespace verisim::cli
