// Shading a hit: choice of textures, layers, own light, then what is seen through and in the surface (spec 06 section
// 3).
#include <cmath>
#include <limits>

#include "tracer/shading/finish.h"
#include "tracer/shading/tracer.h"

namespace verisim::shading {
namespace {

// What POV-Ray shows where a normal is none, with and without light (spec 06 3.3).
constexpr Rgb kNoNumber(std::numeric_limits<float>::quiet_NaN());

bool is_nan(const Vec3& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z); }

// Cuts a stack back to the size it had.
template <class T>
class StackScope {
 public:
  explicit StackScope(std::vector<T>& stack) : stack_(stack), size_(stack.size()) {}
  ~StackScope() { stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(size_), stack_.end()); }
  StackScope(const StackScope&) = delete;
  StackScope& operator=(const StackScope&) = delete;
  std::size_t begin() const { return size_; }

 private:
  std::vector<T>& stack_;
  std::size_t size_;
};

// Tells a witness that the layers that follow belong to a texture among several.
class ToldTexture {
 public:
  ToldTexture(Observer* observer, float weight) : observer_(observer) {
    if (observer_) observer_->texture_started(weight);
  }
  ~ToldTexture() {
    if (observer_) observer_->texture_ended();
  }
  ToldTexture(const ToldTexture&) = delete;
  ToldTexture& operator=(const ToldTexture&) = delete;

 private:
  Observer* observer_;
};

}  // namespace

textures::SurfacePoint texture_point(const shapes::Hit& hit, const Vec3& normal, const Vec3& direction) {
  return {hit.point, normal, direction,
          [](const void* context) {
            const auto& seen = *static_cast<const shapes::Hit*>(context);
            return seen.shape->uv(seen);
          },
          &hit};
}

SurfaceHit::SurfaceHit(const shapes::Hit& h, const Vec3& normal, const Vec3& direction, std::size_t cache,
                       int child_level)
    : hit(h),
      surface(*h.shape->surface),
      geometric_normal(normal),
      inside_hit(dot(geometric_normal, direction) > 0),
      light_cache(cache),
      level(child_level) {
  if (inside_hit) geometric_normal = -geometric_normal;
  texture_point = shading::texture_point(h, geometric_normal, direction);
}

Color Tracer::shade(const RayState& ray, const shapes::Hit& hit) {
  Color result = shade_surface(ray, hit);
  if (scene_.effects && scene_.effects->media_in_interiors && ray.hollow && ray.interiors.count > 0 && ray.volumes) {
    const RandomBranch branch(random_, RandomBranch::kContainer);
    through_air(result, [&] { scene_.effects->container_media(*this, ray, hit.t, *hit.shape->surface, result); });
  }
  return result;
}

Color Tracer::shade_surface(const RayState& ray, const shapes::Hit& hit) {
  const StackScope<CachedLight> lights(light_cache_);
  SurfaceHit at(hit, ray.ray.direction, lights.begin(), ray.surface_level());
  const shapes::Surface& surface = at.surface;
  const Vec3 p = at.pattern_point();
  const auto* texture = surface.texture_within(at.inside_hit);
  // Nested hits use the same list, so its entries are copied to this call's part of the selection stack.
  weighted_.clear();
  if (surface.shows_several()) scene_.world.weighted_textures(hit, at.inside_hit, weighted_);
  at.keeps_lights = !(weighted_.empty() && texture && !texture->patterned() && texture->layers.size() == 1);
  if (at.keeps_lights) light_cache_.resize(lights.begin() + scene_.global_lights());

  Color result;
  if (weighted_.empty()) {
    if (texture)
      result =
          shade_texture(ray, at, *texture, p, nullptr);  // none: a cutaway surface in no textured child shows black
  } else {
    const StackScope<textures::WeightedTexture> scope(selection_);
    selection_.insert(selection_.end(), weighted_.begin(), weighted_.end());
    const std::size_t end = selection_.size();
    for (std::size_t i = scope.begin(); i < end; ++i) {
      const textures::WeightedTexture entry = selection_[i];
      if (entry.weight < bailout(ray)) continue;
      const ToldTexture told(observer_, entry.weight);
      result += scaled(shade_texture(ray, at, *entry.texture, p, nullptr), entry.weight);
    }
  }
  return result;
}

Color Tracer::shade_texture(const RayState& ray, SurfaceHit& at, const textures::CompiledTexture& texture,
                            const Vec3& p, TextureFrames* frames) {
  if (!texture.patterned())
    return scene_.quality <= 1 ? shade_unlit(at, texture, p) : shade_layers(ray, at, texture, p, frames);
  const TextureParts parts(selection_, texture, p, at.texture_point, frames);
  Color sum;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const textures::WeightedTexture entry = parts[i];
    // POV-Ray shades what does not count in an average: it draws numbers, leaves frames and may be no number.
    if (entry.weight == 0 && !texture.average) continue;
    const ToldTexture told(observer_, entry.weight);
    sum += scaled(shade_texture(ray, at, *entry.texture, parts.point, &parts.frames), entry.weight);
  }
  return sum;
}

