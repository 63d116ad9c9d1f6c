// What rays meet of CSG objects, beside the plain rule of spec 03 section 5: all hits of the children that pass the
// inside tests, and of those the nearest.
#include "tracer/shapes/test_support.h"

namespace verisim::shapes::testing {
namespace {

bool within_clips(const Object& object, const Vec3& p) {
  return std::all_of(object.clipped_by.begin(), object.clipped_by.end(),
                     [&](const auto& clip) { return compile(*clip)->inside(p); });
}

// The plain rule, for objects without bounds.
HitList hits_by_rule(const Shape& shape, const Ray& ray) {
  HitList hits;
  const auto* csg = shape.object->as<scene::Csg>();
  if (!csg) {
    shape.intersect_all(ray, RayKind::query, hits);
    return hits;
  }
  for (const auto& child : shape.children())
    for (const Hit& hit : hits_by_rule(*child, ray)) {
      bool kept = within_clips(*shape.object, hit.point);
      for (const auto& other : shape.children())
        if (csg->kind == scene::CsgKind::intersection && other != child)
          kept = kept && other->inside(hit.point);
        else if (csg->kind == scene::CsgKind::merge && other != child)
          kept = kept && !other->inside(hit.point);
      if (kept) hits.push_back(hit);
    }
  return hits;
}

void expect_rule(const ObjectRef& object) {
  const auto shape = compile(*object);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-3, 3);
  int met = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 from(place(random), place(random), place(random)),
        to(0.5 * place(random), 0.5 * place(random), 0.5 * place(random));
    const Ray ray{from, normalize(to - from)};
    HitList expected = hits_by_rule(*shape, ray), all;
    shape->intersect_all(ray, RayKind::query, all);
    ASSERT_EQ(all.size(), expected.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      ASSERT_TRUE(all[k].t == expected[k].t && all[k].shape == expected[k].shape);
    const double t_min = i % 3 == 0 ? 1.0 : 0.0, t_max = i % 2 == 0 ? 1e9 : 2.5;
    const Hit* nearest = nullptr;
    for (const Hit& h : expected)
      if (h.t >= t_min && h.t < t_max && (!nearest || h.t <= nearest->t)) nearest = &h;
    Hit hit;
    ASSERT_EQ(shape->intersect(ray, RayKind::query, t_min, t_max, hit), nearest != nullptr);
    ASSERT_EQ(shape->occludes(ray, t_min, t_max), nearest != nullptr);
    if (!nearest) continue;
    ASSERT_TRUE(hit.t == nearest->t && hit.shape == nearest->shape && hit.point == nearest->point);
    ++met;
  }
  EXPECT_GT(met, 300);
}

const ObjectRef block = make(scene::Box{{-1.5, -1, -1.2}, {1.5, 1, 1.2}});
const ObjectRef tube = make(scene::Cone{{-2, 0, 0}, {2, 0, 0}, 0.8, 0.8}, [](Object& o) {
  scene::rotate(o, {0, 10, 5});
});
const ObjectRef ball = make(scene::Sphere{{0.3, 0.2, 0.1}, 1});
const ObjectRef ring = make(scene::Torus{0.9, 0.2});
const Steps below = [](Object& o) { o.clipped_by.push_back(make(scene::Plane{{0.2, 1, 0}, 0.1})); };
const Steps above = [](Object& o) {
  o.clipped_by.push_back(make(scene::Plane{{0, 1, 0.1}, -0.2}, [](Object& p) { scene::invert(p); }));
};

TEST(CsgRays, SolidsWithRoomyHoles) {
  expect_rule(make_difference({block, tube}));
  expect_rule(make_difference({block, tube, make(scene::Cone{{0, 0, -2}, {0, 0, 2}, 0.9, 0.7})}));
  expect_rule(make_difference({block, make(scene::Box{{-1.4, -0.9, -1.1}, {1.4, 1.1, 1.1}})}));
  expect_rule(make_difference({make(scene::Sphere{Vec3(0), 1.2}), ball}));
}

// What is cut out of a solid that rays cross once is only looked for where they are within it.
TEST(CsgRays, SolidsOfASuperellipsoid) {
  for (const auto& [east, north] : {std::pair(0.05, 0.05), std::pair(0.4, 1.3)}) {
    const ObjectRef body = make(scene::Superellipsoid{east, north}, [](Object& o) {
      scene::scale(o, {1.5, 1, 1.2});
      scene::rotate(o, {5, 20, 0});
    });
    expect_rule(make_difference({body, tube}));
    expect_rule(make_difference({body, ring, make_difference({tube, block}), ball}));
    expect_rule(
        make_difference({body, make_union({ring, make(scene::Sphere{{0.9, 0.7, 0}, 0.6})}), make_merge({ball, tube})}));
    expect_rule(make_intersection({ball, body, make(scene::Plane{{0.2, 1, 0}, 0.1})}));
    expect_rule(make_difference({body, make_intersection({block, ball}), ring}, below));
  }
}

ObjectRef balls_of_a_blob(double threshold, const Vec3& second, double strength, const Steps& steps = {}) {
  return make_shared_shape(scene::Blob{threshold,
                                       {{Vec3(-0.5, 0, 0), Vec3(0), 1.5, 1, false, {}, {}},
                                        {second, Vec3(0), 1.3, strength, false, {}, {}}}},
                           steps);
}
// What is asked for hits between the nearest so far and the ray's beginning, for eight rays at once.
TEST(CsgRays, HollowBlobs) {
  const Steps turned = [](Object& o) { scene::rotate(o, {20, 30, 40}), scene::scale(o, {1, 0.8, 1.3}); };
  for (const Steps& steps : {Steps(), turned}) {
    const ObjectRef outer = balls_of_a_blob(0.2, {0.6, 0.1, 0}, 1, steps),
                    inner = balls_of_a_blob(0.3, {0.6, 0.1, 0}, 1, steps),
                    bitten = balls_of_a_blob(0.2, {0.4, 0.3, 0}, -0.9, steps);
    expect_rule(make_difference({outer, inner}));
    expect_rule(make_difference({make_union({outer, bitten}), make_union({inner, ring}, above)}));
    expect_rule(make_merge({outer, bitten, ring}));
    expect_rule(make_intersection({make_merge({bitten, inner}, below), outer, block}));
  }
}
TEST(CsgRays, MergedSuperellipsoids) {
  const auto body = [](double east, double north, const Vec3& place) {
    return make(scene::Superellipsoid{east, north}, [=](Object& o) {
      scene::scale(o, {1.2, 0.7, 0.9});
      scene::rotate(o, {5, 20, 0});
      scene::translate(o, place);
    });
  };
  expect_rule(make_merge({body(0.05, 0.05, Vec3(0)), body(0.4, 0.9, {0.5, 0.3, 0}), body(0.4, 1.3, {-0.5, 0.2, 0})}));
  expect_rule(make_difference(
      {make_merge({body(0.2, 0.3, Vec3(0)), body(0.2, 0.3, {0.8, 0, 0})}), body(0.3, 0.3, {0.2, 0, -0.3})}, below));
}

// Clip objects of parts, and of objects within.
TEST(CsgRays, PartsWithClips) {
  const auto cut = [](const ObjectRef& object, const ObjectRef& by) {
    return make(object->shape, [&](Object& o) { o.clipped_by.push_back(by); });
  };
  const ObjectRef dome = cut(ball, make(scene::Plane{{0.2, 1, 0}, 0.3})), sheet = cut(block, tube),
                  pole = make(scene::Cone{{-2, 0, 0}, {2, 0, 0}, 0.8, 0.6, true}, [](Object&o) {
                    o.clipped_by = {make(scene::Plane{{0, 1, 0.1}, 0.4}), make_difference({block, ball})};
                    scene::invert(o);
                  });
  expect_rule(make_merge({dome, sheet, pole}));
  expect_rule(make_merge({dome, make_intersection({block, tube}, below), make_union({ring, ball}, above)}));
  expect_rule(make_difference({block, make_merge({tube, ring}, above)}));
  expect_rule(make_merge({cut(tube, cut(block, ball)), sheet, dome}));
  expect_rule(make_intersection({make_difference({block, ring}, above), make_union({pole, ball}, above)}));
}

TEST(CsgRays, PrismsOfStraightSegments) {
  const auto prism = [](bool open, std::vector<Vec2> points, const Steps& steps) {
    return make(std::make_shared<const scene::Prism>(
                    scene::Prism{scene::SplineKind::linear, false, open, -0.9, 0.8, std::move(points)}),
                steps);
  };
  const std::vector<Vec2> hexagon = {{1.2, 0}, {0.6, 1}, {-0.6, 1}, {-1.2, 0}, {-0.6, -1}, {0.6, -1}, {1.2, 0}},
                          star = {{1.3, 0.1},   {0.2, 0.3},  {-1, 1.1}, {-0.4, -0.2},
                                  {-0.9, -1.2}, {0.3, -0.4}, {1.3, 0.1}};
  const Steps turned = [](Object& o) { scene::rotate(o, {20, 30, 40}), scene::scale(o, {1, 0.8, 1.3}); };
  for (const auto& outline : {hexagon, star}) {
    const ObjectRef upright = prism(false, outline, {}), leaning = prism(false, outline, turned);
    expect_rule(make_intersection({upright, leaning}));
    expect_rule(make_difference({block, leaning}));
    expect_rule(make_difference({leaning, tube, ball}));
    expect_rule(make_merge({upright, leaning, ring}));
    expect_rule(make_union({upright, prism(true, outline, turned)}, above));
  }
}

TEST(CsgRays, UnionsWithClips) {
  expect_rule(make_union({ball, ring, tube}, below));
  expect_rule(make_union({make_difference({block, tube}), ring}, above));
  expect_rule(make_union({make_union({ball, ring}, below), make_merge({tube, block}, below), ring}, above));
}

// Trees of random solids: what the plain rule finds.
class RandomObjects {
 public:
  explicit RandomObjects(unsigned seed) : random_(seed) {}
  Vec3 vector(double most) { return {number(-most, most), number(-most, most), number(-most, most)}; }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  ObjectRef solid(int depth) {
    if (depth == 0 || below(6) == 0) return leaf();
    std::vector<ObjectRef> parts;
    for (int n = 2 + below(3); n > 0; --n) parts.push_back(solid(depth - 1));
    switch (below(4)) {
      case 0:
        return make_union(parts, steps());
      case 1:
        return make_merge(parts, steps());
      case 2:
        return make_intersection(parts, steps());
      default:
        return make_difference(parts, steps());
    }
  }

