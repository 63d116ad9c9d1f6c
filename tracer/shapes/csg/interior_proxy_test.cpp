#include "tracer/shapes/csg/interior_proxy.h"

#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

struct ProxyCase {
  const char* name;
  ObjectRef object;
};

std::vector<ProxyCase> cases() {
  const auto turn = [](Object& o) {
    scene::transform(o, Transform::scaling({1.5, 0.4, 1}));
    scene::rotate(o, {20, 130, -50});
    scene::translate(o, {0.3, -0.2, 0.5});
  };
  const scene::Sphere sphere{{0.1, 0.2, -0.1}, 1.1};
  const scene::Box box{{-1, -0.7, -1.1}, {0.8, 0.9, 1}};
  const scene::Cone cone{{0, -1, 0}, {0.2, 1, 0.1}, 1.2, 0.3}, cylinder{{-1, 0, 0}, {1, 0.1, 0}, 0.8, 0.8, true};
  return {{"ball", make(sphere)},      {"ellipsoid", make(sphere, turn)},
          {"box", make(box)},          {"turned box", make(box, turn)},
          {"cone", make(cone)},        {"turned cone", make(cone, turn)},
          {"cylinder", make(cylinder)}};
}

TEST(InteriorProxy, HoldsOnlyRaysThatDoNotMeetTheShape) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
  for (const ProxyCase& c : cases()) {
    const auto proxy = InteriorProxy::of(*c.object);
    ASSERT_TRUE(proxy) << c.name;
    const auto shape = compile(*c.object);
    int held = 0, inside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3 from = point(), to = point();
      const Ray ray{from, normalize(to - from)};
      const double far = length(to - from);
      EXPECT_EQ(proxy->holds(ray, 0, far), proxy->holds(from) && proxy->holds(to)) << c.name;
      inside += shape->inside(from) && shape->inside(to);
      if (!proxy->holds(ray, 0, far)) continue;
      ++held;
      Hit hit;
      EXPECT_FALSE(shape->intersect(ray, RayKind::query, 0, far, hit)) << c.name;
      EXPECT_TRUE(shape->inside(from) && shape->inside(to)) << c.name;
    }
    // The room is hardly smaller than the shape.
    EXPECT_GT(held, 100) << c.name;
    EXPECT_GT(held, inside - 5) << c.name;
  }
}

TEST(InteriorProxy, NumbersThatAreNoneAreHeldByNothing) {
  for (const ProxyCase& c : cases())
    EXPECT_FALSE(InteriorProxy::of(*c.object)->holds(Ray{{0, 0, 0}, {0, 0, 1}}, 0, HUGE_VAL)) << c.name;
}

TEST(InteriorProxy, ClippedShapesHaveNoRoom) {
  const auto clipped = make(scene::Sphere{Vec3(0), 1}, [](Object& o) {
    o.clipped_by.push_back(make(scene::Plane{{0, 1, 0}, 0}));
  });
  EXPECT_FALSE(InteriorProxy::of(*clipped));
}

}  // namespace
}  // namespace verisim::shapes::testing
