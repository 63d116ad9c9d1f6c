#include "tracer/shapes/surface_test_support.h"

namespace verisim::shapes::testing {
namespace {

double p_norm(double a, double b, double p) {
  return std::pow(std::pow(std::fabs(a), p) + std::pow(std::fabs(b), p), 1 / p);
}

// Two spheres joined by the inner sheet of a spindle torus (spec 03 4.14), the lower one larger.
double ovus_value(double b, double t, const Vec3& p) {
  const double rho = 2 * b, v = 2 * t - b - t * t / (2 * b), h = std::sqrt(b * b - v * v);
  if (p.y < -v) return length(p) - b;
  if (p.y > b + (b - v) * t / (rho - t)) return length(p - Vec3(0, b, 0)) - t;
  return std::hypot(std::hypot(p.x, p.z) + h, p.y - v) - rho;
}

// The cubic with values a, b and slopes p, q at 0 and 1.
double hermite(double a, double b, double p, double q, double w) {
  return ((2 * a - 2 * b + p + q) * w * w * w) + (-3 * a + 3 * b - 2 * p - q) * w * w + p * w + a;
}

// A profile through points 1 .. n - 2 whose heights rise all the way, by Catmull and Rom.
double lathe_value(const std::vector<Vec2>& points, const Vec3& p) {
  const double r = std::hypot(p.x, p.z);
  std::size_t i = 1;
  while (i + 3 < points.size() && p.y > points[i + 1].y) ++i;
  const auto at = [&](int axis, double w) {
    return hermite(points[i][axis], points[i + 1][axis], (points[i + 1][axis] - points[i - 1][axis]) / 2,
                   (points[i + 2][axis] - points[i][axis]) / 2, w);
  };
  double low = -0.1, high = 1.1;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (at(1, middle) < p.y ? low : high) = middle;
  }
  return r - at(0, low);
}

// The square of the radius is a cubic in each interval (spec 03 4.16).
double sor_value(const std::vector<Vec2>& points, const Vec3& p) {
  const std::size_t last = points.size() - 2;
  std::size_t i = 1;
  while (i + 1 < last && p.y > points[i + 1].y) ++i;
  const auto slope = [&](std::size_t k) {
    return 2 * points[k].x * (points[k + 1].x - points[k - 1].x) / (points[k + 1].y - points[k - 1].y);
  };
  const double width = points[i + 1].y - points[i].y, w = (p.y - points[i].y) / width;
  const double square =
      hermite(points[i].x * points[i].x, points[i + 1].x * points[i + 1].x, slope(i) * width, slope(i + 1) * width, w);
  return std::max({(p.x * p.x + p.z * p.z - square) / 2, points[1].y - p.y, p.y - points[last].y});
}

// Negative inside a polygon by the even-odd rule.
double polygon_value(const std::vector<Vec2>& points, const Vec2& p) {
  double nearest = 1e300;
  bool in = false;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 a = points[i], edge = points[i + 1] - a, from = p - a;
    const double w = std::clamp(from.dot(edge) / edge.dot(edge), 0.0, 1.0);
    nearest = std::min(nearest, (from - w * edge).length());
    if ((a.y > p.y) != (points[i + 1].y > p.y) && p.x < a.x + (p.y - a.y) / edge.y * edge.x) in = !in;
  }
  return in ? -nearest : nearest;
}

// Spheres whose centres and radii change linearly: the distance from the nearest one.
double round_cone_value(const Vec3& a, const Vec3& b, double ra, double rb, const Vec3& p) {
  const auto distance = [&](double w) { return length(p - (a + w * (b - a))) - (ra + w * (rb - ra)); };
  double low = 0, high = 1;
  for (int k = 0; k < 100; ++k) {
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    if (distance(first) < distance(second))
      high = second;
    else
      low = first;
  }
  return distance((low + high) / 2);
}

