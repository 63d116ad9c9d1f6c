#include "tracer/render/cameras/mesh_camera.h"

namespace verisim::render {
namespace {

constexpr double kEdgeTolerance = 1e-9;

const Vec3& vertex(const scene::MeshData& mesh, const scene::MeshTriangle& t, int i) {
  return mesh.vertices[t.vertex[i]];
}

// The mesh's own front side (spec 04 1.4): (0,0,0), (1,0,0), (0,1,0) faces -z.
Vec3 face_normal(const scene::MeshData& mesh, const scene::MeshTriangle& t) {
  const Vec3& b = vertex(mesh, t, 1);
  return normalize(cross(vertex(mesh, t, 0) - b, vertex(mesh, t, 2) - b));
}

// Barycentric weights of p in a 2-D triangle; false outside, where a weight is below -tolerance.
bool barycentric(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c, double tolerance, double weights[3]) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area == 0) return false;
  weights[1] = ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / area;
  weights[2] = ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / area;
  weights[0] = 1 - weights[1] - weights[2];
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
  return finished(f->mesh, (vertex(mesh, t, 0) + vertex(mesh, t, 1) + vertex(mesh, t, 2)) / 3.0, face_normal(mesh, t));
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
  Vec3 origin(0, 0, 0), normal(0, 0, 0);
  for (int i = 0; i < 3; ++i) {
    origin += vertex(mesh, t, i) * place->weights[i];
    if (t.smooth) normal += mesh.normals[t.normal[i]] * place->weights[i];
  }
  return finished(0, origin, camera_.smooth && t.smooth ? normalize(normal) : face_normal(mesh, t));
}

std::optional<MeshCamera::UvPlace> MeshCamera::uv_place(const Vec2& uv, double tolerance) const {
  std::optional<UvPlace> first;
  uv_map_.any_around(Vec3(uv.x, uv.y, 0), [&](std::uint32_t i) {
    if (first && first->triangle < i) return false;
    const scene::MeshData& mesh = *camera_.meshes.front();
    const scene::MeshTriangle& t = mesh.triangles[i];
    UvPlace place{i, {}};
    if (barycentric(uv, mesh.uvs[t.uv[0]], mesh.uvs[t.uv[1]], mesh.uvs[t.uv[2]], tolerance, place.weights))
      first = place;
    return false;
  });
  return first;
}

Ray MeshCamera::finished(std::size_t mesh, const Vec3& origin, const Vec3& normal) const {
  Ray ray{origin + normal * camera_.location.z, camera_.direction.z < -kEpsilon ? -normal : normal};
  if (mesh < camera_.mesh_transforms.size()) {
    const Transform& t = camera_.mesh_transforms[mesh];
    ray = {t.point(ray.origin), t.normal(ray.direction)};
  }
  ray.direction = normalize(ray.direction);
  return ray;
}

}  // namespace verisim::render
