// What shows where the rays of a wavefront hit: textures, their layers, colours and normals, batch by batch (spec 06
// sections 3.1 to 3.3).
#include "tracer/shading/finish.h"
#include "tracer/shading/wavefront/wavefront.h"
#include "tracer/textures/evaluation/pigment.h"
#include "tracer/textures/patterns/pattern.h"

namespace verisim::shading {
namespace {

constexpr std::size_t kMaxTextures = 8, kMaxLayers = 8;  // of a hit; what has more goes the common way
// Of a map two textures show at most, but of one in another there may be more.
constexpr int kMaxNesting = 4;
// Looked at in a texture of textures: maps may share entries, so that there are powers of them.
constexpr int kMaxEntries = 1024;

bool is_mirror(const scene::Finish& f) { return f.reflection.maximum != Rgb() || f.reflection.minimum != Rgb(); }

}  // namespace

// `depth`: textures around this one; `rest`: entries that may still be looked at.
bool Wavefront::shaded_together(const textures::CompiledTexture& texture, int depth, int& rest) const {
  if (--rest < 0) return false;
  if (texture.patterned()) {
    return depth < kMaxNesting && !texture.map.empty() && (!texture.average || texture.map.size() <= kMaxTextures) &&
           std::ranges::all_of(texture.map,
                               [&](const auto& entry) { return shaded_together(*entry.value, depth + 1, rest); });
  }
  if (texture.layers.size() > kMaxLayers) return false;
  int grainy = 0;
  for (const textures::CompiledLayer& layer : texture.layers) {
    grainy += layer.finish.crand > 0;
    if (layer.finish.subsurface && scene_.effects && scene_.effects->subsurface) return false;
  }
  // The numbers of several grainy layers are drawn layer by layer, while these are lit light by light; and photons draw
  // some before the lights.
  return grainy == 0 || (grainy == 1 && depth == 0 && !photons_);
}

Wavefront::Materials Wavefront::find_materials(const textures::CompiledTexture& texture) const {
  Materials all;
  int rest = kMaxEntries;
  if (!shaded_together(texture, 0, rest)) return all;
  if (texture.patterned()) {
    all.emplace_back();
    return all;
  }
  for (const textures::CompiledLayer& layer : texture.layers) {
    const scene::Finish& f = layer.finish;
    Material& m = all.emplace_back();
    m.layer = &layer;
    m.constant = layer.pigment->source == textures::CompiledPigment::Source::plain;
    m.only = texture.layers.size() == 1;
    m.mirror = is_mirror(f);
    m.color = layer.pigment->color;
    m.highlight = f.phong > 0 ? phong_highlight(f) : f.specular > 0 ? blinn_highlight(f) : Highlight{};
    m.lobes = (f.phong > 0      ? kPhong
               : f.specular > 0 ? kBlinn
                                : 0) |
              (f.metallic > 0 ? kMetallic : 0) | (f.phong > 0 && f.specular > 0 ? kBothHighlights : 0) |
              (f.brilliance != 1 ? kBrilliance : 0) | (f.irid > 0 ? kFilm : 0) | (f.crand > 0 ? kGrain : 0);
    m.single = m.only && !m.mirror && !layer.pigment->transparent && !indirect_ && !photons_ &&
               !(m.constant && !is_finite(m.color.rgb())) && !(m.lobes & kFilm);
    const bool finite = is_finite(f.ambient * scene_.ambient_light) && is_finite(f.emission) &&
                        std::fabs(m.highlight.exponent) < 1e6 && m.highlight.amount < 1e30 &&
                        std::fabs(f.diffuse) + std::fabs(f.diffuse_back) < 1e30f;
    if (!finite) return {};
  }
  return all;
}

const Wavefront::Materials& Wavefront::materials(const textures::CompiledTexture& texture) {
  auto& last =
      last_materials_[reinterpret_cast<std::uintptr_t>(&texture) / sizeof texture % std::size(last_materials_)];
  if (last.first != &texture) {
    auto known = materials_.find(&texture);
    if (known == materials_.end()) known = materials_.emplace(&texture, find_materials(texture)).first;
    last = {&texture, &known->second};
  }
  return *last.second;
}

// Which way hit i goes, and the textures that show there.
void Wavefront::meet(int i) {
  Met& met = met_[i];
  met.together = false;
  met.single = nullptr;
  met.leaves = met.parts = 0;
  const shapes::Hit& hit = hits_[i];
  const Vec3 direction = packet_.rays.direction.at(i), normal = hit.shape->normal(hit);
  const double along = dot(normal, direction);
  if (!(std::fabs(along) < 1e30)) return;
  const bool inside = along > 0;
  auto& last = last_single_[inside];
  if (last.first == hit.shape) return take_single(i, *last.second, inside ? -normal : normal);
  const shapes::Surface& surface = *hit.shape->surface;
  if (surface.ignore_global_lights || !surface.group_lights().empty()) return;
  const auto* texture = surface.texture_within(inside);
  weighted_.clear();
  if (surface.shows_several()) scene_.world.weighted_textures(hit, inside, weighted_);
  const bool alone = weighted_.size() == 1 && weighted_[0].weight == 1;
  if (alone) texture = weighted_[0].texture;
  if (!texture) return;
  met.first = static_cast<int>(leaves_.size());
  if (!weighted_.empty() && !alone) {
    met.at.emplace(hit, normal, direction, 0, state_.surface_level());
    return add_weighted_leaves(i);
  }
  const Materials& found = materials(*texture);
  if (found.empty()) return;
  const Material& first = found[0];
  if (first.single) {
    if (!surface.shows_several()) last = {hit.shape, &first};
    return take_single(i, first, inside ? -normal : normal);
  }
  met.together = true;
  met.at.emplace(hit, normal, direction, 0, state_.surface_level());
  add_leaves(i, *texture, found);
}

// What of it is the same everywhere is known at once. `normal`: turned towards the viewer.
void Wavefront::take_single(int i, const Material& material, const Vec3& normal) {
  Met& met = met_[i];
  met.together = true;
  met.single = &material;
  met.normal = normal;
  met.color = material.color.rgb();
  if (material.constant && !material.layer->normal) return;
  const shapes::Hit& hit = hits_[i];
  texture_points_[i] = texture_point(hit, normal, packet_.rays.direction.at(i));
  met.point = hit.shape->surface->uv_mapping ? textures::uv_point(texture_points_[i]) : hit.point;
  varying_[varying_count_++] = i;
}

// Splits off those of `waiting` that have the same key as its first; leaves the others there, in order.
template <class Key>
int Wavefront::take_group(int* waiting, int& n, int* group, const Key& key) {
  const auto* const first = key(waiting[0]);
  int same = 0, others = 0;
  for (int k = 0; k < n; ++k) (key(waiting[k]) == first ? group[same++] : waiting[others++]) = waiting[k];
  n = others;
  return same;
}

// Colours and normals of single materials that vary.
void Wavefront::find_singles() {
  int group[kMax];
  while (varying_count_ > 0) {
    const int same = take_group(varying_, varying_count_, group, [this](int i) { return met_[i].single; });
    find_singles(*met_[group[0]].single, group, same);
  }
}

void Wavefront::find_singles(const Material& material, const int* rays, int n) {
  textures::PointBatch points;
  textures::SurfacePoint* surfaces[kMax];
  for (int k = 0; k < n; ++k) {
    points.set(k, met_[rays[k]].point);
    surfaces[k] = &texture_points_[rays[k]];
    normals_[k] = met_[rays[k]].normal;
  }
  points.fill_up(n);
  if (const auto* perturbed = material.layer->normal) {
    textures::perturb(*perturbed, n, points, surfaces, normals_);
    for (int k = 0; k < n; ++k) {
      met_[rays[k]].normal = normals_[k];
      met_[rays[k]].together = faces_finitely(rays[k], normals_[k]);
    }
  }
  if (material.constant) return;
  textures::evaluate(*material.layer->pigment, n, points, surfaces, colors_, colored_);
  for (int k = 0; k < n; ++k) {
    met_[rays[k]].color = colors_[k].rgb();
    if (!is_finite(met_[rays[k]].color)) met_[rays[k]].together = false;
  }
}

// Leaves and parts are written where they stay: copies of what was just written in pieces would wait for it.
Wavefront::Leaf& Wavefront::add_leaf(int i, const Materials& found, const Vec3& point, double weight) {
  Leaf& leaf = leaves_.emplace_back();
  leaf.ray = i;
  leaf.materials = &found;
  leaf.point = point;
  leaf.weight = weight;
  return leaf;
}

// Patterns that look at the surface see the normal that the textures before have left.
bool Wavefront::sees_left_normal(int i, const textures::CompiledTexture& texture) const {
  if (!texture.pattern || !scene::info(texture.pattern->kind).is(scene::PatternInfo::kNotRemembered)) return false;
  return std::any_of(leaves_.begin() + met_[i].first, leaves_.end(), [](const Leaf& leaf) {
    return std::ranges::any_of(*leaf.materials, [](const Material& m) { return m.layer->normal != nullptr; });
  });
}

// The textures that show of a patterned one, and of those among them. `frames`: those that were looked into before.
void Wavefront::add_entries(int i, const textures::CompiledTexture& texture, const Vec3& p, int group,
                            TextureFrames* frames) {
  Met& met = met_[i];
  const TextureParts parts(tracer_.selection_, texture, p, met.at->texture_point, frames);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const textures::WeightedTexture entry = parts[k];
    if (entry.weight == 0 && !texture.average) continue;
    const Materials& inner = materials(*entry.texture);
    const bool fits = leaves_.size() - static_cast<std::size_t>(met.first) < kMaxTextures;
    if (inner.empty() || entry.weight == 0 || !fits || sees_left_normal(i, *entry.texture)) {
      met.together = false;
    } else if (entry.texture->patterned()) {
      groups_.push_back({group, entry.weight});
      add_entries(i, *entry.texture, parts.point, static_cast<int>(groups_.size()) - 1, &parts.frames);
    } else {
      Leaf& leaf = add_leaf(i, inner, parts.point, entry.weight);
      leaf.group = group;
      // To those of the leaf before some were added, if any.
      while (frames_.size() - static_cast<std::size_t>(met.first_frame) < parts.frames.size())
        frames_.push_back(&parts.frames[frames_.size() - static_cast<std::size_t>(met.first_frame)]);
      leaf.first_frame = met.first_frame, leaf.frames = static_cast<int>(parts.frames.size());
    }
    if (!met.together) return;
  }
}

