#include "tracer/shading/wave.h"

#include "tracer/shading/finish.h"
#include "tracer/textures/pigment.h"

namespace verisim::shading {
namespace {

constexpr double kNearestHit = 1e-4;       // of camera rays
constexpr double kShadowTolerance = 1e-3;  // to the shaded point and to the light
constexpr float kDark = static_cast<float>(kEpsilon);

bool is_finite(const Rgb& c) { return std::fabs(c.r) + std::fabs(c.g) + std::fabs(c.b) < 1e30f; }

// Lights that draw random numbers, or that light a surface by several directions at once, are for the common way.
bool is_simple(const Light& light) { return !light.area_illumination() && !(light.area() && light.source().jitter) && is_finite(light.color()); }

}  // namespace

Wave::Wave(Tracer& tracer) : tracer_(tracer), scene_(tracer.scene()), kernels_(wave_kernels()), lanes_{} {
  usable_ = scene_.quality >= 9 && !tracer_.random_.replay() && !scene_.effects && !scene_.fog && scene_.rainbows.empty() && scene_.adc_bailout >= 0 && scene_.adc_bailout < 1;
  for (std::size_t i = 0; i < scene_.global_lights(); ++i) usable_ = usable_ && is_simple(scene_.lights()[i]);
  for (float* tint : {lanes_.tint.r, lanes_.tint.g, lanes_.tint.b}) std::fill_n(tint, kMost, 1.0f);
  plain_sky_ = !scene_.sky.varies();
  if (plain_sky_) sky_ = scene_.sky.seen({0, 0, 1}, false);
}

Wave::Material::Material(const textures::CompiledTexture& texture, const SceneData& scene) {
  if (texture.layers.size() != 1) return;
  const textures::CompiledLayer& only = texture.layers[0];
  const scene::Finish& f = only.finish;
  const bool mirror = f.reflection.maximum != Rgb() || f.reflection.minimum != Rgb();
  if (mirror || only.pigment->transparent || f.brilliance != 1 || f.crand > 0 || f.irid > 0 || (f.phong > 0 && f.specular > 0)) return;
  constant = only.pigment->source == textures::CompiledPigment::Source::plain;
  color = only.pigment->color;
  glow = f.ambient * scene.ambient_light + f.emission;
  phong = f.phong > 0;
  amount = f.phong > 0 ? f.phong : f.specular > 0 ? f.specular : 0;
  exponent = f.phong > 0 ? f.phong_size : f.roughness == 0 ? 0 : 1.0 / f.roughness;
  base_limit = f.phong > 0 && f.phong_size >= 60 ? 0.0008 : 0;
  if (is_finite(glow) && std::fabs(exponent) < 1e6 && amount < 1e30 && std::fabs(f.diffuse) + std::fabs(f.diffuse_back) < 1e30f) layer = &only;
}

const Wave::Material& Wave::material(const textures::CompiledTexture& texture) {
  if (last_material_.first != &texture) last_material_ = {&texture, &materials_.try_emplace(&texture, texture, scene_).first->second};
  return *last_material_.second;
}

// Which way hit i goes, and its normal.
void Wave::meet(int i) {
  Met& met = met_[i];
  met.material = nullptr;
  const shapes::Hit& hit = hits_[i];
  const shapes::Surface& surface = *hit.shape->surface;
  if (surface.shows_several() || surface.ignore_global_lights || !surface.group_lights.empty()) return;
  const Vec3 direction = lanes_.camera.direction.at(i);
  met.normal = hit.shape->normal(hit);
  const double along = dot(met.normal, direction);
  if (!(std::fabs(along) < 1e30)) return;
  const bool inside = along > 0;
  const Material& m = material(inside && surface.interior_texture ? *surface.interior_texture : *surface.texture);
  if (!m.layer) return;
  met.material = &m;
  met.color = m.color;
  met.colored = m.constant;
  if (m.constant && !m.layer->normal) {
    if (inside) met.normal = -met.normal;
    return;
  }
  SurfaceHit& at = met.at.emplace(hit, direction, 0, 0);
  met.normal = tracer_.layer_normal(at, *m.layer, at.pattern_point(), nullptr);
  if (!(std::fabs(dot(met.normal, direction)) < 1e30)) met.material = nullptr;
}

// The colours of what has no constant colour, for all hits of a layer together.
void Wave::find_colors(int count) {
  for (int first = 0; first < count; ++first) {
    const Material* const m = found_[first] ? met_[first].material : nullptr;
    if (!m || met_[first].colored) continue;
    textures::PointRow points;
    const textures::SurfacePoint* surfaces[kMost];
    int of[kMost], n = 0;
    for (int i = first; i < count; ++i) {
      if (!found_[i] || met_[i].material != m) continue;
      points.set(n, met_[i].at->pattern_point());
      surfaces[n] = &met_[i].at->texture_point;
      of[n++] = i;
    }
    points.fill_up(n);
    Color colors[kMost];
    bool colored[kMost];
    textures::evaluate(*m->layer->pigment, n, points, surfaces, colors, colored);
    for (int k = 0; k < n; ++k) {
      Met& met = met_[of[k]];
      met.color = colors[k];
      met.colored = colored[k];
      if (!colored[k]) met.material = nullptr;
    }
  }
}

// Takes a hit among the surfaces that are lit together; false: it is not of that kind.
bool Wave::add_surface(int i) {
  const Met& met = met_[i];
  const Color& color = met.color;
  if (!met.material || color.f != 0 || color.t != 0 || !is_finite(color.rgb())) return false;

  const Material& m = *met.material;
  const int k = count_++;
  pixel_[k] = i;
  surface_[k] = hits_[i].shape->surface;
  lanes_.to_light.origin.set(k, hits_[i].point);
  lanes_.normal.set(k, met.normal);
  lanes_.view.set(k, lanes_.camera.direction.at(i));
  (m.phong != 0 ? any_phong_ : any_blinn_) |= m.amount != 0;
  any_metallic_ |= m.layer->finish.metallic > 0;
  if (layer_[k] == m.layer) return true;
  layer_[k] = m.constant ? m.layer : nullptr;
  finish_[k] = &m.layer->finish;
  lanes_.pigment.r[k] = color.r, lanes_.pigment.g[k] = color.g, lanes_.pigment.b[k] = color.b;
  const Rgb own = color.rgb() * m.glow;
  lanes_.own.r[k] = own.r, lanes_.own.g[k] = own.g, lanes_.own.b[k] = own.b;
  lanes_.exponent[k] = m.exponent, lanes_.amount[k] = m.amount, lanes_.base_limit[k] = m.base_limit, lanes_.phong[k] = m.phong;
  return true;
}

// Where the light is from every surface.
void Wave::aim(const Light& light) {
  if (light.radial()) {
    kernels_.aim(light.source().position + Vec3(0, 0, 0), count_, lanes_);
  } else {
    for (int k = 0; k < count_; ++k) {
      const LightDirection direction = light.direction(lanes_.to_light.origin.at(k));
      lanes_.to_light.direction.set(k, direction.towards);
      lanes_.distance[k] = direction.distance;
    }
  }
  kernels_.face(count_, lanes_);
}

// Which surfaces the light reaches, and with what colour.
bool Wave::reach(const Light& light, const RayState& ray) {
  bool any = false;
  for (int k = 0; k < count_; ++k) {
    asked_[k] = false;
    const scene::Finish& finish = *finish_[k];
    const bool back = lanes_.cosine[k] < kEpsilon && !surface_[k]->double_illuminate;
    if ((back && finish.diffuse_back == 0) || !reflects_light(finish)) continue;
    const LightDirection direction{lanes_.to_light.direction.at(k), lanes_.distance[k]};
    const Rgb color = light.color() * static_cast<float>(light.attenuation(lanes_.to_light.origin.at(k), direction));
    if (color.max_abs() < kDark) continue;
    any = asked_[k] = true;
    lanes_.diffuse[k] = std::max(back ? finish.diffuse_back : finish.diffuse, 0.0f);
    lanes_.shines[k] = light.highlights() && !back;
    lanes_.intensity.r[k] = color.r, lanes_.intensity.g[k] = color.g, lanes_.intensity.b[k] = color.b;
  }
  if (!any) return false;
  cast_shadows(light, ray);
  any = false;
  for (int k = 0; k < count_; ++k) {
    lanes_.lit[k] = asked_[k] && Rgb(lanes_.intensity.r[k], lanes_.intensity.g[k], lanes_.intensity.b[k]).max_abs() > kDark;
    any |= lanes_.lit[k] != 0;
  }
  return any;
}

// Filters the light of all that are asked for. Where any opaque thing decides, the rays of one cell of space are traced together.
void Wave::cast_shadows(const Light& light, const RayState& ray) {
  if (!light.shadows()) return;
  const bool together = !light.area() && !light.projector();
  const auto one_by_one = [&](int k) {
    const LightDirection direction{lanes_.to_light.direction.at(k), lanes_.distance[k]};
    const Rgb arriving(lanes_.intensity.r[k], lanes_.intensity.g[k], lanes_.intensity.b[k]);
    const Rgb color = tracer_.shadowed(light, lanes_.to_light.origin.at(k), direction, ray, surface_[k], arriving);
    lanes_.intensity.r[k] = color.r, lanes_.intensity.g[k] = color.g, lanes_.intensity.b[k] = color.b;
  };
  accel::WorldEntry* entry = nullptr;
  Box3 served;
  int first = 0, end = 0;  // the rays that wait, with this entry
  // Without a tree there is nothing to know of where rays start.
  const bool entries = !scene_.world.tree().empty(), transparent = scene_.world.has_transparent_shadows();
  bool wanted[kMost], blocked[kMost] = {};
  double limit[kMost];
  const auto trace_waiting = [&] {
    if (first < end) scene_.world.occluded_row(lanes_.to_light, first, end - first, wanted, kShadowTolerance, limit, entry, blocked);
    first = end;
  };
  for (int k = 0; k < count_; ++k) {
    wanted[k] = false;
    if (!asked_[k]) continue;
    if (!together) {
      one_by_one(k);
      continue;
    }
    const Vec3 p = lanes_.to_light.origin.at(k);
    if (entries && accel::contains(served, p)) {
      tracer_.coherent_.used_again(accel::CoherentRays::Viewer::camera);
    } else if (entries) {
      if (entry) trace_waiting();  // the next one may take its place
      accel::WorldEntry* const next = tracer_.shadow_entry({ray, surface_[k], light}, p);
      if (entry || next) {
        trace_waiting();
        first = k;
      }
      entry = next;
      served = tracer_.coherent_.served();
    }
    if (entry ? !entry->only_opaque : transparent) {
      trace_waiting();
      one_by_one(k);
      served.makeEmpty();  // it may have made the entry another's
    } else {
      ++tracer_.statistics_.shadow_rays;
      limit[k] = lanes_.distance[k] - kShadowTolerance;
      wanted[k] = lanes_.distance[k] > 2 * kShadowTolerance;
      end = k + 1;
    }
  }
  trace_waiting();
  for (int k = 0; k < count_; ++k)
    if (blocked[k]) asked_[k] = false;
}

void Wave::respond() {
  if (any_metallic_ || tinted_) {
    for (int k = 0; k < count_; ++k) {
      const Rgb pigment(lanes_.pigment.r[k], lanes_.pigment.g[k], lanes_.pigment.b[k]);
      const Rgb tint = finish_[k]->metallic > 0 ? metallic_tint(pigment, finish_[k]->metallic, lanes_.cosine[k]) : Rgb(1);
      lanes_.tint.r[k] = tint.r, lanes_.tint.g[k] = tint.g, lanes_.tint.b[k] = tint.b;
    }
    tinted_ = true;
  }
  if (!kernels_.respond(any_phong_, any_blinn_, count_, lanes_)) return;
  for (int k = 0; k < count_; ++k) {
    if (!lanes_.uncertain[k] || lanes_.lit[k] == 0 || lanes_.amount[k] * lanes_.shines[k] == 0) continue;
    const Vec3 n = lanes_.normal.at(k), d = lanes_.view.at(k), l = lanes_.to_light.direction.at(k);
    lanes_.strength[k] = static_cast<float>(lanes_.phong[k] != 0 ? phong_highlight(*finish_[k], n, d, l) : specular_highlight(*finish_[k], n, d, l));
  }
}

void Wave::light(const Light& light, const RayState& ray) {
  aim(light);
  if (!reach(light, ray)) return;
  respond();
  kernels_.add(count_, lanes_);
}

void Wave::trace(double x, double y, int count, const accel::WorldEntry* const* entries, Color* out) {
  if (tracer_.cancel_ && tracer_.cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  count_ = 0;
  any_phong_ = any_blinn_ = any_metallic_ = false;
  RayState ray = tracer_.camera_state(lanes_.camera.at(0), false);
  tracer_.statistics_.camera_rays += static_cast<std::uint64_t>(count);
  for (int first = 0, end; first < count; first = end) {
    for (end = first + 1; end < count && entries[end] == entries[first];) ++end;
    scene_.world.intersect_row(lanes_.camera, first, end - first, ray.kind(), kNearestHit, entries[first], hits_, found_);
  }
  for (int i = 0; i < count; ++i)
    if (found_[i]) meet(i);
  find_colors(count);
  for (int i = 0; i < count; ++i) {
    if (!found_[i] && plain_sky_) {
      out[i] = sky_;
      continue;
    }
    if (found_[i] && add_surface(i)) continue;
    ray.ray = lanes_.camera.at(i);
    tracer_.random_.begin_sample(x + i, y, 0);
    out[i] = tracer_.resolve(ray, found_[i] ? &hits_[i] : nullptr);
  }
  if (count_ == 0) return;
  for (float* sum : {lanes_.direct.r, lanes_.direct.g, lanes_.direct.b}) std::fill_n(sum, count_, 0.0f);
  for (std::size_t i = 0; i < scene_.global_lights(); ++i) light(scene_.lights()[i], ray);
  for (int k = 0; k < count_; ++k)
    out[pixel_[k]] = {0 + (lanes_.own.r[k] + lanes_.direct.r[k]), 0 + (lanes_.own.g[k] + lanes_.direct.g[k]), 0 + (lanes_.own.b[k] + lanes_.direct.b[k])};
}

}  // namespace verisim::shading
