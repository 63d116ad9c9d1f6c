// Probes of spec 03 section 10 for sphere, box, cone, cylinder, plane, disc, triangle.
#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

ObjectRef sphere(const Vec3& c, double r, const Steps& m = {}) { return make(scene::Sphere{c, r}, m); }
ObjectRef box(const Vec3& a, const Vec3& b, const Steps& m = {}) { return make(scene::Box{a, b}, m); }
ObjectRef cone(const Vec3& a, double ra, const Vec3& b, double rb, bool open = false) {
  return make(scene::Cone{a, b, ra, rb, open});
}

TEST(Sphere, ScaledAndRotated) {
  expect_trace(sphere(Vec3(0), 1,
                      [](Object& o) {
                        scene::scale(o, {1, 2, 3});
                      }),
               {0.3, 0.2, -5}, z, {0.3, 0.2, -2.846049894151541},
               {0.683763458757828, 0.113960576459638, -0.720749970156447});
  expect_trace(sphere(Vec3(0), 1,
                      [](Object& o) {
                        scene::scale(o, {1, 2, 1}), scene::rotate(o, {0, 0, 30});
                      }),
               {0.1, 0.2, -4}, {0.01, 0.02, 1}, {0.130333538892606, 0.260667077785212, -0.966646110739404},
               {0.191012421855368, 0.156748280633191, -0.968991347337779});
}

TEST(Sphere, GrazingRays) {
  expect_march(sphere(Vec3(0), 1), {-5, 1 - 1e-11, 0}, x, {});
  expect_march(sphere(Vec3(0), 1), {-5, 1 - 1e-10, 0}, x, {4.9999858579},
               1e-9);  // the exit is closer than the smallest distance
}

TEST(Sphere, LimitsOfDistance) {
  EXPECT_TRUE(march(sphere(Vec3(0), 1.1e7), Vec3(0), z).empty());
  EXPECT_TRUE(march(sphere(Vec3(0), 1, [](Object& o) { scene::scale(o, Vec3(1.1e7)); }), Vec3(0), z).empty());
  EXPECT_EQ(
      march(sphere(Vec3(0), 1, [](Object& o) { scene::transform(o, Transform::scaling(Vec3(1.1e7))); }), Vec3(0), z)
          .size(),
      1u);
  EXPECT_TRUE(march(sphere(Vec3(0), 0.9e-5), {0, 0, -1}, z).empty());
}

TEST(Sphere, Uv) { expect_uv(sphere(Vec3(0), 1), {0.3, 0.2, -3}, z, {0.79953, 0.56410}); }

TEST(Box, Rotated) {
  const auto object = box(Vec3(-1), Vec3(1), [](Object& o) {
    scene::rotate(o, {0, 0, 45}), scene::rotate(o, {30, 0, 0});
  });
  expect_trace(object, {0.1, 0.2, -5}, {0, 0.1, 1}, {0.1, 0.620345617062223, -0.796543829377773},
               {0, 0.5, -0.866025403784439});
  expect_extent(object, {-1.414213538169861, -1.724744915962219, -1.573132157325745},
                {1.414213538169861, 1.724744915962219, 1.573132157325745});
}

TEST(Box, FacesAtEdgesAndCorners) {
  const auto object = box(Vec3(-1), Vec3(1));
  const query::Target target(object);
  EXPECT_EQ(target.trace({-4, -4, -4}, {1, 1, 1})->normal, -x);
  EXPECT_EQ(target.trace({-4, -4, 0.2}, {1, 1, 0})->normal, -x);
  EXPECT_EQ(target.trace({-3, -5, 0.2}, {1, 2, 0})->normal, -y);
}

TEST(Box, Uv) { expect_uv(box(Vec3(-1), Vec3(1)), {0.3, 0.2, -3}, z, {0.83750, 0.53333}); }

TEST(Cone, Traces) {
  expect_trace(cone(Vec3(0), 1, 2.0 * y, 0), {0.1, 0.5, -5}, z, {0.1, 0.5, -0.743303437365924},
               {0.119256958799989, 0.447213595499958, -0.886441074058382});
  expect_trace(cone(Vec3(0), 1, 2.0 * y, -0.5), {0.1, 1, -5}, z, {0.1, 1, -0.229128784747789},
               {0.320000000000002, 0.600000000000005, -0.733212111192930});
  expect_march(cone(Vec3(0), 1, 2.0 * y, -0.5), {0.3, -5, 0}, y, {5, 5.9333333333, 6.7333333333, 7});
}

TEST(Cylinder, Trace) {
  const auto object = cone({1, 2, 3}, 0.5, {3, 3, 5}, 0.5);
  expect_trace(object, {2, 2.5, -5}, z, {2, 2.5, 3.329179606750062},
               {0.596284793999944, 0.298142396999972, -0.745355992499930});
  expect_extent(object, {0.5, 1.333333373069763, 2.5}, {3.5, 3.666666507720947, 5.5});
}

TEST(Cone, InsideOfClosedIsSmallerThanOpen) {
  EXPECT_FALSE(inside(cone(Vec3(0), 1, 2.0 * y, 0), {0.1, 0, 0.2}));
  EXPECT_TRUE(inside(cone(Vec3(0), 1, 2.0 * y, 0, true), {0.1, 0, 0.2}));
}

