// The world: frame-level list, ties, visibility, shadows, interiors, weighted textures (spec
// 03 2.3, 2.6, 5.3, 5.5, 6.2, 10.6, 10.7).
#include "tracer/world/world_impl.h"

#include "tracer/bvh/shaft.h"
#include "tracer/shapes/test_support.h"

namespace verisim::accel {
namespace {

using namespace shapes::testing;
using scene::Object;

scene::TexturePtr texture_of(const Color& color) {
  auto pigment = std::make_shared<scene::Pigment>();
  pigment->pattern.kind = scene::PatternKind::plain;
  pigment->color = color;
  auto texture = std::make_shared<scene::Texture>();
  texture->layers.push_back({pigment, nullptr, {}});
  return texture;
}
const scene::TexturePtr kOpaque = texture_of({1, 0, 0}), kGlass = texture_of({1, 1, 1, 0, 0.5f});

ObjectRef textured(const ObjectRef& object, const scene::TexturePtr& texture = kOpaque) {
  object->texture = texture;
  object->interior = std::make_shared<scene::Interior>();
  if (object->as<scene::Csg>())
    for (const auto& child : scene::own_children(*object))
      if (!child->texture) textured(std::const_pointer_cast<Object>(child), texture);
  return object;
}
ObjectRef sphere(const Vec3& c, double r, const Steps& m = {}) { return textured(make(scene::Sphere{c, r}, m)); }
ObjectRef box(const Vec3& a, const Vec3& b, const Steps& m = {}) { return textured(make(scene::Box{a, b}, m)); }
std::vector<ObjectRef> far_spheres() {
  return {sphere({50, 0, 0}, 1), sphere({-50, 0, 0}, 1), sphere({0, 50, 0}, 1), sphere({0, 60, 0}, 1)};
}

struct Stage {
  scene::Scene scene;
  textures::Compiler compiler{textures::Settings{}};
  std::unique_ptr<World> world;

  explicit Stage(const std::vector<ObjectRef>& objects, bool split = false, bool remove_bounds = true) {
    for (const auto& o : objects) scene.objects.push_back(o);
    world = std::make_unique<World>(scene, compiler, Arrangement{split, remove_bounds});
  }
  // The description of the object that is hit; null: none.
  const Object* hit(const Vec3& origin, const Vec3& direction, RayKind kind = RayKind::camera) const {
    Hit h;
    return world->intersect({origin, normalize(direction)}, kind, 1e-4, 2e10, h) ? h.shape->surface->object : nullptr;
  }
};

const Vec3 y{0, 1, 0}, z{0, 0, 1};

TEST(World, FindsTheNearestOfManyAsASearchOfAllDoes) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> u(-10, 10);
  std::vector<ObjectRef> objects;
  for (int i = 0; i < 500; ++i) objects.push_back(sphere({u(random), u(random), u(random)}, 0.5));
  objects.push_back(textured(make(scene::Plane{y, -12})));
  const Stage stage(objects);
  for (int i = 0; i < 2000; ++i) {
    // Some cameras are so far away that single precision alone would miss everything.
    const Vec3 origin = random_unit(random) * (i % 3 == 0 ? 1e6 : 20.0), target(u(random), u(random), u(random));
    const Ray ray{origin, normalize(target - origin)};
    double nearest = 2e10;
    for (const auto& o : objects) {
      shapes::Hit h;
      if (shapes::compile(*o)->intersect(ray, RayKind::camera, 1e-4, nearest, h)) nearest = h.t;
      if (o == objects[20] && i > 50) break;  // enough for speed; the full search runs on the first rays
    }
    Hit h;
    const bool found = stage.world->intersect(ray, RayKind::camera, 1e-4, 2e10, h);
    if (i <= 50) {
      ASSERT_EQ(found, nearest < 2e10);
      if (found) {
        ASSERT_EQ(h.t, nearest);
      }
    } else if (nearest < 2e10) {
      ASSERT_TRUE(found);
      ASSERT_LE(h.t, nearest);
    }
    if (found) {
      ASSERT_TRUE(stage.world->occluded(ray, 1e-3, h.t + 1));
      ASSERT_FALSE(stage.world->occluded(ray, 1e-3, h.t - 1e-3 * h.t));
    }
  }
}

TEST(World, ARayFollowedPastSurfacesMeetsWhatSearchesFromEachFind) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> u(-10, 10);
  std::vector<ObjectRef> objects;
  for (int i = 0; i < 300; ++i) objects.push_back(sphere({u(random), u(random), u(random)}, 1.5));
  objects.push_back(objects[3]);  // a twin
  objects.push_back(textured(make(scene::Plane{y, -12})));
  const Stage stage(objects);
  int surfaces = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 origin = i % 3 == 0 ? Vec3(u(random), u(random), u(random)) : random_unit(random) * 30.0;
    Ray ray{origin, normalize(Vec3(u(random), u(random), u(random)) - origin)};
    double left = i % 2 == 0 ? 200 : 15, travelled = 0;
    BoxesAlong boxes;
    ASSERT_TRUE(stage.world->boxes_along(ray, 1e-6, left, nullptr, boxes));
    for (;;) {
      shapes::Hit expected, hit;
      const bool met = stage.world->intersect(ray, RayKind::shadow, 1e-6, left, expected);
      ASSERT_EQ(stage.world->intersect_along(ray, RayKind::shadow, 1e-6, left, hit, nullptr, boxes, travelled), met);
      if (!met) break;
      ASSERT_EQ(hit.t, expected.t);
      ASSERT_EQ(hit.shape, expected.shape);
      ray.origin = hit.point, left -= hit.t, travelled += hit.t;
      ++surfaces;
    }
  }
  EXPECT_GT(surfaces, 5000);
}

