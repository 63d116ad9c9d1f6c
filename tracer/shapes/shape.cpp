#include "tracer/shapes/shape.h"

#include <limits>

#include "tracer/shapes/half_spaces.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_everywhere(const Box3& box) { return box.min.x == -kInfinity && box.max.x == kInfinity; }

// Grows by rounding errors of transformed corners and of hit points.
Box3 padded(Box3 box) {
  for (int i = 0; i < 3; ++i) {
    const double pad = 1e-9 * std::max(std::fabs(box.min[i]), std::fabs(box.max[i])) + 1e-9;
    box.min[i] -= pad, box.max[i] += pad;
  }
  return box;
}

Box3 transformed(const Box3& box, const std::optional<Transform>& transform) {
  if (is_everywhere(box)) return box;
  if (!transform) return padded(box);
  Box3 result;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = transform->point(
        {corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y, corner & 4 ? box.max.z : box.min.z});
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return everywhere();
    result.extendBy(p);
  }
  return padded(result);
}

}  // namespace

Box3 everywhere() { return Box3(Vec3(-kInfinity), Vec3(kInfinity)); }

HitList& thread_hits() {
  thread_local HitList hits;
  return hits;
}

namespace {

template <class Keep>
bool nearest_of_all(const Shape& shape, const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit,
                    Keep&& keep) {
  ScratchHits hits;
  shape.intersect_all(ray, kind, hits.list());
  bool found = false;
  for (std::size_t i = hits.begin(); i < hits.end(); ++i) {
    const double t = hits[i].t;
    if (!(t >= t_min) || !(found ? t <= t_max : t < t_max) || !keep(Vec3(hits[i].point))) continue;
    hit = hits[i];
    t_max = t;
    found = true;
  }
  return found;
}

}  // namespace

bool Shape::intersect(const Ray& ray, RayKind kind, double t_min, double t_max, Hit& hit) const {
  return nearest_of_all(*this, ray, kind, t_min, t_max, hit, [](const Vec3&) { return true; });
}

bool Shape::intersect_clipped(const Ray& ray, RayKind kind, double t_min, double t_max, const Clips& clips,
                              Hit& hit) const {
  return nearest_of_all(*this, ray, kind, t_min, t_max, hit, [&](const Vec3& p) { return clips.contain(p); });
}

bool Shape::occludes(const Ray& ray, double t_min, double t_max) const {
  Hit hit;
  return intersect(ray, RayKind::shadow, t_min, t_max, hit);
}

void Shape::intersect_packet_between(const RayPacket& rays, RayKind kind, const double* from, const double* to,
                                     LaneHits& hits) const {
  each_lane(rays.active, [&](int k) {
    intersect_between(rays.at(k), kind, from[k], to[k], hits.begin_lane(k));
    hits.end_lane(k);
  });
}

unsigned Shape::intersect_packet(const RayPacket& rays, const accel::EntryPoints* entry, RayKind kind, double t_min,
                                 const double* t_max, Hit* hits) const {
  unsigned found = 0;
  each_lane(rays.active, [&](int k) {
    const Ray ray = rays.at(k);
    if (entry ? intersect_from(*entry, ray, kind, t_min, t_max[k], hits[k])
              : intersect(ray, kind, t_min, t_max[k], hits[k]))
      found |= 1u << k;
  });
  return found;
}

unsigned Shape::occludes_packet(const RayPacket& rays, const accel::EntryPoints* entry, double t_min,
                                const double* t_max) const {
  unsigned found = 0;
  each_lane(rays.active, [&](int k) {
    const Ray ray = rays.at(k);
    if (entry ? occludes_from(*entry, ray, t_min, t_max[k]) : occludes(ray, t_min, t_max[k])) found |= 1u << k;
  });
  return found;
}

std::unique_ptr<const Guards> Guards::of(const scene::Object& object) {
  if (object.bounded_by.empty() && object.clipped_by.empty()) return nullptr;
  auto guards = std::make_unique<Guards>();
  for (const auto& clip : object.clipped_by) guards->clips.push_back(compile(*clip));
  for (const auto& bound : object.bounded_by) guards->bounds.push_back(compile(*bound));
  return guards;
}

constexpr double kSmallestDistance = 1e-4, kLargestDistance = 2e10;  // of a bounding object

bool Guards::admit(const Ray& ray) const {
  for (const auto& bound : bounds) {
    Hit hit;
    if (!bound->inside(ray.origin) && !bound->intersect(ray, RayKind::query, kSmallestDistance, kLargestDistance, hit))
      return false;
  }
  return true;
}

unsigned Guards::admit(const RayPacket& rays) const {
  double limits[RayPacket::kCount];
  std::fill_n(limits, RayPacket::kCount, kLargestDistance);
  unsigned admitted = rays.active;
  for (const auto& bound : bounds) {
    unsigned within = 0;
    each_lane(admitted, [&](int k) { within |= bound->inside(rays.rays.origin.at(rays.first + k)) ? 1u << k : 0; });
    Hit hits[RayPacket::kCount];
    if (const unsigned active = admitted & ~within; active != 0)
      within |= bound->intersect_packet({rays.rays, rays.first, active}, nullptr, RayKind::query, kSmallestDistance,
                                        limits, hits);
    admitted &= within;
  }
  return admitted;
}

void narrow(Box3& box, const Guards& guards) {
  std::vector<HalfSpace> half_spaces;
  for (const auto& clip : guards.clips) {
    if (const auto half_space = half_space_of(*clip->object)) half_spaces.push_back(*half_space);
    const SolidExtent extent = clip->solid_extent();
    if (extent.outside) continue;
    for (int i = 0; i < 3; ++i) {
      box.min[i] = std::max(box.min[i], extent.box.min[i]);
      box.max[i] = std::min(box.max[i], extent.box.max[i]);
    }
  }
  box = narrowed(box, half_spaces);
}

Box3 surface_bounds(const scene::Object& object, const Box3& local, const Guards* guards) {
  Box3 box = transformed(local, object.transform);
  if (guards) narrow(box, *guards);
  return box;
}

SolidExtent surface_solid(const scene::Object& object, const LocalBox& local, const Guards* guards) {
  SolidExtent extent{everywhere(), false};
  // A patch that was turned over has no inside either.
  const bool outside = object.inverted && !scene::is_patch(object);
  if (local.solid_inside) extent = {transformed(local.box, object.transform), outside};
  // Clips apply after inversion: outside any of them nothing is inside.
  if (guards && extent.outside) extent = {everywhere(), false};
  if (guards && !extent.outside) narrow(extent.box, *guards);
  return extent;
}

}  // namespace verisim::shapes
