// ovus (spec 03 4.14): two spheres joined by the inner sheet of a spindle torus, (h + H)^2 + (y - V)^2 = rho^2.
#include <algorithm>

#include "tracer/math/polynomial.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/kept_point.h"
#include "tracer/shapes/primitive.h"
#include "tracer/shapes/spherical_uv.h"

namespace verisim::shapes {
namespace {

constexpr double kNearest = 1e-10, kElimination = 1e-4, kOnSheet = 1e-4;

struct Measures {
  double bottom, top;
  bool sphere_only;  // the top sphere swallows the bottom one
  double rho = 0, v = 0, h = 0, low = 0, high = 0;

  explicit Measures(const scene::Ovus& o) : bottom(o.bottom), top(o.top), sphere_only(o.top >= 2 * o.bottom) {
    if (sphere_only) return;
    const double b = bottom, t = top;
    if (b > t) {
      rho = 2 * b;
      v = 2 * t - b - t * t / (2 * b);
      h = std::sqrt(b * b - v * v);
      low = -v;
      high = b + (b - v) * t / (rho - t);
    } else {
      rho = 2 * t;
      v = -2 * t + b + 1.5 * t * t / b;
      h = std::sqrt(t * t - (v - b) * (v - b));
      low = -v * b / (rho - b);
      high = 2 * b - v;
    }
  }
};

Box3 box_of(const Measures& m) {
  if (m.sphere_only) return {Vec3(-m.top, m.bottom - m.top, -m.top), Vec3(m.top, m.bottom + m.top, m.top)};
  const double half = std::max({m.rho - m.h, m.bottom, m.top});
  return {Vec3(-half, -m.bottom, -half), Vec3(half, m.bottom + m.top, half)};
}

enum Part : std::int32_t { bottom_sphere, sheet, top_sphere };

class Ovus final : public Primitive<Ovus> {
 public:
  Ovus(const scene::Object& description, const Measures& m)
      : Primitive(description, {box_of(m)}), m_(m), sturm_(description.sturm) {}

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = unit_local(ray);
    const auto report = [&](double t, Part part) {
      if (!(t > kNearest)) return;
      const Vec3 found = l.origin + t * l.direction;
      add_found(sink, t / l.scale, found, moved_by(), part);
    };
    const auto height = [&](double t) { return l.origin.y + t * l.direction.y; };
    double near, far;
    if (!m_.sphere_only && sphere(l, 0, m_.bottom, near, far))
      for (const double t : {near, far})
        if (height(t) < m_.low) report(t, bottom_sphere);
    if (sphere(l, m_.bottom, m_.top, near, far))
      for (const double t : {near, far})
        if (m_.sphere_only || height(t) > m_.high) report(t, top_sphere);
    if (m_.sphere_only || !(m_.low < m_.high)) return;
    if (sink.upper() < 0 || !passes_sheet(l)) return;  // some hit was enough, or there is no other

    // The quartic of a torus of radii H and rho about (0, V, 0), in the order of torus.cpp, but from the ray's origin.
    const Vec3 p(l.origin.x, l.origin.y - m_.v, l.origin.z);
    const Vec3& d = l.direction;
    const double h2 = m_.h * m_.h, rho2 = m_.rho * m_.rho, y2 = p.y * p.y, ydy = p.y * d.y;
    const double k1 = p.x * p.x + p.z * p.z + y2 - h2 - rho2, k2 = p.x * d.x + p.z * d.z + ydy;
    const double c[5] = {1, 4 * k2, 2 * (k1 + 2 * (k2 * k2 + h2 * (d.y * d.y))), 4 * (k1 * k2 + 2 * h2 * ydy),
                         k1 * k1 + 4 * h2 * (y2 - rho2)};
    double roots[4];
    const int n = solve_polynomial(4, c, roots, sturm_, kElimination);
    for (int i = 0; i < n; ++i) {
      const double t = roots[i];
      const Vec3 q = l.origin + t * d;
      if (q.y > m_.low && q.y < m_.high && std::fabs(sheet_value(q)) < kOnSheet) report(t, sheet);
    }
  }

  bool contains(const Vec3& point) const {
    const Vec3 p = local(point), q(p.x, p.y - m_.bottom, p.z);
    if (dot(q, q) < m_.top * m_.top) return true;
    if (m_.sphere_only) return false;
    return dot(p, p) < m_.bottom * m_.bottom || (p.y > m_.low && p.y < m_.high && sheet_value(p) < 0);
  }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 p = found_point(hit, moved_by());
    if (hit.part == bottom_sphere) return world_normal(p * (1 / m_.bottom));
    if (hit.part == top_sphere) return world_normal(Vec3(p.x, p.y - m_.bottom, p.z) * (1 / m_.top));
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(rho > 0)) return world_normal({0, p.y - m_.v, 0});
    // Normalised here and again in the world, as POV-Ray does.
    return world_normal(normalize({p.x + m_.h * p.x / rho, p.y - m_.v, p.z + m_.h * p.z / rho}));
  }

  Vec2 uv(const Hit& hit) const override {
    Vec3 p = local(hit.point);
    p.y -= 0.5 * m_.top;
    return spherical_uv(normalize(p));
  }

 private:
  const Transform* moved_by() const { return has_matrix() ? &matrix() : nullptr; }
  static bool sphere(const LocalRay& l, double height, double radius, double& near, double& far) {
    const Vec3 to(-l.origin.x, height - l.origin.y, -l.origin.z);
    const double closest = dot(to, l.direction), half2 = radius * radius - dot(to, to) + closest * closest;
    if (!(half2 > 0)) return false;
    const double half = std::sqrt(half2);
    near = closest - half, far = closest + half;
    return true;
  }
  // False: no point of the ray lies in the sheet's heights and near enough to the axis for its value to be small.
  bool passes_sheet(const LocalRay& l) const {
    const Vec3 &o = l.origin, &d = l.direction;
    const double radius = std::sqrt(m_.rho * m_.rho + kOnSheet) - m_.h, radius2 = radius * radius * (1 + 1e-6) + 1e-9;
    const double slack = 1e-9 * (std::fabs(o.y) + std::fabs(m_.low) + std::fabs(m_.high));
    double enter = -HUGE_VAL, leave = HUGE_VAL;
    if (std::fabs(d.y) > kEpsilon) {
      const double a = (m_.low - slack - o.y) / d.y, b = (m_.high + slack - o.y) / d.y;
      enter = std::min(a, b), leave = std::max(a, b);
    }
    // The squared distance from the axis is a t^2 + 2 b t + c; it is least at -b / a.
    const double a = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z, c = o.x * o.x + o.z * o.z;
    if (!(a > kEpsilon)) return true;
    const double t = std::clamp(-b / a, enter, leave), x = o.x + t * d.x, z = o.z + t * d.z;
    return !(x * x + z * z > radius2 + 1e-9 * c);
  }
  double sheet_value(const Vec3& p) const {
    const double outer = std::sqrt(p.x * p.x + p.z * p.z) + m_.h, y = p.y - m_.v;
    return outer * outer + y * y - m_.rho * m_.rho;
  }

  Measures m_;
  bool sturm_;
};

}  // namespace

Box3 ovus_box(const scene::Ovus& ovus) { return box_of(Measures(ovus)); }

std::unique_ptr<Shape> compile_ovus(const scene::Object& object) {
  return std::make_unique<Ovus>(object, Measures(*object.as<scene::Ovus>()));
}

}  // namespace verisim::shapes
