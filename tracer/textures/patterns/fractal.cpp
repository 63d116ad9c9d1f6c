// Mandelbrot, Julia and magnet fractals over the x-y plane.
#include <complex>
#include <limits>

#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/patterns/fractal_kernels.h"

namespace verisim::textures {
namespace {

using Complex = std::complex<double>;

Complex multiply(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

Complex divide(const Complex& a, const Complex& b) {
  const double n = b.real() * b.real() + b.imag() * b.imag();
  return {(a.real() * b.real() + a.imag() * b.imag()) / n, (a.imag() * b.real() - a.real() * b.imag()) / n};
}

Complex power(const Complex& z, int exponent) {
  Complex result = z, square = z;
  for (int n = exponent - 1; n > 0; n >>= 1) {
    if (n & 1) result = multiply(result, square);
    square = multiply(square, square);
  }
  return result;
}

double squared(const Complex& z) { return z.real() * z.real() + z.imag() * z.imag(); }

// Types 2 to 5: a coordinate of the place where an orbit ends, or its square.
double end_of_orbit(int type, const Complex& z) {
  const double x = type % 2 == 0 ? z.real() : z.imag();
  return type < 4 ? x : x * x;
}

double exterior(const scene::FractalParams& f, const Complex& z, int k) {
  const double factor = f.exterior_factor;
  const auto modulo = [&](double modulus) {
    const int m = static_cast<int>(std::clamp(modulus, -2147483647.0, 2147483647.0));
    return m == 0 ? 0.0 : (k % m) / factor;
  };
  switch (f.exterior_type) {
    case 0:
      return factor;
    case 1:
      return static_cast<double>(k) / f.iterations;
    case 2:
    case 3:
    case 4:
    case 5:
      return end_of_orbit(f.exterior_type, z) * factor;
    case 6:
      return std::sqrt(squared(z)) * factor;
    case 7:
      return modulo(std::floor(factor));
    case 8:
      return modulo(std::floor(1 + factor));
    default:
      return 0;
  }
}

double interior(const scene::FractalParams& f, const Complex& z, double smallest) {
  const double a = z.real(), b = z.imag(), factor = f.interior_factor;
  switch (f.interior_type) {
    case 0:
      return factor;
    case 1:
      return std::sqrt(smallest) * factor;
    case 2:
    case 3:
    case 4:
    case 5:
      return end_of_orbit(f.interior_type, z) * factor;
    case 6:
      return a * a + b * b * factor;  // not (a^2 + b^2) times the factor
    default:
      return 0;
  }
}

// An orbit of floating-point numbers that comes to a place for the second time goes round for ever: what is left of it
// are whole rounds, and a part of one. Brent, "An improved Monte Carlo factorization algorithm" (1980): the place of
// every iteration that is a power of two is compared with those that follow.
class Rounds {
 public:
  // How many of `left` iterations change where the orbit ends and what its smallest value is; it is at z after
  // iteration k = 0, 1 ...
  int needed(const Complex& z, int k, int left) {
    if (z == place_) return left % (k - at_);
    if (k == next_) place_ = z, at_ = k, next_ = k < (1 << 29) ? 2 * k : 0;
    return left;
  }

 private:
  Complex place_{std::numeric_limits<double>::infinity(), 0};
  int at_ = 0, next_ = 1;
};

Complex next(const scene::FractalParams& f, const Complex& z, const Complex& c) {
  return (f.exponent == 2 ? Complex(z.real() * z.real() - z.imag() * z.imag(), 2 * z.real() * z.imag())
                          : power(z, f.exponent)) +
         c;
}

double polynomial(const scene::FractalParams& f, Complex z, const Complex& c) {
  double smallest = squared(z);
  Rounds rounds;
  int end = f.iterations;
  for (int k = 0; k < end; ++k) {
    z = next(f, z, c);
    const double size = squared(z);
    if (size > 4) return exterior(f, z, k);
    smallest = std::min(smallest, size);
    end = k + 1 + rounds.needed(z, k, end - k - 1);
  }
  return interior(f, z, smallest);
}

double magnet(const scene::FractalParams& f, Complex z, const Complex& c, double smallest) {
  Rounds rounds;
  int end = f.iterations;
  for (int k = 0; k < end; ++k) {
    Complex numerator, denominator;
    const Complex z2 = multiply(z, z);
    if (f.magnet == 1) {
      numerator = z2 + c - 1.0;
      denominator = 2.0 * z + c - 2.0;
    } else {
      const Complex c1 = c - 1.0, c2 = c - 2.0, c12 = multiply(c1, c2);
      numerator = multiply(z2, z) + 3.0 * multiply(c1, z) + c12;
      denominator = 3.0 * z2 + 3.0 * multiply(c2, z) + c12 + 1.0;
    }
    const Complex quotient = divide(numerator, denominator);
    z = multiply(quotient, quotient);
    const double size = squared(z);
    if (size > 10000 || squared(z - 1.0) < 1e-4) return exterior(f, z, k);
    smallest = std::min(smallest, size);
    end = k + 1 + rounds.needed(z, k, end - k - 1);
  }
  return interior(f, z, smallest);
}

}  // namespace

namespace formulas {

double julia(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return fractal(c.as<scene::FractalParams>(), c.kind, p);
}
double magnet_julia(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return fractal(c.as<scene::FractalParams>(), c.kind, p);
}
double magnet_mandel(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return fractal(c.as<scene::FractalParams>(), c.kind, p);
}
double mandel(const CompiledPattern& c, const Vec3& p, const SurfacePoint*) {
  return fractal(c.as<scene::FractalParams>(), c.kind, p);
}

}  // namespace formulas

double fractal(const scene::FractalParams& f, scene::PatternKind kind, const Vec3& p) {
  const Complex point(p.x, p.y), julia(f.julia.x, f.julia.y);
  switch (kind) {
    case scene::PatternKind::mandel:
      return polynomial(f, point, point);
    case scene::PatternKind::julia:
      return polynomial(f, point, julia);
    case scene::PatternKind::magnet_mandel:
      return magnet(f, {0, 0}, point, 10000);
    default:
      return magnet(f, point, julia, squared(point));
  }
}

void fractal_batch(const scene::FractalParams& f, scene::PatternKind kind, int count, const double* x, const double* y,
                   double* values, const OrbitKernels& kernels) {
  for (int first = 0; first < count; first += 8) {
    const int here = std::min(count - first, 8);
    Orbits o;
    for (int k = 0; k < 8; ++k) {
      const int i = first + std::min(k, here - 1);
      o.zr[k] = x[i], o.zi[k] = y[i];
      const bool julia = kind == scene::PatternKind::julia;
      o.cr[k] = julia ? f.julia.x : x[i], o.ci[k] = julia ? f.julia.y : y[i];
    }
    const unsigned escaped = kernels.follow(f.exponent, f.iterations, (1u << here) - 1, o);
    for (int k = 0; k < here; ++k) {
      Complex z(o.zr[k], o.zi[k]);
      if (escaped >> k & 1) {
        values[first + k] = exterior(f, z, o.k[k]);
        continue;
      }
      double smallest = o.smallest[k];
      for (int left = o.left[k]; left > 0; --left) {
        z = next(f, z, {o.cr[k], o.ci[k]});
        smallest = std::min(smallest, squared(z));
      }
      values[first + k] = interior(f, z, smallest);
    }
  }
}

}  // namespace verisim::textures
