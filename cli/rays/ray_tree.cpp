#include "cli/rays/ray_tree.h"

#include <fmt/format.h>

#include "cli/describe/object_names.h"

namespace verisim::cli {
namespace {

using Json = nlohmann::json;

double without_noise(double value) { return std::fabs(value) < 1e-12 ? 0 : value; }
Json numbers(const Vec3& v) { return {without_noise(v.x), without_noise(v.y), without_noise(v.z)}; }
Json numbers(const Rgb& c) { return {c.r, c.g, c.b}; }

}  // namespace

std::string text(const Vec3& v) {
  return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", without_noise(v.x), without_noise(v.y), without_noise(v.z));
}
std::string text(const Rgb& c) { return fmt::format("<{:.5g}, {:.5g}, {:.5g}>", c.r, c.g, c.b); }

std::string RayTree::name_of(const shapes::Surface* surface) const {
  if (!surface || !surface->object) return "a surface";
  return origins_ ? full_object_name(*surface->object, *origins_) : object_name(*surface->object);
}

void RayTree::line(const std::string& what) { lines_ += std::string(open_.size() * 2, ' ') + what + "\n"; }

// What was sent by the surface that the ray before meets: `reflected` and `refracted` of a state stay for all that
// follow, so the geometry tells.
const char* RayTree::kind_of(const shading::RayState& ray) const {
  if (open_.empty()) return "camera";
  if (ray.gather) return "gathering";
  if (ray.continuation) return "transmitted";
  const Open& from = open_.back();
  const bool through = dot(ray.ray.direction, from.normal) * dot(from.direction, from.normal) > 0;
  return through ? "refracted" : "reflected";
}

void RayTree::put(Json ray) { (open_.empty() ? rays_ : open_.back().story["rays"]).push_back(std::move(ray)); }

void RayTree::ray_started(const shading::RayState& ray, const shapes::Hit* hit) {
  const char* kind = kind_of(ray);
  line(fmt::format("{} ray from {} towards {}{}", kind, text(ray.ray.origin), text(ray.ray.direction),
                   ray.weight == 1 ? "" : fmt::format(", weight {:.4g}", ray.weight)));
  Json story{{"kind", kind},
             {"origin", numbers(ray.ray.origin)},
             {"direction", numbers(ray.ray.direction)},
             {"weight", ray.weight},
             {"distance", hit ? Json(hit->t) : Json(nullptr)},
             {"layers", Json::array()},
             {"rays", Json::array()},
             {"sum", Json::array()}};
  open_.push_back({std::move(story), ray.ray.direction, Vec3(0, 0, 0), {}, {}, 0, {}});
  open_.back().story["crosses"] = crossings(ray);
  if (!hit) line("hits nothing: sees the sky");
}

// A part of the colour of the latest ray.
Json* RayTree::term(const std::string& what, const Rgb& adds, bool even_nothing) {
  if (open_.empty() || (adds == Rgb() && !even_nothing)) return nullptr;
  Open& ray = open_.back();
  ray.sum += adds;
  Json& sum = ray.story["sum"];
  sum.push_back({{"what", what}, {"adds", numbers(adds)}});
  return &sum.back();
}

// What the latest layer adds.
void RayTree::layer_term(const std::string& what, const Rgb& light) {
  if (open_.empty()) return;
  if (Json* added = term(what, light * open_.back().share)) (*added)["layer"] = open_.back().story["layers"].size() - 1;
}

void RayTree::texture_started(float weight) {
  if (!open_.empty()) open_.back().weights.push_back(open_.back().weight() * weight);
}
void RayTree::texture_ended() {
  if (!open_.empty()) open_.back().weights.pop_back();
}

void RayTree::indirect(const char* effect, const Rgb& light) {
  if (light == Rgb()) return;
  line(fmt::format("  {} adds {}", effect, text(light)));
  layer_term(effect, light);
}

void RayTree::rays_added(const Rgb& seen) {
  if (open_.empty()) return;
  Open& ray = open_.back();
  const std::size_t first = std::exchange(ray.rays_added, ray.story["rays"].size());
  if (first == ray.rays_added) return;  // none was sent
  const std::string kind = ray.story["rays"][first]["kind"];
  const Rgb adds = seen * ray.weight();
  line(fmt::format("what is {} adds {}", kind == "cut off" ? "not traced" : kind, text(adds)));
  if (Json* added = term(kind, adds, true)) (*added)["rays"] = {first, ray.rays_added};
}

void RayTree::air(const Color& without, const Color& with, float) {
  if (without == with) return;
  line(fmt::format("fog and media make {} of {}", text(with.rgb()), text(without.rgb())));
  if (Json* added = term("fog and media", with.rgb() - without.rgb())) (*added)["without"] = numbers(without.rgb());
}

void RayTree::ray_ended(const shading::RayState&, const Color& color) {
  if (open_.back().story["distance"].is_null()) {
    term("sky", color.rgb() - open_.back().sum);
  } else if (const Rgb rest = color.rgb() - open_.back().sum; rest.max_abs() > 1e-5f * color.rgb().max_abs()) {
    term("not told apart", rest);
  }
  line(fmt::format("colour {}{}", text(color.rgb()), color.t == 0 ? "" : fmt::format(", see-through {:.4g}", color.t)));
  Json story = std::move(open_.back().story);
  open_.pop_back();
  story["color"] = numbers(color.rgb()), story["see_through"] = color.t;
  put(std::move(story));
}

void RayTree::ray_cut_off(const shading::RayState& ray) {
  const std::string reason = ray.level >= ray.level_limit
                                 ? fmt::format("max_trace_level {} is reached", ray.level_limit)
                                 : fmt::format("its weight {:.4g} is below adc_bailout", ray.weight);
  line("a ray is not traced: " + reason);
  put({{"kind", "cut off"}, {"reason", reason}, {"direction", numbers(ray.ray.direction)}});
}

void RayTree::layer(const shading::SurfaceHit& at, const shading::LayerContext& layer, const Rgb& reflectivity) {
  hit_point_ = at.hit.point;
  const std::string name = name_of(&at.surface);
  line(fmt::format("hits {} at {:.9g}{}", name, at.hit.t, at.inside_hit ? ", from inside" : ""));
  line(fmt::format("  point {}, normal {}{}", text(at.hit.point), text(at.geometric_normal),
                   layer.normal == at.geometric_normal ? "" : ", perturbed to " + text(layer.normal)));
  const Color& c = layer.pigment;
  line(fmt::format("  pigment {}{}{}{}", text(c.rgb()), c.f == 0 ? "" : fmt::format(" filter {:.4g}", c.f),
                   c.t == 0 ? "" : fmt::format(" transmit {:.4g}", c.t),
                   layer.filter == Rgb(1) ? "" : ", layers above let " + text(layer.filter) + " through"));
  const scene::Finish& f = layer.layer.finish;
  line(fmt::format("  ambient {}, emission {}, diffuse {:.4g}{}{}{}", text(f.ambient * data_->ambient_light),
                   text(f.emission), f.diffuse,
                   f.phong == 0 ? "" : fmt::format(", phong {:.4g} size {:.4g}", f.phong, f.phong_size),
                   f.specular == 0 ? "" : fmt::format(", specular {:.4g} roughness {:.4g}", f.specular, f.roughness),
                   reflectivity == Rgb() ? "" : ", reflects " + text(reflectivity)));
  if (open_.empty()) return;
  open_.back().normal = at.geometric_normal;
  const Rgb own = c.rgb() * (f.ambient * data_->ambient_light + f.emission) * layer.opacity;
  open_.back().share = layer.filter * open_.back().weight();
  open_.back().story["layers"].push_back({{"object", name},
                                          {"point", numbers(at.hit.point)},
                                          {"normal", numbers(at.geometric_normal)},
                                          {"bumped", numbers(layer.normal)},
                                          {"inside", at.inside_hit},
                                          {"pigment", numbers(c.rgb())},
                                          {"filter", c.f},
                                          {"transmit", c.t},
                                          {"above", numbers(layer.filter)},
                                          {"own", numbers(own)},
                                          {"reflects", numbers(reflectivity)},
                                          {"share", numbers(open_.back().share)},
                                          {"lights", Json::array()}});
  layer_term("own light", own);
}

void RayTree::light(const shading::Light& light, const shading::LightDirection& direction, bool tested,
                    const Rgb& arriving, const Rgb& added, const Rgb& highlight) {
  const std::string where = text(light.source().position);
  Json story{{"position", numbers(light.source().position)},
             {"distance", direction.distance},
             {"arrives", numbers(arriving)},
             {"adds", numbers(added)},
             {"highlight", numbers(highlight)}};
  if (!tested) {
    const bool dark = arriving.max_abs() == 0;
    line(fmt::format("  light at {}: {}", where, dark ? "out of its reach" : "behind the surface, adds nothing"));
    story["state"] = dark ? "out of reach" : "behind";
  } else if (arriving.max_abs() == 0) {
    std::string blocker;
    shapes::Hit hit;
    if (light.area()) {
      blocker = " (all its samples)";
    } else if (data_->world.intersect({hit_point_, direction.towards}, shapes::RayKind::shadow, 1e-3,
                                      direction.distance - 1e-3, hit)) {
      blocker = fmt::format(" of {} at {:.6g}", name_of(hit.shape->surface), hit.t);
      story["blocker"] = name_of(hit.shape->surface);
      story["blocked_at"] = numbers(hit_point_ + direction.towards * hit.t);
    }
    line(fmt::format("  light at {}: {:.6g} away, in shadow{}", where, direction.distance, blocker));
    story["state"] = "shadow";
  } else {
    line(fmt::format("  light at {}: {:.6g} away towards {}, {} arrives, adds {}{}", where, direction.distance,
                     text(direction.towards), text(arriving), text(added),
                     highlight == Rgb() ? "" : ", of that the highlight " + text(highlight)));
    story["state"] = "lit";
    layer_term("diffuse of the light at " + where, added - highlight);
    layer_term("highlight of the light at " + where, highlight);
  }
  if (open_.empty() || open_.back().story["layers"].empty()) return;
  open_.back().story["layers"].back()["lights"].push_back(std::move(story));
}

// Every surface along the ray, near to far.
Json RayTree::crossings(const shading::RayState& ray) {
  constexpr int kMax = 40;
  Json all = Json::array();
  double from = 1e-4;
  line("crosses, near to far:");
  for (int i = 0; i < kMax; ++i) {
    shapes::Hit hit;
    if (!data_->world.intersect(ray.ray, ray.kind(), from, std::numeric_limits<double>::infinity(), hit)) {
      if (i == 0) line("  nothing");
      return all;
    }
    const std::string name = name_of(hit.shape->surface);
    line(fmt::format("  {:.9g}  {}", hit.t, name));
    all.push_back({{"distance", hit.t}, {"object", name}});
    from = std::nextafter(hit.t, std::numeric_limits<double>::infinity());
  }
  line("  ...");
  return all;
}

}  // namespace verisim::cli
