// Probes of spec 03 section 10 for the blob.
#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

const Vec3 x{1, 0, 0}, z{0, 0, 1};

scene::BlobComponent ball(const Vec3& c, double r, double s, scene::Rare<Transform> t = {}) {
  return {c, c, r, s, false, t, nullptr};
}
scene::BlobComponent capsule(const Vec3& a, const Vec3& b, double r, double s, scene::Rare<Transform> t = {}) {
  return {a, b, r, s, true, t, nullptr};
}
ObjectRef blob(double threshold, std::vector<scene::BlobComponent> c, const Steps& m = {}) {
  return make_shared_shape(scene::Blob{threshold, std::move(c)}, m);
}

TEST(Blob, Traces) {
  expect_trace(blob(0.6, {ball({-0.5, 0, 0}, 1, 1), ball({0.6, 0.1, 0}, 1.2, 0.8)}), {0.1, 0.2, -5}, z,
               {0.1, 0.2, -0.396234117215307}, {0.188967389506592, 0.353491446154590, -0.916152347155538}, 1e-10);
  const auto rod = blob(0.3, {capsule({-1, 0, 0}, {1, 0.5, 0}, 0.5, 1)});
  expect_trace(rod, {0.1, 0.1, -5}, z, {0.1, 0.1, -0.290251324221565},
               {0.122455036038557, -0.489820144154229, -0.863180740360631}, 1e-10);
  expect_extent(rod, {-1.709503173828125, -1.375675916671753, -1.625675916671753},
                {1.709503173828125, 1.875675916671753, 1.625675916671753});
  expect_trace(blob(0.5, {ball(Vec3(0), 2, 1.5), ball({0, 0, -0.5}, 1, -1.2)}), {0.1, 0.2, -5}, z,
               {0.1, 0.2, -0.230443071676742}, {-0.172386001415982, -0.344772002831964, -0.922721698335443}, 1e-9);
  const Transform t =
      Transform::scaling({1, 0.5, 2}).then(Transform::rotation({0, 0, 30})).then(Transform::translation(x));
  expect_trace(blob(0.4, {ball(Vec3(0), 1, 1, t)}), {1.1, 0.1, -5}, z, {1.1, 0.1, -1.172220508402506},
               {0.127055467517343, 0.549670335148190, -0.825663024987813}, 1e-9);
}

TEST(Blob, Distances) {
  expect_march(blob(0.6, {ball(Vec3(0), 1, 1), ball({1.5, 0, 0}, 1, 1)}), {-5, 0.1, 0.1}, x,
               {4.5467855576, 5.4532144424, 6.0467855576, 6.9532144424}, 1e-9);
}

TEST(Blob, Boxes) {
  const Transform t = Transform::scaling({1, 2, 3}).then(Transform::rotation({0, 0, 30}));
  expect_extent(blob(0.5, {ball(Vec3(0), 1, 1, t)},
                     [](Object& o) {
                       scene::rotate(o, {0, 20, 0}), scene::rotate(o, {20, 0, 0});
                     }),
                {-3.845138311386, -4.134192466736, -4.639308452606}, {3.845138311386, 4.134192466736, 4.639308452606});
  expect_extent(
      blob(0.5, {ball(Vec3(0), 1, 1), capsule(Vec3(0), x, 0.5, 1, Transform::scaling(Vec3(2))), ball(Vec3(4), 1, -1)}),
      {-1, -1.414213538170, -1.414213538170}, {3, 1.414213538170, 1.414213538170});
}

double field(const scene::BlobComponent& c, const Vec3& p) {
  Vec3 d = p - c.a;
  if (c.cylinder) {
    const Vec3 axis = c.b - c.a;
    d -= axis * std::clamp(dot(d, axis) / dot(axis, axis), 0.0, 1.0);
  }
  const double q = 1 - dot(d, d) / (c.radius * c.radius);
  return q > 0 ? c.strength * q * q : 0;
}

// Roots of rays that graze the surface are only as good as the closed form that POV-Ray takes.
constexpr double kClosedForm = 1e-4;

// An empty box that is turned round holds everything.
TEST(Blob, BoxWithoutPositiveComponents) {
  const std::vector<scene::BlobComponent> hole{ball(Vec3(0), 1, -0.5)};
  expect_extent(blob(0.5, hole), Vec3(2e10), Vec3(-2e10));
  expect_extent(blob(0.5, hole, [](Object& o) { scene::rotate(o, {30, 0, 0}); }), Vec3(-1e10), Vec3(1e10));
}

TEST(Blob, HitsLieOnTheSurface) {
  const std::vector<scene::BlobComponent> c{ball({-0.5, 0, 0}, 1, 1), ball({0.6, 0.1, 0}, 1.2, 0.8),
                                            capsule({0, -1, 0}, {0.3, 1, 0.2}, 0.6, 0.9), ball({0, 0, 0.3}, 0.5, -0.5)};
  check_solid(blob(0.5, c), {[&](const Vec3& p) {
                               double sum = -0.5;
                               for (const auto& component : c) sum += field(component, p);
                               return sum;
                             },
                             kClosedForm});
}

TEST(Blob, ManyComponentsEqualFewSearchedOneByOne) {
  struct Cloud {
    int count;
    double radius, threshold;
  };
  // A ray meets some ten of the first, which are put in order section by section, and all of the second.
  for (const Cloud& cloud : {Cloud{200, 0.4, 0.6}, Cloud{300, 2.5, 60}}) {
    std::vector<scene::BlobComponent> c;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> u(-1.5, 1.5);
    for (int i = 0; i < cloud.count; ++i) c.push_back(ball({u(random), u(random), u(random)}, cloud.radius, 1));
    check_solid(blob(cloud.threshold, c), {[&](const Vec3& p) {
                                             double sum = -cloud.threshold;
                                             for (const auto& component : c) sum += field(component, p);
                                             return sum;
                                           },
                                           kClosedForm, true, 300});
  }
}

TEST(Blob, SharesOfTexturesFollowTheFields) {
  auto components = std::vector<scene::BlobComponent>{ball({-0.5, 0, 0}, 1, 1), ball({0.6, 0.1, 0}, 1.2, 0.8)};
  components[0].texture = components[1].texture = std::make_shared<scene::Texture>();
  const auto object = blob(0.4, components);
  const auto shape = compile(*object);
  EXPECT_EQ(shape->extra_textures().size(), 2u);
  Hit hit;
  ASSERT_TRUE(shape->intersect({{0.1, 0.2, -5}, z}, RayKind::camera, 1e-4, 1e7, hit));
  std::vector<TextureShare> shares;
  shape->texture_shares(hit, false, shares);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_EQ(shares[0].texture, 1);                    // from right to left (spec 08 N)
  EXPECT_NEAR(shares[0].weight, 194 / 255.0, 0.003);  // the colours of spec 03 10.7
  EXPECT_NEAR(shares[1].weight, 61 / 255.0, 0.003);
}

TEST(Blob, SurvivesDegenerateNumbers) {
  for (const double bad : {0.0, -1.0, 1e30, HUGE_VAL, std::nan("")}) {
    for (const auto& object :
         {blob(0.5, {ball(Vec3(bad), 1, 1)}), blob(0.5, {ball(Vec3(0), bad, 1)}), blob(bad, {ball(Vec3(0), 1, 1)}),
          blob(0.5, {ball(Vec3(0), 1, bad), capsule(Vec3(0), x, bad, 1)}), blob(0.5, {})})
      ask_everything(object);
  }
}

}  // namespace
}  // namespace verisim::shapes::testing