TEST(Plane, ScaledRotatedTranslated) {
  const auto object = make(scene::Plane{normalize(Vec3(1, 1, 0)), 3}, [](Object& o) {
    scene::scale(o, {1, 2, 1}), scene::rotate(o, {0, 0, 20}), scene::translate(o, x);
  });
  expect_trace(object, {9, 9, 0}, {-1, -1, 0}, {3.170621870775541, 3.170621870775541, 0},
               {0.687530573182806, 0.726155431666611, 0});
}

TEST(Plane, Inside) {
  const auto object = make(scene::Plane{y, 3});
  EXPECT_TRUE(inside(object, {0, 3, 0}));
  EXPECT_TRUE(inside(object, {0, 3 + 5e-11, 0}));
  EXPECT_FALSE(inside(object, {0, 3 + 2e-10, 0}));
}

TEST(Disc, BoxAndInside) {
  expect_extent(make(scene::Disc{{1, 2, 3}, {1, 1, 0}, 1}), {-0.000707106839400, 0.999292910099030, 1.585786461830139},
                {2.000707149505615, 3.000707149505615, 4.414213657379150});
  const auto object = make(scene::Disc{Vec3(0), y, 2, 1});
  EXPECT_TRUE(inside(object, {0, -1, 0}));
  EXPECT_FALSE(inside(object, {0, 1, 0}));
  EXPECT_FALSE(inside(object, {9, 0, 0}));
}

TEST(Triangle, OrientationFlipsAtTheFirstTransformation) {
  const scene::Triangle t{{Vec3(1, -1, 0), Vec3(-1, -1, 0), Vec3(0, 1, 1)}};
  const Vec3 point{0, 0, 0.5}, normal{0, -0.447213595499958, 0.894427190999916};
  expect_trace(make(t), {0, 0, -5}, z, point, normal);
  expect_trace(make(t, [](Object& o) { scene::translate(o, Vec3(0)); }), {0, 0, -5}, z, point, -normal);
}

TEST(SmoothTriangle, NormalsUnderScaleAndMatrix) {
  const scene::SmoothTriangle t{
      {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)},
      {normalize(Vec3(-0.3, -0.2, -1)), normalize(Vec3(0.4, -0.1, -1)), normalize(Vec3(0, 0.5, -1))}};
  const auto normal = [](const ObjectRef& object) { return query::Target(object).trace({0.1, 0.2, -5}, z)->normal; };
  expect_near(normal(make(t)), {0.053557204951260, 0.231886499846635, -0.971267356080027}, 1e-12);
  expect_near(normal(make(t,
                          [](Object& o) {
                            scene::scale(o, {1, 1, 2});
                          })),
              {0.099623644501811, 0.412961970514827, -0.905283127184357}, 1e-12);
  expect_near(normal(make(t,
                          [](Object& o) {
                            scene::transform(o, Transform::scaling({1, 1, 2}));
                          })),
              {0.099030727877706, 0.428773101317071, -0.897968007516389}, 1e-12);
}

TEST(SimpleShapes, HitsLieOnSurfacesAndSeparateInsideFromOutside) {
  const Transform t = Transform::scaling({1.2, 0.7, 1.5})
                          .then(Transform::rotation({20, 40, 60}))
                          .then(Transform::translation({0.1, 0.2, -0.1}));
  const Steps move = [&](Object& o) { scene::transform(o, t); };
  check_solid(sphere(Vec3(0), 1, move), {[&](const Vec3& p) { return length(t.inverse_point(p)) - 1; }, 1e-9});
  check_solid(box(Vec3(-1), Vec3(1), move), {[&](const Vec3& p) {
                                               const Vec3 q = t.inverse_point(p);
                                               return std::max({std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)}) - 1;
                                             },
                                             1e-9});
  const auto cylinder = make(scene::Cone{-y, y, 1, 1}, move);
  check_solid(cylinder, {[&](const Vec3& p) {
                           const Vec3 q = t.inverse_point(p);
                           return std::max(std::hypot(q.x, q.z), std::fabs(q.y)) - 1;
                         },
                         1e-9});
  check_solid(make(scene::Cone{-y, y, 1, 0.3}, move), {{}, 1e-9});
}

TEST(SimpleShapes, SurviveDegenerateNumbers) {
  const double inf = HUGE_VAL, nan = std::nan("");
  for (const double bad : {0.0, inf, nan, 1e30, -1e30}) {
    const std::vector<ObjectRef> objects{sphere(Vec3(bad), 1),
                                         sphere(Vec3(0), bad),
                                         box(Vec3(bad), Vec3(1)),
                                         cone(Vec3(0), bad, y, 1),
                                         make(scene::Plane{y, bad}),
                                         make(scene::Disc{Vec3(bad), y, 1}),
                                         make(scene::Disc{Vec3(0), Vec3(bad), 1}),
                                         make(scene::Triangle{{Vec3(bad), x, y}})};
    for (const ObjectRef& object : objects) {
      const auto shape = compile(*object);
      HitList hits;
      shape->intersect_all({{0.1, 0.2, -5}, z}, RayKind::camera, hits);
      EXPECT_LE(hits.size(), 4u);
      shape->inside({0.1, 0.2, 0.3});
    }
  }
}

}  // namespace
}  // namespace verisim::shapes::testing
