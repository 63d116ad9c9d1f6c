// The geometry of mesh and mesh2, shared by all copies: a tree over POV-Ray's per-triangle data (spec 04 section 1).
#pragma once

#include <memory>
#include <mutex>

#include "tracer/bvh/bvh.h"
#include "tracer/bvh/hierarchy.h"
#include "tracer/scene/object.h"
#include "tracer/shapes/mesh/flat_triangle.h"

namespace verisim::shapes {

class MeshGeometry {
 public:
  // In binary32, as POV-Ray stores it.
  struct Triangle : FlatTriangle<float> {
    std::uint32_t id_and_axis;  // index into MeshData::triangles, dominant axis in the upper two bits
    std::uint32_t id() const { return id_and_axis & 0x3fffffffu; }
    PlaneAxes axes() const { return axes_beside(static_cast<int>(id_and_axis >> 30)); }
  };

  // The geometry of `data`, built once for all its users.
  static std::shared_ptr<const MeshGeometry> of(const std::shared_ptr<const scene::MeshData>& data);

  explicit MeshGeometry(std::shared_ptr<const scene::MeshData> data);

  // Distance along the (unit) local ray, or -1 when triangle `i` of the tree's order is missed.
  double hit(std::uint32_t i, const Vec3& origin, const Vec3& direction) const {
    const Triangle& tri = triangles_[i];
    const RayOfTriangle ray{origin, direction};
    double t;
    return TriangleHit::meets(tri, tri.axes(), ray, kNearest, kFarthest, t) ? t : -1;
  }
  // Whether two hits are so near to each other that the order of boxes tells which of them is seen.
  static bool in_one_place(double t, double other) { return std::fabs(t - other) <= 1e-12 * t; }

  // Whether triangle `j` continues `i` beyond an edge so smoothly that it does not matter which of them is seen there.
  bool goes_on(std::uint32_t i, std::uint32_t j) const;

  static constexpr double kNearest = kTriangleNearest, kFarthest = kTriangleFarthest;  // in local units

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
  // The box of a triangle, as POV-Ray's hierarchy has it.
  scene::Bounds bounds(std::uint32_t i) const;
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

// A triangle as it is kept in binary32: its corners, its normal, and whether it has normals of its own.
Vec3 kept_vertex(const scene::MeshData& data, const scene::MeshTriangle& t, int corner);
Vec3 kept_normal(const scene::MeshData& data, const scene::MeshTriangle& t);
bool is_smooth(const scene::MeshData& data, const scene::MeshTriangle& t);
// Its corner numbers in POV-Ray's canonical order: 0 and 1 may be exchanged.
std::array<int, 3> kept_corners(const scene::MeshData& data, const scene::MeshTriangle& t);
// Interpolated normal of a smooth triangle, not normalised.
Vec3 smooth_normal(const scene::MeshData& data, const scene::MeshTriangle& t, const Vec3& p);

// The box of all vertices used by faces, rounded to binary32.
Box3 mesh_vertex_box(const scene::MeshData& data);

}  // namespace verisim::shapes
