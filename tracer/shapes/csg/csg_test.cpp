// Probes of spec 03 section 10 for CSG, clips and boxes.
#include <filesystem>

#include "tracer/shapes/factories.h"
#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

const ObjectRef A = make(scene::Box{Vec3(-1), Vec3(1)});
const ObjectRef B = make(scene::Sphere{{0.5, 0, 0}, 0.8});
const ObjectRef B_moved = make(scene::Sphere{{1.2, 0, 0}, 0.8});
const Vec3 from{-5, 0.1, 0.2};

TEST(Csg, Distances) {
  expect_march(make_union({A, B}), from, x, {4, 4.7318854252, 6, 6.2681145748});
  expect_march(make_merge({A, B_moved}), from, x, {4, 6.9681145748});
  expect_march(make_intersection({A, B}), from, x, {4.7318854252, 6});
  expect_march(make_difference({A, B}), from, x, {4, 4.7318854252});
  expect_march(make_union({A, B_moved}, [](Object& o) { scene::invert(o); }), from, x, {4, 6.9681145748});
}

// A text is a union of letters, twice inverted a merge: its flags count in intersections (spec 03 5.5).
TEST(Csg, FlagsOfTexts) {
  const std::string font = "/usr/share/povray-3.7/include/timrom.ttf";
  if (!std::filesystem::exists(font)) GTEST_SKIP() << "no fonts";
  scene::Text text;
  text.font = font, text.text = u"I", text.thickness = 1;
  const auto hits = [&](bool inverted_twice, RayKind kind) {
    const ObjectRef letter = make_shared_shape(text);
    letter->no_image = letter->no_reflection = true;
    for (int i = 0; i < (inverted_twice ? 2 : 0); ++i) scene::invert(*letter);
    HitList found;
    compile(*make_difference({letter}))->intersect_all({{.17, .3, -2}, z}, kind, found);
    return found.size();
  };
  EXPECT_EQ(hits(false, RayKind::camera), 2u);
  EXPECT_EQ(hits(false, RayKind::reflected), 0u);
  EXPECT_EQ(hits(false, RayKind::refracted), 0u);
  EXPECT_EQ(hits(true, RayKind::camera), 0u);
  EXPECT_EQ(hits(true, RayKind::shadow), 2u);
}

TEST(Csg, Boxes) {
  expect_extent(make_intersection({A, B}), {-0.300000011920929, -0.800000011920929, -0.800000011920929},
                {0.999999940395355, 0.800000011920929, 0.800000011920929});
  expect_extent(make_union({A},
                           [](Object& o) {
                             scene::rotate(o, {0, 45, 0}), scene::rotate(o, {0, -45, 0});
                           }),
                {-2, -1, -2}, {2, 1, 2});
  expect_extent(make_intersection({A, make(scene::Box{Vec3(2), Vec3(3)})}), Vec3(-1e10), Vec3(1e10));
  const auto light = make(scene::LightSource{});
  expect_extent(make_union({make(scene::Sphere{Vec3(0), 1}), light}), Vec3(-1e10), Vec3(1e10));
  const auto clip = make(scene::Box{{-0.5, -1, -2}, {0.7, 1, 0}});
  expect_extent(make(scene::Sphere{Vec3(0), 1}, [&](Object& o) { o.clipped_by.push_back(clip); }), {-0.5, -1, -2},
                {0.700000047683716, 1, 0});
}

TEST(Csg, WrongBoxOfAScaledPlane) {
  const auto plane = make(scene::Plane{y, 1}, [](Object& o) { scene::transform(o, Transform::scaling(Vec3(3))); });
  const auto object = make_intersection({make(scene::Box{Vec3(-5), Vec3(5)}), plane});
  EXPECT_FLOAT_EQ(object->bounds.low[1], -5);
  EXPECT_FLOAT_EQ(object->bounds.low[1] + object->bounds.size[1], -1);
  EXPECT_TRUE(march(object, {-9, 2.5, 0}, x).empty());
  expect_march(object, {0, 9, 0}, -y, {6, 14});
}