 private:
  Steps steps() {
    const bool turned = below(2) == 0, moved = below(2) == 0, inverted = below(6) == 0, clipped = below(8) == 0,
               grown = below(4) == 0;
    const Vec3 angles = vector(180), way = vector(0.6);
    const double size = number(0.6, 1.5);
    return [=](Object& o) {
      if (grown) scene::scale(o, {size, 1, 1 / size});
      if (turned) scene::rotate(o, angles);
      if (moved) scene::translate(o, way);
      if (clipped && moved) o.clipped_by.push_back(make(scene::Plane{normalize(angles), 0.3}));
      if (clipped) o.clipped_by.push_back(make(scene::Sphere{way, 1.2}));
      if (inverted) scene::invert(o);
    };
  }
  ObjectRef leaf() {
    switch (below(10)) {
      case 0:
      case 1:
        return make(scene::Sphere{vector(0.6), number(0.3, 1.2)}, steps());
      case 2:
        return make(scene::Box{{number(-1, -0.1), number(-1, -0.1), number(-1, -0.1)},
                               {number(0.1, 1), number(0.1, 1), number(0.1, 1)}},
                    steps());
      case 3:
        return make(scene::Box{{-1, -1, -0.5}, {1, 0.5, 1}}, steps());  // faces that several have
      case 4:
        return make(scene::Plane{normalize(vector(1)), number(-0.3, 0.8)}, steps());
      case 5:
        return make(scene::Cone{{0, -0.8, 0}, {0, 0.9, 0}, 0.5, 0.5, below(3) == 0}, steps());
      case 6:
        return make(scene::Cone{vector(0.8), {0, 0.9, 0}, number(0.2, 0.9), number(0, 0.9), below(3) == 0}, steps());
      case 7:
        return make(scene::Quadric{{number(-0.5, 1.5), number(-0.5, 1.5), number(-0.5, 1.5)},
                                   vector(0.4),
                                   vector(0.3),
                                   number(-0.8, -0.1)},
                    steps());
      case 8:
        return balls_of_a_blob(number(0.2, 0.4), vector(0.8), number(-1, 1), steps());
      default:
        return make(
            below(2) == 0 ? scene::Shape(scene::Torus{0.8, 0.3}) : scene::Shape(scene::Superellipsoid{0.3, 0.6}),
            steps());
    }
  }
  std::mt19937 random_;
};
TEST(CsgRays, RandomTrees) {
  RandomObjects random(17);
  int met = 0;
  for (int round = 0; round < 150; ++round) {
    const ObjectRef object = random.solid(1 + round % 3);
    const auto shape = compile(*object);
    if (shape->children().empty() || !object->clipped_by.empty()) continue;
    // Alone and in unions a superellipsoid is asked for one hit, which may be one too near.
    const bool one_hit = object->as<scene::Csg>()->kind == scene::CsgKind::union_;
    for (int k = 0; k < 64; ++k) {
      const Vec3 from = random.vector(round % 2 == 0 ? 3 : 0.8);
      const Ray ray{from, k % 7 == 0 ? Vec3(0, k % 2 == 0 ? 1 : -1, 0) : normalize(random.vector(0.7) - from)};
      const double t_min = k < 8 && !one_hit ? 0.5 : 0, t_max = k % 3 == 0 ? 2.5 : HUGE_VAL;
      const HitList all = hits_by_rule(*shape, ray);
      const Hit* nearest = nullptr;
      for (const Hit& h : all)
        if (h.t >= t_min && h.t < t_max && (!nearest || h.t <= nearest->t)) nearest = &h;
      Hit hit;
      ASSERT_EQ(shape->intersect(ray, RayKind::query, t_min, t_max, hit), nearest != nullptr) << round << ' ' << k;
      ASSERT_EQ(shape->occludes(ray, t_min, t_max), nearest != nullptr) << round << ' ' << k;
      ASSERT_TRUE(!nearest || (hit.t == nearest->t && hit.shape == nearest->shape && hit.point == nearest->point &&
                               hit.part == nearest->part))
          << round << ' ' << k;
      met += nearest != nullptr;
    }
  }
  EXPECT_GT(met, 1000);
}

// Of hits at the same distance the last one shows.
TEST(CsgRays, SolidsInTheSamePlace) {
  const auto copy = [](const ObjectRef& object) { return make(object->shape); };
  expect_rule(make_intersection({make_union({block, copy(block)}), make(scene::Plane{{0.2, 1, 0}, 0.5})}));
  expect_rule(make_intersection(
      {make(scene::Plane{{0.2, 1, 0}, 0.5}), make_union({make_union({ball, ring}), copy(ball), copy(ring)})}));
  expect_rule(make_intersection({block, copy(block)}));
}

TEST(CsgRays, ClippedSolids) {
  expect_rule(make_difference({block, tube}, below));
  expect_rule(make_merge({ball, ring, tube}, above));
}

}  // namespace
}  // namespace verisim::shapes::testing
