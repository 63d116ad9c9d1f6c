// Eight rays at once find what each finds alone, to the last bit, whatever their numbers are, and with every
// instruction set.
#include "tracer/shapes/packet_kernels.h"

#include <cstring>
#include <limits>
#include <memory>

#include "tracer/shapes/blob/blob_packet.h"
#include "tracer/shapes/mesh/mesh_packet.h"
#include "tracer/shapes/swept/lathe_packet.h"
#include "tracer/shapes/algebraic/poly_packet.h"
#include "tracer/shapes/swept/sphere_sweep_packet.h"
#include "tracer/shapes/algebraic/superellipsoid_packet.h"
#include "tracer/shapes/test_support.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shapes::testing {
namespace {

constexpr int kLanes = RayPacket::kCount, kRounds = 3000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }
bool same(const Hit& a, const Hit& b) {
  return same(a.t, b.t) && same(a.point.x, b.point.x) && same(a.point.y, b.point.y) && same(a.point.z, b.point.z) &&
         a.shape == b.shape && a.part == b.part && same(a.u, b.u) && same(a.v, b.v);
}

// Rays towards and beside the origin; every third round some of their numbers are strange.
class Rays {
 public:
  void fill(int round, int first) {
    static const double kStrange[] = {
        0.0, -0.0, 5e-324, -1e-310, 1e-11,     -1e-9,      1,
        -1,  1e8,  1e200,  -1e300,  kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
    std::normal_distribution<double> d;
    std::uniform_int_distribution<std::size_t> any(0, std::size(kStrange) - 1);
    for (int i = first; i < first + kLanes; ++i) {
      const Vec3 origin = Vec3(d(random), d(random), d(random)) * (round % 2 ? 3.0 : 0.5),
                 target = Vec3(d(random), d(random), d(random)) * 0.7;
      batches->origin.set(i, origin);
      batches->direction.set(i, normalize(target - origin));
      if (round % 3 == 0) {
        double* const numbers[] = {batches->origin.x,    batches->origin.y,    batches->origin.z,
                                   batches->direction.x, batches->direction.y, batches->direction.z};
        for (std::size_t n = 0; n < 1 + any(random) % 2; ++n) numbers[any(random) % 6][i] = kStrange[any(random)];
        // Directions are of unit length, or nothing that has one.
        const Vec3 strange = batches->direction.at(i), unit = normalize(strange);
        if (length(strange) < kInfinity && length(unit) > 0.5) batches->direction.set(i, unit);
      }
      limit[i - first] = round % 5 == 0 ? 2 + std::fabs(d(random)) : kInfinity;
    }
    active = round % 4 == 0 ? static_cast<unsigned>(any(random) * 17 & 255) : 255;
  }
  std::mt19937 random{21};
  std::unique_ptr<RayBatch> batches = std::make_unique<RayBatch>();
  alignas(64) double limit[kLanes];
  unsigned active = 255;
};

const Steps kMoved[] = {{}, [](Object& o) {
                          scene::transform(o, Transform::scaling({0.7, -1.2, 0.9})
                                                  .then(Transform::rotation({20, 70, -40}))
                                                  .then(Transform::translation({0.2, 0.1, -0.3})));
                        }};

struct Term {
  int x, y, z;  // powers
  double factor;
};
scene::Poly poly(int order, const std::vector<Term>& terms) {
  scene::Poly result{order, {}};
  for (int i = order; i >= 0; --i)
    for (int j = order - i; j >= 0; --j)
      for (int k = order - i - j; k >= 0; --k) {
        result.coefficients.push_back(0);
        for (const Term& t : terms)
          if (t.x == i && t.y == j && t.z == k) result.coefficients.back() = t.factor;
      }
  return result;
}

// A bumpy sheet, folded so that rays cross it more than once, and a tent that is solid.
void add_meshes(const Steps& steps, std::vector<ObjectRef>& objects) {
  constexpr std::uint32_t kSide = 24;
  scene::MeshData sheet;
  for (std::uint32_t i = 0; i <= kSide; ++i)
    for (std::uint32_t k = 0; k <= kSide; ++k) {
      const double x = i * 2.4 / kSide - 1.2, z = k * 2.4 / kSide - 1.2;
      sheet.vertices.emplace_back(x, float(0.5 * std::sin(5 * x) + 0.2 * std::cos(7 * z)), z);
    }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    scene::MeshTriangle t;
    t.vertex = t.normal = t.uv = {a, b, c};
    sheet.triangles.push_back(t);
  };
  for (std::uint32_t i = 0; i < kSide; ++i)
    for (std::uint32_t k = 0; k < kSide; ++k) {
      const std::uint32_t a = i * (kSide + 1) + k;
      add(a, a + 1, a + kSide + 1), add(a + 1, a + kSide + 2, a + kSide + 1);
      if (i == k) add(a, a + 1, a + kSide + 1);  // written twice
    }
  scene::MeshData solid = sheet;
  solid.inside_vector = Vec3(0, 1, 0);
  for (const auto& data : {sheet, solid})
    objects.push_back(make(scene::Mesh{std::make_shared<const scene::MeshData>(data), {}}, steps));
  objects.push_back(make(scene::Mesh{std::make_shared<const scene::MeshData>(sheet), {}}, [&](Object& o) {
    if (steps) steps(o);
    o.hierarchy = false;
  }));
}

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

