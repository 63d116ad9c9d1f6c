// scenes/analytic: the numbers of its manifest are those of the formulas, and verisim renders them.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "compare/compare.h"
#include "compare/oracle/working_copy.h"

namespace verisim {
namespace {

using Color3 = std::array<double, 3>;
using Point = std::array<double, 3>;

Color3 grey(double v) { return {v, v, v}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point& a) { return std::sqrt(dot(a, a)); }

// Mean of h / r over the rectangle seen from a point below it.
double mean_cosine(double x, double z, double h, double half) {
  const auto antiderivative = [h](double a, double b) {
    return h * (a * std::asinh(b / std::hypot(h, a)) + b * std::asinh(a / std::hypot(h, b)) -
                h * std::atan(a * b / (h * std::sqrt(h * h + a * a + b * b))));
  };
  const double a = -half - x, b = half - x, c = -half - z, d = half - z;
  return (antiderivative(b, d) - antiderivative(a, d) - antiderivative(b, c) + antiderivative(a, c)) /
         (4 * half * half);
}

// Lambert's formula (1760): a point with normal y and a polygon above its horizon.
double form_factor(const Point& p, const std::vector<Point>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p, n = cross(a, b);
    sum += std::acos(dot(a, b) / (length(a) * length(b))) * n[1] / length(n);
  }
  return std::fabs(sum) / (2 * std::numbers::pi);
}

double fresnel(double cosine, double n) {
  const double t = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
  const double s = (cosine - n * t) / (cosine + n * t), p = (n * cosine - t) / (n * cosine + t);
  return (s * s + p * p) / 2;
}

// Where a ray arrives that meets a glass sphere (n = 1.5, radius 1) at a distance h from its axis: at this distance
// from the axis, on a plane 1.1 below the middle.
double through_sphere(double h) {
  const double a = std::asin(h), b = std::asin(h / 1.5), turn = 2 * (a - b), exit = a + std::numbers::pi - 2 * b;
  return std::sin(exit) - (std::cos(exit) + 1.1) / std::cos(turn) * std::sin(turn);
}

// Irradiance there, of light of irradiance 1: h dh / (r dr) of every ray that arrives.
double caustic(double r) {
  constexpr int kSteps = 2000;
  double sum = r > 1 ? 1 : 0;
  for (const double place : {r, -r})
    for (int i = 0; i < kSteps; ++i) {
      const auto miss = [&](double h) { return through_sphere(h) - place; };
      double low = static_cast<double>(i) / kSteps, high = std::min(static_cast<double>(i + 1) / kSteps, 1 - 1e-9);
      const double side = miss(low);
      if (side * miss(high) >= 0) continue;
      for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (miss(middle) * side > 0 ? low : high) = middle;
      }
      sum += low / (r * std::fabs(through_sphere(low + 1e-7) - through_sphere(low - 1e-7)) / 2e-7);
    }
  return sum;
}

// What a half-space without a refracting surface returns of even light (Jensen, Marschner, Levoy, Hanrahan 2001): the
// dipole, integrated over the plane, as a function of the reduced albedo ...
double dipole_reflectance(double albedo) {
  const double r = std::sqrt(3 * (1 - albedo));
  return albedo / 2 * (1 + std::exp(-4 * r / 3)) * std::exp(-r);
}
// ... and single scattering of light that comes and goes along the normal. A quarter of it at each depth s, but POV-Ray
// takes exp(-s) of the way out twice, as the paper prints it: int exp(-3 s) / 8 instead of int exp(-2 s) / 4.
double subsurface(double reflectance) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (dipole_reflectance(middle) < reflectance ? low : high) = middle;
  }
  return reflectance + low / 24;
}

