// cubic, quartic, poly and polynomial (spec 03 4.9): sum of c x^i y^j z^k = 0, coefficients in order of falling powers of x, then y, then z.
#include <algorithm>

#include "tracer/math/bernstein.h"
#include "tracer/math/polynomial.h"
#include "tracer/shapes/factories.h"
#include "tracer/shapes/primitive.h"

namespace verisim::shapes {
namespace {

constexpr double kFarthestRoot = 1e7, kNearest = 1e-4, kElimination = 1e-4, kInsideThreshold = 1e-4;

// A polynomial in the ray parameter, constant term first; size 0 is zero.
struct Univariate {
  double c[kMaxPolynomialDegree + 1];
  int size = 0;

  // this = this * (a + b t)
  void multiply(double a, double b) {
    if (size == 0) return;
    c[size] = c[size - 1] * b;
    for (int i = size - 1; i > 0; --i) c[i] = c[i] * a + c[i - 1] * b;
    c[0] *= a;
    ++size;
  }
  void add(double v) {
    if (v == 0) return;
    if (size == 0) c[size++] = 0;
    c[0] += v;
  }
  void add(const Univariate& o) {
    while (size < o.size) c[size++] = 0;
    for (int i = 0; i < o.size; ++i) c[i] += o.c[i];
  }
};

class Poly final : public Primitive<Poly> {
 public:
  Poly(const scene::Object& description, const scene::Poly& p)
      : Primitive(description, {everywhere(), false}), order_(p.order), coefficients_(p.coefficients), sturm_(description.sturm) {
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
  void crossings(const Ray& ray, Sink& sink) const {
    const LocalRay l = local(ray);
    double roots[kMaxPolynomialDegree];
    const int n = order_ == 2 ? solve_order2(l, roots) : solve(l, roots);
    for (int i = 0; i < n; ++i) {
      const double t = roots[i];
      if (!(t > kNearest)) continue;
      bool duplicate = false;
      for (int k = 0; k < i; ++k) duplicate = duplicate || roots[k] == t;
      if (!duplicate) sink.add(t / l.scale, [&] { return world(l.origin + t * l.direction); });
    }
  }

  bool contains(const Vec3& p) const { return value(local(p)) < kInsideThreshold; }

  Vec3 raw_normal(const Hit& hit) const {
    const Vec3 g = gradient(local(hit.point));
    if (g == Vec3(0)) return {1, 0, 0};
    return world_normal(g / std::max({std::fabs(g.x), std::fabs(g.y), std::fabs(g.z)}));
  }

 private:
  // Horner's rule over all powers, as it runs along the coefficient list.
  Univariate along(const LocalRay& l) const {
    const double* c = coefficients_.data();
    const unsigned char* used = used_.data();
    Univariate result;
    for (int i = order_; i >= 0; --i) {
      Univariate in_y;
      for (int j = order_ - i; j >= 0; --j) {
        in_y.multiply(l.origin.y, l.direction.y);
        const int count = order_ - i - j + 1;
        if (*used++) {
          Univariate in_z;
          for (int k = 0; k < count; ++k) {
            in_z.multiply(l.origin.z, l.direction.z);
            in_z.add(c[k]);
          }
          in_y.add(in_z);
        }
        c += count;
      }
      result.multiply(l.origin.x, l.direction.x);
      result.add(in_y);
    }
    return result;
  }

  int solve(const LocalRay& l, double* roots) const {
    const Univariate p = along(l);
    double c[kMaxPolynomialDegree + 1];
    int degree = p.size - 1;
    while (degree >= 0 && p.c[degree] == 0) --degree;
    if (degree < 2) return 0;
    if (degree >= 5 && degree <= kMaxBernsteinDegree) return solve_bounded(degree, p.c, roots);
    for (int i = 0; i <= degree; ++i) c[i] = p.c[degree - i];
    return solve_polynomial(degree, c, roots, sturm_, kElimination);
  }

  // Degrees for which POV-Ray has Sturm sequences: all roots lie within Fujiwara's bound, and on that stretch they are isolated in Bernstein form.
  static int solve_bounded(int degree, const double* power, double* roots) {
    double exponent = -1e9;
    for (int k = 1; k <= degree; ++k) {
      const double ratio = std::fabs(power[degree - k] / power[degree]) * (k == degree ? 0.5 : 1);
      // ratio^(1/k), in powers of two rounded up.
      if (ratio > 0 && std::isfinite(ratio)) exponent = std::max(exponent, (std::ilogb(ratio) + 1.0) / k);
    }
    const double bound = std::min(2 * std::exp2(exponent) * (1 + 1e-9), kFarthestRoot);
    if (!(bound > 0)) return 0;
    return bernstein_roots(degree, power, 0, bound, roots);
  }

  int solve_order2(const LocalRay& l, double* roots) const {
    Univariate p = along(l);
    while (p.size < 3) p.c[p.size++] = 0;
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

  // Horner's rule with derivatives carried along.
  Vec3 gradient(const Vec3& p) const {
    const double* c = coefficients_.data();
    double v = 0, dx = 0, dy = 0, dz = 0;
    for (int i = order_; i >= 0; --i) {
      double v1 = 0, dy1 = 0, dz1 = 0;
      for (int j = order_ - i; j >= 0; --j) {
        double v2 = 0, dz2 = 0;
        for (int k = order_ - i - j; k >= 0; --k) {
          dz2 = dz2 * p.z + v2;
          v2 = v2 * p.z + *c++;
        }
        dy1 = dy1 * p.y + v1;
        v1 = v1 * p.y + v2;
        dz1 = dz1 * p.y + dz2;
      }
      dx = dx * p.x + v;
      v = v * p.x + v1;
      dy = dy * p.x + dy1;
      dz = dz * p.x + dz1;
    }
    return {dx, dy, dz};
  }

  int order_;
  std::vector<double> coefficients_;
  std::vector<unsigned char> used_;  // per power of x and y: whether any coefficient is not zero
  bool sturm_;
};

}  // namespace

std::unique_ptr<Shape> compile_poly(const scene::Object& object) { return std::make_unique<Poly>(object, *object.as<scene::Poly>()); }

}  // namespace verisim::shapes
