// What is seen in the mirrors of a wavefront and through its surfaces: the rays that they send out are wavefronts, too
// (spec 06 sections 5 and 6).
#include <algorithm>

#include "tracer/shading/finish.h"
#include "tracer/shading/wavefront/wavefront.h"

namespace verisim::shading {
namespace {

constexpr int kMin = 8;       // rays that are worth a wavefront
constexpr int kDeepest = 12;  // wavefronts within wavefronts: each has its own room

}  // namespace

RayState Wavefront::ray_state(int i) const {
  RayState ray = state_;
  ray.ray = packet_.rays.at(i);
  ray.weight = weights_[i];
  if (state_.gather) ray.notes = notes_[i];
  return ray;
}

int Wavefront::add_branch(const Leaf& leaf, const Tracer::ShadedLayer& layer, bool behind) {
  const int index = static_cast<int>(&leaf - leaves_.data()), texture = index - met_[leaf.ray].first;
  const std::uint32_t number = behind
                                   ? RandomBranch::behind(texture)
                                   : RandomBranch::mirror(texture, parts_[static_cast<std::size_t>(leaf.last)].index);
  branches_.push_back({layer, leaf.ray, index, behind, RandomSource::branch_key(keys_[leaf.ray], number),
                       parts_[static_cast<std::size_t>(behind ? leaf.first : leaf.last)].thickness});
  return static_cast<int>(branches_.size()) - 1;
}

// Crossing a surface of this interior; kept until the wavefront's branches are traced.
const Wavefront::Crossing& Wavefront::crossing(const scene::Interior& interior) {
  for (const Crossing& known : crossings_)
    if (known.interior == &interior) return known;
  Crossing& c = crossings_.emplace_back(Crossing{&interior, tracer_.cross_surface(ray_state(0), interior)});
  c.group = static_cast<int>(crossings_.size());
  // Rays that are in the same interiors behind different surfaces are one wavefront.
  const auto inside = tracer_.interiors(c.refraction.interiors);
  for (const Crossing& other : crossings_) {
    if (&other == &c || other.refraction.straight() != c.refraction.straight() ||
        !std::ranges::equal(inside, tracer_.interiors(other.refraction.interiors)))
      continue;
    c.group = other.group;
    break;
  }
  return c;
}

// Where the ray goes on behind the surface, or that it does not.
void Wavefront::aim_behind(Branch& branch) {
  const SurfaceHit& at = *met_[branch.ray].at;
  const Crossing& c = crossing(*at.surface.interior);
  if (c.refraction.disperses()) return;  // a spectrum of rays
  const Vec3 d = packet_.rays.direction.at(branch.ray), &normal = branch.layer.normal;
  branch.weight = weights_[branch.ray] * branch.weight;
  if (c.refraction.straight()) {
    branch.group = c.group;
    branch.direction = d;
    return;
  }
  if (const auto refracted = refracted_direction(d, normal, c.refraction.ratio)) {
    branch.group = c.group;
    branch.direction = *refracted;
  } else {
    branch.total = true;
    branch.group = 0;
    branch.direction = reflected_direction(d, normal, at.geometric_normal);
  }
}

bool Wavefront::hidden(const Leaf& leaf, const Branch& mirror) const {
  return leaf.behind >= 0 && branches_[static_cast<std::size_t>(leaf.behind)].total &&
         Tracer::hidden_by_total_reflection(parts_[static_cast<std::size_t>(leaf.first)].normal, mirror.layer.normal);
}

void Wavefront::trace_branches() {
  if (branches_.size() < kMin || depth_ >= kDeepest) return;
  const Tracer::InteriorScope scope(tracer_);
  crossings_.clear();
  for (Branch& branch : branches_)
    if (branch.behind && met_[branch.ray].together) aim_behind(branch);
  for (Branch& branch : branches_) {
    if (branch.behind || !met_[branch.ray].together || hidden(leaves_[static_cast<std::size_t>(branch.leaf)], branch))
      continue;
    branch.group = 0;
    branch.weight = weights_[branch.ray] * branch.layer.translucency * branch.layer.mirror.strength;
    branch.direction = reflected_direction(packet_.rays.direction.at(branch.ray), branch.layer.normal,
                                           met_[branch.ray].at->geometric_normal);
  }
  trace_group(0, nullptr);
  for (std::size_t i = 0; i < crossings_.size(); ++i)
    if (crossings_[i].group == static_cast<int>(i) + 1) trace_group(crossings_[i].group, &crossings_[i].refraction);
}

// The branches of one group; `refraction`: null in mirrors.
void Wavefront::trace_group(int group, const Tracer::Refraction* refraction) {
  const auto size = std::ranges::count(branches_, group, &Branch::group);
  if (size < kMin) return;
  if (!branch_wavefront_) {
    branch_wavefront_ = std::make_unique<Wavefront>(tracer_, indirect_);
    branch_wavefront_->depth_ = depth_ + 1;
  }
  Wavefront& child = *branch_wavefront_;
  child.state_ = state_;
  child.state_.primary = false;
  child.state_.continuation = refraction && refraction->straight();
  child.state_.level = state_.surface_level();
  if (refraction) {
    refraction->enter(child.state_);
  } else {
    child.state_.reflected = true;
  }
  std::uint64_t& counter = !refraction              ? tracer_.statistics_.reflected_rays
                           : refraction->straight() ? tracer_.statistics_.transmitted_rays
                                                    : tracer_.statistics_.refracted_rays;
  counter += static_cast<std::uint64_t>(size);
  Branch* traced[kMax];
  int n = 0;
  const auto trace_waiting = [&] {
    const accel::WorldEntry* const unknown[kMax] = {};
    Color colors[kMax];
    if (n > 0) child.run(n, unknown, colors);
    for (int k = 0; k < n; ++k) traced[k]->color = group == 0 ? mirrored_by_film(*traced[k], colors[k]) : colors[k];
    n = 0;
  };
  for (Branch& branch : branches_) {
    if (branch.group != group) continue;
    branch.seen = true;
    child.state_.weight = branch.weight;
    if (tracer_.cut_off(child.state_)) continue;
    child.weights_[n] = branch.weight;
    child.keys_[n] = branch.key;
    if (state_.gather) child.notes_[n] = notes_[branch.ray];
    child.packet_.rays.origin.set(n, met_[branch.ray].at->hit.point);
    child.packet_.rays.direction.set(n, branch.direction);
    traced[n++] = &branch;
    if (n == kMax) trace_waiting();
  }
  trace_waiting();
}

// What a mirror under an iridescent film shows of a colour.
Color Wavefront::mirrored_by_film(const Branch& branch, const Color& color) const {
  const scene::Finish& finish = branch.layer.layer->finish;
  if (!(finish.irid > 0)) return color;
  const Vec3& normal = branch.layer.normal;
  const double cosines =
      std::fabs(dot(normal, branch.direction)) + std::fabs(dot(normal, packet_.rays.direction.at(branch.ray)));
  return Color(color.rgb() * tracer_.film_tint(finish, branch.thickness, cosines), 0, color.t);
}

// What a texture shows behind itself and in its mirrors.
void Wavefront::add_branches(const Leaf& leaf, Color& color) {
  Rgb sum = color.rgb();
  float see_through = 0;
  bool total = false;
  if (leaf.behind >= 0) {
    const Branch& branch = branches_[static_cast<std::size_t>(leaf.behind)];
    const Color seen = seen_behind(branch, total);
    if (total) {
      sum += seen.rgb();
    } else {
      sum += seen.rgb() * leaf.filter;
      see_through = seen.t * leaf.translucency;
    }
  }
  for (int k = leaf.first; k >= 0; k = parts_[static_cast<std::size_t>(k)].next) {
    const int i = parts_[static_cast<std::size_t>(k)].mirror;
    if (i < 0) continue;
    const Branch& branch = branches_[static_cast<std::size_t>(i)];
    if (branch.seen) {
      sum += tracer_.mirror_image(branch.layer, branch.color.rgb());
    } else if (!(total && Tracer::hidden_by_total_reflection(parts_[static_cast<std::size_t>(leaf.first)].normal,
                                                             branch.layer.normal))) {
      tracer_.random_.begin(branch.key);
      sum += tracer_.mirrored(ray_state(branch.ray), *met_[branch.ray].at, branch.layer);
    }
  }
  color = Color(sum, 0, see_through);
}

Color Wavefront::seen_behind(const Branch& branch, bool& total) {
  SurfaceHit& at = *met_[branch.ray].at;
  if (!branch.seen) {
    tracer_.random_.begin(branch.key);
    const RayState ray = ray_state(branch.ray);
    return tracer_.transmit(ray, at, branch.layer,
                            ray.weight * leaves_[static_cast<std::size_t>(branch.leaf)].filter.max_abs(), total);
  }
  total = branch.total;
  return tracer_.attenuated(branch.color, state_.interiors, at, total);
}

}  // namespace verisim::shading
