#include "tracer/shading/photon_walk.h"

#include "tracer/shading/dispersion.h"
#include "tracer/shading/finish.h"

namespace verisim::shading {
namespace {

constexpr int kMaxNesting = 300;


// On in one of object and light, off in neither (spec 07 3.6).
bool allowed(scene::Flag object, scene::Flag light) {
  using enum scene::Flag;
  return (object == on || light == on) && object != off && light != off;
}

}  // namespace

double PhotonShot::area_factor(double path) const {
  double factor = sigma * sigma;
  if (!light->parallel) factor *= path * path;
  if (light->fade_power > 0 && std::fabs(light->fade_distance) > kEpsilon)
    factor *= 2.0 / (1.0 + std::pow(path / light->fade_distance, static_cast<double>(light->fade_power)));
  return factor;
}

bool PhotonWalk::run(const Ray& start, std::span<const scene::Interior* const> around, const Rgb& color, std::vector<StoredPhoton>& stored) {
  stored_ = &stored;
  hit_target_ = false;
  const Tracer::InteriorScope scope(tracer_);
  Packet packet;
  packet.ray.ray = start;
  packet.ray.interiors = tracer_.copied(around);
  packet.ray.hollow = tracer_.all_hollow(packet.ray.interiors);
  packet.color = color;
  follow(packet);
  return hit_target_;
}

void PhotonWalk::follow(Packet packet) {
  if (packet.ray.level >= shot_.max_trace_level || packet.ray.weight < shot_.adc_bailout || nesting_ >= kMaxNesting) return;
  if (tracer_.cancel_ && tracer_.cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  shapes::Hit hit;
  const auto kind = packet.ray.reflected ? shapes::RayKind::reflected : shapes::RayKind::photon;
  if (!tracer_.scene_.world.intersect(packet.ray.ray, kind, 1e-4, std::numeric_limits<double>::infinity(), hit)) return;
  const shapes::Surface& surface = *hit.shape->surface;
  const bool first_segment = packet.path == 0;
  if (media_ && packet.ray.hollow) media_->segment(tracer_, packet.ray, hit.t, packet.path, packet.reached, shot_, packet.color, *stored_);
  packet.path += hit.t;

  const bool is_target = shot_.target->contains(surface.object);
  if (is_target) packet.reached = hit_target_ = true;
  const bool passes = !packet.reached;
  if (passes && !surface.photons.pass_through) return;
  // Beyond the first segment every hit on an object that collects is stored, before the surface filters the packet.
  if (!first_segment && packet.reached && !packet.passed && surface.photons.collect)
    stored_->push_back({hit.point, -packet.ray.ray.direction, packet.color * static_cast<float>(shot_.area_factor(packet.path)), false});

  const scene::LightSource& light = *shot_.light;
  const bool refracts = passes || allowed(surface.photons.refraction, light.photon_refraction);
  const bool reflects = !passes && allowed(surface.photons.reflection, light.photon_reflection);
  packet.passed = passes;
  if (!refracts && !reflects) return;
  ++nesting_;
  SurfaceHit at(hit, packet.ray.ray.direction, 0, packet.ray.level + 1);  // unlike other rays, also when it goes straight on
  std::vector<textures::WeightedTexture> weighted;
  tracer_.scene_.world.weighted_textures(hit, at.inside_hit, weighted);
  const auto scatter_at = [&](const textures::CompiledTexture* texture, float weight) {
    if (texture) scatter(packet, at, *texture, at.pattern_point(), nullptr, weight, refracts, reflects);
  };
  if (weighted.empty()) scatter_at(at.inside_hit && surface.interior_texture ? surface.interior_texture : surface.texture, 1.0f);
  for (const auto& entry : weighted) scatter_at(entry.texture, entry.weight);
  --nesting_;
}

void PhotonWalk::scatter(const Packet& packet, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p, const Tracer::Frame* frame,
                         float share, bool refracts, bool reflects) {
  if (!texture.patterned()) {
    scatter_layers(packet, at, texture, p, frame, share, refracts, reflects);
    return;
  }
  std::vector<textures::WeightedTexture> storage(std::max<std::size_t>(texture.map.size(), 2));
  Vec3 warped;
  const auto chosen = textures::select(texture, p, &at.texture_point, storage, warped);
  float total = 0;
  for (const auto& entry : chosen) total += entry.weight;
  const Tracer::Frame inner{&texture, frame};
  for (const auto& entry : chosen) {
    if (entry.weight == 0) continue;
    const float part = texture.average && total != 0 ? entry.weight / total : entry.weight;
    scatter(packet, at, *entry.texture, warped, &inner, share * part, refracts, reflects);
  }
}

void PhotonWalk::scatter_layers(const Packet& packet, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p,
                                const Tracer::Frame* frame, float share, bool refracts, bool reflects) {
  const Vec3& d = packet.ray.ray.direction;
  std::vector<Layer> layers;
  Rgb filter(share);
  for (const textures::CompiledLayer& layer : texture.layers) {
    const scene::Finish& finish = layer.finish;
    const Vec3 normal = tracer_.layer_normal(at, layer, p, frame);
    Color c;
    const bool colored = textures::evaluate(*layer.pigment, p, &at.texture_point, c);
    Rgb rho;
    if (finish.reflection.maximum != Rgb() || finish.reflection.minimum != Rgb()) {
      const double eta = finish.reflection.fresnel ? tracer_.fresnel_ratio(packet.ray, *at.surface.interior) : 1.0;
      rho = reflectivity(finish.reflection, c.rgb(), -dot(d, normal), eta);
      if (finish.reflection.exponent != 1) {
        const float e = 1 / finish.reflection.exponent;
        rho = {std::pow(rho.r, e), std::pow(rho.g, e), std::pow(rho.b, e)};
      }
    }
    layers.push_back({normal, rho});
    if (!colored) continue;
    filter *= c.transmission();
    if (finish.conserve_energy) filter *= {std::min(1.0f, 1 - rho.r), std::min(1.0f, 1 - rho.g), std::min(1.0f, 1 - rho.b)};
  }
  if (layers.empty()) return;
  if (refracts && filter.max_abs() > 0) refract(packet, at, layers.front(), filter);
  if (!reflects) return;
  for (const Layer& layer : layers) {
    // Reflectivity counts twice in the weight, not in the colour.
    if (layer.reflectivity != Rgb()) reflect(packet, at, layer, layer.reflectivity * share, layer.reflectivity.max_abs());
  }
}

PhotonWalk::Packet PhotonWalk::child_of(const Packet& packet, const SurfaceHit& at, const Vec3& direction, const Rgb& color) {
  Packet child = packet;
  child.ray.ray = {at.hit.point, direction};
  child.ray.primary = false;
  child.ray.continuation = false;
  child.ray.level = at.level;
  child.ray.weight *= color.max_abs();
  child.color *= color;
  return child;
}

void PhotonWalk::refract(const Packet& packet, SurfaceHit& at, const Layer& top, const Rgb& filter) {
  const scene::Interior& x = *at.surface.interior;
  const Tracer::InteriorScope scope(tracer_);
  const Tracer::Refraction refraction = tracer_.cross_surface(packet.ray, x);
  const Rgb color = filter * tracer_.fade_factor(packet.ray.interiors, x, at.hit.t);
  if (packet.passed || (refraction.straight() && !refraction.disperses())) {
    Packet child = child_of(packet, at, packet.ray.ray.direction, color);
    child.ray.interiors = refraction.interiors;
    child.ray.hollow = refraction.hollow;
    child.ray.refracted = true;
    child.ray.continuation = true;
    follow(child);
  } else if (!refraction.disperses()) {
    bend(packet, at, top, color, refraction, refraction.ratio, packet.ray.wavelength);
  } else if (packet.ray.monochromatic) {
    bend(packet, at, top, color, refraction, ratio_at(refraction.ratio, refraction.dispersion, packet.ray.wavelength), packet.ray.wavelength);
  } else {
    const int n = refraction.samples;
    Packet part = packet;
    part.ray.monochromatic = true;
    for (int i = 0; i < n; ++i) {
      const double wavelength = spectral_wavelength(i, n);
      part.color = packet.color * (spectral_weight(i, n) * (1.0f / static_cast<float>(n)));  // the weight remains
      bend(part, at, top, color, refraction, ratio_at(refraction.ratio, refraction.dispersion, wavelength), static_cast<float>(wavelength));
    }
  }
}

void PhotonWalk::bend(const Packet& packet, SurfaceHit& at, const Layer& top, const Rgb& color, const Tracer::Refraction& refraction, double ratio,
                      float wavelength) {
  const Vec3& d = packet.ray.ray.direction;
  const double signed_cosine = dot(d, top.normal), k = std::fabs(signed_cosine);
  const Vec3 n = signed_cosine <= 0 ? top.normal : -top.normal;
  const double q = 1 + ratio * ratio * (k * k - 1);
  if (q < 0) {  // total reflection
    reflect(packet, at, top, color, 1.0f);
    return;
  }
  Packet child = child_of(packet, at, d * ratio + n * (ratio * k - std::sqrt(q)), color);
  child.ray.interiors = refraction.interiors;
  child.ray.hollow = refraction.hollow;
  child.ray.refracted = true;
  child.ray.wavelength = wavelength;
  follow(child);
}

void PhotonWalk::reflect(const Packet& packet, SurfaceHit& at, const Layer& layer, const Rgb& color, float weight) {
  Packet child = child_of(packet, at, reflected_direction(packet.ray.ray.direction, layer.normal, at.raw), color);
  child.ray.weight *= weight;
  child.ray.reflected = true;
  child.passed = false;
  follow(child);
}

}  // namespace verisim::shading