Vec3 Tracer::layer_normal(SurfaceHit& at, const textures::CompiledLayer& layer, const Vec3& p, TextureFrames* frames) {
  if (!layer.normal || scene_.quality < 8) return at.geometric_normal;
  return perturb_in_frames(*layer.normal, p, at.geometric_normal, at.texture_point, frames);
}

// Quality 0 and 1: the colour of the lowest layer reached.
Color Tracer::shade_unlit(SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p) {
  Rgb shown, filter(1);
  float translucency = 1;
  for (const auto& layer : texture.layers) {
    Color c;
    const bool colored = textures::evaluate(*layer.pigment, p, &at.texture_point, c);
    shown = c.rgb();
    if (colored) filter *= c.transmission();
    translucency = std::min(1.0f, std::fabs(filter.grey()));
    if (!(translucency > scene_.adc_bailout)) break;
  }
  return shown;
}

// The compositing equation of spec 06 3.3.
Color Tracer::shade_layers(const RayState& ray, SurfaceHit& at, const textures::CompiledTexture& texture, const Vec3& p,
                           TextureFrames* frames) {
  const StackScope<ShadedLayer> layers(layers_);
  const Vec3& d = ray.ray.direction;
  const double adc = bailout(ray);
  Rgb color, filter(1);
  float translucency = 1;
  bool any_reflection = false;
  const int index = at.textures++;
  at.indirect = at.indirect_back = {};  // each of blended textures asks for its own
  double eta = 0;                       // of fresnel; 0: not yet known
  for (const textures::CompiledLayer& layer : texture.layers) {
    if (!(translucency > adc)) break;
    const scene::Finish& finish = layer.finish;
    const Vec3 normal = layer_normal(at, layer, p, frames);
    Color c;
    const bool colored = textures::evaluate(*layer.pigment, p, &at.texture_point, c);

    Mirror mirror;
    const Rgb& rho = mirror.reflectivity;
    if (finish.reflection.maximum != Rgb() || finish.reflection.minimum != Rgb()) {
      if (finish.reflection.fresnel && eta == 0) eta = fresnel_ratio(ray, *at.surface.interior);
      mirror = mirror_of(finish.reflection, c.rgb(), -dot(d, normal), eta);
      any_reflection = any_reflection || rho != Rgb();
    }
    layers_.push_back({&layer, c, normal, mirror, translucency});

    const LayerContext context{layer, c, normal, surface_opacity(c, scene_.version), filter};
    if (observer_) observer_->layer(at, context, rho);
    Rgb own = own_light(finish, c.rgb(), scene_.ambient_light, context.opacity);
    // Subsurface first: the order in which radiosity is asked for decides where its samples are (replay).
    const auto indirect = [&](const char* effect, const Rgb& light) {
      if (observer_) observer_->indirect(effect, light);
      own += light;
    };
    if (scene_.effects && scene_.effects->subsurface && finish.subsurface)
      indirect("subsurface", scene_.effects->subsurface_light(*this, ray, at, context));
    if (scene_.effects && scene_.effects->radiosity) {
      const RandomBranch branch(random_,
                                RandomBranch::indirect(index, static_cast<int>(&layer - texture.layers.data())));
      indirect("radiosity", scene_.effects->indirect_light(*this, ray, at, context));
    }
    add_direct_light(ray, at, context, own);
    if (scene_.effects && scene_.effects->photons)
      indirect("photons", scene_.effects->photon_light(*this, ray, at, context));
    color += filter * (layer.normal && is_nan(normal) ? kNoNumber : own);

    if (colored) {
      filter *= c.transmission();
      if (finish.conserve_energy)
        filter *= {std::min(1.0f, 1 - rho.r), std::min(1.0f, 1 - rho.g), std::min(1.0f, 1 - rho.b)};
    }
    translucency = std::min(1.0f, std::fabs(filter.grey()));
  }
  const std::size_t end = layers_.size();

  float see_through = 0;
  bool total_reflection = false;
  if (translucency > adc && scene_.quality >= 6) {
    const ShadedLayer top = layers_[layers.begin()];
    const RandomBranch branch(random_, RandomBranch::behind(index));
    const Color seen = transmit(ray, at, top, ray.weight * filter.max_abs(), total_reflection);
    const Rgb through = total_reflection ? seen.rgb() : seen.rgb() * filter;
    if (observer_) observer_->rays_added(through);
    color += through;
    if (!total_reflection) see_through = seen.t * translucency;
  }
  if (any_reflection && scene_.quality >= 8) {
    const Vec3 top_normal = layers_[layers.begin()].normal;
    for (std::size_t i = layers.begin(); i < end; ++i) {
      const ShadedLayer layer = layers_[i];
      if (layer.mirror.reflectivity == Rgb()) continue;
      if (total_reflection && hidden_by_total_reflection(top_normal, layer.normal)) continue;
      const RandomBranch branch(random_, RandomBranch::mirror(index, static_cast<int>(i - layers.begin())));
      const Rgb seen = mirrored(ray, at, layer);
      if (observer_) observer_->rays_added(seen);
      color += seen;
    }
  }
  return {color, 0, see_through};
}

}  // namespace verisim::shading
