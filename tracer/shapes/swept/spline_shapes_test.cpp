// Probes of spec 03 section 10 for lathe, sor, prism and sphere_sweep.
#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

using scene::SplineKind;
const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

ObjectRef lathe(SplineKind spline, std::vector<Vec2> points, const Steps& m = {}) {
  return make_shared_shape(scene::Lathe{spline, std::move(points)}, m);
}
ObjectRef sor(std::vector<Vec2> points, bool open = false, const Steps& m = {}) {
  return make_shared_shape(scene::Sor{std::move(points), open}, m);
}
ObjectRef prism(SplineKind spline, bool conic, double low, double high, std::vector<Vec2> points, const Steps& m = {}) {
  return make_shared_shape(scene::Prism{spline, conic, false, low, high, std::move(points)}, m);
}
ObjectRef sweep(SplineKind spline, std::vector<Vec3> centers, std::vector<double> radii, double tolerance = 1e-6,
                const Steps& m = {}) {
  return make_shared_shape(scene::SphereSweep{spline, std::move(centers), std::move(radii), tolerance}, m);
}

Vec2 uv_at(const ObjectRef& object, const Vec3& origin, const Vec3& direction) {
  const auto shape = compile(*object);
  Hit hit;
  EXPECT_TRUE(shape->intersect({origin, direction}, RayKind::camera, 1e-4, 1e7, hit));
  return shape->uv(hit);
}

TEST(Lathe, Traces) {
  expect_trace(lathe(SplineKind::cubic, {{0, -1}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0.2, 1.5}, {0, 2}}), {0.1, 0.3, -5}, z,
               {0.1, 0.3, -0.833101478358235}, {0.069178507997058, -0.814285775320598, -0.576327172829664},
               3e-9);  // POV-Ray's roots of degree 6 are good to 1e-9
  expect_trace(lathe(SplineKind::bezier, {{0.2, 0}, {1, 0.2}, {1, 1}, {0.3, 1.5}}), {0.1, 0.3, -5}, z,
               {0.1, 0.3, -0.686838274605244}, {0.115830408119518, -0.594689454777481, -0.795567576596312}, 3e-9);
}

TEST(Lathe, Distances) {
  // A level ray: the quartic is a square, of which only Sturm sequences find the roots.
  const std::vector<Vec2> bottle{{0, -1}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 1.5}};
  expect_march(lathe(SplineKind::quadratic, bottle), {0.1, 0.3, -5}, z, {});
  expect_march(lathe(SplineKind::quadratic, bottle, [](Object& o) { o.sturm = true; }), {0.1, 0.3, -5}, z,
               {4.2691572301, 5.7308427699}, 1e-9);
  // Nearly level: both hits become one.
  const Vec3 d{0.01, 9e-7, 1};
  expect_march(lathe(SplineKind::linear, {{0, 0}, {1, 0.5}, {0.5, 1}, {0, 1.5}}), Vec3(0.1, 0.3, 0) - 5.0 * d, d,
               {4.9992511237}, 1e-9);
  expect_march(lathe(SplineKind::quadratic, {{0.1, -1}, {0.6, 0}, {1.1, 0.7}, {0.5, 1.6}}), {0.8, 5, 0}, -y,
               {3.6961746315, 4.6840000000}, 1e-9);
  expect_march(lathe(SplineKind::bezier, {{0.1, -1}, {0.6, 0}, {1.1, 0.7}, {0.5, 1.6}}), {0.6, 5, 0}, -y,
               {3.5667576894, 4.9861421795}, 1e-9);
}

TEST(Lathe, Inside) {
  const auto spindle = lathe(SplineKind::linear, {{0, -1}, {1, 0}, {0, 1}});
  EXPECT_FALSE(inside(spindle, {0.2, 0, 0}));
  EXPECT_TRUE(inside(spindle, {0.2, 1e-9, 0}));
  const auto tube = lathe(SplineKind::linear, {{0.5, 0}, {0.5, 1}, {1, 1}, {1, 0}});
  EXPECT_TRUE(inside(tube, {0.7, 0.5, 0}));
  EXPECT_FALSE(inside(tube, {0.2, 0.5, 0}));
}

TEST(Lathe, Uv) {
  const Vec2 uv = uv_at(lathe(SplineKind::linear, {{1, 0}, {2, 1}, {1, 3}}), {0.5, 0.5, -5}, z);
  EXPECT_NEAR(uv.x, 0.80409, 1e-5);
  EXPECT_NEAR(uv.y, 0.25, 1e-9);
}