// Objects of many kinds that touch, hide each other and are seen by some rays only.
std::vector<ObjectRef> crowd() {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> u(-2, 2);
  std::vector<ObjectRef> objects;
  for (int i = 0; i < 9; ++i) {
    const Vec3 c(u(random), u(random), u(random));
    if (i % 3 == 0)
      objects.push_back(box(c - Vec3(0.5), c + Vec3(0.5), [i](Object& o) { o.no_shadow = i == 3; }));
    else
      objects.push_back(textured(make(scene::Sphere{c, 0.7}), i == 7 ? kGlass : kOpaque));
    if (i == 6) objects.push_back(box(c - Vec3(0.5), c + Vec3(0.5)));  // a twin
  }
  objects.push_back(textured(make(scene::Plane{y, -1.5})));
  return objects;
}

// Two skies and a room that stand far around them.
std::vector<ObjectRef> crowd_under_skies() {
  auto objects = crowd();
  objects.push_back(textured(make(scene::Sphere{Vec3(0), 30},
                                  [](Object& o) {
                                    scene::transform(o, Transform::scaling({1, 0.8, 1}));
                                  }),
                             kGlass));
  objects.insert(objects.begin(), sphere({1, 2, 3}, 25));
  objects.push_back(box(Vec3(-15), Vec3(18)));
  return objects;
}

TEST(World, SkiesAreFoundAsASearchOfAllFindsThem) {
  const auto objects = crowd_under_skies();
  const Stage stage(objects);
  std::vector<std::unique_ptr<shapes::Shape>> shapes;
  for (const auto& o : objects) shapes.push_back(shapes::compile(*o));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 from = (i % 2 ? 4.0 : 40.0) * Vec3(u(random), u(random), u(random)),
               to = (i % 5 ? 3.0 : 30.0) * Vec3(u(random), u(random), u(random));
    const Ray ray{from, normalize(to - from)};
    double nearest = 2e10;
    for (const auto& shape : shapes)
      if (Hit h; shape->intersect(ray, RayKind::camera, 1e-4, nearest, h)) nearest = h.t;
    Hit h;
    ASSERT_EQ(stage.world->intersect(ray, RayKind::camera, 1e-4, 2e10, h), nearest < 2e10);
    if (nearest < 2e10) {
      ASSERT_EQ(h.t, nearest);
    }
    const double limit = 10 + 10 * u(random);
    bool blocked = false;
    for (const auto& shape : shapes)
      if (!shape->object->no_shadow && shape->object->texture != kGlass)
        blocked = blocked || shape->occludes(ray, 1e-3, limit);
    ASSERT_EQ(stage.world->occluded(ray, 1e-3, limit), blocked);
  }
}

