#include "tracer/shapes/mesh/mesh_geometry.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <unordered_map>

#include "tracer/base/parallel.h"
#include "tracer/scene/bounds.h"

namespace verisim::shapes {

namespace {

constexpr unsigned kLeafSize = 4;
constexpr std::size_t kTask = 16384;  // triangles

double f32(double v) { return static_cast<float>(v); }
Vec3 f32(const Vec3& v) { return {f32(v.x), f32(v.y), f32(v.z)}; }

bool valid(const scene::MeshData& data, const scene::MeshTriangle& t) {
  for (const std::uint32_t v : t.vertex) {
    if (v >= data.vertices.size()) return false;
  }
  return true;
}

// The vector in the plane of a triangle whose product with a point is 0 at P1 and 1 on the edge P2 P3. POV-Ray keeps it
// in binary32, and normalises it so (spec 04 1.4).
Vec3 rise_of(const Vec3& p1, const Vec3& p2, const Vec3& p3) {
  const Vec3 edge = normalize(p2 - p3), to_first = p1 - p3, across = dot(to_first, edge) * edge - to_first;
  float rise[3];
  for (int k = 0; k < 3; ++k) rise[k] = static_cast<float>(across[k]);
  const float inverse = 1 / std::sqrt(rise[0] * rise[0] + rise[1] * rise[1] + rise[2] * rise[2]);
  for (float& r : rise) r *= inverse;
  const double height = to_first.x * rise[0] + to_first.y * rise[1] + to_first.z * rise[2];
  const auto scale = static_cast<float>(-1 / f32(height));
  return {rise[0] * scale, rise[1] * scale, rise[2] * scale};
}

Vec3 plane_normal(const Vec3& p1, const Vec3& p2, const Vec3& p3) { return normalize(cross(p3 - p1, p2 - p1)); }

std::array<int, 3> corners_of(const scene::MeshData& data, const scene::MeshTriangle& t, PlaneAxes axes) {
  const bool swap = turns_clockwise(kept_vertex(data, t, 0), kept_vertex(data, t, 1), kept_vertex(data, t, 2), axes);
  return swap ? std::array<int, 3>{1, 0, 2} : std::array<int, 3>{0, 1, 2};
}

Vec3 interpolated_normal(const scene::MeshData& data, const scene::MeshTriangle& t, const std::array<int, 3>& c,
                         const Vec3& p) {
  // Of length 1 since they were read: divided by it once more, one in a hundred had other last bits.
  const auto vertex_normal = [&](int k) {
    return f32(data.normals[t.normal[static_cast<std::size_t>(c[static_cast<std::size_t>(k)])]]);
  };
  const auto as_written = [&](int k) {
    return data.vertices[t.vertex[static_cast<std::size_t>(c[static_cast<std::size_t>(k)])]];
  };
  const Vec3 w1 = as_written(0), w2 = as_written(1), w3 = as_written(2);
  const Vec3 rise = rise_of(w1, w2, w3);
  const Vec3 n1 = vertex_normal(0), n2 = vertex_normal(1), n3 = vertex_normal(2);
  const Vec3 p1 = f32(w1), p2 = f32(w2), p3 = f32(w3);
  const Vec3 from = p - p1;
  const double u = dot(rise, from);
  if (u < 1e-10) return n1;
  const int m = dominant_axis(p3 - p2);
  const double v = (from[m] / u + p1[m] - p2[m]) / (p3[m] - p2[m]);
  return n1 + u * ((n2 - n1) + v * (n3 - n2));
}

}  // namespace

Vec3 kept_vertex(const scene::MeshData& data, const scene::MeshTriangle& t, int corner) {
  return f32(data.vertices[t.vertex[static_cast<std::size_t>(corner)]]);
}

// A triangle whose three normals are (almost) equal is flat and uses its geometric normal (spec 04 1.3).
bool is_smooth(const scene::MeshData& data, const scene::MeshTriangle& t) {
  if (!t.smooth) return false;
  for (const std::uint32_t n : t.normal) {
    if (n >= data.normals.size()) return false;
  }
  const Vec3 n1 = data.normals[t.normal[0]], d2 = n1 - data.normals[t.normal[1]], d3 = n1 - data.normals[t.normal[2]];
  return dot(d2, d2) > 1e-10 || dot(d3, d3) > 1e-10;
}

Vec3 kept_normal(const scene::MeshData& data, const scene::MeshTriangle& t) {
  return f32(plane_normal(data.vertices[t.vertex[0]], data.vertices[t.vertex[1]], data.vertices[t.vertex[2]]));
}

std::array<int, 3> kept_corners(const scene::MeshData& data, const scene::MeshTriangle& t) {
  const Vec3 n = plane_normal(data.vertices[t.vertex[0]], data.vertices[t.vertex[1]], data.vertices[t.vertex[2]]);
  return corners_of(data, t, axes_beside(dominant_axis(n)));
}

Vec3 smooth_normal(const scene::MeshData& data, const scene::MeshTriangle& t, const Vec3& p) {
  return interpolated_normal(data, t, kept_corners(data, t), p);
}

std::shared_ptr<const MeshGeometry> MeshGeometry::of(const std::shared_ptr<const scene::MeshData>& data) {
  struct Known {
    std::mutex mutex;  // held while it is made
    std::weak_ptr<const MeshGeometry> geometry;
  };
  static std::mutex mutex;
  static std::unordered_map<const scene::MeshData*, std::shared_ptr<Known>> meshes;
  std::shared_ptr<Known> known;
  {
    const std::lock_guard lock(mutex);
    if (meshes.size() > 64)  // who is about to make one holds it, too
      std::erase_if(
          meshes, [](const auto& entry) { return entry.second.use_count() == 1 && entry.second->geometry.expired(); });
    std::shared_ptr<Known>& entry = meshes[data.get()];
    if (!entry) entry = std::make_shared<Known>();
    known = entry;
  }
  const std::lock_guard lock(known->mutex);
  if (auto geometry = known->geometry.lock())
    return geometry;  // it keeps its data alive, so the address is still that of the same mesh
  std::shared_ptr<const MeshGeometry> geometry;
  // While it waits for its loops this thread takes up no other work: that might ask for the same mesh.
  tbb::this_task_arena::isolate([&] { geometry = std::make_shared<const MeshGeometry>(data); });
  known->geometry = geometry;
  return geometry;
}

MeshGeometry::MeshGeometry(std::shared_ptr<const scene::MeshData> data) : data_(std::move(data)) {
  const auto& d = *data_;
  const auto box_of = [&](std::size_t i) {
    Box3 box;
    const scene::MeshTriangle& t = d.triangles[i];
    if (!valid(d, t)) return box;
    const Vec3 &p1 = d.vertices[t.vertex[0]], n = cross(d.vertices[t.vertex[2]] - p1, d.vertices[t.vertex[1]] - p1);
    const double square = dot(n, n);
    if (!(square > 0 && square < std::numeric_limits<double>::infinity())) return box;  // without a normal: never hit
    for (const std::uint32_t v : t.vertex) box.extendBy(f32(d.vertices[v]));
    return box;
  };
  tree_ = accel::Bvh(d.triangles.size(), box_of, kLeafSize);
  const std::vector<std::uint32_t>& order = tree_.order();
  triangles_ = std::make_unique_for_overwrite<Triangle[]>(order.size());
  parallel_for(order.size(), kTask, [&](std::size_t i) { triangles_[i] = prepared(order[i]); });
}

MeshGeometry::Triangle MeshGeometry::prepared(std::uint32_t id) const {
  const scene::MeshTriangle& t = data_->triangles[id];
  const Vec3 &v1 = data_->vertices[t.vertex[0]], &v2 = data_->vertices[t.vertex[1]], &v3 = data_->vertices[t.vertex[2]];
  const Vec3 n = plane_normal(v1, v2, v3);
  const int axis = dominant_axis(n);
  const PlaneAxes axes = axes_beside(axis);
  Triangle triangle;
  for (int k = 0; k < 3; ++k) triangle.normal[k] = static_cast<float>(n[k]);
  triangle.distance = static_cast<float>(dot(n, v1));
  triangle.id_and_axis = id | static_cast<std::uint32_t>(axis) << 30;
  Vec3 p1 = f32(v1), p2 = f32(v2);
  const Vec3 p3 = f32(v3);
  if (turns_clockwise(p1, p2, p3, axes)) std::swap(p1, p2);
  const Vec3* const corner[3] = {&p1, &p2, &p3};
  for (int k = 0; k < 3; ++k) {
    triangle.corner[k][0] = static_cast<float>((*corner[k])[axes.u]);
    triangle.corner[k][1] = static_cast<float>((*corner[k])[axes.v]);
  }
  return triangle;
}

scene::Bounds MeshGeometry::bounds(std::uint32_t i) const {
  Box3 box;
  for (const std::uint32_t v : source(i).vertex) box.extendBy(f32(data_->vertices[v]));
  return scene::make_bounds(box.min, box.max);
}

const accel::Hierarchy& MeshGeometry::hierarchy() const {
  std::call_once(hierarchy_built_, [this] {
    const std::vector<std::uint32_t>& order = tree_.order();
    std::vector<std::uint32_t> places(order.size());  // in the order of the file
    std::iota(places.begin(), places.end(), 0u);
    std::sort(places.begin(), places.end(), [&](std::uint32_t a, std::uint32_t b) { return order[a] < order[b]; });
    std::vector<accel::Hierarchy::Item> items;
    items.reserve(places.size());
    for (const std::uint32_t place : places) items.push_back({place, bounds(place), false});
    hierarchy_ = accel::Hierarchy(std::move(items));
  });
  return hierarchy_;
}

std::array<int, 3> MeshGeometry::corners(std::uint32_t i) const {
  return corners_of(*data_, source(i), triangles_[i].axes());
}

Vec3 MeshGeometry::vertex(std::uint32_t i, int corner) const { return kept_vertex(*data_, source(i), corner); }

bool MeshGeometry::smooth(std::uint32_t i) const { return is_smooth(*data_, source(i)); }

bool MeshGeometry::goes_on(std::uint32_t i, std::uint32_t j) const {
  const scene::MeshTriangle &a = source(i), &b = source(j);
  if (!is_smooth(*data_, a) || !is_smooth(*data_, b) || a.texture[0] >= 0 || b.texture[0] >= 0) return false;
  int common = 0;
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t n = 0; n < 3; ++n)
      common += data_->vertices[a.vertex[m]] == data_->vertices[b.vertex[n]] &&
                data_->normals[a.normal[m]] == data_->normals[b.normal[n]];
  return common >= 2;
}