TEST(Lathe, SeparatesInsideFromOutside) {
  const Transform t = Transform::scaling({1.2, 0.7, 1.5}).then(Transform::rotation({20, 40, 60}));
  const Steps move = [&](Object& o) { scene::transform(o, t); };
  check_solid(lathe(SplineKind::linear, {{0, -1}, {1, -0.5}, {0.5, 0.5}, {0.8, 0.9}, {0, 1}}, move), {});
  check_solid(lathe(SplineKind::quadratic, {{-0.5, -1}, {0, -1}, {1, -0.2}, {0.5, 0.4}, {0, 1}}, move), {});
  check_solid(lathe(SplineKind::cubic, {{-0.5, -1}, {0, -1}, {1, -0.2}, {0.5, 0.4}, {0, 1}, {0, 1.5}}, move), {});
  check_solid(lathe(SplineKind::bezier, {{0, -1}, {1.5, -0.8}, {0.3, 0.4}, {0, 1}}, move), {});
}

TEST(Sor, Trace) {
  expect_trace(sor({{0.5, -1}, {0.5, 0}, {1, 0.5}, {0.4, 1}, {0.6, 1.5}, {0.6, 2}}), {0.1, 0.3, -5}, z,
               {0.1, 0.3, -0.869712596206355}, {0.073616459998199, -0.764629631181295, -0.640251625485551}, 1e-11);
}

// trace() of POV-Ray: the cubic that comes to the axis is -1e-12 at its extreme beside that point, and no ray finds it.
// With other numbers the extreme lies beyond the segment.
TEST(Sor, NoRayFindsASegmentWhoseExtremeIsBelowTheAxis) {
  const Vec3 from{0, 5, -0.3}, down{0, -1, 0};
  expect_trace(sor({{0, 0}, {1, 0}, {1, 1}, {0, 1.2}, {0, 2}, {0, 2}}), from, down, {0, 0, -0.3}, {0, -1, 0}, 1e-12);
  const auto hit = query::Target(sor({{0, 0}, {1, 0}, {1, 1}, {0, 1.3}, {0, 2}, {0, 2}})).trace(from, down);
  ASSERT_TRUE(hit);
  EXPECT_GT(hit->point.y, 1);
}

// A ray that comes to the wall 0.0003 behind its origin, as shadow rays do: the far side counts if it is of the same
// segment, and is lost with the near one if it is of the next.
TEST(SplineShapes, TheSearchEndsWithTheSegmentOfAHitThatIsTooNear) {
  scene::Lathe wall;
  wall.points = {{1, -1}, {1, 0}, {1, 1}, {1, 2}};
  const ObjectRef lathe = make_shared_shape(wall), vase = sor({{1, -2}, {1, -1}, {1, 0}, {1, 1}, {1, 2}, {1, 3}});
  for (const ObjectRef& object : {lathe, vase}) {
    const auto shape = shapes::compile(*object);
    for (const auto& [rise, found] : {std::pair{0.1, true}, {0.4, false}}) {
      const Ray ray{{-1.0003, 0.5, 0}, normalize(Vec3(1, rise, 0))};
      Hit hit;
      EXPECT_EQ(shape->intersect(ray, RayKind::shadow, 1e-3, 10, hit), found) << rise;
    }
  }
}

// Measured with trace() of POV-Ray, spec 08 F. The surface is hit at 4.1304 and 5.8700.
TEST(Sor, NearlyHorizontalRayHitsWherePovRaysCubicDoes) {
  const Vec3 d{0.01, 0.0009, 1}, origin = Vec3(0.1, 0.3, 0) - 5.0 * d;
  const ObjectRef object = sor({{0.5, -1}, {0.5, 0}, {1, 0.5}, {0.4, 1}, {0.6, 1.5}, {0.6, 2}});
  double t = 0;
  for (const double expected : {4.1595205854, 5.8403489746, 5.9076858465}) {
    const query::Target target(object);
    const auto hit = target.trace(origin + t * d, d);
    ASSERT_TRUE(hit);
    t = hit->point.z - origin.z;
    EXPECT_NEAR(t, expected, 2e-10);
    t += 1e-3;
  }
}

