// Probe P7 of spec 05 section 15: normals on the plane z = 0.3 seen along z. POV-Ray showed sin(pi/2 (2 V / 65535 - 1))
// of each component as a 16-bit grey V.
#include <gtest/gtest.h>

#include <numbers>

#include "tracer/textures/texture.h"

namespace verisim::textures {
namespace {

using namespace scene;

std::shared_ptr<Normal> normal(PatternKind kind, float amount = 0.5f) {
  auto n = std::make_shared<Normal>();
  n->pattern.kind = kind;
  n->amount = amount;
  return n;
}

// The greys of a perturbed normal.
Vec3 greys(const NormalPtr& description, const Vec3& p) {
  Compiler compiler{Settings{}};
  SurfacePoint surface;
  surface.point = p;
  surface.normal = Vec3(0, 0, -1);
  surface.ray_direction = Vec3(0, 0, 1);
  perturb(*compiler.normal(description), p, surface.normal, surface);
  Vec3 result;
  for (int k = 0; k < 3; ++k)
    result[k] = (0.5 + std::asin(std::clamp(surface.normal[k], -1.0, 1.0)) / std::numbers::pi) * 65535;
  return result;
}

void expect_normal(const NormalPtr& n, const Vec3& first, const Vec3& second, const char* sdl) {
  const Vec3 a = greys(n, {-0.75, 0.75, 0.3}), b = greys(n, {0.75, -0.75, 0.3});
  for (int k = 0; k < 3; ++k) {
    // 1.5: rounding of the 16-bit output. The z component near -1 (grey 0) is steep: asin has no slope there.
    EXPECT_NEAR(a[k], first[k], k == 2 ? 40 : 1.5) << sdl << ", component " << k << " at pixel (2,1)";
    EXPECT_NEAR(b[k], second[k], k == 2 ? 40 : 1.5) << sdl << ", component " << k << " at pixel (5,4)";
  }
}

TEST(NormalProbes, Bumps) {
  expect_normal(normal(PatternKind::bumps), {29717, 34726, 3633}, {31792, 32762, 976}, "bumps");
  auto scaled = normal(PatternKind::bumps, 0.6f);
  scaled->pattern.prepend(Transform::scaling({0.3, 0.5, 2}));
  expect_normal(scaled, {41960, 47293, 18342}, {43245, 36112, 11096}, "bumps 0.6 scale <0.3,0.5,2>");
  scaled->no_bump_scale = true;
  expect_normal(scaled, {39218, 42683, 6281}, {39567, 34987, 0}, "bumps 0.6 scale <0.3,0.5,2> no_bump_scale");
}

TEST(NormalProbes, PatternsWithTheirOwnDisplacement) {
  expect_normal(normal(PatternKind::dents, 0.7f), {32550, 32908, 259}, {32617, 32767, 150}, "dents 0.7");
  expect_normal(normal(PatternKind::wrinkles, 0.4f), {37799, 36883, 6552}, {35589, 33602, 2944}, "wrinkles 0.4");
  auto ripples = normal(PatternKind::ripples, 0.4f);
  ripples->pattern.frequency = 3;
  ripples->pattern.phase = 0.2f;
  expect_normal(ripples, {33236, 32165, 764}, {31952, 32657, 823}, "ripples 0.4 frequency 3 phase 0.2");
  auto waves = normal(PatternKind::waves, 0.3f);
  waves->pattern.frequency = 5;
  waves->pattern.phase = 0.1f;
  expect_normal(waves, {28384, 36802, 5999}, {35045, 31092, 2831}, "waves 0.3 frequency 5 phase 0.1");
  auto quilted = normal(PatternKind::quilted, 0.9f);
  quilted->pattern.params = QuiltedParams{0.3f, 0.8f};
  expect_normal(quilted, {30642, 34893, 3011}, {34893, 30642, 3011}, "quilted 0.9 control0 0.3 control1 0.8");
}

TEST(NormalProbes, Facets) {
  auto facets = normal(PatternKind::facets);
  facets->pattern.params = FacetsParams{0.4, 0, 2};
  expect_normal(facets, {36288, 32875, 3522}, {36288, 32875, 3522}, "facets size 0.4");
  facets->pattern.params = FacetsParams{0.3, 0.5, 2};
  expect_normal(facets, {34802, 32113, 2138}, {30979, 35193, 3019}, "facets coords 0.5 size 0.3");
}

TEST(NormalProbes, HeightFields) {
  expect_normal(normal(PatternKind::bozo, 1), {33217, 33512, 870}, {33875, 32596, 1120}, "bozo 1");
  auto granite = normal(PatternKind::granite, 0.3f);
  granite->accuracy = 0.005f;
  expect_normal(granite, {38232, 35545, 6160}, {23641, 35164, 9479}, "granite 0.3 accuracy 0.005");
  auto leopard = normal(PatternKind::leopard, 1);
  leopard->pattern.prepend(Transform::scaling({0.3, 0.3, 0.3}));
  expect_normal(leopard, {33177, 33179, 580}, {33179, 33173, 578}, "leopard 1 scale 0.3");
  auto onion = normal(PatternKind::onion, 0.6f);
  onion->slope_map = std::make_shared<BlendMap<SlopeEntry>>(
      BlendMap<SlopeEntry>{{0, {0, 1}}, {0.4f, {1, -1}}, {0.4f, {0.2, 0}}, {1, {0.8, 2}}});
  expect_normal(onion, {36855, 28658, 5835}, {28649, 36868, 5851}, "onion with slope_map");
  auto checker = normal(PatternKind::checker);
  checker->pattern.frequency = 0;
  expect_normal(checker, {32768, 32768, 0}, {32768, 32768, 0}, "checker 0.5");
}

TEST(NormalProbes, Maps) {
  auto wrinkles = normal(PatternKind::wrinkles);
  wrinkles->pattern.prepend(Transform::scaling({0.5, 0.5, 0.5}));
  auto map = normal(PatternKind::gradient);
  map->pattern.params = GradientParams{{1, 0, 0}};
  map->normal_map = std::make_shared<BlendMap<NormalPtr>>(
      BlendMap<NormalPtr>{{0.2f, normal(PatternKind::bumps, 0.8f)}, {0.7f, wrinkles}});
  map->pattern.prepend(Transform::scaling({2, 1, 1}));
  expect_normal(map, {34393, 37693, 5197}, {34428, 32309, 1723}, "normal_map");
  auto average = normal(PatternKind::average);
  average->normal_map = std::make_shared<BlendMap<NormalPtr>>(
      BlendMap<NormalPtr>{{1, normal(PatternKind::bumps, 0.8f)}, {2, normal(PatternKind::ripples)}});
  expect_normal(average, {30612, 33252, 2209}, {31090, 33578, 1864}, "average");
}

}  // namespace
}  // namespace verisim::textures