class PacketKernel : public ::testing::TestWithParam<int> {};

TEST_P(PacketKernel, GivesTheSameBitsAsEveryOther) {
  const PacketKernels *kernels = packet_kernels(GetParam()), &plain = *packet_kernels(simd::kBaseline);
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
    compare([&](const PacketKernels& set, PacketHits& hits) {
      set.sphere({0.1, -0.2, 0.3}, 0.8, matrix, packet, 1e-4, rays.limit, hits);
    });
    compare([&](const PacketKernels& set, PacketHits& hits) {
      set.box(Vec3(-0.9), Vec3(0.8), matrix, packet, 1e-4, rays.limit, hits);
    });
    for (const bool open : {false, true}) {
      compare([&](const PacketKernels& set, PacketHits& hits) {
        set.cone(true, open, 0, matrix, packet, 1e-4, rays.limit, hits);
      });
      compare([&](const PacketKernels& set, PacketHits& hits) {
        set.cone(false, open, -0.4, matrix, packet, 1e-4, rays.limit, hits);
      });
    }
    const scene::Quadric saddle{{1, -0.5, 0}, {0.2, 0, 0.3}, {0, 0.1, 1}, round % 3 - 1.0};
    compare([&](const PacketKernels& set, PacketHits& hits) { set.quadric(saddle, packet, 1e-4, rays.limit, hits); });
    const TriangleShape slanted{normalize(Vec3(0.4, -0.9, 0.3)), 0.1, 0, 2, {-1.5, 1.3, 0.1}, {-1.2, -1, 1.7}};
    compare([&](const PacketKernels& set, PacketHits& hits) { set.triangle(slanted, packet, 1e-4, rays.limit, hits); });
    TorusPacket a, b;
    kernels->torus(0.8, 0.3, matrix, packet, a);
    plain.torus(0.8, 0.3, matrix, packet, b);
    for (int k = 0; k < kLanes; ++k) {
      ASSERT_EQ(a.met[k], b.met[k]);
      if (a.met[k] == 0) continue;
      ++met;
      ASSERT_TRUE(same(a.advance[k], b.advance[k]) && same(a.scale[k], b.scale[k]));
      for (const auto& [x, y] :
           {std::pair{a.c[0][k], b.c[0][k]}, {a.c[1][k], b.c[1][k]}, {a.c[2][k], b.c[2][k]}, {a.c[3][k], b.c[3][k]}})
        ASSERT_TRUE(same(x, y));
    }
  }
  EXPECT_GT(met, 10000);
}

