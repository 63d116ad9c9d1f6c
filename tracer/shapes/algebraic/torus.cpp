// torus (spec 03 4.4): about the y axis.
#include <numbers>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-4, kFarthest = 1e7, kElimination = 1e-4;

class Torus final : public SearchPrimitive<Torus> {
 public:
  Torus(const scene::Object& description, const scene::Torus& t)
      : SearchPrimitive(description, {t.box()}),
        major_(t.major),
        minor_(t.minor),
        major2_(t.major * t.major),
        minor2_(t.minor * t.minor),
        sturm_(description.sturm),
        guarded_(has_guards(description)) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = unit_local(ray);
    if (!meets_thick_cylinder(l)) return;
    // Start near the torus: the quartic loses its digits far away from it.
    const Vec3& d = l.direction;
    const double around = major_ + minor_ + minor_, distance = length(l.origin);
    const double advance = distance > around ? distance - around : 0;
    const Vec3 p = l.origin + advance * d;

    // The order of sums and products is POV-Ray's (spec 08 N).
    const double y2 = p.y * p.y, ydy = p.y * d.y;
    const double k1 = p.x * p.x + p.z * p.z + y2 - major2_ - minor2_, k2 = p.x * d.x + p.z * d.z + ydy;
    const double c[5] = {1, 4 * k2, 2 * (k1 + 2 * (k2 * k2 + major2_ * (d.y * d.y))), 4 * (k1 * k2 + 2 * major2_ * ydy),
                         k1 * k1 + 4 * major2_ * (y2 - minor2_)};
    report(ray, c, advance, l.scale, sink);
  }

  bool takes_packets() const { return !guarded_; }
  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    TorusPacket packet;
    packet_kernels().torus(major_, minor_, &matrix(), rays, packet);
    unsigned found = 0;
    each_lane(rays.active, [&](int k) {
      if (packet.met[k] == 0) return;
      const double c[5] = {1, packet.c[0][k], packet.c[1][k], packet.c[2][k], packet.c[3][k]};
      NearestHit sink(*this, nullptr, t_min, t_max[k], hit_of(k), any);
      report(rays.at(k), c, packet.advance[k], packet.scale[k], sink);
      found |= sink.found() ? 1u << k : 0;
    });
    return found;
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point);
    const double rho = std::sqrt(p.x * p.x + p.z * p.z) - major_;
    return rho * rho + p.y * p.y <= minor2_;
  }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 p = local(hit.point);
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(rho > kEpsilon)) return world_normal(p);
    return world_normal({p.x - major_ * p.x / rho, p.y, p.z - major_ * p.z / rho});
  }

  Vec2 uv(const Hit& hit) const override {
    const Vec3 p = local(hit.point);
    constexpr double pi = std::numbers::pi;
    const double u = 1 - (std::atan2(p.z, p.x) + pi) / (2 * pi);
    const double v = (std::atan2(p.y, std::sqrt(p.x * p.x + p.z * p.z) - major_) + pi) / (2 * pi);
    return {u, v};
  }

 private:
  // The hits of a ray whose quartic counts from `advance`.
  template <class Sink>
  void report(const Ray& ray, const double* c, double advance, double scale, Sink& sink) const {
    double roots[4];
    const int n = solve_polynomial(4, c, roots, sturm_, kElimination);
    for (int i = n - 1; i >= 0; --i) {
      const double depth = (roots[i] + advance) / scale;
      if (depth > kNearest && depth < kFarthest) sink.add(depth, [&] { return ray.origin + depth * ray.direction; });
    }
  }
  // |y| <= r, distance from the axis between R - r and R + r.
  bool meets_thick_cylinder(const LocalRay& l) const {
    const Vec3 &o = l.origin, &d = l.direction;
    const double outer = major_ + minor_, inner = major_ > minor_ ? major_ - minor_ : 0;
    const double outer2 = outer * outer, inner2 = inner * inner;
    double near = 0, far = HUGE_VAL;
    if (std::fabs(d.y) < kEpsilon) {
      if (std::fabs(o.y) > minor_) return false;
    } else {
      double a = (-minor_ - o.y) / d.y, b = (minor_ - o.y) / d.y;
      if (a > b) std::swap(a, b);
      near = std::max(near, a), far = std::min(far, b);
      if (near > far) return false;
    }
    const double a = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z, c = o.x * o.x + o.z * o.z;
    const auto rho2 = [&](double t) { return c + t * (2 * b + a * t); };
    // Along the axis the side is not asked: the ray has to cross an end within the ring, however far away that is.
    if (a < kEpsilon) {
      const auto in_ring = [&](double t) { return rho2(t) >= inner2 * (1 - 1e-9) && rho2(t) <= outer2 * (1 + 1e-9); };
      return in_ring(near) || in_ring(far);
    }
    const double discriminant = b * b - a * (c - outer2);
    if (discriminant < 0) return false;
    const double root = std::sqrt(discriminant);
    near = std::max(near, (-b - root) / a), far = std::min(far, (-b + root) / a);
    if (near > far) return false;
    // Inside the hole all the way from near to far?
    return !(inner2 > 0 && rho2(near) < inner2 * (1 - 1e-9) && rho2(far) < inner2 * (1 - 1e-9));
  }

  double major_, minor_, major2_, minor2_;
  bool sturm_, guarded_;
};

}  // namespace

std::unique_ptr<Shape> compile_torus(const scene::Object& object) {
  return std::make_unique<Torus>(object, *object.as<scene::Torus>());
}

}  // namespace verisim::shapes