void Wavefront::add_leaves(int i, const textures::CompiledTexture& texture, const Materials& found) {
  Met& met = met_[i];
  const Vec3 p = met.at->pattern_point();
  if (!texture.patterned()) {
    add_leaf(i, found, p, 1);
  } else {
    met.first_frame = static_cast<int>(frames_.size());
    add_entries(i, texture, p, kNoGroup, nullptr);
  }
  met.leaves = static_cast<int>(leaves_.size()) - met.first;
  met.together = met.together && met.leaves > 0;
}

// Of the textures that share hit i by weights: corners of a triangle, components of a blob.
void Wavefront::add_weighted_leaves(int i) {
  Met& met = met_[i];
  const Vec3 p = met.at->pattern_point();
  met.together = true;
  for (const textures::WeightedTexture& entry : weighted_) {
    if (entry.weight < tracer_.bailout(state_)) continue;
    const Materials& found = materials(*entry.texture);
    const bool grainy = std::ranges::any_of(found, [](const Material& m) { return m.lobes & kGrain; });
    if (found.empty() || grainy || sees_left_normal(i, *entry.texture)) {
      met.together = false;
    } else if (entry.texture->patterned()) {
      groups_.push_back({kNoGroup, entry.weight});
      met.first_frame = static_cast<int>(frames_.size());
      add_entries(i, *entry.texture, p, static_cast<int>(groups_.size()) - 1, nullptr);
    } else {
      add_leaf(i, found, p, entry.weight);
    }
  }
  met.leaves = static_cast<int>(leaves_.size()) - met.first;
  met.together = met.together && met.leaves > 0;
}