TEST_P(PacketKernel, MeetsTheSameTrianglesOfAMesh) {
  const MeshKernels *kernels = mesh_kernels(GetParam()), &plain = *mesh_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::vector<ObjectRef> objects;
  add_meshes({}, objects);
  const auto mesh = MeshGeometry::of(objects[0]->as<scene::Mesh>()->data);
  Rays rays;
  int met = 0, passed_over = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    MeshPacket a, b;
    packet_kernels(simd::kBaseline)->local(nullptr, {*rays.batches, 0, rays.active}, a.rays);
    b.rays = a.rays;
    const double t_min = round % 2 ? 1e-4 : 1;
    kernels->meet(*mesh, nullptr, rays.active, t_min, rays.limit, false, a);
    plain.meet(*mesh, nullptr, rays.active, t_min, rays.limit, false, b);
    for (int k = 0; k < kLanes; ++k) {
      ASSERT_EQ(a.triangle[k], b.triangle[k]);
      ASSERT_TRUE(same(a.t[k], b.t[k]));
      met += a.triangle[k] >= 0;
    }
    ASSERT_EQ(a.passed_over, b.passed_over);
    passed_over += std::popcount(a.passed_over);
  }
  EXPECT_GT(met, 3000);
  EXPECT_GT(passed_over, 1000);
}

TEST_P(PacketKernel, MakesTheSamePolynomialsAlongRays) {
  const PacketKernels* kernels = packet_kernels(GetParam());
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  const Transform moved = Transform::scaling({0.7, -1.2, 0.9}).then(Transform::rotation({20, 70, -40}));
  const scene::Poly surface =
      poly(6, {{6, 0, 0, 1}, {1, 2, 3, -0.7}, {0, 4, 1, 2}, {0, 0, 5, 0.3}, {2, 1, 0, 1}, {0, 0, 0, -1}});
  std::vector<unsigned char> used(28, 1);
  const SweepCubic cubic{{{0.1, -0.3, 0.2, 0.4}, {1, 0.5, -0.2, 0.1}, {-0.3, 0.8, 0.5, -0.2}, {0.2, -0.7, 0.3, 0.1}},
                         {0.55, 0.06, 0.26}};
  Rays rays;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, round % 9);
    const RayPacket packet{*rays.batches, round % 9, 255};
    LocalPacket local, plain_local;
    kernels->local(round % 2 ? &moved : nullptr, packet, local);
    packet_kernels(simd::kBaseline)->local(round % 2 ? &moved : nullptr, packet, plain_local);
    PolyPacket a, b;
    (*poly_along(GetParam()))(6, surface.coefficients.data(), used.data(), local, a);
    (*poly_along(simd::kBaseline))(6, surface.coefficients.data(), used.data(), plain_local, b);
    ASSERT_EQ(a.size, 7);
    ASSERT_EQ(b.size, 7);
    SweepSidePacket c, d;
    (*sweep_follow(GetParam()))(cubic, local, c);
    (*sweep_follow(simd::kBaseline))(cubic, plain_local, d);
    for (int k = 0; k < kLanes; ++k) {
      for (int i = 0; i < 7; ++i) ASSERT_TRUE(same(a.c[i][k], b.c[i][k]));
      for (int i = 0; i < 11; ++i) ASSERT_TRUE(same(c.power[i][k], d.power[i][k]));
    }
  }
}