Vec3 MeshGeometry::smooth_normal(std::uint32_t i, const Vec3& p) const {
  return interpolated_normal(*data_, source(i), corners(i), p);
}

Vec2 MeshGeometry::uv(std::uint32_t i, const Vec3& p) const {
  const scene::MeshTriangle& t = source(i);
  if (!t.has_uv) return {0, 0};
  // Barycentric weights in the projection.
  const auto [a, b] = triangles_[i].axes();
  const Vec3 p0 = vertex(i, 0), p1 = vertex(i, 1), p2 = vertex(i, 2);
  const double area = (p1[a] - p0[a]) * (p2[b] - p0[b]) - (p2[a] - p0[a]) * (p1[b] - p0[b]);
  const double w1 = ((p[a] - p0[a]) * (p2[b] - p0[b]) - (p2[a] - p0[a]) * (p[b] - p0[b])) / area;
  const double w2 = ((p1[a] - p0[a]) * (p[b] - p0[b]) - (p[a] - p0[a]) * (p1[b] - p0[b])) / area;
  Vec2 result(0, 0);
  const double w[3] = {1 - w1 - w2, w1, w2};
  for (std::size_t k = 0; k < 3; ++k) {
    if (t.uv[k] < data_->uvs.size()) result += w[k] * data_->uvs[t.uv[k]];
  }
  return result;
}

