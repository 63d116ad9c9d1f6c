// Complex functions with POV-Ray's formulas. Signed zeros decide on which side of a branch cut a number lies and the
// fractal depends on it, so every product and difference is formed component by component as written.
#include "tracer/shapes/julia/julia_algebra.h"

#include <cmath>

namespace verisim::shapes::julia {

namespace {

struct Complex {
  double re = 0, im = 0;
};

Complex multiply(const Complex& a, const Complex& b) { return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re}; }
Complex divide(const Complex& a, const Complex& b) {
  const double m = b.re * b.re + b.im * b.im, p = b.re / m, q = -b.im / m;
  return {a.re * p - a.im * q, a.re * q + a.im * p};
}
Complex ln(const Complex& z) { return {std::log(std::sqrt(z.re * z.re + z.im * z.im)), std::atan2(z.im, z.re)}; }
Complex exp(const Complex& z) {
  const double e = std::exp(z.re);
  return {e * std::cos(z.im), e * std::sin(z.im)};
}
Complex sqrt(const Complex& z) {
  const double modulus = std::sqrt(std::sqrt(z.re * z.re + z.im * z.im)), angle = std::atan2(z.im, z.re) / 2;
  if (z.re == 0 && z.im == 0) return {0, 0};
  // That of a negative real number, too: its real part is some 1e-16, on which last bits of normals hang (spec 08 M).
  return {modulus * std::cos(angle), modulus * std::sin(angle)};
}

Complex asin(const Complex& z) {  // -i ln(iz + sqrt(1 - z^2))
  const Complex z2 = multiply(z, z), root = sqrt({1 - z2.re, -z2.im});
  const Complex l = ln({root.re - z.im, root.im + z.re});
  return {l.im, -l.re};
}
Complex acos(const Complex& z) {  // -i ln(z + sqrt(z^2 - 1))
  const Complex z2 = multiply(z, z), root = sqrt({z2.re - 1, z2.im});
  const Complex l = ln({root.re + z.re, root.im + z.im});
  return {l.im, -l.re};
}
Complex asinh(const Complex& z) {
  const Complex z2 = multiply(z, z), root = sqrt({z2.re + 1, z2.im});
  return ln({root.re + z.re, root.im + z.im});
}
Complex acosh(const Complex& z) {
  const Complex z2 = multiply(z, z), root = sqrt({z2.re - 1, z2.im});
  return ln({root.re + z.re, root.im + z.im});
}
Complex atanh(const Complex& z) {
  if (z.re == 0) return {0, std::atan(z.im)};
  if (z.im == 0 && std::fabs(z.re) < 1) return {std::log((1 + z.re) / (1 - z.re)) / 2, 0};
  if (z.im == 0 && std::fabs(z.re) == 1) return {0, 0};  // undefined in POV-Ray
  const Complex l = ln(divide({1 + z.re, z.im}, {1 - z.re, -z.im}));
  return {l.re / 2, l.im / 2};
}
Complex atan(const Complex& z) {  // i/2 ln((1 - iz) / (1 + iz))
  if (z.im == 0) return {std::atan(z.re), 0};
  const Complex l = ln(divide({1 + z.im, -z.re}, {1 - z.im, z.re}));
  return {-l.im / 2, l.re / 2};
}
Complex sin(const Complex& z) { return {std::sin(z.re) * std::cosh(z.im), std::cos(z.re) * std::sinh(z.im)}; }
Complex cos(const Complex& z) { return {std::cos(z.re) * std::cosh(z.im), -(std::sin(z.re) * std::sinh(z.im))}; }
Complex sinh(const Complex& z) { return {std::sinh(z.re) * std::cos(z.im), std::cosh(z.re) * std::sin(z.im)}; }
Complex cosh(const Complex& z) { return {std::cosh(z.re) * std::cos(z.im), std::sinh(z.re) * std::sin(z.im)}; }
Complex tan(const Complex& z) {
  const double d = std::cos(2 * z.re) + std::cosh(2 * z.im);
  return {std::sin(2 * z.re) / d, std::sinh(2 * z.im) / d};
}
Complex tanh(const Complex& z) {
  const double d = std::cosh(2 * z.re) + std::cos(2 * z.im);
  return {std::sinh(2 * z.re) / d, std::sin(2 * z.im) / d};
}
Complex power(const Complex& z, const Complex& c) {
  if (z.re == 0 && z.im == 0) return {0, 0};
  const Complex e = multiply(c, ln(z));
  const double modulus = e.re < -690 ? 0 : std::exp(e.re);
  return {modulus * std::cos(e.im), modulus * std::sin(e.im)};
}

Complex evaluate(scene::JuliaFunction f, const Vec2& exponent, const Complex& z) {
  using enum scene::JuliaFunction;
  switch (f) {
    case exp:
      return julia::exp(z);
    case sin:
      return julia::sin(z);
    case asin:
      return julia::asin(z);
    case sinh:
      return julia::sinh(z);
    case asinh:
      return julia::asinh(z);
    case cos:
      return julia::cos(z);
    case acos:
      return julia::acos(z);
    case cosh:
      return julia::cosh(z);
    case acosh:
      return julia::acosh(z);
    case tan:
      return julia::tan(z);
    case atan:
      return julia::atan(z);
    case tanh:
      return julia::tanh(z);
    case atanh:
      return julia::atanh(z);
    case ln:
      return julia::ln(z);
    case pwr:
      return power(z, {exponent.x, exponent.y});
    case sqr:
    case cube:
    case reciprocal:
      break;
  }
  return z;
}

}  // namespace

Number reciprocal(const Number& h) {
  const double x = h.x, y = h.y, z = h.z, w = h.w;
  // |h|^2, and the squares of what h stands for, (x - w) + i(y + z) and (x + w) + i(y - z).
  const double all = norm2<Kind::other>(h),
               both = ((x - w) * (x - w) + (y + z) * (y + z)) * ((x + w) * (x + w) + (y - z) * (y - z));
  if (both == 0) return {};
  const double q = x * w - y * z;
  return {(x * all - 2 * w * q) / both, (-y * all - 2 * z * q) / both, (-z * all - 2 * y * q) / both,
          (w * all - 2 * x * q) / both};
}

Number apply(scene::JuliaFunction f, const Vec2& exponent, const Number& h) {
  using enum scene::JuliaFunction;
  if (f == sqr || f == cube) return product(h, h);
  if (f == reciprocal) return julia::reciprocal(h);
  const Complex p = evaluate(f, exponent, {h.x - h.w, h.y + h.z}), q = evaluate(f, exponent, {h.x + h.w, h.y - h.z});
  return {(p.re + q.re) / 2, (p.im + q.im) / 2, (p.im - q.im) / 2, (q.re - p.re) / 2};
}

}  // namespace verisim::shapes::julia
