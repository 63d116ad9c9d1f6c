#include "tracer/shading/wavefront/wavefront.h"

#include "tracer/shading/finish.h"
#include "tracer/shading/atmosphere/fog.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/shading/direct/shadow_batch.h"
#include "tracer/textures/evaluation/pigment.h"

namespace verisim::shading {
namespace {

// Lights that light a surface by several directions at once are for the common way.
bool is_simple(const Light& light) { return !light.area_illumination() && is_finite(light.color()); }

}  // namespace

Wavefront::Wavefront(Tracer& tracer, bool asks_around)
    : tracer_(tracer), scene_(tracer.scene()), kernels_(wavefront_kernels()), packet_{} {
  usable_ = scene_.quality >= 9 && !tracer_.in_order() && scene_.adc_bailout >= 0 && scene_.adc_bailout < 1;
  indirect_ = asks_around && scene_.effects && scene_.effects->radiosity;
  // A sample may decide which of the rays after it are shaded.
  usable_ = usable_ && !(scene_.effects && scene_.effects->importance_counts);
  photons_ = scene_.effects && scene_.effects->photons;
  for (std::size_t i = 0; i < scene_.global_lights(); ++i) usable_ = usable_ && is_simple(scene_.lights()[i]);
  for (float* tint : {packet_.tint.r, packet_.tint.g, packet_.tint.b, packet_.film.r, packet_.film.g, packet_.film.b})
    std::fill_n(tint, kMax, 1.0f);
  plain_sky_ = !scene_.sky.varies();
  for (const bool opaque : {false, true})
    if (plain_sky_) sky_[opaque] = scene_.sky.seen({0, 0, 1}, opaque);
}

// The next lane, for a surface at hit i.
int Wavefront::add_lane(int i, const Material& m, const Vec3& normal) {
  const int k = count_++;
  pixel_[k] = i;
  grains_[k] = 0;
  surface_[k] = hits_[i].shape->surface;
  packet_.to_light.origin.set(k, hits_[i].point);
  packet_.normal.set(k, normal);
  packet_.view.set(k, packet_.rays.direction.at(i));
  packet_.two_sided[k] = surface_[k]->double_illuminate;
  lobes_ |= m.lobes;
  return k;
}

void Wavefront::set_material(int k, const Material& m) {
  material_[k] = &m;
  finish_[k] = &m.layer->finish;
  packet_.lit_behind[k] = finish_[k]->diffuse_back != 0;
  packet_.dull[k] = !reflects_light(*finish_[k]);
  packet_.exponent[k] = m.highlight.exponent, packet_.amount[k] = m.highlight.amount,
  packet_.dark_to[k] = m.highlight.dark_to, packet_.phong[k] = (m.lobes & kPhong) != 0;
}

void Wavefront::set_opacity(int k, double opacity) {
  packet_.front[k] = diffuse_share(opacity, std::max(finish_[k]->diffuse, 0.0f)),
  packet_.behind[k] = diffuse_share(opacity, std::max(finish_[k]->diffuse_back, 0.0f));
}

void Wavefront::set_color(int k, const Rgb& color, double opacity) {
  packet_.pigment.r[k] = color.r, packet_.pigment.g[k] = color.g, packet_.pigment.b[k] = color.b;
  const Rgb own = own_light(*finish_[k], color, scene_.ambient_light, opacity);
  packet_.own.r[k] = own.r, packet_.own.g[k] = own.g, packet_.own.b[k] = own.b;
}

// A material in a lane where it stands already has its numbers there, and, if it is of one colour, that: it is opaque
// in parts, too.
void Wavefront::add_single(int i) {
  const Met& met = met_[i];
  const Material& m = *met.single;
  const int k = add_lane(i, m, met.normal);
  part_[k] = nullptr;
  if (material_[k] != &m) {
    set_material(k, m);
    set_opacity(k, 1);
  } else if (m.constant) {
    return;
  }
  set_color(k, met.color, 1);
}

// `texture`: its number among those of the hit.
void Wavefront::add_part(int i, const Part& part, int texture) {
  const Material& m = *part.material;
  const int k = add_lane(i, m, part.normal);
  part_[k] = &part;
  if (material_[k] != &m) set_material(k, m);
  set_opacity(k, part.opacity);
  set_color(k, part.color.rgb(), part.opacity);
  if (!indirect_) return;
  begin_branch(i, RandomBranch::indirect(texture, part.index));
  if (part.index == 0) met_[i].at->indirect = met_[i].at->indirect_back = {};  // as in Tracer::shade_layers
  const Rgb own = Rgb(packet_.own.r[k], packet_.own.g[k], packet_.own.b[k]) +
                  scene_.effects->indirect_light(tracer_, ray_state(i), *met_[i].at, layer_context(part));
  packet_.own.r[k] = own.r, packet_.own.g[k] = own.g, packet_.own.b[k] = own.b;
}

// Takes what shows at hit i among the surfaces that are lit together; false: there is no room for it.
bool Wavefront::add_surface(int i) {
  if (met_[i].single) {
    if (count_ == kMax) return false;
    add_single(i);
    return true;
  }
  if (count_ + met_[i].parts > kMax) return false;
  layered_ |= met_[i].parts > 1;
  for (int l = met_[i].first; l < met_[i].first + met_[i].leaves; ++l)
    for (int k = leaves_[static_cast<std::size_t>(l)].first; k >= 0;) {
      const Part& part = parts_[static_cast<std::size_t>(k)];
      add_part(i, part, l - met_[i].first);
      k = part.next;
    }
  return true;
}

// Where the light is from every surface.
void Wavefront::aim(const Light& light) {
  aim_at(light, count_, packet_.to_light, packet_.distance);
  kernels_.face(count_, packet_);
}

// Which surfaces the light reaches, and with what colour.
bool Wavefront::reach(const Light& light) {
  if (const auto falloff = light.attenuates() ? LightFalloff::of(light) : std::nullopt) {
    falloff->attenuate(packet_.to_light.direction, packet_.distance, count_, packet_.attenuation);
  } else if (light.attenuates()) {
    for (int k = 0; k < count_; ++k)
      packet_.attenuation[k] =
          light.attenuation(packet_.to_light.origin.at(k), {packet_.to_light.direction.at(k), packet_.distance[k]});
  } else if (attenuated_) {
    std::fill_n(packet_.attenuation, kMax, 1.0);
  }
  attenuated_ = light.attenuates();
  if (!kernels_.receive(light.color(), light.highlights() && !state_.gather, count_, packet_)) return false;
  int asks[kMax];
  if (layered_) share_asking(asks);
  cast_shadows(light);
  for (int k = 0; layered_ && k < count_; ++k) {
    const int first = asks[k];
    if (first < 0 || first == k) continue;
    packet_.active[k] = packet_.active[first];
    packet_.intensity.r[k] = packet_.intensity.r[first], packet_.intensity.g[k] = packet_.intensity.g[first],
    packet_.intensity.b[k] = packet_.intensity.b[first];
  }
  return kernels_.illuminate(count_, packet_);
}

// The first layer of a hit that asks for its shadow does so for all: asks[k] is the layer that asks for layer k, or -1.
void Wavefront::share_asking(int* asks) {
  for (int k = 0, first = -1; k < count_; ++k) {
    if (k == 0 || pixel_[k] != pixel_[k - 1]) first = -1;
    asks[k] = -1;
    if (packet_.active[k] == 0) continue;
    if (first < 0) first = k;
    asks[k] = first;
    packet_.active[k] = first == k;
  }
}

// Filters the light of all that are asked for.
void Wavefront::cast_shadows(const Light& light) {
  if (!light.shadows()) return;
  const std::uint32_t number = RandomBranch::light(static_cast<std::size_t>(&light - scene_.lights().data()));
  ShadowBatch batch;
  int lane[kMax];
  for (int k = 0; k < count_; ++k) {
    if (packet_.active[k] == 0) continue;
    lane[batch.count] = k;
    batch.add(packet_.to_light.at(k), packet_.distance[k],
              {packet_.intensity.r[k], packet_.intensity.g[k], packet_.intensity.b[k]}, surface_[k],
              RandomSource::branch_key(keys_[pixel_[k]], number));
  }
  tracer_.cast_shadows(light, state_, batch);
  for (int i = 0; i < batch.count; ++i) {
    const int k = lane[i];
    packet_.intensity.r[k] = batch.light[i].r, packet_.intensity.g[k] = batch.light[i].g,
    packet_.intensity.b[k] = batch.light[i].b;
  }
}

void Wavefront::evaluate_lobes() {
  if ((lobes_ & kMetallic) || tinted_) {
    for (int k = 0; k < count_; ++k) {
      const Rgb pigment(packet_.pigment.r[k], packet_.pigment.g[k], packet_.pigment.b[k]);
      const Rgb tint =
          finish_[k]->metallic > 0 ? metallic_tint(pigment, finish_[k]->metallic, packet_.cosine[k]) : Rgb(1);
      packet_.tint.r[k] = tint.r, packet_.tint.g[k] = tint.g, packet_.tint.b[k] = tint.b;
    }
    tinted_ = true;
  }
  if (kernels_.evaluate_lobes(lobes_ & kPhong, lobes_ & kBlinn, count_, packet_)) {
    for (int k = 0; k < count_; ++k)
      if (packet_.uncertain[k] && packet_.lit[k] != 0 && packet_.amount[k] * packet_.shines[k] != 0)
        packet_.strength[k] = highlights(k)[material_[k]->lobes & kPhong ? 0 : 1];
  }
  if (lobes_ & (kBothHighlights | kBrilliance | kGrain)) evaluate_special_lobes();
  if ((lobes_ & kFilm) || filmed_) tint_by_films();
}

// What iridescence makes of the light of each surface.
void Wavefront::tint_by_films() {
  for (int k = 0; k < count_; ++k) {
    Rgb tint(1);
    if ((material_[k]->lobes & kFilm) && packet_.lit[k] != 0)
      tint = tracer_.film_tint(*finish_[k], part_[k]->thickness,
                               std::fabs(packet_.cosine[k]) + std::fabs(dot(packet_.normal.at(k), packet_.view.at(k))));
    packet_.film.r[k] = tint.r, packet_.film.g[k] = tint.g, packet_.film.b[k] = tint.b;
  }
  filmed_ = true;
}

// What the wide instructions do not know.
void Wavefront::evaluate_special_lobes() {
  for (int k = 0; k < count_; ++k) {
    packet_.second[k] = 0;
    if (packet_.lit[k] == 0) continue;
    if ((material_[k]->lobes & kBrilliance) && packet_.diffuse[k] != 0)
      packet_.scattered[k] = packet_.diffuse[k] * brilliance(finish_[k]->brilliance, packet_.cosine[k]);
    if (material_[k]->lobes & kGrain) {
      const bool back = packet_.cosine[k] < kEpsilon && packet_.two_sided[k] == 0;
      if ((back ? finish_[k]->diffuse_back : finish_[k]->diffuse) > 0)
        packet_.scattered[k] -= finish_[k]->crand * RandomSource::crand(keys_[pixel_[k]], ++grains_[k]);
    }
    if ((material_[k]->lobes & kBothHighlights) && packet_.shines[k] != 0) {
      const auto [phong, blinn] = highlights(k);
      packet_.strength[k] = phong, packet_.second[k] = blinn;
    }
  }
}

std::array<double, 2> Wavefront::highlights(int k) const {
  return highlight_strengths(*finish_[k], packet_.normal.at(k), packet_.view.at(k), packet_.to_light.direction.at(k));
}

void Wavefront::light(const Light& light) {
  aim(light);
  if (!reach(light)) return;
  evaluate_lobes();
  kernels_.add(lobes_ & kBothHighlights, count_, packet_);
}

// What a texture shows whose layers are lit in the lanes from `lane` on; moves to the lane behind them.
Color Wavefront::shown(const Leaf& leaf, int& lane) {
  Rgb color;
  bool branches = leaf.behind >= 0;
  for (int k = leaf.first; k >= 0; ++lane) {
    const Part& part = parts_[static_cast<std::size_t>(k)];
    color += part.filter * Rgb(packet_.direct.r[lane], packet_.direct.g[lane], packet_.direct.b[lane]);
    branches |= part.mirror >= 0;
    k = part.next;
  }
  Color result = color;
  if (branches) add_branches(leaf, result);
  return result;
}

// The child of `outer` that `group` is or lies in; kNoGroup: it does not lie there.
int Wavefront::child_around(int group, int outer) const {
  while (group != kNoGroup && groups_[static_cast<std::size_t>(group)].outer != outer)
    group = groups_[static_cast<std::size_t>(group)].outer;
  return group;
}

// What the leaves from `leaf` on that lie in a group show together; moves to the leaf and the lane behind them.
Color Wavefront::sum_of(int group, int& leaf, int end, int& lane) {
  Color sum;
  while (leaf < end) {
    const Leaf& next = leaves_[static_cast<std::size_t>(leaf)];
    if (next.group == group) {
      sum += scaled(shown(next, lane), next.weight);
      ++leaf;
    } else if (const int child = child_around(next.group, group); child != kNoGroup) {
      sum += scaled(sum_of(child, leaf, end, lane), groups_[static_cast<std::size_t>(child)].weight);
    } else {
      break;
    }
  }
  return sum;
}

// The colours of pixels from their layers and textures.
void Wavefront::sum_layers(Color* out) {
  for (int k = 0; k < count_;) {
    const Met& met = met_[pixel_[k]];
    Color& result = out[pixel_[k]];
    Color sum;
    if (met.single) {
      sum += Rgb(packet_.direct.r[k], packet_.direct.g[k], packet_.direct.b[k]);
      ++k;
    } else {
      int leaf = met.first;
      sum = sum_of(kNoGroup, leaf, met.first + met.leaves, k);
    }
    result = sum;
  }
}

LayerContext Wavefront::layer_context(const Part& part) {
  return {*part.material->layer, part.color, part.normal, part.opacity, part.filter};
}

void Wavefront::add_photons() {
  for (int k = 0; k < count_; ++k) {
    const Rgb added =
        scene_.effects->photon_light(tracer_, ray_state(pixel_[k]), *met_[pixel_[k]].at, layer_context(*part_[k]));
    packet_.direct.r[k] += added.r, packet_.direct.g[k] += added.g, packet_.direct.b[k] += added.b;
  }
}

// Lights the surfaces that were added, and writes their colours.
void Wavefront::show(Color* out) {
  packet_.direct = packet_.own;
  if (count_ > 0)
    for (std::size_t i = 0; i < scene_.global_lights(); ++i) light(scene_.lights()[i]);
  if (photons_) add_photons();
  if (leaves_.empty()) {  // single materials alone
    for (int k = 0; k < count_; ++k)
      out[pixel_[k]] = Rgb() + Rgb(packet_.direct.r[k], packet_.direct.g[k], packet_.direct.b[k]);
  } else {
    sum_layers(out);
  }
  count_ = 0;
  lobes_ = 0;
  layered_ = false;
}

// The rays that hit nothing.
void Wavefront::show_sky(int count, Color* out) {
  const bool opaque = state_.reflected || state_.gather;
  textures::PointBatch directions;
  int misses[kMax], n = 0;
  for (int i = 0; i < count; ++i) {
    if (found_[i]) continue;
    if (plain_sky_) {
      out[i] = sky_[opaque];
    } else {
      directions.set(n, packet_.rays.direction.at(i));
      misses[n++] = i;
    }
  }
  if (n == 0) return;
  Color colors[kMax];
  scene_.sky.seen(n, directions, opaque, colors);
  for (int k = 0; k < n; ++k) out[misses[k]] = colors[k];
}

void Wavefront::trace(int count, const accel::WorldEntry* const* entries, Color* out) {
  state_ = tracer_.camera_state(packet_.rays.at(0), false);
  std::fill_n(weights_, count, 1.0f);
  for (int i = 0; i < count; ++i) keys_[i] = tracer_.random_.sample_key(places_[i].x, places_[i].y, numbers_[i]);
  tracer_.statistics_.camera_rays += static_cast<std::uint64_t>(count);
  if (count > 1) tracer_.statistics_.wavefront_rays += static_cast<std::uint64_t>(count);
  run(count, entries, out);
}

void Wavefront::run(int count, const accel::WorldEntry* const* entries, Color* out) {
  if (tracer_.cancel_ && tracer_.cancel_->load(std::memory_order_relaxed)) throw Cancelled();
  for (int first = 0, end; first < count; first = end) {
    for (end = first + 1; end < count && entries[end] == entries[first];) ++end;
    scene_.world.intersect_batch(packet_.rays, first, end - first, state_.kind(), kNearestHit, entries[first], hits_,
                                 found_);
  }
  shade(count, out);
}

// What is known to be hit.
void Wavefront::shade(int count, Color* out) {
  leaves_.clear();
  groups_.clear();
  frames_.clear();
  parts_.clear();
  branches_.clear();
  varying_count_ = 0;
  for (int i = 0; i < count; ++i)
    if (found_[i]) meet(i);
  find_singles();
  find_parts(count);
  trace_branches();
  show_sky(count, out);
  bool cut_off[kMax] = {};
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

// Of ray i, with the numbers of one of its branches.
MediaSegment Wavefront::segment(int i, std::uint32_t branch, Color& color) const {
  return {packet_.rays.at(i), found_[i] ? hits_[i].t : kMissDistance, found_[i] ? hits_[i].shape->surface : nullptr,
          RandomSource::branch_key(keys_[i], branch), &color};
}

void Wavefront::apply_volumes(int count, const bool* cut_off, Color* out) {
  if (!state_.hollow || !state_.volumes) return;
  const bool container = scene_.effects && scene_.effects->media_in_interiors && state_.interiors.count > 0;
  if (!container && !tracer_.has_volumes_) return;
  if (container) {
    MediaSegment segments[kMax];
    std::size_t n = 0;
    for (int i = 0; i < count; ++i)
      if (found_[i] && !cut_off[i]) segments[n++] = segment(i, RandomBranch::kContainer, out[i]);
    scene_.effects->container_media(tracer_, state_, std::span(segments, n));
  }
  if (!tracer_.has_volumes_) return;
  if (scene_.rainbows.empty()) {
    MediaSegment segments[kMax];
    std::size_t n = 0;
    for (int i = 0; i < count; ++i)
      if (!cut_off[i]) segments[n++] = segment(i, RandomBranch::kAir, out[i]);
    if (scene_.effects && scene_.effects->atmosphere)
      scene_.effects->atmosphere_media(tracer_, state_, std::span(segments, n));
    tracer_.apply_fog(std::span(segments, n));
    return;
  }
  for (int i = 0; i < count; ++i) {
    if (cut_off[i]) continue;
    tracer_.random_.begin(keys_[i]);
    tracer_.apply_volumes(ray_state(i), found_[i] ? hits_[i].t : kMissDistance,
                          found_[i] ? hits_[i].shape->surface : nullptr, out[i]);
  }
}

}  // namespace verisim::shading