ObjectRef light_at(const Vec3& p) {
  scene::LightSource light;
  light.position = p;
  return make(scene::Boxed<scene::LightSource>(light));
}

// Shadow rays that stay in a transparent ball with their light do not meet it.
TEST(World, RoomsOfLightsAreKnownToLetShadowRaysAlone) {
  auto objects = far_spheres();
  objects.push_back(light_at({0, 5, 0}));
  objects.push_back(textured(make(scene::Sphere{Vec3(0), 200}), kGlass));
  const Stage stage(objects);
  EXPECT_TRUE(stage.world->has_transparent_shadows());
  EXPECT_TRUE(stage.world->only_opaque_between({100, 0, 0}, {0, 5, 0}));
  EXPECT_FALSE(stage.world->only_opaque_between({201, 0, 0}, {0, 5, 0}));
  EXPECT_FALSE(stage.world->only_opaque_between({0, 5, 0}, {0, -200, 0}));
  const auto only_opaque = [](const Stage& s, const Vec3& from, const Vec3& to) {
    WorldEntry entry;
    s.world->enter(*Shaft::between(Box3(from - Vec3(1), from + Vec3(1)), Box3(to, to)), entry);
    return entry.only_opaque;
  };
  EXPECT_TRUE(only_opaque(stage, {100, 0, 0}, {0, 5, 0}));
  EXPECT_FALSE(only_opaque(stage, {199.5, 0, 0}, {0, 5, 0}));
  EXPECT_FALSE(only_opaque(stage, {250, 0, 0}, {0, 5, 0}));

  // Glass elsewhere in the ball.
  objects.push_back(textured(make(scene::Sphere{{20, 20, 0}, 3}), kGlass));
  const Stage with_glass(objects);
  EXPECT_FALSE(with_glass.world->only_opaque_between({100, 0, 0}, {0, 5, 0}));
  EXPECT_TRUE(only_opaque(with_glass, {0, -20, 0}, {0, 5, 0}));
  EXPECT_FALSE(only_opaque(with_glass, {40, 35, 0}, {0, 5, 0}));

  // Without a light in it, it is no such room.
  objects = far_spheres();
  objects.push_back(light_at({0, 500, 0}));
  objects.push_back(textured(make(scene::Sphere{Vec3(0), 200}), kGlass));
  const Stage lit_from_outside(objects);
  EXPECT_FALSE(lit_from_outside.world->only_opaque_between({100, 0, 0}, {0, 5, 0}));
}

