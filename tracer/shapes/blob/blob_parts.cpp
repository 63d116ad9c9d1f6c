#include "tracer/shapes/blob/blob_parts.h"

#include <algorithm>
#include <cmath>

#include "tracer/shapes/blob/sphere_order.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/shared_payload.h"

namespace verisim::shapes::blob {
namespace {

// A sphere that POV-Ray draws around a part, as a cube; generous for transformed ones.
Box3 cube_around(const Vec3& center, double radius, const Transform& t) {
  Box3 box;
  for (int corner = 0; corner < 8; ++corner)
    box.extendBy(t.point(center + radius * Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
  const Vec3 size = box.max - box.min;
  const Vec3 half(0.5 * std::max({size.x, size.y, size.z}));
  const Vec3 moved = t.point(center);
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

std::vector<BlobPart> parts_of(const scene::Blob& blob, std::vector<Box3>* pov_boxes) {
  std::vector<BlobPart> parts;
  std::size_t count = 0;
  for (const scene::BlobComponent& c : blob.components) count += c.cylinder ? 3 : 1;
  parts.reserve(count);
  const auto add = [&](const BlobPart& part, const Vec3& center, double radius) {
    if (pov_boxes) pov_boxes->push_back(cube_around(center, radius, *part.transform));
    parts.push_back(part);
  };
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
    const auto set_reach = [&](const Box3& box, const Vec3& center, double reach) {
      part.box = box;
      part.around = c.transform ? box.center() : center;
      part.reach = c.transform ? 0.5 * length(box.max - box.min) : reach;
    };
    if (!c.cylinder) {
      part.kind = BlobPartKind::sphere;
      part.center = c.a;
      set_reach(box_of_sphere(c.a, radius, moved), c.a, radius);
      add(part, c.a, radius);
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
    part.kind = BlobPartKind::cylinder;
    set_reach(both, 0.5 * (c.a + c.b), around);
    add(part, {0, 0, 0.5 * len}, around);
    part.kind = BlobPartKind::base;
    set_reach(base, c.a, radius);
    add(part, Vec3(0), radius);
    part.kind = BlobPartKind::apex;
    part.center = {0, 0, len};
    set_reach(apex, c.b, radius);
    add(part, part.center, radius);
  }
  return parts;
}

std::vector<PartSpheres> spheres_around(const std::vector<BlobPart>& parts) {
  std::vector<PartSpheres> spheres((parts.size() + 7) / 8);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const BlobPart& part = parts[i];
    PartSpheres& s = spheres[i / 8];
    s.x[i % 8] = part.around.x, s.y[i % 8] = part.around.y, s.z[i % 8] = part.around.z, s.radius[i % 8] = part.reach;
  }
  return spheres;
}

// The parts in the order in which POV-Ray's hierarchy holds them.
std::vector<BlobPart> parts_in_order(const scene::Blob& blob) {
  std::vector<Box3> boxes;
  const std::vector<BlobPart> parts = parts_of(blob, &boxes);
  std::vector<BoundingSphere> spheres;
  bool finite = true;
  for (const Box3& box : boxes) {
    spheres.push_back({box.center(), 0.5 * (box.max.x - box.min.x)});
    finite = finite && accel::is_finite(box);
  }
  if (parts.empty() || !finite) return parts;
  std::vector<BlobPart> ordered;
  ordered.reserve(parts.size());
  for (const std::uint32_t i : order_of(spheres)) ordered.push_back(parts[i]);
  return ordered;
}

Box3 box_of(const std::vector<BlobPart>& parts, bool all) {
  Box3 box;
  for (const BlobPart& part : parts)
    if (all || part.k2 > 0) box.extendBy(part.box);
  return box;
}

BlobParts::BlobParts(const scene::Blob& blob) : parts(parts_in_order(blob)) {
  constexpr std::size_t kFewParts = 2;
  std::vector<Box3> boxes;
  boxes.reserve(parts.size());
  bool finite = true;
  for (const BlobPart& part : parts) {
    boxes.push_back(part.box);
    finite = finite && accel::is_finite(part.box) && !accel::is_empty(part.box);
  }
  if (parts.size() <= kMaxForPacket && finite) spheres = spheres_around(parts);
  if (parts.size() > kFewParts && finite) tree = accel::Bvh(boxes);
}

std::shared_ptr<const BlobParts> BlobParts::of(const std::shared_ptr<const scene::Blob>& blob) {
  return shared_payload<BlobParts>(blob, [&] { return std::make_shared<BlobParts>(*blob); });
}

}  // namespace verisim::shapes::blob