TEST(Csg, WrongBoxesOfQuadrics) {
  const auto clip = make(scene::Box{{-9, -1, -9}, {9, 2, 9}});
  const auto hyperboloid =
      make(scene::Quadric{{1, -1, 1}, Vec3(0), Vec3(0), -4}, [&](Object& o) { o.clipped_by.push_back(clip); });
  expect_extent(hyperboloid, {-2.236068010330200, -1, -2.236068010330200}, {2.236068010330200, 2, 2.236068010330200});

  const auto paraboloid = make(scene::Quadric{{1, 0, 1}, Vec3(0), {0, -2, 0}, -3});
  expect_march(paraboloid, {-20, 0, 0}, x, {18.2679491924, 21.7320508076});
  const auto cut = make_intersection({paraboloid, make(scene::Plane{y, 5})});
  expect_extent(cut, {-2.645751237869263, 1.5, -2.645751237869263}, {2.645751237869263, 5, 2.645751237869263});
  EXPECT_TRUE(march(cut, {-20, 0, 0}, x).empty());
}

TEST(Csg, SubtractingAPatchRemovesTheBody) {
  const auto triangle = make(scene::Triangle{{Vec3(-0.5, -1, 0), Vec3(0.5, -1, 0), Vec3(0, 1, 0)}});
  const auto object = make_difference({A, triangle});
  expect_march(object, {0, 0, -5}, z, {5});
  EXPECT_TRUE(march(object, {0.7, 0, -5}, z).empty());
}

TEST(Csg, SubtractingADiscRemovesItsHalfSpace) {
  const auto object = make_difference({A, make(scene::Disc{{0, 0, 0.5}, z, 0.5})});
  expect_march(object, {0, 0, -5}, z, {5.5, 6});
  expect_march(object, {0.7, 0, -5}, z, {6});
}

TEST(Csg, ClippedCutterRemovesWhatItsClipExcludes) {
  const auto cutter = make(scene::Sphere{{0, 0, -1}, 0.8}, [&](Object& o) {
    o.clipped_by.push_back(make(scene::Plane{x, 0}));
  });
  const auto object = make_difference({A, cutter});
  EXPECT_TRUE(march(object, {0.5, 0.03, -5}, z).empty());
  EXPECT_FALSE(march(object, {-0.5, 0.03, -5}, z).empty());
}

TEST(Csg, ManyChildren) {
  std::vector<ObjectRef> balls;
  for (int i = 0; i < 100; ++i) balls.push_back(make(scene::Sphere{{i % 10 * 1.0, i / 10 * 1.0, 0}, 0.3}));
  const auto cluster = make_union(balls);
  const auto slab = make(scene::Box{{-1, -1, -0.1}, {10, 10, 0.1}});
  const auto sieve = make_difference({slab, cluster});
  for (int i = 0; i < 100; ++i) {
    const Vec3 c{i % 10 * 1.0, i / 10 * 1.0, -5};
    EXPECT_EQ(march(cluster, c, z).size(), 2u);
    EXPECT_TRUE(march(sieve, c, z).empty());
    EXPECT_EQ(march(sieve, c + Vec3(0.5, 0.5, 0), z).size(), 2u);
    EXPECT_TRUE(inside(cluster, c + Vec3(0.1, 0, 5)));
    EXPECT_FALSE(inside(sieve, c + Vec3(0.1, 0, 5)));
    EXPECT_TRUE(inside(sieve, c + Vec3(0.5, 0, 5)));
  }
}

TEST(Csg, CopiesAreIndependent) {
  const auto original = make_union({A, B});
  const auto moved = scene::copy(*original);
  scene::translate(*moved, {10, 0, 0});
  EXPECT_EQ(march(original, from, x).size(), 4u);
  EXPECT_NEAR(march(moved, from, x).front(), 14, 1e-12);
}

}  // namespace
}  // namespace verisim::shapes::testing
