#include "tracer/shading/wavefront/wave.h"

#include "tracer/shading/finish.h"
#include "tracer/shading/atmosphere/fog.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/shading/direct/shadow_row.h"
#include "tracer/textures/evaluation/pigment.h"

namespace verisim::shading {
namespace {

constexpr double kNearestHit = 1e-4;  // of camera rays

bool is_finite(const Rgb& c) { return std::fabs(c.r) + std::fabs(c.g) + std::fabs(c.b) < 1e30f; }

// Lights that light a surface by several directions at once are for the common way.
bool is_simple(const Light& light) { return !light.area_illumination() && is_finite(light.color()); }

}  // namespace

Wave::Wave(Tracer& tracer, bool asks_around)
    : tracer_(tracer), scene_(tracer.scene()), kernels_(wave_kernels()), lanes_{} {
  usable_ = scene_.quality >= 9 && !tracer_.in_order() && scene_.adc_bailout >= 0 && scene_.adc_bailout < 1;
  indirect_ = asks_around && scene_.effects && scene_.effects->radiosity;
  photons_ = scene_.effects && scene_.effects->photons;
  for (std::size_t i = 0; i < scene_.global_lights(); ++i) usable_ = usable_ && is_simple(scene_.lights()[i]);
  for (float* tint : {lanes_.tint.r, lanes_.tint.g, lanes_.tint.b}) std::fill_n(tint, kMost, 1.0f);
  plain_sky_ = !scene_.sky.varies();
  for (const bool opaque : {false, true})
    if (plain_sky_) sky_[opaque] = scene_.sky.seen({0, 0, 1}, opaque);
}

void Wave::add_lane(int i, const Material& m, const Vec3& normal, const Color& color, float opacity, int texture,
                    const Part* part) {
  const int k = count_++;
  part_[k] = part;
  pixel_[k] = i;
  surface_[k] = hits_[i].shape->surface;
  lanes_.to_light.origin.set(k, hits_[i].point);
  lanes_.normal.set(k, normal);
  lanes_.view.set(k, lanes_.rays.direction.at(i));
  lanes_.two_sided[k] = surface_[k]->double_illuminate;
  shine_ |= m.shine;
  const scene::Finish& finish = m.layer->finish;
  if (material_[k] == &m) {
    if (m.constant && m.only && !indirect_) return;
  } else {
    material_[k] = &m;
    finish_[k] = &finish;
    lanes_.lit_behind[k] = finish.diffuse_back != 0;
    lanes_.dull[k] = !reflects_light(finish);
    lanes_.exponent[k] = m.exponent, lanes_.amount[k] = m.amount, lanes_.base_limit[k] = m.base_limit,
    lanes_.phong[k] = m.phong;
  }
  lanes_.front[k] = opacity * std::max(finish.diffuse, 0.0f),
  lanes_.behind[k] = opacity * std::max(finish.diffuse_back, 0.0f);
  lanes_.pigment.r[k] = color.r, lanes_.pigment.g[k] = color.g, lanes_.pigment.b[k] = color.b;
  Rgb own = color.rgb() * m.glow * opacity;
  if (indirect_) {
    begin_branch(i, RandomBranch::indirect(texture, part->index));
    own += scene_.effects->indirect_light(tracer_, ray_state(i), *met_[i].at, layer_context(*part));
  }
  lanes_.own.r[k] = own.r, lanes_.own.g[k] = own.g, lanes_.own.b[k] = own.b;
}

// Takes what shows at hit i among the surfaces that are lit together; false: there is no room for it.
bool Wave::add_surface(int i) {
  if (const Material* plain = met_[i].plain) {
    if (count_ == kMost) return false;
    add_lane(i, *plain, met_[i].normal, plain->color, plain->opacity, 0, nullptr);
    return true;
  }
  if (count_ + met_[i].parts > kMost) return false;
  layered_ |= met_[i].parts > 1;
  for (int l = met_[i].first; l < met_[i].first + met_[i].leaves; ++l)
    for (int k = leaves_[static_cast<std::size_t>(l)].first; k >= 0;) {
      const Part& part = parts_[static_cast<std::size_t>(k)];
      add_lane(i, *part.material, part.normal, part.color, part.opacity, l - met_[i].first, &part);
      k = part.next;
    }
  return true;
}

// Where the light is from every surface.
void Wave::aim(const Light& light) {
  aim_at(light, count_, lanes_.to_light, lanes_.distance);
  kernels_.face(count_, lanes_);
}

// Which surfaces the light reaches, and with what colour.
bool Wave::reach(const Light& light) {
  if (const auto falloff = light.attenuates() ? LightFalloff::of(light) : std::nullopt) {
    falloff->attenuate(lanes_.to_light.direction, lanes_.distance, count_, lanes_.attenuation);
  } else if (light.attenuates()) {
    for (int k = 0; k < count_; ++k)
      lanes_.attenuation[k] = static_cast<float>(
          light.attenuation(lanes_.to_light.origin.at(k), {lanes_.to_light.direction.at(k), lanes_.distance[k]}));
  } else if (attenuated_) {
    std::fill_n(lanes_.attenuation, kMost, 1.0f);
  }
  attenuated_ = light.attenuates();
  if (!kernels_.receive(light.color(), light.highlights() && !state_.gather, count_, lanes_)) return false;
  int asks[kMost];
  if (layered_) share_asking(asks);
  cast_shadows(light);
  for (int k = 0; layered_ && k < count_; ++k) {
    const int first = asks[k];
    if (first < 0 || first == k) continue;
    lanes_.asked[k] = lanes_.asked[first];
    lanes_.intensity.r[k] = lanes_.intensity.r[first], lanes_.intensity.g[k] = lanes_.intensity.g[first],
    lanes_.intensity.b[k] = lanes_.intensity.b[first];
  }
  return kernels_.illuminate(count_, lanes_);
}

// The first layer of a hit that asks for its shadow does so for all: asks[k] is the layer that asks for layer k, or -1.
void Wave::share_asking(int* asks) {
  for (int k = 0, first = -1; k < count_; ++k) {
    if (k == 0 || pixel_[k] != pixel_[k - 1]) first = -1;
    asks[k] = -1;
    if (lanes_.asked[k] == 0) continue;
    if (first < 0) first = k;
    asks[k] = first;
    lanes_.asked[k] = first == k;
  }
}

// Filters the light of all that are asked for.
void Wave::cast_shadows(const Light& light) {
  if (!light.shadows()) return;
  const std::uint32_t number = RandomBranch::light(static_cast<std::size_t>(&light - scene_.lights().data()));
  ShadowRow row;
  int lane[kMost];
  for (int k = 0; k < count_; ++k) {
    if (lanes_.asked[k] == 0) continue;
    lane[row.count] = k;
    row.add(lanes_.to_light.at(k), lanes_.distance[k],
            {lanes_.intensity.r[k], lanes_.intensity.g[k], lanes_.intensity.b[k]}, surface_[k],
            RandomSource::branch_key(keys_[pixel_[k]], number));
  }
  tracer_.cast_shadows(light, state_, row);
  for (int i = 0; i < row.count; ++i) {
    const int k = lane[i];
    lanes_.intensity.r[k] = row.light[i].r, lanes_.intensity.g[k] = row.light[i].g,
    lanes_.intensity.b[k] = row.light[i].b;
  }
}

void Wave::respond() {
  if ((shine_ & kMetallic) || tinted_) {
    for (int k = 0; k < count_; ++k) {
      const Rgb pigment(lanes_.pigment.r[k], lanes_.pigment.g[k], lanes_.pigment.b[k]);
      const Rgb tint =
          finish_[k]->metallic > 0 ? metallic_tint(pigment, finish_[k]->metallic, lanes_.cosine[k]) : Rgb(1);
      lanes_.tint.r[k] = tint.r, lanes_.tint.g[k] = tint.g, lanes_.tint.b[k] = tint.b;
    }
    tinted_ = true;
  }
  if (kernels_.respond(shine_ & kPhong, shine_ & kBlinn, count_, lanes_)) {
    for (int k = 0; k < count_; ++k)
      if (lanes_.uncertain[k] && lanes_.lit[k] != 0 && lanes_.amount[k] * lanes_.shines[k] != 0)
        lanes_.strength[k] = static_cast<float>(highlight(k));
  }
  if (shine_ & (kBothHighlights | kBrilliance)) respond_specially();
}

// What the wide instructions do not know.
void Wave::respond_specially() {
  for (int k = 0; k < count_; ++k) {
    if (lanes_.lit[k] == 0) continue;
    if ((material_[k]->shine & kBrilliance) && lanes_.diffuse[k] != 0)
      lanes_.scattered[k] =
          static_cast<float>(lanes_.diffuse[k] * brilliance(finish_[k]->brilliance, lanes_.cosine[k]));
    if ((material_[k]->shine & kBothHighlights) && lanes_.shines[k] != 0)
      lanes_.strength[k] = static_cast<float>(highlight(k));
  }
}

double Wave::highlight(int k) const {
  const scene::Finish& finish = *finish_[k];
  const Vec3 n = lanes_.normal.at(k), d = lanes_.view.at(k), l = lanes_.to_light.direction.at(k);
  double strength = 0;
  if (finish.phong > 0) strength += phong_highlight(finish, n, d, l);
  if (finish.specular > 0) strength += specular_highlight(finish, n, d, l);
  return strength;
}

void Wave::light(const Light& light) {
  aim(light);
  if (!reach(light)) return;
  respond();
  kernels_.add(count_, lanes_);
}

// What a texture shows whose layers are lit in the lanes from `lane` on; moves to the lane behind them.
Color Wave::shown(const Leaf& leaf, int& lane) {
  Rgb color;
  bool branches = leaf.behind >= 0;
  for (int k = leaf.first; k >= 0; ++lane) {
    const Part& part = parts_[static_cast<std::size_t>(k)];
    color += part.filter * Rgb(lanes_.direct.r[lane], lanes_.direct.g[lane], lanes_.direct.b[lane]);
    branches |= part.mirror >= 0;
    k = part.next;
  }
  Color result = color;
  if (branches) add_branches(leaf, result);
  return result;
}

// The colours of pixels from their layers and textures.
void Wave::sum_layers(Color* out) {
  for (int k = 0; k < count_;) {
    const Met& met = met_[pixel_[k]];
    Color& result = out[pixel_[k]];
    Color sum;
    if (met.plain) {
      sum += Rgb(lanes_.direct.r[k], lanes_.direct.g[k], lanes_.direct.b[k]);
      ++k;
    }
    for (int l = met.first; l < met.first + met.leaves; ++l) {
      const Leaf& leaf = leaves_[static_cast<std::size_t>(l)];
      const Color color = shown(leaf, k);
      if (leaf.around)
        sum += color * leaf.weight;
      else
        sum = color;
    }
    result = sum;
  }
}

LayerContext Wave::layer_context(const Part& part) {
  return {*part.material->layer, part.color, part.normal, part.opacity, part.filter};
}

void Wave::add_photons() {
  for (int k = 0; k < count_; ++k) {
    const Rgb added =
        scene_.effects->photon_light(tracer_, ray_state(pixel_[k]), *met_[pixel_[k]].at, layer_context(*part_[k]));
    lanes_.direct.r[k] += added.r, lanes_.direct.g[k] += added.g, lanes_.direct.b[k] += added.b;
  }
}

// Lights the surfaces that were added, and writes their colours.
void Wave::show(Color* out) {
  for (float* sum : {lanes_.direct.r, lanes_.direct.g, lanes_.direct.b}) std::fill_n(sum, count_, 0.0f);
  if (count_ > 0)
    for (std::size_t i = 0; i < scene_.global_lights(); ++i) light(scene_.lights()[i]);
  kernels_.add_own(count_, lanes_);
  if (photons_) add_photons();
  if (leaves_.empty()) {  // plain surfaces alone
    for (int k = 0; k < count_; ++k)
      out[pixel_[k]] = Rgb() + Rgb(lanes_.direct.r[k], lanes_.direct.g[k], lanes_.direct.b[k]);
  } else {
    sum_layers(out);
  }
  count_ = 0;
  shine_ = 0;
  layered_ = false;
}

// The rays that hit nothing.
void Wave::show_sky(int count, Color* out) {
  const bool opaque = state_.reflected || state_.gather;
  textures::PointRow directions;
  int misses[kMost], n = 0;
  for (int i = 0; i < count; ++i) {
    if (found_[i]) continue;
    if (plain_sky_) {
      out[i] = sky_[opaque];
    } else {
      directions.set(n, lanes_.rays.direction.at(i));
      misses[n++] = i;
    }
  }
  if (n == 0) return;
  Color colors[kMost];
  scene_.sky.seen(n, directions, opaque, colors);
  for (int k = 0; k < n; ++k) out[misses[k]] = colors[k];
}

void Wave::trace(int count, const accel::WorldEntry* const* entries, Color* out) {
  state_ = tracer_.camera_state(lanes_.rays.at(0), false);
  std::fill_n(weights_, count, 1.0f);
  for (int i = 0; i < count; ++i) keys_[i] = tracer_.random_.sample_key(places_[i].x, places_[i].y, numbers_[i]);
  tracer_.statistics_.camera_rays += static_cast<std::uint64_t>(count);
  run(count, entries, out);
}

void Wave::run(int count, const accel::WorldEntry* const* entries, Color* out) {
  if (tracer_.cancel_ && tracer_.cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  for (int first = 0, end; first < count; first = end) {
    for (end = first + 1; end < count && entries[end] == entries[first];) ++end;
    scene_.world.intersect_row(lanes_.rays, first, end - first, state_.kind(), kNearestHit, entries[first], hits_,
                               found_);
  }
  shade(count, out);
}

// What is known to be hit.
void Wave::shade(int count, Color* out) {
  leaves_.clear();
  parts_.clear();
  branches_.clear();
  for (int i = 0; i < count; ++i)
    if (found_[i]) meet(i);
  find_parts(count);
  trace_branches();
  show_sky(count, out);
  bool cut_off[kMost] = {};
  for (int i = 0; i < count; ++i) {
    if (!found_[i]) continue;
    if (met_[i].together) {
      if (add_surface(i)) continue;
      show(out);
      if (add_surface(i)) continue;
    }
    tracer_.random_.begin(keys_[i]);
    const RayState ray = ray_state(i);
    cut_off[i] = tracer_.cut_off(ray);
    out[i] = cut_off[i] ? Color() : tracer_.resolve_surface(ray, hits_[i]);
  }
  show(out);
  apply_volumes(count, cut_off, out);
}

void Wave::apply_volumes(int count, const bool* cut_off, Color* out) {
  if (!state_.hollow || !state_.volumes) return;
  const bool container = scene_.effects && scene_.effects->media_in_interiors && state_.interiors.count > 0;
  if (!container && !tracer_.has_volumes_) return;
  if (container) {
    ContainerStretch stretches[kMost];
    std::size_t n = 0;
    for (int i = 0; i < count; ++i)
      if (found_[i] && !cut_off[i])
        stretches[n++] = {lanes_.rays.at(i), hits_[i].t, hits_[i].shape->surface,
                          RandomSource::branch_key(keys_[i], RandomBranch::kContainer), &out[i]};
    scene_.effects->container_media(tracer_, state_, std::span(stretches, n));
  }
  for (int i = 0; i < count && tracer_.has_volumes_; ++i) {
    if (cut_off[i]) continue;
    tracer_.random_.begin(keys_[i]);
    tracer_.apply_volumes(ray_state(i), found_[i] ? hits_[i].t : kMissDistance,
                          found_[i] ? hits_[i].shape->surface : nullptr, out[i]);
  }
}

}  // namespace verisim::shading