// The matrix of a thin segment has lost its digits: POV-Ray's radius at its foot is 1.776, not 1.2, and the base is as
// wide, but the box is not that of the cubic's ends (spec 08 F).
TEST(Sor, ThinSegmentsAreAsWideAsPovRaysMatrixMakesThem) {
  const ObjectRef object = sor({{1.2, 0}, {1.2, 2}, {1.2, 2.001}, {1.1, 2.002}, {0.6, 2.2}, {0.4, 2.5}});
  const auto radius_at = [&](double height) {
    const auto hit = query::Target(object).trace({50, height, 0}, {-1, 0, 0});
    return hit ? hit->point.x : 0;
  };
  EXPECT_DOUBLE_EQ(radius_at(2), 1.77603168055914296);
  EXPECT_DOUBLE_EQ(radius_at(2.0005), 1.78063284907380392);
  EXPECT_DOUBLE_EQ(radius_at(2.0015), 3.06812695861989937);
  EXPECT_TRUE(query::Target(object).trace({1.7, 0, 0}, {0, 1, 0}));
  expect_extent(object, {-1.781540989876, 2, -1.781540989876}, {1.781540989876, 2.200000047684, 1.781540989876});
}

// Nearly level rays see false roots, unless they leave the annulus within 1e-10 of their start: POV-Ray's results.
TEST(Sor, IsNotFoundFromItsOwnLargestRadius) {
  const auto target = query::Target(sor({{0, -1}, {0.5, -0.8}, {1, 0}, {0.3, 0.8}, {0.5, 1.2}}));
  const auto from = [&](const Vec3& origin, const Vec3& direction) {
    return target.trace(origin, normalize(direction));
  };
  const auto seen = from({0.61606878771496787, 0.040320604890734357, 0.7876923554303481},
                         {0.73974243476538493, -0.0015959694693995581, 0.67289013234508066});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(length(seen->point), 1.03243200660975387, 1e-9);
  EXPECT_FALSE(from({0.46005913715676322, 0.044756530187101511, -0.88788827580758978},
                    {-0.026919260108022536, -0.0024347864622888686, -0.99963761105474447}));
  EXPECT_FALSE(from({-0.72416596233786723, 0.014798394079748318, 0.6896257383460036},
                    {-0.97169641390540296, -0.0025811123497359294, 0.23623310352992388}));
}

TEST(Sor, Radii) {
  const auto object = sor({{0.2, -0.5}, {0.6, 0}, {1.1, 0.7}, {0.5, 1.6}, {0.4, 2.2}});
  for (const auto& [height, radius] :
       {std::pair{0.2, 0.791177768575}, {0.6, 1.088135084973}, {1.0, 0.986858025362}, {1.4, 0.650276836173}}) {
    const auto hits = march(object, {0, height + 1e-7, -5}, z);
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(5 - hits[0], radius, 1e-9);
  }
}

TEST(Sor, UvOfTheCap) {
  const Vec2 uv = uv_at(sor({{0, -1}, {1, 0}, {2, 1}, {1, 3}, {1, 4}}), {0.5, 5, 0.2}, -y);
  EXPECT_NEAR(uv.x, 0.06061, 1e-4);  // measured as a fraction of a picture
  EXPECT_NEAR(uv.y, 1.46140, 2e-4);
}

TEST(Sor, SeparatesInsideFromOutside) {
  const Transform t = Transform::scaling({1.2, 0.7, 1.5}).then(Transform::rotation({20, 40, 60}));
  check_solid(sor({{0.5, -2}, {0.5, -1}, {1, -0.3}, {0.4, 0.4}, {0.6, 1}, {0.6, 2}}, false,
                  [&](Object& o) { scene::transform(o, t); }),
              {});
}

TEST(Prism, Traces) {
  expect_trace(prism(SplineKind::cubic, false, 0, 1, {{-1, 1}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}),
               {0.1, 0.3, -5}, z, {0.1, 0.3, -1.248395885548638}, {0.032148323349134, 0, -0.999483109064800}, 1e-11);
  expect_trace(prism(SplineKind::linear, true, 0.5, 1, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}), {0.1, 0.7, -5},
               z, {0.1, 0.7, -0.7}, {0, -0.707106781186548, -0.707106781186547}, 1e-11);
}

TEST(Prism, Distances) {
  expect_march(prism(SplineKind::quadratic, false, 0, 1, {{1, -1}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}),
               {-5, 0.5, 0.5}, x, {3.7679491924, 6.1457513111}, 1e-9);
  const auto diamond = prism(SplineKind::linear, false, 0, 1, {{-1, 0}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  expect_march(diamond, {0, 5, 0}, -y, {});
  expect_march(diamond, {0, 5, 1e-9}, -y, {4, 5});
}

TEST(Prism, InsideIsOpenAtTheTop) {
  const auto square = prism(SplineKind::linear, false, 0, 1, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}});
  EXPECT_TRUE(inside(square, {0.1, 0, 0.2}));
  EXPECT_FALSE(inside(square, {0.1, 1, 0.2}));
}

