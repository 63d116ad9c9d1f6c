// cubic, quartic, poly and polynomial (spec 03 4.9): sum of c x^i y^j z^k = 0, coefficients in order of falling powers
// of x, then y, then z.
#include <algorithm>

#include "tracer/math/bernstein_packet.h"
#include "tracer/math/polynomial.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/packet_primitive.h"
#include "tracer/shapes/algebraic/poly_packet.h"

namespace verisim::shapes {
namespace {

constexpr double kFarthestRoot = 1e7, kNearest = 1e-4, kElimination = 1e-4, kInsideThreshold = 1e-4;

#include "tracer/shapes/algebraic/poly_along.inc"

class Poly final : public SearchPrimitive<Poly> {
 public:
  Poly(const scene::Object& description, const scene::Poly& p)
      : SearchPrimitive(description, {everywhere(), false}),
        order_(p.order),
        coefficients_(p.coefficients),
        sturm_(description.sturm) {
    const auto n = static_cast<std::size_t>(order_);
    coefficients_.resize((n + 1) * (n + 2) * (n + 3) / 6);
    const double* c = coefficients_.data();
    for (int i = order_; i >= 0; --i)
      for (int j = order_ - i; j >= 0; --j) {
        const int count = order_ - i - j + 1;
        used_.push_back(std::any_of(c, c + count, [](double v) { return v != 0; }));
        c += count;
      }
  }

  template <class Sink>
  void intersections(const Ray& ray, Sink& sink) const {
    const LocalRay l = unit_local(ray);
    const double o[3] = {l.origin.x, l.origin.y, l.origin.z}, d[3] = {l.direction.x, l.direction.y, l.direction.z};
    Univariate<double> p;
    along(order_, coefficients_.data(), used_.data(), o, d, p);
    report_roots(l, p, sink);
  }

  template <class HitOf>
  unsigned nearest_of_packet(const RayPacket& rays, double t_min, const double* t_max, HitOf&& hit_of, bool any) const {
    const unsigned admitted = guards() ? guards()->admit(rays) : rays.active;
    if (admitted == 0) return 0;
    LocalPacket packet;
    packet_kernels().local(&matrix(), rays, packet);
    PolyPacket along;
    poly_along()(order_, coefficients_.data(), used_.data(), packet, along);
    const int degree = along.size - 1;
    RootPacket bounded;
    unsigned found = 0, wanted = 0;
    each_lane(admitted, [&](int k) {
      if (isolates(degree) && along.c[degree][k] != 0) {
        double c[kMaxBernsteinDegree + 1];
        for (int i = 0; i <= degree; ++i) c[i] = along.c[i][k];
        bounded.from[k] = 0, bounded.to[k] = root_bound(degree, c);
        wanted |= bounded.to[k] > 0 ? 1u << k : 0;
        return;
      }
      Univariate<double> p;
      for (; p.size < along.size; ++p.size) p.c[p.size] = along.c[p.size][k];
      NearestHit sink(*this, guards(), t_min, t_max[k], hit_of(k), any);
      report_roots(unit_local(rays.at(k)), p, sink);
      found |= sink.found() ? 1u << k : 0;
    });
    if (wanted == 0) return found;
    for (int i = 0; i <= degree; ++i) std::copy_n(along.c[i], RayPacket::kCount, bounded.power[i]);
    unsigned open = bernstein_kernels().begin(degree, wanted, bounded);
    while (open != 0) {
      open &= bernstein_kernels().next(degree, open, bounded);
      each_lane(open, [&](int k) {
        const double t = bounded.root[k];
        NearestHit sink(*this, guards(), t_min, t_max[k], hit_of(k), any);
        if (report(unit_local(rays.at(k)), t, sink))
          found |= 1u << k, open &= ~(1u << k);
        else if (t / packet.scale[k] >= t_max[k])
          open &= ~(1u << k);
      });
    }
    return found;
  }

  bool contains(const Vec3& p) const { return value(local(p)) < kInsideThreshold; }

  Vec3 geometric_normal(const Hit& hit) const {
    const Vec3 g = gradient(local(hit.point));
    if (g == Vec3(0)) return {1, 0, 0};
    return world_normal(g);
  }

 private:
  static constexpr int kGrouped = 4;  // orders of which POV-Ray has formulas of their own
  using Powers = double[3][kGrouped + 1];

  template <std::size_t kCount>
  static void fill_powers(const Vec3& p, int order, double (&powers)[3][kCount]) {
    for (int axis = 0; axis < 3; ++axis) {
      powers[axis][0] = 1;
      for (int k = 1; k <= order; ++k) powers[axis][k] = powers[axis][k - 1] * p[axis];
    }
  }

  // Of a polynomial of that degree.
  static int terms(int variables, int degree) {
    return variables == 0 ? 1 : variables == 1 ? degree + 1 : (degree + 1) * (degree + 2) / 2;
  }

  template <class Sink>
  void report_roots(const LocalRay& l, Univariate<double>& p, Sink& sink) const {
    double roots[kMaxPolynomialDegree];
    const int n = order_ == 2 ? solve_order2(p, roots) : solve(p, roots);
    for (int i = 0; i < n; ++i) {
      const double t = roots[i];
      bool duplicate = false;
      for (int k = 0; k < i; ++k) duplicate = duplicate || roots[k] == t;
      if (!duplicate) report(l, t, sink);
    }
  }
  template <class Sink>
  bool report(const LocalRay& l, double t, Sink& sink) const {
    return t > kNearest && sink.add(t / l.scale, [&] { return world(l.origin + t * l.direction); });
  }

