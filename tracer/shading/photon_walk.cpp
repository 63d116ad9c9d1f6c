#include "tracer/shading/photon_walk.h"

#include "tracer/shading/dispersion.h"
#include "tracer/shading/finish.h"

namespace verisim::shading {
namespace {

constexpr int kMaxPhotonNesting = 300;

// On in one of object and light, off in neither (spec 07 3.6).
bool allowed(scene::Flag object, scene::Flag light) {
  using enum scene::Flag;
  return (object == on || light == on) && object != off && light != off;
}

}  // namespace

double PhotonShot::area_factor(double path) const {
  double factor = sigma * sigma;
  if (!light->parallel) factor *= path * path;
  if (light->fades()) factor *= faded(std::pow(path / light->fade_distance, light->fade_power));
  return factor;
}

bool PhotonWalk::run(const Ray& start, const shapes::Hit* first, std::span<const scene::Interior* const> around,
                     const Rgb& color, std::vector<StoredPhoton>& stored) {
  stored_ = &stored;
  hit_target_ = false;
  const Tracer::InteriorScope scope(tracer_);
  Packet packet;
  packet.ray.ray = start;
  packet.ray.interiors = tracer_.copied(around);
  packet.ray.hollow = tracer_.all_hollow(packet.ray.interiors);
  packet.color = color;
  if (goes_on(packet) && first) meet(packet, *first);
  return hit_target_;
}

bool PhotonWalk::goes_on(const Packet& packet) {
  if (packet.ray.level >= shot_.max_trace_level || packet.ray.weight < shot_.adc_bailout ||
      nesting_ >= kMaxPhotonNesting)
    return false;
  if (tracer_.cancel_ && tracer_.cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  ++(packet.ray.reflected ? tracer_.statistics_.reflected_rays : tracer_.statistics_.refracted_rays);
  return true;
}

void PhotonWalk::follow(const Packet& packet) {
  if (!goes_on(packet)) return;
  shapes::Hit hit;
  const auto kind = packet.ray.reflected ? shapes::RayKind::reflected : shapes::RayKind::photon;
  if (tracer_.scene_.world.intersect(packet.ray.ray, kind, kNearestHit, accel::kFarthestHit, hit)) meet(packet, hit);
}

void PhotonWalk::meet(Packet packet, const shapes::Hit& hit) {
  const shapes::Surface& surface = *hit.shape->surface;
  const bool first_segment = packet.path == 0, left_target = packet.reached;
  const bool is_target = shot_.target->contains(surface.object);
  if (is_target) packet.reached = hit_target_ = true;
  const bool passes = !packet.reached;
  if (passes && !surface.photons().pass_through) return;
  if (media_ && packet.ray.hollow)
    media_->segment(tracer_, packet.ray, hit.t, packet.path, left_target, shot_, packet.color, *stored_);
  packet.path += hit.t;
  packet.color *= tracer_.fade_factor(packet.ray.interiors, *surface.interior, hit.t);
  const scene::LightSource& light = *shot_.light;
  Encounter what;
  what.stores = !first_segment && packet.reached && !packet.passed && surface.photons().collect;
  what.refracts = passes || allowed(surface.photons().refraction, light.photon_refraction);
  what.reflects = !passes && allowed(surface.photons().reflection, light.photon_reflection);
  packet.passed = passes;
  if (!what.stores && !what.scatters()) return;
  ++nesting_;
  SurfaceHit at(hit, packet.ray.ray.direction, 0,
                packet.ray.level + 1);  // unlike other rays, also when it goes straight on
  std::vector<textures::WeightedTexture> weighted;
  tracer_.scene_.world.weighted_textures(hit, at.inside_hit, weighted);
  const auto meet_at = [&](const textures::CompiledTexture* texture, float weight) {
    if (texture) meet_texture(packet, at, *texture, at.pattern_point(), nullptr, weight, what);
  };
  if (weighted.empty()) meet_at(surface.texture_within(at.inside_hit), 1.0f);
  for (const auto& entry : weighted) {
    if (entry.weight >= shot_.adc_bailout) meet_at(entry.texture, entry.weight);
  }
  --nesting_;
}

void PhotonWalk::meet_texture(const Packet& packet, SurfaceHit& at, const textures::CompiledTexture& texture,
                              const Vec3& p, TextureFrames* frames, float share, const Encounter& what) {
  if (!texture.patterned()) {
    if (what.stores) store(packet, at.hit.point, share);
    if (what.scatters()) scatter(packet, at, texture, p, frames, share, what);
    return;
  }
  const TextureParts parts(tracer_.selection_, texture, p, at.texture_point, frames);
  float total = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) total += parts[i].weight;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const textures::WeightedTexture entry = parts[i];
    if (entry.weight == 0 && !texture.average) continue;  // of an average, black photons are stored, too
    const float part = texture.average && total != 0 ? entry.weight / total : entry.weight;
    meet_texture(packet, at, *entry.texture, parts.point, &parts.frames, share * part, what);
  }
}

void PhotonWalk::store(const Packet& packet, const Vec3& point, float share) {
  stored_->push_back({point, -packet.ray.ray.direction,
                      packet.color * static_cast<float>(shot_.area_factor(packet.path)) * share, false});
}

