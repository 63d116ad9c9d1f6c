// Mandelbrot, Julia and magnet fractals over the x-y plane.
#include <limits>

#include "tracer/textures/patterns/formulas.h"
#include "tracer/textures/patterns/fractal_kernels.h"

namespace verisim::textures {
namespace {

#include "tracer/textures/patterns/fractal_orbit.inc"

// Types 2 to 5: a coordinate of the place where an orbit ends, or its square.
double end_of_orbit(int type, const Complex<double>& z) {
  const double x = type % 2 == 0 ? z.r : z.i;
  return type < 4 ? x : x * x;
}

double exterior(const scene::FractalParams& f, const Complex<double>& z, int k) {
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

double interior(const scene::FractalParams& f, const Complex<double>& z, double smallest) {
  const double a = z.r, b = z.i, factor = f.interior_factor;
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
  int needed(const Complex<double>& z, int k, int left) {
    if (z.r == place_.r && z.i == place_.i) return left % (k - at_);
    if (k == next_) place_ = z, at_ = k, next_ = k < (1 << 29) ? 2 * k : 0;
    return left;
  }

 private:
  Complex<double> place_{std::numeric_limits<double>::infinity(), 0};
  int at_ = 0, next_ = 1;
};

template <class Step>
double follow(const scene::FractalParams& f, const Step& step, Complex<double> z, const Complex<double>& c,
              double smallest) {
  Rounds rounds;
  int end = f.iterations;
  for (int k = 0; k < end; ++k) {
    z = step.next(z, c);
    const double size = squared(z);
    if (step.ends(z, size)) return exterior(f, z, k);
    smallest = std::min(smallest, size);
    end = k + 1 + rounds.needed(z, k, end - k - 1);
  }
  return interior(f, z, smallest);
}

// Where the orbit of a point begins, and what is added in each step.
struct Start {
  Complex<double> z, c;
  double smallest;
};
Start start(const scene::FractalParams& f, scene::PatternKind kind, double x, double y) {
  const Complex<double> point{x, y}, julia{f.julia.x, f.julia.y};
  switch (kind) {
    case scene::PatternKind::mandel:
      return {point, point, squared(point)};
    case scene::PatternKind::magnet_mandel:
      return {{0, 0}, point, 10000};
    default:
      return {point, julia, squared(point)};
  }
}
// The type of the magnetic model; 0: none.
int magnet_of(const scene::FractalParams& f, scene::PatternKind kind) {
  return kind == scene::PatternKind::magnet_mandel || kind == scene::PatternKind::magnet_julia ? f.magnet : 0;
}

// What eight orbits that were followed together come to.
template <class Step>
void end(const scene::FractalParams& f, const Step& step, unsigned escaped, const Orbits& o, int count,
         double* values) {
  for (int k = 0; k < count; ++k) {
    Complex<double> z{o.zr[k], o.zi[k]};
    if (escaped >> k & 1) {
      values[k] = exterior(f, z, o.k[k]);
      continue;
    }
    double smallest = o.smallest[k];
    for (int left = o.left[k]; left > 0; --left) {
      z = step.next(z, {o.cr[k], o.ci[k]});
      smallest = std::min(smallest, squared(z));
    }
    values[k] = interior(f, z, smallest);
  }
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
  const Start s = start(f, kind, p.x, p.y);
  return with_step(magnet_of(f, kind), f.exponent,
                   [&](const auto& step) { return follow(f, step, s.z, s.c, s.smallest); });
}

void fractal_batch(const scene::FractalParams& f, scene::PatternKind kind, int count, const double* x, const double* y,
                   double* values, const OrbitKernels& kernels) {
  for (int first = 0; first < count; first += 8) {
    const int here = std::min(count - first, 8);
    Orbits o;
    for (int k = 0; k < 8; ++k) {
      const int i = first + std::min(k, here - 1);
      const Start s = start(f, kind, x[i], y[i]);
      o.zr[k] = s.z.r, o.zi[k] = s.z.i, o.cr[k] = s.c.r, o.ci[k] = s.c.i, o.smallest[k] = s.smallest;
    }
    const int magnet = magnet_of(f, kind);
    const unsigned escaped = kernels.follow(magnet, f.exponent, f.iterations, (1u << here) - 1, o);
    with_step(magnet, f.exponent, [&](const auto& step) { end(f, step, escaped, o, here, values + first); });
  }
}

}  // namespace verisim::textures