TEST_P(PacketKernel, MeetsThePartsOfABlobAlike) {
  const BlobKernels *kernels = blob_kernels(GetParam()), &plain = *blob_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  std::vector<BlobPart> parts(4);
  PartSpheres spheres;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    BlobPart& part = parts[i];
    part.kind = static_cast<BlobPartKind>(i);
    part.center = Vec3(0.2 * double(i), -0.1, 0.3), part.length = 0.7;
    part.radius2 = 0.5, part.k0 = 4, part.k1 = -4, part.k2 = 1;
    part.moved = i == 2, part.transform = Transform::scaling({0.7, 1.2, 0.9});
    spheres.x[i] = part.center.x, spheres.y[i] = part.center.y, spheres.z[i] = part.center.z, spheres.radius[i] = 1.1;
  }
  Rays rays;
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    LocalPacket local;
    packet_kernels(simd::kBaseline)->local(nullptr, {*rays.batches, 0, 255}, local);
    const Ray ray = rays.batches->at(3);
    ASSERT_EQ(kernels->near(&spheres, 1, ray.origin, ray.direction, 0.1, 0.2),
              plain.near(&spheres, 1, ray.origin, ray.direction, 0.1, 0.2));
    const std::uint64_t around = plain.around(&spheres, 1, ray.origin);
    ASSERT_EQ(kernels->around(&spheres, 1, ray.origin), around);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (length(ray.origin - parts[i].center) <= spheres.radius[i]) {
        ASSERT_TRUE(around >> i & 1);
      }
    }
    // What lies near is never left out.
    const std::uint64_t near = plain.near(&spheres, 1, ray.origin, ray.direction, 0, 0);
    PiecePacket a[4], b[4];
    const std::size_t count = kernels->pieces(parts.data(), 15, local, rays.active, a);
    ASSERT_EQ(count, plain.pieces(parts.data(), 15, local, rays.active, b));
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(a[i].part == b[i].part && a[i].met == b[i].met);
      const auto index = static_cast<std::size_t>(a[i].part - parts.data());
      if (a[i].met >> 3 & 1 && !a[i].part->moved) {
        ASSERT_TRUE(near >> index & 1);
      }
      each_lane(a[i].met, [&](int k) {
        ASSERT_TRUE(same(a[i].t0[k], b[i].t0[k]) && same(a[i].t1[k], b[i].t1[k]) && same(a[i].peak[k], b[i].peak[k]) &&
                    same(a[i].stretch[k], b[i].stretch[k]));
        ++met;
      });
    }
  }
  EXPECT_GT(met, 5000);
}

TEST_P(PacketKernel, MeetsALatheAlike) {
  const LatheKernels *kernels = lathe_kernels(GetParam()), &plain = *lathe_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  const CurveSegment segment = CurveSegment::bezier({0.4, -1}, {1.2, -0.6}, {0.1, -0.2}, {0.3, 0.7});
  Rays rays;
  int met = 0, passed = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    LathePacket a, b;
    RootPacket roots_a, roots_b;
    const auto ask = [&](const LatheKernels& set, LathePacket& packet, RootPacket& roots) {
      packet_kernels(simd::kBaseline)->local(nullptr, {*rays.batches, 0, 255}, packet.rays);
      const unsigned near = set.begin(0.8, rays.active, packet);
      set.follow(segment, packet, roots);
      return near & set.beside(-0.3, 0.2, 1e-9, packet);
    };
    const unsigned found = ask(*kernels, a, roots_a);
    ASSERT_EQ(found, ask(plain, b, roots_b));
    each_lane(found, [&](int k) {
      EightSegments segments;
      for (int i = 0; i < 8; ++i) {
        segments.y_low[i] = 0.25 * i - 1, segments.y_high[i] = segments.y_low[i] + 0.1 * (round % 5);
        segments.low2[i] = 0.01 * i * i, segments.high2[i] = segments.low2[i] + 0.02 * (round % 7);
      }
      const double dy = a.rays.dy[k], near = round % 3 == 0 ? 0.5 : 0;
      LathePassage ray{a.y0[k], a.y1[k], 1e-9, a.r[k], a.m[k], a.c[k], a.rays.oy[k], near, near + 2};
      if (std::fabs(dy) > 0.1) ray.inverse = 1 / dy, ray.turn = -a.m[k] / a.r[k], ray.doubt = 1e-5;
      const unsigned along = kernels->along(segments, ray);
      ASSERT_EQ(along, plain.along(segments, ray));
      passed += 8 - std::popcount(along);
      ASSERT_TRUE(same(a.y0[k], b.y0[k]) && same(a.y1[k], b.y1[k]));
      for (int i = 0; i < 7; ++i) ASSERT_TRUE(same(roots_a.power[i][k], roots_b.power[i][k]));
      ++met;
    });
  }
  EXPECT_GT(passed, 3000);
  EXPECT_GT(8 * met - passed, 3000);
  EXPECT_GT(met, 3000);
}

