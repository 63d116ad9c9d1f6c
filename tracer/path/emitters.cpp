#include "tracer/path/emitters.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "tracer/math/constants.h"

namespace verisim::path {
namespace {

void count_objects(const scene::Object& object, std::unordered_map<const scene::Object*, int>& times) {
  ++times[&object];
  for (const auto& child : scene::children_of(object)) count_objects(*child, times);
}

// The strongest emission of any layer; it only steers which emitters are chosen how often.
double strength_of(const scene::Texture& texture) {
  double most = 0;
  for (const scene::TextureLayer& layer : texture.layers)
    most = std::max(most, static_cast<double>(layer.finish->emission.max()));
  if (texture.texture_map) {
    for (const auto& entry : *texture.texture_map)
      if (entry.value) most = std::max(most, strength_of(*entry.value));
  }
  return most;
}

Vec3 at(const std::optional<Transform>& t, const Vec3& p) { return t ? t->point(p) : p; }

}  // namespace

Emitters::Emitters(const scene::Scene& scene) {
  std::unordered_map<const scene::Object*, int> times;
  for (const auto& object : scene.objects) count_objects(*object, times);
  for (const auto& [object, n] : times) {
    if (n > 1) per_area_[object] = -1;  // one description in several places: which of them was hit cannot be told
  }
  for (const auto& object : scene.objects) add(*object);
  double total = 0;
  for (const Part& p : parts_) cumulative_.push_back(total += p.power);
  for (double& c : cumulative_) c /= total;
  std::unordered_map<const scene::Object*, double> densities;
  for (const Part& p : parts_) densities[p.object] = p.power / p.area / total;
  per_area_ = std::move(densities);
}

void Emitters::add(const scene::Object& object) {
  if (const auto* csg = object.as<scene::Csg>()) {
    if (csg->kind != scene::CsgKind::union_ || !object.clipped_by.empty()) return;
    for (const auto& child : scene::children_of(object)) add(*child);
    return;
  }
  if (object.as<scene::LightGroup>()) {
    for (const auto& child : scene::children_of(object)) add(*child);
    return;
  }
  if (!object.texture || !object.clipped_by.empty() || !object.bounded_by.empty() || per_area_.contains(&object))
    return;
  const double strength = strength_of(*object.texture);
  if (!(strength > 0)) return;
  if (const auto* sphere = object.as<scene::Sphere>()) {
    if (object.transform) return;
    add_part(object, {.kind = Part::Kind::sphere, .a = sphere->center, .b = {}, .c = {}, .radius = sphere->radius},
             strength);
  } else if (const auto* box = object.as<scene::Box>()) {
    const Vec3 size = box->high - box->low;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 u(0, 0, 0), v(0, 0, 0), out(0, 0, 0);
      u[(axis + 1) % 3] = size[(axis + 1) % 3], v[(axis + 2) % 3] = size[(axis + 2) % 3], out[axis] = size[axis];
      for (const Vec3& corner : {box->low, box->low + out}) {
        const Vec3 a = at(object.transform, corner);
        add_part(object,
                 {.kind = Part::Kind::parallelogram,
                  .a = a,
                  .b = at(object.transform, corner + u) - a,
                  .c = at(object.transform, corner + v) - a},
                 strength);
      }
    }
  } else if (const auto* triangle = object.as<scene::Triangle>()) {
    const Vec3 a = at(object.transform, triangle->p[0]);
    add_part(object,
             {.kind = Part::Kind::triangle,
              .a = a,
              .b = at(object.transform, triangle->p[1]) - a,
              .c = at(object.transform, triangle->p[2]) - a},
             strength);
  } else if (const auto* disc = object.as<scene::Disc>()) {
    if (object.transform) return;
    const Vec3 n = normalize(disc->normal), side = std::fabs(n.x) > 0.5 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 u = normalize(cross(n, side)), v = cross(n, u);
    add_part(object,
             {.kind = Part::Kind::disc, .a = disc->center, .b = u, .c = v, .radius = disc->radius, .hole = disc->hole},
             strength);
  }
}

void Emitters::add_part(const scene::Object& object, Part part, double strength) {
  using enum Part::Kind;
  switch (part.kind) {
    case sphere:
      part.area = 4 * kPi * part.radius * part.radius;
      break;
    case disc:
      part.area = kPi * (part.radius * part.radius - part.hole * part.hole);
      break;
    case triangle:
      part.area = 0.5 * length(cross(part.b, part.c));
      break;
    case parallelogram:
      part.area = length(cross(part.b, part.c));
      break;
  }
  if (!(part.area > 0) || !std::isfinite(part.area)) return;
  part.object = &object;
  part.power = part.area * strength;
  parts_.push_back(part);
}

Emitters::Point Emitters::sample(double which, const Vec2& uv) const {
  const auto i =
      static_cast<std::size_t>(std::upper_bound(cumulative_.begin(), cumulative_.end(), which) - cumulative_.begin());
  const Part& p = parts_[std::min(i, parts_.size() - 1)];
  Vec3 point;
  switch (p.kind) {
    case Part::Kind::sphere: {
      const double z = 1 - 2 * uv.x, r = std::sqrt(std::max(0.0, 1 - z * z)), phi = 2 * kPi * uv.y;
      point = p.a + p.radius * Vec3(r * std::cos(phi), r * std::sin(phi), z);
      break;
    }
    case Part::Kind::disc: {
      const double r = std::sqrt(p.hole * p.hole + uv.x * (p.radius * p.radius - p.hole * p.hole)),
                   phi = 2 * kPi * uv.y;
      point = p.a + r * (std::cos(phi) * p.b + std::sin(phi) * p.c);
      break;
    }
    case Part::Kind::triangle: {
      const double s = std::sqrt(uv.x);
      point = p.a + s * (1 - uv.y) * p.b + s * uv.y * p.c;
      break;
    }
    case Part::Kind::parallelogram:
      point = p.a + uv.x * p.b + uv.y * p.c;
      break;
  }
  return {point, p.object};
}

double Emitters::density(const scene::Object* object) const {
  const auto found = per_area_.find(object);
  return found == per_area_.end() ? 0.0 : found->second;
}

}  // namespace verisim::path