// Measured with orthographic cameras: POV-Ray misses objects along the faces of their boxes that lie across x, and
// meets them along the others.
TEST(World, RaysWithinAFaceOfABox) {
  const SlabTest slab{{-1, -2, -3}, {1, 2, 3}, true};
  for (const double side : {-1.0, 1.0}) {
    EXPECT_FALSE(slab.passes({{side, 0.5, -9}, {0, 0, 1}}));
    EXPECT_FALSE(slab.passes({{side * (1 + 1e-9), 0.5, -9}, {0, 0, 1}})) << "the same in single precision";
    EXPECT_TRUE(slab.passes({{side * (1 - 1e-6), 0.5, -9}, {0, 0, 1}}));
    EXPECT_TRUE(slab.passes({{0.5, 2 * side, -9}, {0, 0, 1}}));
    EXPECT_TRUE(slab.passes({{-9, 0.5, 3 * side}, {1, 0, 0}}));
    EXPECT_FALSE(slab.passes({{0.5, 2.1 * side, -9}, {0, 0, 1}}));
  }
  EXPECT_TRUE(slab.passes({{0, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(slab.passes({{0, 0, 9}, {0, 0, 1}})) << "it lies behind";
  EXPECT_TRUE(SlabTest{}.passes({{1, 0, 9}, {0, 0, 1}})) << "no box";
}

TEST(World, ExactTies) {
  const auto cube = box({-1, -1, -1}, {1, 0, 1});
  const auto floor = textured(make(scene::Plane{y, 0}));
  const Vec3 from{0.3, 4, 0.2};
  EXPECT_EQ(Stage({cube, floor}).hit(from, -y), cube.get());  // fewer than 3 entries: declaration order
  EXPECT_EQ(Stage({floor, cube}).hit(from, -y), floor.get());
  auto objects = far_spheres();
  objects.insert(objects.begin(), {cube, floor});
  EXPECT_EQ(Stage(objects).hit(from, -y), floor.get());  // infinite objects come first
  auto twins = far_spheres();
  const auto first = box(Vec3(-1), Vec3(1)), second = box(Vec3(-1), Vec3(1));
  twins.push_back(first);
  twins.push_back(second);
  EXPECT_EQ(Stage(twins).hit({0.1, 0.2, -5}, z), first.get());
}

TEST(World, LaterChildOfAWholeUnionWinsTies) {
  auto whole = make_union({make(scene::Box{Vec3(-1), Vec3(1)}), make(scene::Box{Vec3(-1), Vec3(1)})},
                          [](Object& o) { o.split_union = false; });
  textured(whole);
  EXPECT_EQ(Stage({whole}).hit({0.1, 0.2, -5}, z), scene::children_of(*whole)[1].get());
}

TEST(World, BoundsCutOnlyWithAHierarchy) {
  const auto bound = make(scene::Sphere{Vec3(0), 0.5});
  const auto cube = [&] { return box(Vec3(-1), Vec3(1), [&](Object& o) { o.bounded_by.push_back(bound); }); };
  EXPECT_NE(Stage({cube()}).hit({0.8, 0.03, -5}, z), nullptr);
  auto objects = far_spheres();
  objects.push_back(cube());
  EXPECT_EQ(Stage(objects).hit({0.8, 0.03, -5}, z), nullptr);
  EXPECT_NE(Stage(objects).hit({0.3, 0.03, -5}, z), nullptr);
  EXPECT_NE(Stage(objects).hit({0.48, 0.48, -5}, z),
            nullptr);  // beside the sphere but inside its box: the bound itself is removed
  EXPECT_EQ(Stage(objects, false, false).hit({0.48, 0.48, -5}, z), nullptr);
}

TEST(World, NegativeRadiusIsHiddenByItsBox) {
  EXPECT_NE(Stage({sphere(Vec3(0), -1)}).hit({0, 0, -5}, z), nullptr);
  auto objects = far_spheres();
  objects.push_back(sphere(Vec3(0), -1));
  EXPECT_EQ(Stage(objects).hit({0, 0, -5}, z), nullptr);
}

TEST(World, VisibilityOfFrameObjects) {
  const auto seen_by = [](const Steps& flags, RayKind kind) {
    return Stage({sphere(Vec3(0), 1, flags)}).hit({0, 0, -5}, z, kind) != nullptr;
  };
  const Steps no_image = [](Object&o) { o.no_image = true; }, no_reflection = [](Object&o) { o.no_reflection = true; };
  EXPECT_FALSE(seen_by(no_image, RayKind::camera));
  EXPECT_FALSE(seen_by(no_image, RayKind::refracted));
  EXPECT_TRUE(seen_by(no_image, RayKind::reflected));
  EXPECT_TRUE(seen_by(no_image, RayKind::shadow));
  EXPECT_FALSE(seen_by(no_reflection, RayKind::reflected));
  EXPECT_TRUE(seen_by(no_reflection, RayKind::camera));
  EXPECT_FALSE(seen_by([](Object& o) { o.no_shadow = true; }, RayKind::shadow));
  EXPECT_FALSE(seen_by([](Object& o) { o.no_radiosity = true; }, RayKind::radiosity));
}

TEST(World, VisibilityOfChildren) {
  const auto hidden = make(scene::Sphere{Vec3(0), 1}, [](Object& o) { o.no_image = true; });
  const auto other = make(scene::Sphere{{5, 0, 0}, 1});
  const auto whole = textured(make_union({hidden, other}, [](Object& o) { o.split_union = false; }));
  EXPECT_NE(Stage({whole}).hit({0, 0, -5}, z), nullptr);
  EXPECT_EQ(Stage({whole}).hit({0, 0, -5}, z, RayKind::refracted), nullptr);
  const auto merged = textured(make_merge({hidden, other}));
  EXPECT_EQ(Stage({merged}).hit({0, 0, -5}, z), nullptr);
  EXPECT_NE(Stage({merged}).hit({0, 0, -5}, z, RayKind::reflected), nullptr);
}

TEST(World, OnlyOpaqueSurfacesOcclude) {
  const auto glass = textured(make(scene::Sphere{{0, 0, 5}, 1}), kGlass);
  const Stage stage({glass, sphere({0, 0, 10}, 1)});
  EXPECT_TRUE(stage.world->has_transparent_shadows());
  EXPECT_FALSE(stage.world->occluded({Vec3(0), z}, 1e-3, 8));
  EXPECT_TRUE(stage.world->occluded({Vec3(0), z}, 1e-3, 20));
  EXPECT_FALSE(Stage({sphere({0, 0, 10}, 1)}).world->has_transparent_shadows());
  // A union that stays whole and has both kinds.
  auto mixed = make_union({make(scene::Sphere{{0, 0, 5}, 1}), make(scene::Sphere{{0, 0, 10}, 1})},
                          [](Object& o) { o.split_union = false; });
  textured(std::const_pointer_cast<Object>(scene::own_children(*mixed)[0]), kGlass);
  textured(mixed);
  const Stage mixed_stage({mixed});
  EXPECT_FALSE(mixed_stage.world->occluded({Vec3(0), z}, 1e-3, 8));
  EXPECT_TRUE(mixed_stage.world->occluded({Vec3(0), z}, 1e-3, 20));
}

TEST(World, InteriorsAroundAPointInOrderOfDeclaration) {
  std::vector<ObjectRef> objects;
  for (int i = 0; i < 20; ++i) objects.push_back(sphere({i * 0.1, 0, 0}, 0.25));
  const Stage stage(objects);
  std::vector<const scene::Interior*> interiors;
  stage.world->interiors_at({1, 0, 0}, interiors);
  ASSERT_EQ(interiors.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(interiors[i], objects[8 + i]->interior.get());
}

TEST(World, InteriorsInABoxAreThoseOfItsHolders) {
  std::vector<ObjectRef> objects{sphere({0, 0, 0}, 1), make(scene::Plane{{0, 1, 0}, -2}), sphere({3, 0, 0}, 0.5)};
  for (int i = 0; i < 4; ++i) objects.push_back(sphere({0.2 * i, 0, 0}, 0.3));
  const Stage stage(objects);
  const Box3 box({-0.5, -0.3, -0.3}, {1.1, 0.3, 0.3});
  const std::vector<std::uint32_t> holders = stage.world->holders(box);
  EXPECT_LT(holders.size(), objects.size());
  std::vector<const scene::Interior*> of_all, of_holders;
  std::size_t most = 0;
  for (int i = 0; i <= 20; ++i) {
    const Vec3 p = box.min + i / 20.0 * (box.max - box.min);
    stage.world->interiors_at(p, of_all);
    stage.world->interiors_at(p, holders, of_holders);
    EXPECT_EQ(of_all, of_holders) << i;
    most = std::max(most, of_all.size());
  }
  EXPECT_GE(most, 3u);
  EXPECT_TRUE(stage.world->holders({{1.2, -1, -1}, {2.4, 1, 1}}).empty());
}

// The hierarchy has them sorted by their middles; two objects alone are asked as they were declared.
TEST(World, InteriorsAroundAPointInOrderOfTheHierarchy) {
  std::vector<ObjectRef> objects;
  for (int i = 0; i < 20; ++i) objects.push_back(sphere({2 - i * 0.1, 0, 0}, 0.25));
  std::vector<const scene::Interior*> interiors;
  Stage(objects).world->interiors_at({1, 0, 0}, interiors);
  ASSERT_EQ(interiors.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(interiors[i], objects[12 - i]->interior.get());
  objects = {objects[9], objects[11]};
  Stage(objects).world->interiors_at({1, 0, 0}, interiors);
  ASSERT_EQ(interiors.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(interiors[i], objects[i]->interior.get());
}

// Below the disc all is inside, as far as the object's box reaches.
TEST(World, InsideReachesBeyondTheSurface) {
  const auto tilted =
      textured(make_merge({make(scene::Disc{Vec3(0), y, 1}), make(scene::Sphere{{3, 0, 0}, 0.5})}, [](Object& o) {
        scene::rotate(o, {30, 0, 40});
      }));
  const Stage stage({tilted, sphere({9, 9, 9}, 1), sphere({-9, 9, 9}, 1), sphere({9, 9, -9}, 1)});
  std::vector<const scene::Interior*> interiors;
  const Vec3 low = scene::low_corner(tilted->bounds), high = scene::high_corner(tilted->bounds);
  int found = 0;
  for (const double s : {0.01, 0.99})
    for (const double t : {0.01, 0.99})
      for (const double u : {0.01, 0.99}) {
        const Vec3 p{low.x + s * (high.x - low.x), low.y + t * (high.y - low.y), low.z + u * (high.z - low.z)};
        stage.world->interiors_at(p, interiors);
        EXPECT_EQ(interiors.size(), shapes::compile(*tilted)->inside(p) ? 1u : 0u);
        found += static_cast<int>(interiors.size());
      }
  EXPECT_GT(found, 0);
}

TEST(World, LightsOfGroupsAreNotGlobal) {
  const auto light = [](double at) {
    scene::LightSource source;
    source.position.x = at;
    return make(source);
  };
  scene::LightGroup group;
  group.children.push_back(light(1));
  group.children.push_back(make_union({light(2), sphere(Vec3(0), 1)}));
  auto grouped = std::make_shared<Object>();
  grouped->shape = group;
  const Stage stage({light(3), textured(make_union({light(4), sphere({0, 0, 9}, 1)})), textured(grouped)});
  std::vector<double> positions;
  for (const auto* l : stage.world->lights()) positions.push_back(l->position.x);
  EXPECT_EQ(positions, (std::vector<double>{3, 4, 2}));
}

TEST(World, CutawayMixesTheChildrenThatContainThePoint) {
  const auto red = make(scene::Box{Vec3(-1), Vec3(1)}), green = make(scene::Box{Vec3(-1.5), Vec3(1.5)});
  red->texture = texture_of({1, 0, 0});
  green->texture = texture_of({0, 1, 0});
  const auto body = make_union({red, green});
  auto cut = make_difference({body, make(scene::Sphere{{0, 0, -1.5}, 1})});
  const Stage stage({cut});
  Hit h;
  ASSERT_TRUE(stage.world->intersect({{0, 0, -5}, z}, RayKind::camera, 1e-4, 1e7, h));
  EXPECT_NEAR(h.t, 4.5, 1e-12);
  EXPECT_EQ(h.shape->surface->texture, nullptr);
  std::vector<textures::WeightedTexture> weights;
  stage.world->weighted_textures(h, false, weights);
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_FLOAT_EQ(weights[0].weight, 0.5f);
  EXPECT_FLOAT_EQ(weights[1].weight, 0.5f);
}

}  // namespace
}  // namespace verisim::accel
