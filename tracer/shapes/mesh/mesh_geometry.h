// The geometry of mesh and mesh2, shared by all copies: a tree over POV-Ray's per-triangle data (spec 04 section 1).
#pragma once

#include <memory>
#include <mutex>

#include "tracer/bvh/bvh.h"
#include "tracer/bvh/hierarchy.h"
#include "tracer/scene/object.h"

namespace verisim::shapes {

class MeshGeometry {
 public:
  // What the hit test needs of one triangle, in binary32 as POV-Ray stores it. Corners are given in the two axes beside
  // the dominant one.
  struct Triangle {
    float normal[3], constant;
    float corner[3][2];
    std::uint32_t id_and_axis;  // index into MeshData::triangles, dominant axis in the upper two bits
    std::uint32_t id() const { return id_and_axis & 0x3fffffffu; }
    int axis() const { return static_cast<int>(id_and_axis >> 30); }
  };

  // The geometry of `data`, built once for all its users.
  static std::shared_ptr<const MeshGeometry> of(const std::shared_ptr<const scene::MeshData>& data);

  explicit MeshGeometry(std::shared_ptr<const scene::MeshData> data);

  // Distance along the (unit) local ray, or -1 when triangle `i` of the tree's order is missed. Limits are not applied.
  double hit(std::uint32_t i, const Vec3& origin, const Vec3& direction) const {
    const Triangle& tri = triangles_[i];
    const double nd = tri.normal[0] * direction.x + tri.normal[1] * direction.y + tri.normal[2] * direction.z;
    if (std::fabs(nd) < 1e-10) return -1;
    const double t =
        -(tri.constant + (tri.normal[0] * origin.x + tri.normal[1] * origin.y + tri.normal[2] * origin.z)) / nd;
    if (!(t >= kNearest)) return -1;
    const int k = tri.axis(), first = k == 0 ? 1 : 0, second = k == 2 ? 1 : 2;
    const double s = origin[first] + t * direction[first], q = origin[second] + t * direction[second];
    const double ax = tri.corner[0][0], ay = tri.corner[0][1], bx = tri.corner[1][0], by = tri.corner[1][1],
                 cx = tri.corner[2][0], cy = tri.corner[2][1];
    if ((bx - s) * (by - ay) < (by - q) * (bx - ax)) return -1;
    if ((cx - s) * (cy - by) < (cy - q) * (cx - bx)) return -1;
    if ((ax - s) * (ay - cy) < (ay - q) * (ax - cx)) return -1;
    return t;
  }
  static constexpr double kNearest = 1e-6, kFarthest = 1e7;  // in local units

  const Triangle& triangle(std::uint32_t i) const { return triangles_[i]; }
  const scene::MeshTriangle& source(std::uint32_t i) const { return data_->triangles[triangles_[i].id()]; }
  const accel::Bvh& tree() const { return tree_; }
  // POV-Ray's own hierarchy; its entries are numbers of the tree's order. Built when it is first asked for.
  const accel::Hierarchy& hierarchy() const;
  const scene::MeshData& data() const { return *data_; }

  // The triangle's corner numbers in POV-Ray's canonical order: 0 and 1 may be exchanged.
  std::array<int, 3> corners(std::uint32_t i) const;
  Vec3 vertex(std::uint32_t i, int corner) const;  // rounded to binary32
  bool smooth(std::uint32_t i) const;
  Vec3 flat_normal(std::uint32_t i) const {
    return {triangles_[i].normal[0], triangles_[i].normal[1], triangles_[i].normal[2]};
  }
  // Interpolated normal at a point of mesh space, not normalised.
  Vec3 smooth_normal(std::uint32_t i, const Vec3& p) const;
  Vec2 uv(std::uint32_t i, const Vec3& p) const;
  // Shares of the three textures at p (spec 04 1.5), in the order of MeshTriangle::texture.
  std::array<float, 3> weights(std::uint32_t i, const Vec3& p) const;
  // Number of triangles hit by the local ray.
  int intersections(const Vec3& origin, const Vec3& direction) const;

 private:
  Triangle prepared(std::uint32_t id) const;

  std::shared_ptr<const scene::MeshData> data_;
  std::unique_ptr<Triangle[]> triangles_;  // in the order of the tree's leaves
  accel::Bvh tree_;
  mutable std::once_flag hierarchy_built_;
  mutable accel::Hierarchy hierarchy_;
};

// The box of all vertices used by faces, rounded to binary32.
Box3 mesh_vertex_box(const scene::MeshData& data);

}  // namespace verisim::shapes