  int solve(const Univariate<double>& p, double* roots) const {
    double c[kMaxPolynomialDegree + 1];
    int degree = p.size - 1;
    while (degree >= 0 && p.c[degree] == 0) --degree;
    if (degree < 2) return 0;
    if (isolates(degree)) {
      const double bound = root_bound(degree, p.c);
      return bound > 0 ? bernstein_roots(degree, p.c, 0, bound, roots) : 0;
    }
    for (int i = 0; i <= degree; ++i) c[i] = p.c[degree - i];
    return solve_polynomial(degree, c, roots, sturm_, kElimination);
  }

  // Degrees for which POV-Ray has Sturm sequences: all roots lie within Fujiwara's bound, and on that interval they are
  // isolated in Bernstein form.
  static bool isolates(int degree) { return degree >= 5 && degree <= kMaxBernsteinDegree; }
  static double root_bound(int degree, const double* power) {
    double exponent = -1e9;
    for (int k = 1; k <= degree; ++k) {
      const double ratio = std::fabs(power[degree - k] / power[degree]) * (k == degree ? 0.5 : 1);
      // ratio^(1/k), in powers of two rounded up.
      if (ratio > 0 && std::isfinite(ratio)) exponent = std::max(exponent, (std::ilogb(ratio) + 1.0) / k);
    }
    return std::min(2 * std::exp2(exponent) * (1 + 1e-9), kFarthestRoot);
  }

  int solve_order2(Univariate<double>& p, double* roots) const {
    const double a = p.c[2], b = 0.5 * p.c[1], c = p.c[0];
    if (std::fabs(a) < 1e-20) {
      if (b == 0) return 0;
      roots[0] = -0.5 * c / b;
      return 1;
    }
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0)) return 0;
    const double root = std::sqrt(discriminant);
    roots[0] = (-b + root) / a;
    roots[1] = (-b - root) / a;
    return 2;
  }

  double value(const Vec3& p) const {
    const double* c = coefficients_.data();
    double result = 0;
    for (int i = order_; i >= 0; --i) {
      double in_y = 0;
      for (int j = order_ - i; j >= 0; --j) {
        double in_z = 0;
        for (int k = order_ - i - j; k >= 0; --k) in_z = in_z * p.z + *c++;
        in_y = in_y * p.y + in_z;
      }
      result = result * p.x + in_y;
    }
    return result;
  }

  // With all of POV-Ray's bits (spec 08 N).
  Vec3 gradient(const Vec3& p) const { return order_ <= kGrouped ? grouped_gradient(p) : summed_gradient(p); }

  Vec3 grouped_gradient(const Vec3& p) const {
    Powers powers;
    fill_powers(p, order_, powers);
    Vec3 g(0);
    for (int axis = 0; axis < 3; ++axis) {
      const double* c = coefficients_.data();
      add_derivative(axis, 0, c, order_, powers, g[axis]);
    }
    return g;
  }
  // The derivative along `axis` of the terms of up to `degree` in the variables from `variable` on, grouped by powers
  // of that: n x^(n-1) times a sum, (n c) x^(n-1) for a coefficient alone, and what has no power of it term by term.
  static void add_derivative(int axis, int variable, const double*& c, int degree, const Powers& powers, double& sum) {
    for (int n = degree; n >= 0; --n) {
      const int factor = axis == variable ? n : 1, exponent = axis == variable ? n - 1 : n;
      if (factor == 0) {
        c += terms(2 - variable, degree);  // constant along the axis
      } else if (variable == 2 || (axis == variable && n == degree)) {
        sum += (factor * *c++) * powers[variable][exponent];
      } else if (exponent == 0) {
        add_derivative(axis, variable + 1, c, degree - n, powers, sum);
      } else {
        double inner = 0;
        add_derivative(axis, variable + 1, c, degree - n, powers, inner);
        sum += (factor * powers[variable][exponent]) * inner;
      }
    }
  }

  // Term by term, (n c) ((X Y) Z).
  Vec3 summed_gradient(const Vec3& p) const {
    double powers[3][kMaxPolynomialDegree + 1];
    fill_powers(p, order_, powers);
    Vec3 g(0);
    const double* c = coefficients_.data();
    for (int i = order_; i >= 0; --i)
      for (int j = order_ - i; j >= 0; --j)
        for (int k = order_ - i - j; k >= 0; --k, ++c) {
          if (*c == 0) continue;
          const auto &x = powers[0], &y = powers[1], &z = powers[2];
          if (i > 0) g.x += (i * *c) * ((x[i - 1] * y[j]) * z[k]);
          if (j > 0) g.y += (j * *c) * ((x[i] * y[j - 1]) * z[k]);
          if (k > 0) g.z += (k * *c) * ((x[i] * y[j]) * z[k - 1]);
        }
    return g;
  }

  int order_;
  std::vector<double> coefficients_;
  std::vector<unsigned char> used_;  // per power of x and y: whether any coefficient is not zero
  bool sturm_;
};

}  // namespace

std::unique_ptr<Shape> compile_poly(const scene::Object& object) {
  return std::make_unique<Poly>(object, *object.as<scene::Poly>());
}

}  // namespace verisim::shapes