std::vector<Solid> solids() {
  using scene::SplineKind;
  const auto shared = [](auto shape) { return [shape](const Steps& m) { return make_shared_shape(shape, m); }; };
  const auto with_sturm = [](auto shape) {  // the closed forms lose digits on purpose
    return [shape](const Steps& m) {
      const ObjectRef object = make_shared_shape(shape, m);
      object->sturm = true;
      return object;
    };
  };
  const auto plain = [](auto shape) { return [shape](const Steps& m) { return make(shape, m); }; };
  scene::Blob blob;
  blob.threshold = 0.5;
  blob.components = {{Vec3(-0.5, 0, 0), Vec3(0), 1, 1, false, {}, {}},
                     {Vec3(0.6, 0.1, 0), Vec3(0), 1.1, 0.9, false, {}, {}},
                     {Vec3(0, 0.8, 0.2), Vec3(0), 0.6, -0.7, false, {}, {}}};
  const auto field = [blob](const Vec3& p) {
    double sum = 0;
    for (const auto& c : blob.components) {
      const Vec3 d = p - c.a;
      const double q = dot(d, d) / (c.radius * c.radius);
      if (q < 1) sum += c.strength * (1 - q) * (1 - q);
    }
    return blob.threshold - sum;
  };
  const std::vector<Vec2> profile{{-0.5, -1}, {0, -1}, {1, -0.2}, {0.5, 0.4}, {0, 1}, {0, 1.5}};
  const std::vector<Vec2> turned{{0.5, -2}, {0.5, -1}, {1, -0.3}, {0.4, 0.4}, {0.6, 1}, {0.6, 2}};
  const std::vector<Vec2> outline{{-1, -1}, {1, -1}, {0.2, 0.1}, {-1, 1.1}, {-1, -1}};
  std::vector<double> rounded_cube(35, 0.0);
  rounded_cube[0] = rounded_cube[20] = rounded_cube[30] = 1, rounded_cube[34] = -1;
  return {
      {"sphere", plain(scene::Sphere{{0.1, -0.2, 0.3}, 0.9}),
       [](const Vec3& p) { return length(p - Vec3(0.1, -0.2, 0.3)) - 0.9; }},
      {"box", plain(scene::Box{{-1, -0.7, -0.5}, {0.8, 0.9, 1}}),
       [](const Vec3& p) {
         return std::max({-1 - p.x, p.x - 0.8, -0.7 - p.y, p.y - 0.9, -0.5 - p.z, p.z - 1});
       }},
      {"cylinder", plain(scene::Cone{{0, -1, 0}, {0, 0.8, 0}, 0.6, 0.6, false}),
       [](const Vec3& p) {
         return std::max({std::hypot(p.x, p.z) - 0.6, -1 - p.y, p.y - 0.8});
       }},
      {"cone", plain(scene::Cone{{0, -1, 0}, {0, 1, 0}, 1, 0.4, false}),
       [](const Vec3& p) {
         return std::max({std::hypot(p.x, p.z) - 0.7 + 0.3 * p.y, -1 - p.y, p.y - 1});
       }},
      {"torus", plain(scene::Torus{0.9, 0.35}),
       [](const Vec3& p) { return std::hypot(std::hypot(p.x, p.z) - 0.9, p.y) - 0.35; }, 1e-5, false},
      {"quadric", plain(scene::Quadric{{1, 0.5, 1.5}, {0.2, -0.1, 0.3}, {0.1, -0.2, 0}, -1}),
       [](const Vec3& p) {
         return (p.x * p.x + 0.5 * p.y * p.y + 1.5 * p.z * p.z + 0.2 * p.x * p.y - 0.1 * p.x * p.z + 0.3 * p.y * p.z +
                 0.1 * p.x - 0.2 * p.y - 1) /
                2;
       }},
      {"quartic", plain(scene::Poly{4, rounded_cube}),
       [](const Vec3& p) {
         return std::sqrt(std::sqrt(p.x * p.x * p.x * p.x + p.y * p.y * p.y * p.y + p.z * p.z * p.z * p.z)) - 1;
       },
       1e-4, false},
      // Exits of grazing rays are lost.
      {"superellipsoid, convex", plain(scene::Superellipsoid{0.4, 0.8}),
       [](const Vec3& p) { return p_norm(p_norm(p.x, p.y, 5), p.z, 2.5) - 1; }, 1e-6, false},
      {"superellipsoid, pinched", plain(scene::Superellipsoid{2.5, 1}),
       [](const Vec3& p) { return p_norm(p_norm(p.x, p.y, 0.8), p.z, 2) - 1; }, 1e-6, false},
      {"blob", shared(blob), field, 1e-4, false},  // as near as POV-Ray's closed form of quartics is
      {"ovus", plain(scene::Ovus{0.9, 0.5}), [](const Vec3& p) { return ovus_value(0.9, 0.5, p); }, 1e-5},
      {"lathe", shared(scene::Lathe{SplineKind::cubic, profile}),
       [=](const Vec3& p) { return lathe_value(profile, p); }},
      {"sor", with_sturm(scene::Sor{turned, false}), [=](const Vec3& p) { return sor_value(turned, p); }},
      {"prism", shared(scene::Prism{SplineKind::linear, false, false, -0.8, 0.7, outline}),
       [=](const Vec3& p) {
         return std::max({polygon_value(outline, {p.x, p.z}), -0.8 - p.y, p.y - 0.7});
       }},
      {"prism, conic", shared(scene::Prism{SplineKind::linear, true, false, 0.3, 1, outline}),
       [=](const Vec3& p) {
         return std::max({p.y * polygon_value(outline, {p.x / p.y, p.z / p.y}), 0.3 - p.y, p.y - 1});
       }},
      {"prism, curved",
       shared(scene::Prism{SplineKind::bezier,
                           false,
                           false,
                           -0.8,
                           0.7,
                           {{0, -1}, {1.6, 0}, {0.5, 1}, {0, 1}, {0, 1}, {-0.5, 1}, {-1.6, 0}, {0, -1}}}),
       {}},
      {"sphere_sweep", shared(scene::SphereSweep{SplineKind::linear, {{-1, 0, 0}, {0.8, 0.3, 0.2}}, {0.4, 0.6}, 1e-6}),
       [](const Vec3& p) {
         return round_cone_value({-1, 0, 0}, {0.8, 0.3, 0.2}, 0.4, 0.6, p);
       },
       1e-6, false},
  };
}

TEST(RandomTransforms, HitsLieOnTheSurfaceWithItsNormalAndSeparateInsideFromOutside) { check_all(solids(), 5000); }

}  // namespace
}  // namespace verisim::shapes::testing