void PhotonWalk::scatter(const Packet& packet, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p,
                         TextureFrames* frames, float share, const Encounter& what) {
  const Vec3& d = packet.ray.ray.direction;
  std::vector<Layer> layers;
  Rgb filter(1);
  float translucency = 1;
  for (const textures::CompiledLayer& layer : texture.layers) {
    if (!(translucency > shot_.adc_bailout)) break;
    const scene::Finish& finish = layer.finish;
    const scene::Reflection& mirror = finish.reflection;
    const Vec3 normal = tracer_.layer_normal(at, layer, p, frames);
    Color c;
    const bool colored = textures::evaluate(*layer.pigment, p, &at.texture_point, c);
    Layer here{normal, {}, mirror.exponent, 0};
    if (mirror.maximum != Rgb() || mirror.minimum != Rgb()) {
      const double eta = mirror.fresnel ? tracer_.fresnel_ratio(packet.ray, *at.surface.interior) : 1.0;
      const Mirror seen = mirror_of(mirror, c.rgb(), -dot(d, normal), eta);
      here.reflectivity = seen.reflectivity;
      here.weight = translucency * seen.reflectivity.max_abs() * seen.strength;  // reflectivity counts twice
    }
    layers.push_back(here);
    if (colored) {
      filter *= filter * c.transmission();  // what came through the layers above counts twice, too
      const Rgb& rho = here.reflectivity;
      if (finish.conserve_energy)
        filter *= {std::min(1.0f, 1 - rho.r), std::min(1.0f, 1 - rho.g), std::min(1.0f, 1 - rho.b)};
    }
    translucency = std::min(1.0f, std::fabs(filter.grey()));
  }
  if (layers.empty()) return;
  const Vec3 top_normal = layers.front().normal;
  const bool total = what.refracts && translucency > shot_.adc_bailout &&
                     refract(packet, at, top_normal, {filter * share, share, filter.max_abs()});
  if (!what.reflects) return;
  for (const Layer& layer : layers) {
    if (layer.reflectivity == Rgb() || (total && Tracer::hidden_by_total_reflection(top_normal, layer.normal)))
      continue;
    Packet mirrored = packet;
    if (layer.exponent != 1) {  // of what arrives, not of the mirror
      const float e = 1 / layer.exponent;
      mirrored.color = {std::pow(packet.color.r, e), std::pow(packet.color.g, e), std::pow(packet.color.b, e)};
    }
    reflect(mirrored, at, layer.normal, layer.reflectivity * share, layer.weight);
  }
}

PhotonWalk::Packet PhotonWalk::child_of(const Packet& packet, const SurfaceHit& at, const Vec3& direction,
                                        const Rgb& color, float weight) {
  Packet child = packet;
  child.ray = packet.ray.spawn({at.hit.point, direction}, at.level, packet.ray.weight * weight);
  child.color *= color;
  return child;
}

bool PhotonWalk::refract(const Packet& packet, SurfaceHit& at, const Vec3& normal, const Passage& through) {
  const Tracer::InteriorScope scope(tracer_);
  const Tracer::Refraction refraction = tracer_.cross_surface(packet.ray, *at.surface.interior);
  if (packet.passed || (refraction.straight() && !refraction.disperses())) {
    Packet child = child_of(packet, at, packet.ray.ray.direction, through.filter, through.weight);
    refraction.enter(child.ray);
    child.ray.continuation = true;
    follow(child);
    return false;
  }
  if (!refraction.disperses())
    return bend(packet, at, normal, through, refraction, refraction.ratio, packet.ray.wavelength);
  if (packet.ray.monochromatic)
    return bend(packet, at, normal, through, refraction,
                ratio_at(refraction.ratio, refraction.dispersion, packet.ray.wavelength), packet.ray.wavelength);
  const int n = refraction.samples;
  Packet part = packet;
  part.ray.monochromatic = true;
  bool total = false;
  for (int i = 0; i < n; ++i) {
    const double wavelength = spectral_wavelength(i, n);
    part.color = packet.color * (spectral_weight(i, n) * (1.0f / static_cast<float>(n)));  // the weight remains
    total |= bend(part, at, normal, through, refraction, ratio_at(refraction.ratio, refraction.dispersion, wavelength),
                  static_cast<float>(wavelength));
  }
  return total;
}

bool PhotonWalk::bend(const Packet& packet, SurfaceHit& at, const Vec3& normal, const Passage& through,
                      const Tracer::Refraction& refraction, double ratio, float wavelength) {
  const auto direction = refracted_direction(packet.ray.ray.direction, normal, ratio);
  if (!direction) {  // total reflection: the surface filters the weight, but not the light
    reflect(packet, at, normal, Rgb(through.share), through.weight);
    return true;
  }
  Packet child = child_of(packet, at, *direction, through.filter, through.weight);
  refraction.enter(child.ray);
  child.ray.wavelength = wavelength;
  follow(child);
  return false;
}

void PhotonWalk::reflect(const Packet& packet, SurfaceHit& at, const Vec3& normal, const Rgb& color, float weight) {
  Packet child =
      child_of(packet, at, reflected_direction(packet.ray.ray.direction, normal, at.geometric_normal), color, weight);
  child.ray.reflected = true;
  child.passed = false;
  follow(child);
}

}  // namespace verisim::shading