double srgb_decoded(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

const std::map<std::string, std::function<Color3(double, double)>>& formulas() {
  static const std::map<std::string, std::function<Color3(double, double)>> all = {
      {"point_light.pov",
       [](double x, double z) {
         const Point to = Point{0.5, 2, -0.25} - Point{x, 0, z};
         const double d = length(to);
         return grey(0.8 * 0.7 * (to[1] / d) * 2 / (1 + d * d / 4));
       }},
      {"spotlight.pov", [](double x, double z) { return grey(0.9 * std::pow(3 / std::sqrt(9 + x * x + z * z), 8)); }},
      {"area_light.pov", [](double x, double z) { return grey(0.9 * mean_cosine(x, z, 2, 1)); }},
      {"furnace.pov", [](double x, double z) { return grey(std::hypot(x, z) < 1 ? 0.8 * 0.5 : 0.5); }},
      {"form_factor_parallel.pov",
       [](double x, double z) {
         return grey(form_factor({x, 0, z}, {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}}));
       }},
      {"form_factor_perpendicular.pov",
       [](double x, double z) {
         return grey(form_factor({x, 0, z}, {{-2, 0, -1}, {-2, 2, -1}, {-2, 2, 1}, {-2, 0, 1}}));
       }},
      {"refraction.pov",
       [](double x, double) {
         const double a = std::numbers::pi / 6, s = std::sin(a);
         return grey((x + s * (1 - std::cos(a) / std::sqrt(1.5 * 1.5 - s * s)) + 2) / 8);
       }},
      {"fresnel.pov",
       [](double x, double z) { return grey(fresnel(std::sqrt(1 - (x * x + z * z) / (1.4 * 1.4)), 1.5)); }},
      {"beer_lambert.pov",
       [](double x, double) {
         const double d = (x + 2) / 2;
         return Color3{0.9 * std::exp(-0.3 * d), 0.9 * std::exp(-0.6 * d), 0.9 * std::exp(-1.2 * d)};
       }},
      {"beer_lambert_fade.pov",
       [](double x, double) {
         const double d = (x + 2) / 2 / 1.5;
         return Color3{0.9 * std::exp(-0.8 * d), 0.9 * std::exp(-0.5 * d), 0.9 * std::exp(-0.2 * d)};
       }},
      {"fog.pov",
       [](double x, double) {
         const double left = std::exp(-(4 + x / 2) / 3);
         return grey(0.9 * left + 0.2 * (1 - left));
       }},
      {"caustic.pov", [](double x, double z) { return grey(0.5 * caustic(std::hypot(x, z))); }},
      {"circle_of_confusion.pov",
       [](double x, double) {
         const double u = std::clamp(x / 0.5, -1.0, 1.0);
         return grey(0.9 * (0.5 + (std::asin(u) + u * std::sqrt(1 - u * u)) / std::numbers::pi));
       }},
      {"dispersion.pov",
       [](double x, double z) {
         const double n = z < -0.5 ? 1.51432 : z < 0.5 ? 1.51680 : 1.52238, a = std::numbers::pi / 6;
         return grey(0.25 + (x - (x * std::tan(a) + 4) * std::tan(std::asin(n * std::sin(a)) - a)) / 12);
       }},
      {"form_factor_disc.pov",
       [](double x, double z) {
         const double d2 = x * x + z * z;
         return grey(0.5 * (1 - d2 / std::sqrt((d2 + 2) * (d2 + 2) - 4 * d2)));
       }},
      {"form_factor_sphere.pov", [](double x, double z) { return grey(0.25 / std::pow(1 + x * x + z * z, 1.5)); }},
      {"gamma_chain.pov",
       [](double x, double z) {
         const double v = (std::floor(2 * (x + 2)) + 1) / 9;
         return grey(z < 0 ? std::pow(v, 2.2) : srgb_decoded(v));
       }},
      {"integrating_sphere.pov", [](double, double) { return grey(0.15 * (1 - std::pow(0.5, 5)) / 0.5); }},
      {"penumbra.pov",
       [](double x, double z) { return grey(0.9 * 2 / std::sqrt(4 + x * x + z * z) * std::clamp(0.5 + x, 0.0, 1.0)); }},
      {"single_scattering.pov",
       [](double x, double) {
         const auto back = [d = (x + 2) / 2](double s) { return 1.2 * (1 - std::exp(-2 * s * d)) / 2; };
         return Color3{back(0.2), back(0.5), back(1)};
       }},
      {"subsurface_dipole.pov",
       [](double x, double) {
         const double t = (x + 2) / 4;
         return Color3{0.8 * subsurface(0.1 + 0.8 * t), 0.8 * subsurface(0.85 - 0.7 * t), 0.8 * subsurface(0.5)};
       }},
      {"thin_film.pov",
       [](double x, double z) {
         const double c = 2 / std::sqrt((x - 0.5) * (x - 0.5) + 4 + (z + 0.25) * (z + 0.25));
         const auto film = [c](double wavelength) {
           return 0.8 * 0.7 * c * (1 + 0.3 * std::cos(2 * std::numbers::pi * 0.8 * (1 + c) / wavelength));
         };
         return Color3{film(0.7), film(0.52), film(0.48)};
       }},
  };
  return all;
}

compare::Suite analytic_suite() {
  return compare::load_suite({std::filesystem::path(VERISIM_SOURCE_DIR) / "scenes/analytic"});
}

TEST(Analytic, TheManifestHoldsWhatTheFormulasSay) {
  const compare::Suite suite = analytic_suite();
  EXPECT_EQ(suite.scenes.size(), formulas().size());
  for (const compare::SceneRequest& scene : suite.scenes) {
    ASSERT_TRUE(scene.truth) << scene.name;
    ASSERT_TRUE(formulas().contains(scene.name)) << scene.name;
    EXPECT_GE(scene.truth->points.size(), 5u);
    for (const compare::TruthPoint& p : scene.truth->points) {
      const Color3 expected =
          formulas().at(scene.name)(4 * ((p.x + 0.5) / scene.width - 0.5), 3 * (0.5 - (p.y + 0.5) / scene.height));
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(p.value[c], expected[c], 1e-6) << scene.name << " at " << p.x << ", " << p.y;
    }
  }
}

TEST(Analytic, VerisimKeepsTheKnownAnswers) {
  const compare::Suite suite = analytic_suite();
  const compare::TemporaryFolder folder;
  const compare::NativeRenderer render =
      compare::native_program(std::filesystem::path(VERISIM_BINARY_DIR) / "bin/verisim");
  for (const compare::SceneRequest& scene : suite.scenes) {
    compare::NativeRequest request;
    request.folder = folder.path(), request.scene = scene.scene, request.output = folder.path() / (scene.name + ".png");
    request.width = scene.width, request.height = scene.height, request.switches = scene.switches,
    request.time_limit = 900;
    const compare::NativeResult result = render(request);
    ASSERT_EQ(result.outcome, compare::NativeResult::Outcome::rendered) << scene.name << ": " << result.message;
    const compare::TruthError error = compare::truth_error(image::read_picture(request.output), *scene.truth);
    EXPECT_LE(error.max, scene.truth->tolerance) << scene.name << " at " << error.worst_x << ", " << error.worst_y;
  }
}

}  // namespace
}  // namespace verisim