TEST_P(PacketKernel, ApproachesASuperellipsoidInTheSameSteps) {
  const SuperellipsoidKernels *kernels = superellipsoid_kernels(GetParam()),
                              &plain = *superellipsoid_kernels(simd::kBaseline);
  if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  Rays rays;
  int met = 0;
  for (int round = 0; round < kRounds; ++round) {
    rays.fill(round, 0);
    const double p = 1 + round % 14, q = 1 + round % 5 * 0.7;
    ConvexPacket a{};
    for (int k = 0; k < kLanes; ++k) {
      const Ray ray = rays.batches->at(k);
      a.ox[k] = ray.origin.x, a.oy[k] = ray.origin.y, a.oz[k] = ray.origin.z, a.dx[k] = ray.direction.x,
      a.dy[k] = ray.direction.y, a.dz[k] = ray.direction.z;
      a.t[k] = 0, a.end[k] = 20, a.side[k] = 1;
    }
    ConvexPacket b = a, alone = a, pair = a;
    const unsigned found = kernels->approach(p, q, rays.active, a);
    ASSERT_EQ(found, plain.approach(p, q, rays.active, b));
    const ConvexPacket arrived = a;
    kernels->value(p, q, a);
    plain.value(p, q, b);
    const double* values = a.value;
    each_lane(found, [&](int k) {
      ASSERT_TRUE(same(a.t[k], b.t[k]));
      ASSERT_TRUE(same(values[k], b.value[k]));
      ASSERT_TRUE(same(values[k], arrived.value[k]));
      ++met;
      // The value is that of the plain formula, and zero at the root of rays that begin outside.
      const Vec3 at(std::fabs(a.ox[k] + a.t[k] * a.dx[k]), std::fabs(a.oy[k] + a.t[k] * a.dy[k]),
                    std::fabs(a.oz[k] + a.t[k] * a.dz[k]));
      const double largest = std::max(at.x, at.y);
      if (round % 3 == 0 || !(largest > 0)) return;
      const double across = largest * std::pow(std::pow(at.x / largest, p) + std::pow(at.y / largest, p), 1 / p),
                   most = std::max(across, at.z);
      const double expected = most * std::pow(std::pow(across / most, q) + std::pow(at.z / most, q), 1 / q) - 1;
      ASSERT_NEAR(values[k], expected, 1e-13 * (1 + std::fabs(expected))) << p << ' ' << q;
      if (a.t[k] > 0) {
        ASSERT_NEAR(expected, 0, 2e-10);
      }
    });
    // What one lane finds does not depend on the others.
    const int k = round % kLanes;
    const unsigned found_alone = kernels->approach(p, q, 1u << k, alone);
    if (rays.active >> k & 1) {
      ASSERT_EQ(found_alone, found & 1u << k);
    }
    if (found >> k & 1) {
      ASSERT_TRUE(same(alone.t[k], a.t[k]));
    }
    const unsigned found_pair = kernels->approach_pair(p, q, rays.active & 3, pair);
    ASSERT_EQ(found_pair, found & 3);
    each_lane(found_pair,
              [&](int lane) { ASSERT_TRUE(same(pair.t[lane], a.t[lane]) && same(pair.value[lane], a.value[lane])); });
  }
  EXPECT_GT(met, 5000);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, PacketKernel, ::testing::Range(0, static_cast<int>(simd::kInstructionSets)));

}  // namespace
}  // namespace verisim::shapes::testing
