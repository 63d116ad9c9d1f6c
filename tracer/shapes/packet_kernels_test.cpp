// Eight rays at once find what each finds alone, to the last bit, whatever their numbers are, and with every
// instruction set.
#include "tracer/shapes/packet_kernels.h"

#include "tracer/shapes/algebraic/torus_packet.h"
#include "tracer/shapes/quadrics/quadric_kernels.h"

#include "tracer/shapes/packet_test_support.h"

namespace verisim::shapes::testing {
namespace {

const Steps kMoved[] = {{}, [](Object& o) {
                          scene::transform(o, Transform::scaling({0.7, -1.2, 0.9})
                                                  .then(Transform::rotation({20, 70, -40}))
                                                  .then(Transform::translation({0.2, 0.1, -0.3})));
                        }};

// Shapes whose rays are roots of polynomials.
void add_curved(const Steps& steps, std::vector<ObjectRef>& objects) {
  objects.push_back(make(poly(2, {{2, 0, 0, 1}, {0, 2, 0, 2}, {0, 0, 1, 1}, {0, 0, 0, -0.5}}), steps));
  objects.push_back(make(poly(3, {{3, 0, 0, 1}, {0, 3, 0, 1}, {0, 0, 2, 1}, {0, 1, 1, 0.5}, {0, 0, 0, -0.3}}), steps));
  objects.push_back(make(
      poly(4, {{4, 0, 0, 1}, {0, 4, 0, 1}, {0, 0, 4, 1}, {2, 0, 0, -1}, {0, 2, 0, -1}, {0, 0, 2, -1}, {0, 0, 0, 0.4}}),
      steps));
  objects.push_back(make(poly(5, {{5, 0, 0, 1}, {0, 4, 0, 1}, {0, 0, 2, 1}, {0, 0, 0, -0.2}}),
                         steps));  // of lower degree along some rays
  const std::vector<Term> cushion{{6, 0, 0, 1}, {0, 6, 0, 1}, {0, 0, 6, 1}, {1, 1, 0, 0.3}, {0, 0, 0, -0.7}};
  objects.push_back(make(poly(6, cushion), steps));
  objects.push_back(make(poly(6, cushion), [&](Object& o) {
    if (steps) steps(o);
    o.clipped_by.push_back(make(scene::Plane{{0, 1, 0}, 0.2}));
    o.bounded_by.push_back(make(scene::Sphere{Vec3(0), 1}));
  }));
  objects.push_back(make(poly(14, {{14, 0, 0, 1}, {0, 4, 0, 1}, {0, 0, 2, 1}, {0, 0, 0, -0.5}}), steps));
  const Transform turned = Transform::scaling({0.7, 1.3, 1}).then(Transform::rotation({30, 10, 50}));
  const auto blob = [&](double threshold, std::vector<scene::BlobComponent> components) {
    objects.push_back(make(std::make_shared<const scene::Blob>(scene::Blob{threshold, std::move(components)}), steps));
  };
  blob(0.5, {{{-0.4, 0, 0}, {}, 0.9, 1, false, {}, {}},
             {{0.5, 0.2, 0}, {}, 0.8, 1, false, {}, {}},
             {{0, 0.4, 0}, {}, 0.4, -1.5, false, {}, {}},
             {{-0.5, -0.6, 0.2}, {0.6, 0.5, 0}, 0.5, 1, true, {}, {}}});
  blob(0.3, {{{0, 0, 0}, {0, 0.6, 0}, 0.7, 1, true, turned, {}}, {{0.3, 0, 0}, {}, 0.8, 0.6, false, turned, {}}});
  // So many parts that a tree finds them; so many near a packet that its rays go alone.
  const auto cloud = [&](int count, double radius, double threshold) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> u(-0.8, 0.8);
    std::vector<scene::BlobComponent> balls;
    for (int i = 0; i < count; ++i)
      balls.push_back({{u(random), u(random), u(random)}, {}, radius, i % 7 == 0 ? -0.5 : 1.0, false, {}, {}});
    blob(threshold, balls);
  };
  cloud(120, 0.3, 0.5);
  if (!steps) cloud(220, 2.5, 100);
  const std::vector<Vec2> vase{{0.2, -1.2}, {0.4, -0.8}, {0.8, -0.2}, {0.3, 0.3}, {0.5, 0.8}, {0.6, 1}};
  for (const bool open : {false, true})
    objects.push_back(make(std::make_shared<const scene::Sor>(scene::Sor{vase, open}), steps));
  const auto lathe = [&](scene::SplineKind spline, std::vector<Vec2> points) {
    objects.push_back(make(std::make_shared<const scene::Lathe>(scene::Lathe{spline, std::move(points)}), steps));
  };
  lathe(scene::SplineKind::linear, {{0, -1}, {0.8, -0.5}, {0.3, 0.4}, {0.9, 1}});
  lathe(scene::SplineKind::quadratic, {{0, -1.2}, {0.5, -1}, {0.9, 0}, {0.4, 0.5}, {0, 0.9}});
  lathe(scene::SplineKind::cubic, {{0.3, -1}, {0.7, -0.8}, {0.4, -0.2}, {0.9, 0.5}, {0, 0.9}, {-0.4, 1}});
  lathe(scene::SplineKind::bezier,
        {{0.4, -1}, {1.2, -0.6}, {0.1, -0.2}, {0.3, 0.3}, {0.3, 0.3}, {0.5, 0.5}, {0.2, 0.7}, {0.7, 0.9}});
  const auto sweep = [&](scene::SplineKind spline, std::vector<Vec3> centers, std::vector<double> radii) {
    objects.push_back(make(std::make_shared<const scene::SphereSweep>(
                               scene::SphereSweep{spline, std::move(centers), std::move(radii), 1e-6}),
                           steps));
  };
  sweep(scene::SplineKind::linear, {{-1, 0, 0}, {0.3, 0.8, 0.2}, {0.8, -0.3, 0.2}}, {0.3, 0.2, 0.5});
  sweep(scene::SplineKind::b_spline, {{-1, 0, 0}, {-0.3, 0.8, 0.2}, {0.6, -0.7, 0.2}, {1, 0.8, 0}},
        {0.6, 0.8, 0.9, 0.4});
  sweep(scene::SplineKind::cubic,
        {{-1, -1, 0}, {-0.7, 0.4, 0.1}, {0, -0.3, 0.4}, {0.5, 0.6, -0.3}, {0.9, -0.2, 0}, {1, -1, 0.5}},
        {0.2, 0.3, 0.4, 0.2, 0.3, 0.2});
}

// Intersections of planes and others: finite, infinite, with holes, with clips and bounds.
void add_intersections(const Steps& steps, std::vector<ObjectRef>& objects) {
  const auto plane = [](const Vec3& n, double d) { return make(scene::Plane{n, d}); };
  const ObjectRef ball = make(scene::Sphere{{0.1, 0.1, 0}, 0.8}),
                  waist = make(scene::Quadric{{1, -1, 1}, Vec3(0), Vec3(0), -0.2});
  const ObjectRef lower = plane({0, 1, 0}, 0.6), upper = plane({0, -1, 0}, 0.7),
                  slope = plane(normalize(Vec3(1, 1, 0.3)), 0.4);
  objects.push_back(make_intersection({lower, waist, upper}, steps));
  objects.push_back(make_intersection({ball, slope, upper}, steps));
  objects.push_back(make_intersection({lower, slope}, steps));
  objects.push_back(make_intersection({waist, plane({0, 1, 0}, -0.2)}, steps));
  objects.push_back(make_intersection(
      {lower, upper, plane({1, 0, 0}, 0.5), plane({-1, 0, 0}, 0.5), plane({0, 0, 1}, 0.5), plane({0, 0, -1}, 0.3)},
      steps));
  objects.push_back(make_difference(
      {make_intersection({lower, upper, ball}), slope, make(scene::Box{{-0.2, -1, -0.2}, {0.3, 1, 0.1}})}, steps));
  objects.push_back(
      make_intersection({make_union({plane({1, 0, 0}, -0.2), plane({0, 0, 1}, 0.1)}), ball, upper}, steps));
  const ObjectRef body = make(scene::Superellipsoid{0.1, 0.3}), ring = make(scene::Torus{0.8, 0.3});
  objects.push_back(make_difference({body, ring}, steps));
  objects.push_back(make_difference({body, slope, make_union({ball, ring})}, steps));
  objects.push_back(
      make_difference({body, make_difference({ball, make(scene::Box{{-0.2, -1, -0.2}, {0.3, 1, 0.1}})})}, steps));
  objects.push_back(make_intersection({ball, slope, upper}, [&](Object& o) {
    if (steps) steps(o);
    o.clipped_by.push_back(make(scene::Plane{{0, 1, 0}, 0.2}));
    o.bounded_by.push_back(make(scene::Box{{-0.7, -0.7, -0.7}, {0.6, 0.6, 0.6}}));
  }));
}

std::vector<ObjectRef> solids() {
  std::vector<ObjectRef> objects;
  for (const Steps& steps : kMoved) {
    objects.push_back(make(scene::Sphere{{0.1, -0.2, 0.3}, 0.9}, steps));
    objects.push_back(make(scene::Sphere{Vec3(0), -0.5}, steps));
    objects.push_back(make(scene::Box{{-1, -0.7, -0.5}, {0.8, 0.9, 1}}, steps));
    objects.push_back(make(scene::Box{{-1, 0, -1}, {1, 0, 1}}, steps));  // flat
    for (const bool open : {false, true}) {
      objects.push_back(make(scene::Cone{{0, -1, 0}, {0, 0.8, 0}, 0.6, 0.6, open}, steps));
      objects.push_back(make(scene::Cone{{0, -1, 0}, {0, 1, 0}, 1, 0.4, open}, steps));
      objects.push_back(make(scene::Cone{{-0.5, 0.3, 0}, {1, 0, 0.2}, -0.4, 0.8, open}, steps));  // double
    }
    objects.push_back(make(scene::Quadric{{1, 0.5, 1.5}, {0.2, -0.1, 0.3}, {0.1, -0.2, 0}, -1}, steps));
    objects.push_back(make(scene::Quadric{{1, -1, 0}, {0, 0, 0}, {0, 0, 1}, 0}, steps));  // some rays meet it once
    objects.push_back(
        make(scene::Triangle{{Vec3(-1.3, -0.8, 0.4), Vec3(1.2, -0.9, -0.3), Vec3(0.2, 1.4, 0.1)}}, steps));
    objects.push_back(make(scene::SmoothTriangle{{Vec3(0.3, -1.2, -1), Vec3(0.2, 1.3, -0.8), Vec3(-0.3, 0.2, 1.5)},
                                                 {Vec3(1, 0, 0), Vec3(1, 0.2, 0), Vec3(1, 0.1, -0.3)}},
                           steps));
    objects.push_back(make(scene::Torus{0.9, 0.35}, steps));
    objects.push_back(make(scene::Torus{0.3, 0.6}, steps));
    for (const auto& [east, north] : {std::pair{0.4, 0.8}, {1.0, 1.0}, {2.0, 0.15}, {1.3, 2.0}, {2.5, 1.0}})
      objects.push_back(make(scene::Superellipsoid{east, north}, steps));
    add_curved(steps, objects);
    add_meshes(steps, objects);
    add_intersections(steps, objects);
    objects.push_back(make(scene::Sphere{Vec3(0), 0.8}, [&](Object& o) {
      if (steps) steps(o);
      o.clipped_by.push_back(make(scene::Plane{{0, 1, 0}, 0}));
    }));
  }
  return objects;
}

TEST(PacketKernels, ShapesAnswerForEightRaysAsForEach) {
  Rays rays;
  for (const ObjectRef& object : solids()) {
    const std::unique_ptr<Shape> shape = compile(*object);
    int met = 0, blocked_rays = 0;
    for (int round = 0; round < kRounds; ++round) {
      const int first = round % 9;
      rays.fill(round, first);
      const RayPacket packet{*rays.batches, first, rays.active};
      const double t_min = round % 7 == 0 ? 1.5 : 1e-4;
      Hit hits[kLanes];
      const unsigned found = shape->intersect_packet(packet, nullptr, RayKind::camera, t_min, rays.limit, hits);
      const unsigned blocked = shape->occludes_packet(packet, nullptr, t_min, rays.limit);
      ASSERT_EQ(found & ~rays.active, 0u);
      for (int k = 0; k < kLanes; ++k) {
        if (!(rays.active >> k & 1)) continue;
        Hit alone;
        const bool expected = shape->intersect(packet.at(k), RayKind::camera, t_min, rays.limit[k], alone);
        ASSERT_EQ(found >> k & 1, expected) << object->shape.index() << ' ' << round << ' ' << k;
        ASSERT_EQ(blocked >> k & 1, shape->occludes(packet.at(k), t_min, rays.limit[k]));
        if (expected) {
          ASSERT_TRUE(same(hits[k], alone)) << object->shape.index() << ' ' << round << ' ' << k;
        }
        met += expected, blocked_rays += blocked >> k & 1;
      }
    }
    EXPECT_GT(met, 1000);
    EXPECT_EQ(met, blocked_rays);
  }
}

class PacketKernel : public EachInstructionSet {};

TEST_P(PacketKernel, GivesTheSameBitsAsEveryOther) {
  const QuadricKernels *kernels = quadric_kernels(GetParam()), &plain = *quadric_kernels(simd::kBaseline);
  const TorusQuartic* torus = torus_quartic_kernel(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  const Transform moved = Transform::scaling({0.7, -1.2, 0.9}).then(Transform::rotation({20, 70, -40}));
  Rays rays;
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, round % 9);
    const RayPacket packet{*rays.batches, round % 9, 255};
    const Transform* matrix = round % 2 ? &moved : nullptr;
    const auto compare = [&](auto&& ask) {
      PacketHits a, b;
      ask(*kernels, a);
      ask(plain, b);
      for (int k = 0; k < kLanes; ++k) {
        ASSERT_EQ(a.part[k], b.part[k]);
        if (a.part[k] >= 0) {
          ASSERT_TRUE(same(a.t[k], b.t[k]));
        }
        met += a.part[k] >= 0;
      }
    };
    compare([&](const QuadricKernels& set, PacketHits& hits) {
      set.sphere({0.1, -0.2, 0.3}, 0.8, matrix, packet, 1e-4, rays.limit, hits);
    });
    compare([&](const QuadricKernels& set, PacketHits& hits) {
      set.box({.matrix = matrix, .a = Vec3(-0.9), .b = Vec3(0.8)}, packet, 1e-4, rays.limit, hits);
    });
    for (const bool open : {false, true}) {
      compare([&](const QuadricKernels& set, PacketHits& hits) {
        set.cone(true, open, 0, matrix, packet, 1e-4, rays.limit, hits);
      });
      compare([&](const QuadricKernels& set, PacketHits& hits) {
        set.cone(false, open, -0.4, matrix, packet, 1e-4, rays.limit, hits);
      });
    }
    const scene::Quadric saddle{{1, -0.5, 0}, {0.2, 0, 0.3}, {0, 0.1, 1}, round % 3 - 1.0};
    compare([&](const QuadricKernels& set, PacketHits& hits) { set.quadric(saddle, packet, 1e-4, rays.limit, hits); });
    TorusPacket a, b;
    (*torus)(0.8, 0.3, matrix, packet, a);
    (*torus_quartic_kernel(simd::kBaseline))(0.8, 0.3, matrix, packet, b);
    ASSERT_EQ(a.met, b.met);
    each_lane(a.met, [&](int k) {
      ++met;
      ASSERT_TRUE(same(a.advance[k], b.advance[k]) && same(a.scale[k], b.scale[k]));
      for (const auto& [x, y] :
           {std::pair{a.c[0][k], b.c[0][k]}, {a.c[1][k], b.c[1][k]}, {a.c[2][k], b.c[2][k]}, {a.c[3][k], b.c[3][k]}})
        ASSERT_TRUE(same(x, y));
    });
  }
  EXPECT_GT(met, 10000);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, PacketKernel, all_instruction_sets());

}  // namespace
}  // namespace verisim::shapes::testing
