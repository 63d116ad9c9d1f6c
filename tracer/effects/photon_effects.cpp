// Photon maps in the recursive trace: the light of stored photons, and the direct light they replace (spec 07
// sections 3.10 and 3.11).
#include "tracer/effects/effects_state.h"
#include "tracer/math/constants.h"
#include "tracer/photons/photon_batch.h"
#include "tracer/shading/finish.h"

namespace verisim::global {
namespace {

// Whether light of any direction can change what this layer shows. Panes of glass rarely do, and photons gather between
// them.
bool reflects_photons(const shading::LayerContext& layer, bool highlights) {
  const scene::Finish& f = layer.layer.finish;
  if (highlights && shading::has_highlight(f)) return true;
  return (f.diffuse > 0 || f.diffuse_back > 0) && (layer.opacity != 0 || f.crand > 0);
}

// Whether a layer shows nothing of a light but the plain diffuse part.
bool is_plain(const scene::Finish& f, bool highlights, bool subsurface) {
  return !(highlights && shading::has_highlight(f)) && !(f.irid > 0) && !(f.crand > 0) && !(f.subsurface && subsurface);
}

}  // namespace

Rgb SceneEffects::photon_light(shading::Tracer& tracer, const shading::RayState& ray, shading::SurfaceHit& at,
                               const shading::LayerContext& layer) const {
  if (surface_photons_.empty() || !at.surface.photons().collect) return {};
  if (!at.photon_normal) at.photon_normal = layer.normal;
  if (!reflects_photons(layer, !ray.gather)) return {};
  EffectsStateOfScene& state = EffectsStateOfScene::of(tracer);
  if (state.gathered_for != &at || !at.photons_gathered) {
    const scene::Photons& s = scene_.settings.photons;
    surface_photons_.gather(at.hit.point, &*at.photon_normal,
                            {s.gather_min, s.gather_max, s.expand_increase, s.expand_min}, state.gathered);
    state.gathered_for = &at;
    at.photons_gathered = true;
  }
  const scene::Finish& finish = layer.layer.finish;
  const bool both_sides = at.surface.double_illuminate || finish.diffuse_back != 0,
             plain = is_plain(finish, !ray.gather, subsurface);
  const Rgb pigment = layer.pigment.rgb();
  const Vec3 normal = layer.normal, geometric_normal = at.geometric_normal;
  const double r = state.gathered.radius;
  const auto per_area = static_cast<float>(1.0 / (kPi * r * r));  // of the whole sum, as in POV-Ray
  Rgb sum;
  if (plain && finish.brilliance == 1.0f) {
    const float behind = !both_sides ? 0.0f : at.surface.double_illuminate ? finish.diffuse : finish.diffuse_back;
    add_light(state.gathered.photons,
              {normal, geometric_normal, pigment, shading::diffuse_share(layer.opacity, std::max(finish.diffuse, 0.0f)),
               shading::diffuse_share(layer.opacity, std::max(behind, 0.0f))},
              sum);
    return sum * per_area;
  }
  for (std::size_t i = 0; i < state.gathered.photons.size(); ++i) {
    const Photon& photon = state.gathered.photons[i];
    const Vec3 direction = photon.direction();
    const double cosine = dot(normal, direction);
    const bool behind = cosine < kEpsilon;
    if (behind && !both_sides) continue;
    const bool back = behind && !at.surface.double_illuminate;
    const float diffuse = back ? finish.diffuse_back : finish.diffuse;
    const double slant = std::max(0.1, dot(geometric_normal, direction));
    const Rgb intensity = photon.color() * static_cast<float>(1 / slant);
    if (!plain) {
      sum += tracer.layer_response(at, layer, ray.ray.direction, direction, intensity, diffuse, !ray.gather && !back);
    } else if (diffuse > 0) {
      const double share = shading::diffuse_share(layer.opacity, diffuse, finish.brilliance, cosine);
      sum += scaled(pigment, share) * intensity;
    }
  }
  return sum * per_area;
}

bool SceneEffects::photons_block(const shapes::Surface* lit, const shapes::Surface& occluder,
                                 const shading::Light& light) const {
  if (surface_photons_.empty() || !occluder.photons().target || (lit && !lit->photons().collect)) return false;
  const scene::LightSource& source = light.source();
  const bool off = occluder.photons().refraction == scene::Flag::off || source.photon_refraction == scene::Flag::off;
  const bool on = occluder.photons().refraction == scene::Flag::on || source.photon_refraction == scene::Flag::on;
  return on && !off;
}

}  // namespace verisim::global
