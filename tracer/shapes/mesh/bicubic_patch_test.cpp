// Probes 9 and 10 of spec 04.
#include "tracer/shapes/trace_test_support.h"

namespace verisim::shapes {
namespace {

using namespace test;

scene::BicubicPatch manual_patch(int u_steps, int v_steps) {
  scene::BicubicPatch p;
  p.u_steps = u_steps, p.v_steps = v_steps;
  p.points = {{{0, 0, 2},
               {1, 0, 0},
               {2, 0, 0},
               {3, 0, -2},
               {0, 1, 0},
               {1, 1, 0},
               {2, 1, 0},
               {3, 1, 0},
               {0, 2, 0},
               {1, 2, 0},
               {2, 2, 0},
               {3, 2, 0},
               {0, 3, 2},
               {1, 3, 0},
               {2, 3, 0},
               {3, 3, -2}}};
  return p;
}

TEST(BicubicPatch, DepthsAndFlatness) {
  const auto at = [](const scene::BicubicPatch& p) { return *trace(object(p), {1.23, .77, -10}, {0, 0, 1}); };
  auto fine = manual_patch(3, 3);
  for (const double flatness : {0.0, 0.1}) {
    fine.flatness = flatness;
    EXPECT_NEAR(at(fine).point.z, 0.1205859375, 1e-14);
    EXPECT_VEC_NEAR(at(fine).normal, Vec3(-0.406488786424325, -0.123563945870769, -0.905261739936094), 1e-14);
  }
  const auto coarse = at(manual_patch(0, 0));
  EXPECT_NEAR(coarse.point.z, 0.36, 1e-14);
  EXPECT_VEC_NEAR(coarse.normal, Vec3(-0.760129712844959, -0.527023267572505, -0.380064856422480), 1e-14);
  const auto uneven = at(manual_patch(1, 2));
  EXPECT_NEAR(uneven.point.z, 0.2925, 1e-14);
  EXPECT_VEC_NEAR(uneven.normal, Vec3(-0.500082101597469, -0.175327423900624, -0.848043740670391), 1e-14);
}

TEST(BicubicPatch, IgnoresClips) {
  auto o = object(manual_patch(3, 3));
  o.clipped_by = {box({-100, -100, -100}, {-50, 100, 100})};
  EXPECT_TRUE(trace(o, {1.23, .77, -10}, {0, 0, 1}));
}

TEST(BicubicPatch, Uv) {
  scene::BicubicPatch p;
  p.u_steps = p.v_steps = 2;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) p.points[4 * i + j] = Vec3(double(j), double(i), 0);
  }
  const auto uv_at = [&](double x, double y) {
    const auto o = object(p);
    const auto s = compile(o);
    return s->uv(trace(*s, {x, y, -5}, {0, 0, 1})->hit);
  };
  EXPECT_NEAR(uv_at(.5625, 2.25).x, .1875, 1e-12);
  EXPECT_NEAR(uv_at(.5625, 2.25).y, .75, 1e-12);
  p.uv = {{Vec2(.1, .2), Vec2(.5, .3), Vec2(.9, .8), Vec2(.2, .7)}};
  EXPECT_NEAR(uv_at(.5625, 2.25).x, .2922, 5e-5);
  EXPECT_NEAR(uv_at(.5625, 2.25).y, .5938, 5e-5);
}

TEST(BicubicPatch, HostileInput) {
  EXPECT_ANY_THROW(compile(object(manual_patch(1000000000, 0))));
  EXPECT_ANY_THROW(compile(object(manual_patch(15, 15))));
  auto p = manual_patch(2, 2);
  p.points[5] = Vec3(std::nan(""), 0, 0);
  trace(object(p), {1.23, .77, -10}, {0, 0, 1});
  for (auto& q : p.points) q = Vec3(1, 1, 1);
  EXPECT_FALSE(trace(object(p), {1.23, .77, -10}, {0, 0, 1}));
}

}  // namespace
}  // namespace verisim::shapes
