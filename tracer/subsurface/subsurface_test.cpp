#include "tracer/subsurface/subsurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace verisim::global {
namespace {

// A ball of radius 1 under one distant light.
class Ball : public SubsurfaceEnvironment {
 public:
  Ball(bool replay, unsigned seed) : replay_(replay), generator_(seed) {}
  scene::Interior interior;

  using SubsurfaceEnvironment::nearest;
  bool nearest(const Ray& ray, SurfaceHit& hit) override {
    const double b = dot(ray.origin, ray.direction), q = b * b - dot(ray.origin, ray.origin) + 1;
    if (q < 0) return false;
    hit.t = -b + std::sqrt(q);
    if (!(hit.t > 1e-9)) return false;
    hit.point = hit.normal = ray.origin + hit.t * ray.direction;
    hit.interior = &interior;
    return true;
  }
  std::size_t lights() override { return 1; }
  bool illumination(std::size_t, const Vec3& p, Rgb& color, Vec3& to_light) override {
    color = Rgb(1);
    to_light = direction_to(0, p);
    return dot(p, to_light) > 0;
  }
  Vec3 direction_to(std::size_t, const Vec3&) override { return normalize(Vec3(1, 1, -1)); }
  Rgb transmitted(const Ray&, const SurfaceHit&, double) override { return {}; }
  Vec3 sphere_direction() override {
    const double x = 2 * random() - 1, r = std::sqrt(1 - x * x), angle = 2 * 3.14159265358979 * random();
    return {x, r * std::cos(angle), r * std::sin(angle)};
  }
  double random() override { return std::uniform_real_distribution<>(0, 1)(generator_); }
  bool replay() const override { return replay_; }

 private:
  bool replay_;
  std::mt19937 generator_;
};

Rgb mean_of_ball(bool replay, double mm_per_unit, int diffuse, int single, int runs) {
  Ball ball(replay, 1);
  ball.interior.ior = 1.4;
  SubsurfacePoint point;
  point.point = point.normal = Vec3(0, 0, -1);
  point.view = Vec3(0, 0, 1);
  point.interior = &ball.interior;
  point.relative_ior = 1.4;
  point.reflectance = Rgb(0.9f, 0.5f, 0.05f);
  point.translucency = Rgb(2, 1, 0.5f);
  const SubsurfaceSettings settings{diffuse, single, mm_per_unit, 1.0f / 255};
  Rgb sum;
  for (int i = 0; i < runs; ++i) sum += subsurface(point, settings, ball);
  return sum * (1.0f / static_cast<float>(runs));
}

// The samples of the default mode have the mean of POV-Ray's: in a ball that light crosses and in one that it does not,
// few and many.
TEST(Subsurface, BetterSamplesHaveTheSameMean) {
  for (const double mm : {5.0, 200.0}) {
    const Rgb expected = mean_of_ball(true, mm, 2000, 200, 200);
    for (const int samples : {10, 100, 3000}) {
      const Rgb found = mean_of_ball(false, mm, samples, samples, 400000 / samples);
      EXPECT_NEAR(found.r, expected.r, 0.01 * expected.r) << mm << ' ' << samples;
      EXPECT_NEAR(found.g, expected.g, 0.01 * expected.g) << mm << ' ' << samples;
      EXPECT_NEAR(found.b, expected.b, 0.02 * expected.b) << mm << ' ' << samples;
    }
  }
}

// Spec 07 section 5.2: rho = 0.9, 0.6, 0.4 at ior 1.4.
TEST(Subsurface, ReducedAlbedoEqualsTheSpecification) {
  EXPECT_NEAR(reduced_albedo(0.9, 1.4), 0.998826, 1e-6);
  EXPECT_NEAR(reduced_albedo(0.6, 1.4), 0.972707, 1e-6);
  EXPECT_NEAR(reduced_albedo(0.4, 1.4), 0.913844, 1e-6);
}

TEST(Subsurface, FresnelTransmittanceAtNormalIncidence) {
  EXPECT_NEAR(fresnel_transmittance(1.0, 1.5), 0.96, 1e-12);
  EXPECT_NEAR(fresnel_transmittance(1.0, 1.0), 1.0, 1e-12);
  EXPECT_EQ(fresnel_transmittance(0.1, 0.5), 1.0);  // total reflection, as POV-Ray has it
}

}  // namespace
}  // namespace verisim::global
