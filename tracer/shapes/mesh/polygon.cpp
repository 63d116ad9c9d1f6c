// polygon (spec 03 4.8): lies in z = 0 of a frame made from its first points. A polygon that is not flat to 1e-10, or
// too small, is never hit.
#include <optional>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/frame.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-8, kFarthest = 1e7;  // of local distances

std::optional<Transform> frame_of(const scene::Polygon& polygon) {
  const std::vector<Vec3>& p = polygon.points;
  const auto squared = [](const Vec3& v) { return dot(v, v); };
  std::size_t i = 1;
  while (i < p.size() && !(squared(p[i] - p[0]) > kEpsilon)) ++i;
  if (i >= p.size()) return std::nullopt;
  const Vec3 u = p[i] - p[0];
  for (++i; i < p.size(); ++i) {
    const Vec3 v = p[i] - p[0], w = cross(u, v);
    if (!(squared(v) > kEpsilon && squared(w) > kEpsilon)) continue;
    const Vec3 across = cross(v, w), a = normalize(across), b = normalize(cross(w, across)), c = normalize(w);
    const Mat4 m(a.x, a.y, a.z, 0, b.x, b.y, b.z, 0, c.x, c.y, c.z, 0, 0, 0, 0, 1);
    return Transform{Affine(m), Affine(m.transposed())}.then(Transform::translation(p[0]));
  }
  return std::nullopt;
}

struct Edge {
  Vec2 from, to;
};

// The outline in its frame; empty if the points are not in one plane.
std::vector<Edge> outline(const scene::Polygon& polygon) {
  const auto frame = frame_of(polygon);
  if (!frame) return {};
  std::vector<Vec2> points;
  for (const Vec3& p : polygon.points) {
    const Vec3 q = frame->inverse_point(p);
    if (!(std::fabs(q.z) <= kEpsilon)) return {};
    points.emplace_back(q.x, q.y);
  }
  const auto same = [&](std::size_t a, std::size_t b) {
    for (int k = 0; k < 3; ++k)
      if (!(std::fabs(polygon.points[a][k] - polygon.points[b][k]) < kEpsilon)) return false;
    return true;
  };
  std::vector<Edge> edges;
  std::size_t start = 0;  // of the current closed loop
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (same(i, start)) {
      edges.push_back({points[i - 1], points[start]});
      start = ++i;
    } else {
      edges.push_back({points[i - 1], points[i]});
      if (i + 1 == points.size()) edges.push_back({points[i], points[start]});
    }
  }
  return edges;
}

class Polygon final : public Primitive<Polygon> {
 public:
  Polygon(const scene::Object& description, const scene::Polygon& polygon)
      : Primitive(description, {padded(polygon_box(polygon)), false}), edges_(outline(polygon)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    if (std::fabs(l.direction.z) < kEpsilon) return;
    const double t = -l.origin.z / l.direction.z;
    if (!(t >= kNearest && t <= kFarthest)) return;
    if (!covers({l.origin.x + t * l.direction.x, l.origin.y + t * l.direction.y})) return;
    const double depth = t / l.scale;
    sink.add(depth, [&] { return ray.origin + depth * ray.direction; });
  }

  bool contains(const Vec3&) const { return false; }
  bool formula(const Vec3&) const { return false; }
  Vec3 geometric_normal(const Hit&) const { return world_normal({0, 0, 1}); }

 private:
  static Box3 padded(Box3 box) {
    box.min.z -= 1e-9, box.max.z += 1e-9;
    return box;
  }
  // Even-odd rule along +x: a point level with an edge's upper end crosses it, and so does one on it (the crossings
  // test of Haines, "Point in polygon strategies", Graphics Gems IV, 1994, with products for quotients, whose last bits
  // decide along an edge). Of 9,500 rays through points of a lattice 20 differ from POV-Ray's.
  bool covers(const Vec2& p) const {
    bool odd = false;
    for (const Edge& e : edges_) {
      const bool to_above = e.to.y >= p.y;
      if ((e.from.y >= p.y) == to_above) continue;
      if (((e.to.y - p.y) * (e.from.x - e.to.x) >= (e.to.x - p.x) * (e.from.y - e.to.y)) == to_above) odd = !odd;
    }
    return odd;
  }

  std::vector<Edge> edges_;
};

}  // namespace

Transform polygon_frame(const scene::Polygon& polygon) { return frame_of(polygon).value_or(Transform{}); }

Box3 polygon_box(const scene::Polygon& polygon) {
  const Transform frame = polygon_frame(polygon);
  Box3 box;
  for (const Vec3& p : polygon.points) {
    const Vec3 q = frame.inverse_point(p);
    box.extendBy({q.x, q.y, 0});
  }
  return box;
}

std::unique_ptr<Shape> compile_polygon(const scene::Object& object) {
  const auto& polygon = *object.as<scene::Polygon>();
  return compile_in_frame<Polygon>(object, polygon, polygon_frame);
}

}  // namespace verisim::shapes