Wavefront::Part& Wavefront::begin_part(Leaf& leaf) {
  const int k = static_cast<int>(parts_.size());
  Part& part = parts_.emplace_back();
  (leaf.first < 0 ? leaf.first : parts_[static_cast<std::size_t>(leaf.last)].next) = k;
  leaf.last = k;
  part.index = leaf.parts++;
  ++met_[leaf.ray].parts;
  return part;
}

// The share that it reflects.
Rgb Wavefront::add_mirror(const Leaf& leaf, Part& part) {
  const textures::CompiledLayer& layer = *part.material->layer;
  const scene::Reflection& reflection = layer.finish.reflection;
  const double ratio = reflection.fresnel ? tracer_.fresnel_ratio(state_, *met_[leaf.ray].at->surface.interior) : 0;
  const Mirror mirror =
      mirror_of(reflection, part.color.rgb(), -dot(packet_.rays.direction.at(leaf.ray), part.normal), ratio);
  if (mirror.reflectivity != Rgb())
    part.mirror = add_branch(leaf, {&layer, part.color, part.normal, mirror, leaf.translucency}, false);
  return mirror.reflectivity;
}

// The layers of all hits. The textures of one hit are looked at one after another: normals leave their trace in what
// patterns see.
void Wavefront::find_parts(int count) {
  int waiting[kMax], group[kMax];
  for (int round = 0;; ++round) {
    int n = 0;
    for (int i = 0; i < count; ++i) {
      if (!found_[i] || !met_[i].together || round >= met_[i].leaves) continue;
      waiting[n++] = met_[i].first + round;
    }
    if (n == 0) return;
    while (n > 0) {
      const int same =
          take_group(waiting, n, group, [this](int l) { return leaves_[static_cast<std::size_t>(l)].materials; });
      find_layers(group, same);
    }
  }
}

