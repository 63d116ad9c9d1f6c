// triangle and smooth_triangle (spec 03 4.7, 04 section 2).
#include <algorithm>
#include <utility>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/mesh/mesh_packet.h"
#include "tracer/shapes/packet_primitive.h"

namespace verisim::shapes {
namespace {

Box3 box_of(const std::array<Vec3, 3>& p) {
  Box3 box;
  for (const Vec3& v : p) box.extendBy(v);
  return box;
}

class Triangle final : public KernelPrimitive<Triangle> {
 public:
  // `n`: vertex normals, null for a flat triangle.
  Triangle(const scene::Object& description, const std::array<Vec3, 3>& p, const std::array<Vec3, 3>* n)
      : KernelPrimitive(description, {box_of(p)}), p_(p) {
    const Vec3 plane = cross(p[0] - p[1], p[2] - p[1]);
    degenerate_ = !(length(plane) > 0);
    if (degenerate_) return;
    normal_ = normalize(plane);
    axes_ = axes_beside(dominant_axis(normal_));
    if (n) {
      smooth_ = true;
      n_ = *n;
      int positive = 0, negative = 0;
      for (const Vec3& v : n_) {
        positive += dot(v, normal_) > 0;
        negative += dot(v, normal_) < 0;
      }
      if (positive != 3 && negative != 3) degenerate_ = true;
    }
    if (turns_clockwise(p_[0], p_[1], p_[2], axes_)) {
      std::swap(p_[0], p_[1]);
      std::swap(n_[0], n_[1]);
    }
    flat_ = {{normal_.x, normal_.y, normal_.z}, dot(normal_, p[0]), {}};
    for (std::size_t k = 0; k < 3; ++k) flat_.corner[k][0] = p_[k][axes_.u], flat_.corner[k][1] = p_[k][axes_.v];
    if (smooth_) prepare_interpolation();
  }

  void meet(const RayPacket& rays, double t_min, const double* t_max, PacketHits& met) const {
    if (degenerate_)
      std::fill_n(met.part, RayPacket::kCount, -1);
    else
      mesh_kernels().triangle(flat_, axes_, rays, t_min, t_max, met);
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    if (degenerate_) return;
    const double low = std::max(kTriangleNearest, sink.lower()), high = std::min(kTriangleFarthest, sink.upper());
    double t;
    if (TriangleHit::meets(flat_, axes_, RayOfTriangle{ray.origin, ray.direction}, low, high, t))
      sink.add(t, [&] { return ray.origin + t * ray.direction; });
  }

  bool contains(const Vec3&) const { return false; }
  bool formula(const Vec3&) const { return false; }  // never inside, inverted or not

  Vec3 geometric_normal(const Hit& hit) const {
    if (!smooth_) return normal_;
    const Vec3 from_first = hit.point - p_[0];
    const double q = dot(perpendicular_, from_first);  // 0 at the first corner, 1 on the opposite edge
    if (q < kEpsilon) return n_[0];
    const int m = edge_axis_;
    const double w = (from_first[m] / q + p_[0][m] - p_[1][m]) / (p_[2][m] - p_[1][m]);
    return normalize(n_[0] + q * (n_[1] - n_[0] + w * (n_[2] - n_[1])));
  }

 private:
  void prepare_interpolation() {
    const Vec3 edge = normalize(p_[1] - p_[2]), to_first = p_[0] - p_[2];
    perpendicular_ = normalize(dot(to_first, edge) * edge - to_first);
    perpendicular_ *= -1 / dot(to_first, perpendicular_);
    edge_axis_ = dominant_axis(p_[2] - p_[1]);
  }

  std::array<Vec3, 3> p_, n_{Vec3(0), Vec3(0), Vec3(0)};
  Vec3 normal_{0, 0, 0}, perpendicular_{0, 0, 0};
  FlatTriangle<double> flat_{};
  PlaneAxes axes_{0, 1};
  int edge_axis_ = 0;
  bool degenerate_ = false, smooth_ = false;
};

}  // namespace

std::unique_ptr<Shape> compile_triangle(const scene::Object& object) {
  return std::make_unique<Triangle>(object, object.as<scene::Triangle>()->p, nullptr);
}

std::unique_ptr<Shape> compile_smooth_triangle(const scene::Object& object) {
  const auto& triangle = *object.as<scene::SmoothTriangle>();
  std::array<Vec3, 3> normals = triangle.n;
  return std::make_unique<Triangle>(object, triangle.p, &normals);
}

}  // namespace verisim::shapes