std::array<float, 3> MeshGeometry::weights(std::uint32_t i, const Vec3& p) const {
  // All thresholds are absolute, in mesh space: very small triangles get equal weights.
  std::array<float, 3> result{};
  for (int k = 0; k < 3; ++k) {
    const Vec3 corner = vertex(i, k), b = vertex(i, (k + 1) % 3), c = vertex(i, (k + 2) % 3);
    const Vec3 a = p - corner, e = c - b, from = b - corner;
    // corner + s a = b + r e, solved in the first pair of axes that is not degenerate.
    constexpr int kPairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    double weight = 1;
    for (const auto& [x, y] : kPairs) {
      const double det = a[x] * e[y] - a[y] * e[x];
      if (det * det < 1e-10) continue;
      const double s = (from[x] * e[y] - from[y] * e[x]) / det;
      const Vec3 q = s * a;  // Q - corner
      double ratio = 0;
      for (int m = 0; m < 3; ++m) {
        if (q[m] * q[m] >= 1e-10) {
          ratio = a[m] / q[m];
          break;
        }
      }
      weight = 1 - ratio;
      break;
    }
    result[static_cast<std::size_t>(k)] = static_cast<float>(weight);
  }
  return result;
}

int MeshGeometry::intersections(const Vec3& origin, const Vec3& direction) const {
  int count = 0;
  tree_.traverse_leaves({origin, direction}, 0, kFarthest, [&](std::uint32_t first, std::uint32_t n, double limit) {
    for (std::uint32_t i = first; i < first + n; ++i) {
      count += hit(i, origin, direction) >= 0;
    }
    return limit;
  });
  return count;
}

Box3 mesh_vertex_box(const scene::MeshData& data) {
  std::vector<Box3> parts((data.triangles.size() + kTask - 1) / kTask);
  parallel_for(parts.size(), 1, [&](std::size_t part) {
    Box3 box;
    for (std::size_t i = part * kTask; i < std::min(data.triangles.size(), (part + 1) * kTask); ++i) {
      const scene::MeshTriangle& t = data.triangles[i];
      if (!valid(data, t)) continue;
      for (const std::uint32_t v : t.vertex) box.extendBy(f32(data.vertices[v]));
    }
    parts[part] = box;
  });
  Box3 box;
  for (const Box3& part : parts)
    if (!part.isEmpty()) box.extendBy(part);
  if (box.isEmpty()) box = Box3(Vec3(0), Vec3(0));
  return box;
}

}  // namespace verisim::shapes