// A point in an edge is inside where the outline lies to its left (-x), outside where it lies to its right.
TEST(Prism, InsideIsOpenOnTheLeft) {
  const auto triangle = prism(SplineKind::linear, false, -1, 0, {{0, 0}, {1, 0}, {1, 1}, {0, 0}});
  for (const double side : {0.25, 0.5, 0.75}) {
    EXPECT_FALSE(inside(triangle, {side, -0.5, side}));
    EXPECT_TRUE(inside(triangle, {1, -0.5, side}));
  }
  EXPECT_FALSE(inside(triangle, {0, -0.5, 0}));
}

TEST(Prism, SeveralOutlines) {
  const auto frame = prism(
      SplineKind::linear, false, 0, 1,
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}});
  expect_march(frame, {-5, 0.5, 0.1}, x, {4, 4.5, 5.5, 6});
  expect_march(frame, {0.1, 5, 0.2}, -y, {});
  expect_march(frame, {0.7, 5, 0.2}, -y, {4, 5});
}

TEST(Prism, SeparatesInsideFromOutside) {
  const Transform t = Transform::scaling({1.2, 0.7, 1.5}).then(Transform::rotation({20, 40, 60}));
  const Steps move = [&](Object& o) { scene::transform(o, t); };
  check_solid(prism(SplineKind::linear, false, -1, 1, {{-1, -1}, {1, -1}, {0.2, 0.1}, {-1, 1.1}, {-1, -1}}, move), {});
  check_solid(
      prism(SplineKind::cubic, false, -1, 1, {{-1, 1}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, move),
      {});
  check_solid(prism(SplineKind::quadratic, true, 0.2, 1, {{1, -1}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, move),
              {});
  check_solid(prism(SplineKind::bezier, true, -1, 0.5,
                    {{-1, 0}, {-1, 1.3}, {1, 1.3}, {1, 0}, {1, 0}, {1, -1.3}, {-1, -1.3}, {-1, 0}}, move),
              {});
}

TEST(SphereSweep, Traces) {
  expect_trace(sweep(SplineKind::linear, {Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(1, 2, 0)}, {0.5, 0.8, 0.3}),
               {0.1, 0.3, -5}, z, {0.1, 0.3, -0.602000076471432}, {-0.15, 0.440977443609023, -0.884894849249361},
               1e-10);
  const std::vector<Vec3> centers{Vec3(-2, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  const std::vector<double> radii{0.3, 0.5, 0.4, 0.6, 0.3};
  expect_trace(sweep(SplineKind::cubic, centers, radii, 1e-4), {0.1, 0.9, -5}, z, {0.1, 0.9, -0.416826696541788},
               {-0.241527683467031, -0.020681663966907, -0.970173513808025}, 1e-7);
  expect_trace(sweep(SplineKind::b_spline, centers, radii), {0.1, 0.6, -5}, z, {0.1, 0.6, -0.455403287796167},
               {-0.112856204719670, -0.098402269899589, -0.988726691424316}, 1e-7);
}

TEST(SphereSweep, Distances) {
  expect_march(sweep(SplineKind::linear, {Vec3(0), Vec3(1, 0, 0)}, {1, 3}), {0.3, 0.1, -5}, z,
               {2.0845240526, 7.9154759474}, 1e-9);
}

TEST(SphereSweep, InsideMissesShortSegments) {
  const auto object = sweep(SplineKind::linear, {Vec3(-0.1, 0, 0), Vec3(0.1, 0, 0)}, {1, 1});
  EXPECT_FALSE(inside(object, Vec3(0)));
  EXPECT_FALSE(inside(object, {0.8, 0, 0}));
  EXPECT_TRUE(inside(object, {0.95, 0, 0}));
}

TEST(SphereSweep, Boxes) {
  const std::vector<Vec3> c{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(2, 1, 0)};
  const std::vector<double> r{1, 0.5, 0.5, 0.5};
  expect_extent(sweep(SplineKind::cubic, c, r), Vec3(-2), {3, 2, 2});
  expect_extent(sweep(SplineKind::b_spline, c, r), Vec3(-1), {2.5, 1.5, 1});
  expect_extent(sweep(SplineKind::linear, {c[0], c[1]}, {1, 0.5}, 1e-6,
                      [](Object& o) {
                        scene::rotate(o, {0, 0, 45});
                      }),
                Vec3(-1), {1.207106828690, 1.207106828690, 1});
}

// Distance to the union of spheres along the curve, by brute force.
TEST(SphereSweep, HitsLieOnTheUnionOfItsSpheres) {
  const std::vector<Vec3> c{Vec3(-2, 0, 0), Vec3(-1, 0.3, 0), Vec3(0, 1, 0.5), Vec3(1, 0, 0), Vec3(2, 0, 0.5)};
  const std::vector<double> r{0.3, 0.5, 0.4, 0.6, 0.3};
  const auto distance = [&](const std::function<void(double, Vec3&, double&)>& curve) {
    return [=](const Vec3& p) {
      double least = 1e9;
      for (int i = 0; i <= 20000; ++i) {
        Vec3 center;
        double radius;
        curve(i / 20000.0, center, radius);
        least = std::min(least, length(p - center) - radius);
      }
      return least;
    };
  };
  const auto linear = [&](double s, Vec3& center, double& radius) {
    const double k = std::min(s * 4, 3.999999999);
    const auto i = static_cast<std::size_t>(k);
    center = c[i] + (k - static_cast<double>(i)) * (c[i + 1] - c[i]),
    radius = r[i] + (k - static_cast<double>(i)) * (r[i + 1] - r[i]);
  };
  check_solid(sweep(SplineKind::linear, c, r), {distance(linear), 1e-4, false, 150});
  const auto b_spline = [&](double s, Vec3& center, double& radius) {
    const double k = std::min(s * 2, 1.999999999);
    const auto i = static_cast<std::size_t>(k);
    const double u = k - static_cast<double>(i);
    const double w[4] = {(1 - u) * (1 - u) * (1 - u) / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
                         (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6, u * u * u / 6};
    center = Vec3(0), radius = 0;
    for (std::size_t j = 0; j < 4; ++j) center += w[j] * c[i + j], radius += w[j] * r[i + j];
  };
  // Both ends of each chord count, as in POV-Ray (spec 08 F): some hits are inside, none is outside.
  const auto outside = [from = distance(b_spline)](const Vec3& p) { return std::max(0.0, from(p)); };
  check_solid(sweep(SplineKind::b_spline, c, r), {outside, 1e-4, false, 150});
}

TEST(SphereSweep, ManySegmentsEqualAUnionOfSpheresAndCones) {
  std::vector<Vec3> c;
  std::vector<double> r;
  for (int i = 0; i < 60; ++i) {
    c.emplace_back(std::cos(i * 0.3), i * 0.03 - 1, std::sin(i * 0.3));
    r.push_back(0.12);
  }
  check_solid(sweep(SplineKind::linear, c, r), {[&](const Vec3& p) {
                                                  double least = 1e9;
                                                  for (std::size_t i = 0; i + 1 < c.size(); ++i) {
                                                    const Vec3 d = c[i + 1] - c[i];
                                                    const double u = std::clamp(dot(p - c[i], d) / dot(d, d), 0.0, 1.0);
                                                    least = std::min(least, length(p - c[i] - u * d) - 0.12);
                                                  }
                                                  return least;
                                                },
                                                1e-6, false, 500});
}

TEST(SplineShapes, SurviveDegenerateNumbers) {
  for (const double bad : {0.0, -1.0, 1e30, HUGE_VAL, std::nan("")}) {
    const Vec2 b(bad, bad);
    for (const auto& object :
         {lathe(SplineKind::linear, {b, {1, 0}, {0, 1}}), lathe(SplineKind::cubic, {b, {1, 0}, {0, 1}, b}),
          lathe(SplineKind::bezier, {b, b, b, b}), sor({b, {1, 0}, {1, 1}, b}), sor({{1, 0}}),
          prism(SplineKind::linear, true, bad, 1, {b, {1, 0}, {0, 1}, b}),
          prism(SplineKind::bezier, false, 0, 1, {b, b, b, b}),
          sweep(SplineKind::linear, {Vec3(bad), Vec3(bad)}, {1, 1}),
          sweep(SplineKind::b_spline, {x, y, z, Vec3(bad)}, {1, bad, 1, bad}), sweep(SplineKind::linear, {}, {}),
          lathe(SplineKind::linear, {}), prism(SplineKind::cubic, false, 0, 1, {})})
      ask_everything(object);
  }
}

}  // namespace
}  // namespace verisim::shapes::testing
