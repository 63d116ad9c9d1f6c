// torus (spec 03 4.4): about the y axis.
#include <numbers>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/algebraic/torus_packet.h"
#include "tracer/shapes/intersections.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"

namespace verisim::shapes {
namespace {

using namespace one_ray;
#include "tracer/shapes/algebraic/torus_quartic.inc"

constexpr double kNearest = 1e-4, kFarthest = 1e7, kElimination = 1e-4;

class Torus final : public SearchPrimitive<Torus> {
 public:
  Torus(const scene::Object& description, const scene::Torus& t)
      : SearchPrimitive(description, {t.box()}),
        radii_{t.major, t.minor},
        sturm_(description.sturm),
        guarded_(has_guards(description)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = unit_local(ray);
    if (!meets_thick_cylinder(l.origin, l.direction, radii_)) return;
    double advance, c[5] = {1}, after[4];
    torus_quartic(l.origin, l.direction, radii_, advance, after);
    std::copy_n(after, 4, c + 1);
    report(ray, c, advance, l.scale, sink);
  }

  bool takes_packets() const { return !guarded_; }
  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    TorusPacket packet;
    torus_quartic_kernel()(radii_.major, radii_.minor, &matrix(), rays, packet);
    unsigned found = 0;
    each_lane(rays.active & packet.met, [&](int k) {
      const double c[5] = {1, packet.c[0][k], packet.c[1][k], packet.c[2][k], packet.c[3][k]};
      NearestHit sink(*this, nullptr, t_min, t_max[k], hit_of(k), any);
      report(rays.at(k), c, packet.advance[k], packet.scale[k], sink);
      found |= sink.found() ? 1u << k : 0;
    });
    return found;
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    const double rho = std::sqrt(p.x * p.x + p.z * p.z) - radii_.major;
    return rho * rho + p.y * p.y <= radii_.minor * radii_.minor;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 p = local(hit.point);
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(rho > kEpsilon)) return world_normal(p);
    return world_normal({p.x - radii_.major * p.x / rho, p.y, p.z - radii_.major * p.z / rho});
  }

  Vec2 uv(const Hit& hit) const override {
    const Vec3 p = local(hit.point);
    constexpr double pi = std::numbers::pi;
    const double u = 1 - (std::atan2(p.z, p.x) + pi) / (2 * pi);
    const double v = (std::atan2(p.y, std::sqrt(p.x * p.x + p.z * p.z) - radii_.major) + pi) / (2 * pi);
    return {u, v};
  }

 private:
  // The hits of a ray whose quartic counts from `advance`.
  template <class Sink>
  void report(const Ray& ray, const double* c, double advance, double scale, Sink& sink) const {
    double roots[4];
    const int n = solve_polynomial(4, c, roots, sturm_, kElimination);
    for (int i = n - 1; i >= 0; --i) {
      const double t = roots[i] + advance, depth = t / scale;  // neither may be too far
      if (t < kFarthest && depth > kNearest && depth < kFarthest)
        sink.add(depth, [&] { return ray.origin + depth * ray.direction; });
    }
  }

  const TorusRadii radii_;
  bool sturm_, guarded_;
};

}  // namespace

std::unique_ptr<Shape> compile_torus(const scene::Object& object) {
  return std::make_unique<Torus>(object, *object.as<scene::Torus>());
}

}  // namespace verisim::shapes
