// Probes of spec 03 section 10 for the torus.
#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

const Vec3 y{0, 1, 0}, z{0, 0, 1};
ObjectRef torus(double major, double minor, bool sturm = false) {
  return make(scene::Torus{major, minor}, [&](Object& o) { o.sturm = sturm; });
}

TEST(Torus, Traces) {
  expect_trace(torus(2, 0.5), {0.3, 0.2, -5}, z, {0.3, 0.2, -2.439883250891807},
               {0.111849362373272, 0.399999999999995, -0.909664619591582}, 1e-11);
  expect_trace(torus(0.5, 1), {0.1, 0.1, 0}, z, {0.1, 0.1, 0.484780943203608},
               {-0.010113948619071, 0.998746073110333, -0.049030495510660}, 1e-11);
}

TEST(Torus, Distances) {
  expect_march(torus(2, 0.5), {0.3, 0.2, -5}, z, {2.5601167491, 3.4877269684, 6.5122730316, 7.4398832509}, 1e-9);
  expect_march(torus(2, 0.5, true), {0.3, 0.2, -5}, z, {2.5601167491, 3.4877269684, 6.5122730316, 7.4398832424}, 2e-8);
  expect_march(torus(0.5, 1), {0.1, 0.1, -5}, z, {3.5083608221, 4.5152190568, 5.4847809432, 6.4916391779}, 1e-9);
}

TEST(Torus, AxisOfASpindle) {
  expect_march(torus(0.5, 1), {0, 5, 0}, -y, {4.1339745876}, 5e-8);
  // A double root: POV-Ray itself is 4e-8 off the true 4.1339745962.
  expect_march(torus(0.5, 1, true), {0, 5, 0}, -y, {4.1339745557, 5.8660254437}, 5e-7);
}

TEST(Torus, Inside) {
  EXPECT_TRUE(inside(torus(0.5, 1), Vec3(0)));
  EXPECT_TRUE(inside(torus(0.5, 1), {0, 0.8, 0}));
  EXPECT_FALSE(inside(torus(0.5, 1), {0, 0.9, 0}));
}

TEST(Torus, Uv) { expect_uv(torus(2, 0.5), {0.3, 0.2, -5}, z, {0.73053, 0.56550}); }

TEST(Torus, HitsLieOnTheSurface) {
  const Transform t = Transform::scaling({1.2, 0.7, 1.5}).then(Transform::rotation({20, 40, 60}));
  for (const bool sturm : {false, true}) {
    const auto object = make(scene::Torus{1, 0.35}, [&](Object& o) {
      o.sturm = sturm;
      scene::transform(o, t);
    });
    check_solid(object, {[&](const Vec3& p) {
                           const Vec3 q = t.inverse_point(p);
                           return std::hypot(std::hypot(q.x, q.z) - 1, q.y) - 0.35;
                         },
                         1e-6});
  }
}

TEST(Torus, SurvivesDegenerateNumbers) {
  for (const double bad : {0.0, -1.0, 1e30, HUGE_VAL, std::nan("")}) {
    for (const auto& object : {torus(bad, 1), torus(1, bad), torus(bad, bad, true)}) {
      HitList hits;
      compile(*object)->intersect_all({{0.1, 0.2, -5}, z}, RayKind::camera, hits);
      EXPECT_LE(hits.size(), 4u);
    }
  }
}

}  // namespace
}  // namespace verisim::shapes::testing