bool Wavefront::faces_finitely(int i, const Vec3& normal) const {
  return std::fabs(dot(normal, packet_.rays.direction.at(i))) < 1e30;
}

// The layers of one texture at n hits, from the top to the last one that shows.
void Wavefront::find_layers(int* leaves, int n) {
  for (const Material& material : *leaves_[static_cast<std::size_t>(leaves[0])].materials) {
    if (n == 0) return;
    find_colors_and_normals(material, leaves, n);
    double thickness[kMax];
    if (material.lobes & kFilm) find_thickness(material, leaves, n, thickness);
    int still = 0;
    for (int k = 0; k < n; ++k) {
      Leaf& leaf = leaves_[static_cast<std::size_t>(leaves[k])];
      const Color& c = colors_[k];
      const bool finite = !material.layer->normal || faces_finitely(leaf.ray, normals_[k]);  // else known by `meet`
      if (!finite || !is_finite(c.rgb()) || !is_finite({c.f, c.t, 0})) {
        met_[leaf.ray].together = false;
        continue;
      }
      Part& part = begin_part(leaf);
      part.material = &material;
      part.normal = normals_[k];
      part.color = c;
      part.opacity = surface_opacity(c, scene_.version);
      part.filter = leaf.filter;
      if (material.lobes & kFilm) part.thickness = thickness[k];
      const Rgb reflected = material.mirror ? add_mirror(leaf, part) : Rgb();
      if (material.only && c.f == 0 && c.t == 0) continue;
      if (colored_[k]) {  // else there is no layer here, as beside an image that is shown once
        leaf.filter *= c.transmission();
        if (material.layer->finish.conserve_energy)
          leaf.filter *=
              {std::min(1.0f, 1 - reflected.r), std::min(1.0f, 1 - reflected.g), std::min(1.0f, 1 - reflected.b)};
      }
      leaf.translucency = std::min(1.0f, std::fabs(leaf.filter.grey()));
      if (leaf.translucency > tracer_.bailout(state_)) leaves[still++] = leaves[k];
    }
    n = still;
  }
  // Something behind the surface shows.
  for (int k = 0; k < n; ++k) {
    Leaf& leaf = leaves_[static_cast<std::size_t>(leaves[k])];
    const Part& top = parts_[static_cast<std::size_t>(leaf.first)];
    leaf.behind = add_branch(leaf, {top.material->layer, top.color, top.normal, {}, 1}, true);
    branches_.back().weight = leaf.filter.max_abs();
  }
}

// Of an iridescent film, at n leaves.
void Wavefront::find_thickness(const Material& material, const int* leaves, int n, double* thickness) const {
  const scene::Finish& finish = material.layer->finish;
  if (finish.irid_turbulence == 0) {
    std::fill_n(thickness, n, finish.irid_thickness);
    return;
  }
  static const textures::Octaves octaves = film_octaves();
  textures::PointBatch points;
  for (int k = 0; k < n; ++k) points.set(k, hits_[leaves_[static_cast<std::size_t>(leaves[k])].ray].point);
  points.fill_up(n);
  alignas(64) double t[textures::PointBatch::kMax];
  textures::turbulence(scene_.scene.settings.noise_generator, n, points, octaves, t);
  for (int k = 0; k < n; ++k) thickness[k] = turbulent_thickness(finish, t[k]);
}

// Normals first: they leave their trace in what patterns see (Tracer::layer_normal).
void Wavefront::find_colors_and_normals(const Material& material, const int* leaves, int n) {
  textures::PointBatch points;
  textures::SurfacePoint* surfaces[kMax];
  const textures::CompiledNormal* const perturbed = material.layer->normal;
  for (int k = 0; k < n; ++k) {
    const Leaf& leaf = leaves_[static_cast<std::size_t>(leaves[k])];
    SurfaceHit& at = *met_[leaf.ray].at;
    points.set(k, leaf.point);
    surfaces[k] = &at.texture_point;
    normals_[k] = at.geometric_normal;
    for (int f = 0; perturbed && f < leaf.frames; ++f) normals_[k] = textures::enter_frame(frame(leaf, f), normals_[k]);
  }
  points.fill_up(n);
  if (perturbed) {
    textures::perturb(*perturbed, n, points, surfaces, normals_);
    for (int k = 0; k < n; ++k) {
      const Leaf& leaf = leaves_[static_cast<std::size_t>(leaves[k])];
      for (int f = leaf.frames; f-- > 0;) normals_[k] = textures::leave_frame(frame(leaf, f), normals_[k]);
    }
  }
  textures::evaluate(*material.layer->pigment, n, points, surfaces, colors_, colored_);
}

}  // namespace verisim::shading
