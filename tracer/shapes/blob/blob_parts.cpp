#include "tracer/shapes/blob/blob_parts.h"

#include <algorithm>
#include <cmath>

#include "tracer/scene/bounds.h"
#include "tracer/shapes/blob/sphere_order.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/shared_payload.h"

namespace verisim::shapes::blob {
namespace {

// A sphere that POV-Ray draws around a part, as a cube. That of a moved one is as wide as the longest side of its moved
// box, in binary32.
Box3 cube_around(const Vec3& center, double radius, const Transform* t) {
  if (!t) return {center - Vec3(radius), center + Vec3(radius)};
  scene::Bounds box;
  for (int i = 0; i < 3; ++i)
    box.low[i] = static_cast<float>(center[i] - radius), box.size[i] = static_cast<float>(2 * radius);
  box = scene::transformed(box, *t);
  const Vec3 half(0.5 * std::max({box.size[0], box.size[1], box.size[2]}));
  const Vec3 moved = t->point(center);
  return {moved - half, moved + half};
}

// The box of a moved sphere.
Box3 box_of_sphere(const Vec3& center, double radius, const Transform& t) {
  const Vec3 moved = t.point(center);
  Vec3 half;
  for (int i = 0; i < 3; ++i)
    half[i] = radius * (1 + 1e-9) * std::sqrt(t.m[0][i] * t.m[0][i] + t.m[1][i] * t.m[1][i] + t.m[2][i] * t.m[2][i]);
  return {moved - half, moved + half};
}

}  // namespace

PartList parts_of(const scene::Blob& blob) {
  PartList list;
  std::size_t count = 0;
  for (const scene::BlobComponent& c : blob.components) count += c.cylinder ? 3 : 1;
  list.parts.reserve(count), list.reaches.reserve(count);
  for (std::size_t i = 0; i < blob.components.size(); ++i) {
    const scene::BlobComponent& c = blob.components[i];
    BlobPart part;
    part.component = static_cast<std::int32_t>(i);
    part.radius2 = c.radius * c.radius;
    part.k0 = c.strength / (part.radius2 * part.radius2);
    part.k1 = -2 * c.strength / part.radius2;
    part.k2 = c.strength;
    part.moved = c.transform.has_value();
    part.transform = c.transform;
    const Transform moved = *part.transform;
    const double radius = std::fabs(c.radius);
    // POV-Ray's sphere is in the part's own space.
    const auto add = [&](const Box3& box, const Vec3& center, double reach, const Vec3& pov_center) {
      list.parts.push_back(part);
      list.reaches.push_back({c.transform ? box.center() : center,
                              c.transform ? 0.5 * length(box.max - box.min) : reach, box,
                              cube_around(pov_center, reach, part.moved ? &*part.transform : nullptr)});
    };
    if (!c.cylinder) {
      part.kind = BlobPartKind::sphere;
      part.center = c.a;
      add(box_of_sphere(c.a, radius, moved), c.a, radius, c.a);
      continue;
    }
    const double len = length(c.b - c.a), around = std::sqrt(part.radius2 + 0.25 * len * len);
    part.center = Vec3(0);
    part.length = len;
    part.moved = true;
    part.transform = frame_along(c.a, (c.b - c.a) * (1 / len), 1, 1).then(moved);
    const Box3 base = box_of_sphere(c.a, radius, moved), apex = box_of_sphere(c.b, radius, moved);
    Box3 both = base;
    both.extendBy(apex);
    part.kind = BlobPartKind::base;
    add(base, c.a, radius, Vec3(0));
    part.kind = BlobPartKind::apex;
    part.center = {0, 0, len};
    add(apex, c.b, radius, part.center);
    part.kind = BlobPartKind::cylinder;
    part.center = Vec3(0);
    add(both, 0.5 * (c.a + c.b), around, {0, 0, 0.5 * len});
  }
  return list;
}

namespace {

std::vector<PartSpheres> spheres_around(const std::vector<PartReach>& reaches) {
  std::vector<PartSpheres> spheres((reaches.size() + 7) / 8);
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const Vec3& center = reaches[i].center;
    PartSpheres& s = spheres[i / 8];
    s.x[i % 8] = center.x, s.y[i % 8] = center.y, s.z[i % 8] = center.z, s.radius[i % 8] = reaches[i].radius;
  }
  return spheres;
}

// Puts the parts into the order in which POV-Ray's hierarchy holds them.
void put_in_order(PartList& list) {
  std::vector<BoundingSphere> spheres;
  spheres.reserve(list.reaches.size());
  bool finite = true;
  for (const PartReach& reach : list.reaches) {
    spheres.push_back({reach.pov_box.center(), 0.5 * (reach.pov_box.max.x - reach.pov_box.min.x)});
    finite = finite && accel::is_finite(reach.pov_box);
  }
  if (spheres.empty() || !finite) return;
  PartList ordered;
  ordered.parts.reserve(spheres.size()), ordered.reaches.reserve(spheres.size());
  for (const std::uint32_t i : order_of(spheres)) {
    ordered.parts.push_back(std::move(list.parts[i]));
    ordered.reaches.push_back(list.reaches[i]);
  }
  list = std::move(ordered);
}

}  // namespace

BlobParts::BlobParts(const scene::Blob& blob) {
  PartList list = parts_of(blob);
  if (blob.hierarchy) put_in_order(list);
  parts = std::move(list.parts);
  bool finite = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Box3& reach = list.reaches[i].box;
    finite = finite && accel::is_finite(reach) && !accel::is_empty(reach);
    box.extendBy(reach);
    if (parts[i].k2 > 0) positive_box.extendBy(reach);
    capsules = capsules || parts[i].kind == BlobPartKind::cylinder;
    const bool half = parts[i].kind == BlobPartKind::base || parts[i].kind == BlobPartKind::apex;
    if (half && i < 64) halves |= std::uint64_t{1} << i;
  }
  constexpr std::size_t kFewParts = 2;
  if (parts.size() <= kMaxInSpheres && finite) spheres = spheres_around(list.reaches);
  if (parts.size() > kFewParts && finite)
    tree = accel::Bvh(
        list.reaches.size(), [&](std::size_t i) { return list.reaches[i].box; }, 1);
}

std::shared_ptr<const BlobParts> BlobParts::of(const std::shared_ptr<const scene::Blob>& blob) {
  return shared_payload<BlobParts>(blob, [&] { return std::make_shared<BlobParts>(*blob); });
}

}  // namespace verisim::shapes::blob
