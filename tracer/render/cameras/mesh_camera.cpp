#include "tracer/render/cameras/mesh_camera.h"

#include "tracer/shapes/mesh/mesh_geometry.h"

namespace verisim::render {
namespace {

constexpr double kEdgeTolerance = 1e-9;

// Summed up in binary32, in which meshes keep their corners.
Vec3 centroid(const scene::MeshData& mesh, const scene::MeshTriangle& t) {
  const Vec3 a = shapes::kept_vertex(mesh, t, 0), b = shapes::kept_vertex(mesh, t, 1),
             c = shapes::kept_vertex(mesh, t, 2);
  Vec3 middle;
  for (int k = 0; k < 3; ++k)
    middle[k] = (static_cast<float>(a[k]) + static_cast<float>(b[k]) + static_cast<float>(c[k])) / 3.0f;
  return middle;
}

// Barycentric weights of p in a 2-D triangle; false outside, where a weight is below -tolerance. Areas are measured
// from p, that of the triangle from its first corner: from another one the last bits differ (spec 02 1.7).
bool barycentric(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c, double tolerance, double weights[3]) {
  const auto twice_area = [](const Vec2& o, const Vec2& v, const Vec2& w) {
    return (v.x - o.x) * (w.y - o.y) - (w.x - o.x) * (v.y - o.y);
  };
  const double area = twice_area(a, b, c);
  if (area == 0) return false;
  weights[0] = twice_area(p, b, c) / area;
  weights[1] = twice_area(p, c, a) / area;
  weights[2] = twice_area(p, a, b) / area;
  return weights[0] >= -tolerance && weights[1] >= -tolerance && weights[2] >= -tolerance;
}

// Where a triangle lies in the UV map; empty: nowhere.
Box3 uv_box(const scene::MeshData& mesh, const scene::MeshTriangle& t) {
  Box3 box;
  for (int i = 0; i < 3 && t.has_uv; ++i) box.extendBy(Vec3(mesh.uvs[t.uv[i]].x, mesh.uvs[t.uv[i]].y, 0));
  return box;
}

}  // namespace

MeshCamera::MeshCamera(const scene::Camera& camera, int width, int height, int left, int top)
    : camera_(camera), width_(width), height_(height), left_(left), top_(top) {
  if (camera.distribution != 3 || camera.meshes.empty()) return;
  const scene::MeshData& mesh = *camera.meshes.front();
  uv_map_ = accel::Bvh(
      mesh.triangles.size(), [&](std::size_t i) { return uv_box(mesh, mesh.triangles[i]); }, 1);
}

std::optional<Ray> MeshCamera::ray(double x, double y, int k) const {
  const double px = std::clamp(x + left_ + 0.5, 0.0, static_cast<double>(width_ - 1)),
               py = std::clamp(y + top_ - 0.5, 0.0, static_cast<double>(height_ - 1));
  if (camera_.distribution == 3) return by_uv({(px - 0.5) / width_, 1 - (py + 0.5) / height_});
  const std::optional<Face> f = face(px, py, k);
  if (!f) return std::nullopt;
  const scene::MeshData& mesh = *camera_.meshes[f->mesh];
  const scene::MeshTriangle& t = mesh.triangles[f->triangle];
  return finished(f->mesh, centroid(mesh, t), shapes::kept_normal(mesh, t));
}

std::optional<MeshCamera::Face> MeshCamera::face(double x, double y, int k) const {
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  const std::size_t meshes = camera_.meshes.size();
  std::size_t mesh = 0, index = row * width_ + column;
  switch (camera_.distribution) {
    case 0:
      mesh = static_cast<std::size_t>(k);
      break;
    case 1:  // meshes one after the other; all rays but the first fall off the end
      if (k > 0) return std::nullopt;
      while (mesh < meshes && index >= camera_.meshes[mesh]->triangles.size())
        index -= camera_.meshes[mesh++]->triangles.size();
      break;
    default: {
      const double strip = static_cast<double>(width_) / static_cast<double>(meshes);
      mesh = static_cast<std::size_t>(x / strip);
      index = row * static_cast<std::size_t>(strip) + column;
    }
  }
  if (mesh >= meshes || index >= camera_.meshes[mesh]->triangles.size()) return std::nullopt;
  return Face{mesh, index};
}

std::optional<Ray> MeshCamera::by_uv(const Vec2& uv) const {
  // A pixel on the edge between two triangles may lie outside of both by a rounding.
  std::optional<UvPlace> place = uv_place(uv, 0);
  if (!place) place = uv_place(uv, kEdgeTolerance);
  if (!place) return std::nullopt;
  const scene::MeshData& mesh = *camera_.meshes.front();
  const scene::MeshTriangle& t = mesh.triangles[place->triangle];
  Vec3 origin(0, 0, 0);
  for (std::size_t i = 0; i < 3; ++i) origin += shapes::kept_vertex(mesh, t, place->corners[i]) * place->weights[i];
  if (!camera_.smooth) return finished(0, origin, shapes::kept_normal(mesh, t));
  return finished(0, origin, shapes::is_smooth(mesh, t) ? shapes::smooth_normal(mesh, t, origin) : Vec3(0));
}

std::optional<MeshCamera::UvPlace> MeshCamera::uv_place(const Vec2& uv, double tolerance) const {
  std::optional<UvPlace> first;
  uv_map_.any_around(Vec3(uv.x, uv.y, 0), [&](std::uint32_t i) {
    if (first && first->triangle < i) return false;
    const scene::MeshData& mesh = *camera_.meshes.front();
    const scene::MeshTriangle& t = mesh.triangles[i];
    UvPlace place{i, shapes::kept_corners(mesh, t), {}};
    const auto corner = [&](std::size_t n) { return mesh.uvs[t.uv[static_cast<std::size_t>(place.corners[n])]]; };
    if (barycentric(uv, corner(0), corner(1), corner(2), tolerance, place.weights)) first = place;
    return false;
  });
  return first;
}

std::optional<Ray> MeshCamera::first_ray() const {
  constexpr int kBlock = 32;  // POV-Ray's
  for (int top = 0; top < height_; top += kBlock)
    for (int left = 0; left < width_; left += kBlock)
      for (int y = top; y < std::min(top + kBlock, height_); ++y)
        for (int x = left; x < std::min(left + kBlock, width_); ++x)
          if (const std::optional<Ray> found = ray(x, y, 0)) return found;
  return std::nullopt;
}

Ray MeshCamera::finished(std::size_t mesh, const Vec3& origin, const Vec3& normal) const {
  // What has no normals of its own to interpolate looks along y (spec 02 1.7).
  const Vec3 along = normal == Vec3(0) ? Vec3(0, 1, 0) : normal;
  Ray ray{origin + normal * camera_.location.z, camera_.direction.z < -kEpsilon ? -along : along};
  if (mesh < camera_.mesh_transforms.size()) {
    const Transform& t = camera_.mesh_transforms[mesh];
    ray = {t.point(ray.origin), t.normal(ray.direction)};
  }
  ray.direction = normalize(ray.direction);
  return ray;
}

}  // namespace verisim::render
