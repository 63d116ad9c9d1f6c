// Directions of every kind of camera against the numbers of spec 02.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tracer/render/cameras/camera_rays.h"

namespace verisim::render {
namespace {

// Spec 02 probe P1: the sky maps direction component c to 3 * (c + 1.1) / 2.2 / 3, written linear in 8 bits.
struct CameraCase {
  const char* name;
  scene::Camera camera;
  std::array<std::array<int, 3>, 4> expected;  // pixels (0,0) (11,2) (5,5) (15,11) of 16x12
};
class CameraProbe : public testing::TestWithParam<CameraCase> {};

TEST_P(CameraProbe, DirectionsOfTheTable) {
  const int pixels[4][2] = {{0, 0}, {11, 2}, {5, 5}, {15, 11}};
  const CameraRays camera(GetParam().camera, 16, 12);
  for (int i = 0; i < 4; ++i) {
    const auto ray = camera.at(pixels[i][0], pixels[i][1]);
    std::array<int, 3> got{0, 0, 0};
    if (ray) {
      const Vec3 d = normalize(ray->ray.direction);
      for (int c = 0; c < 3; ++c) got[c] = static_cast<int>(std::floor((d[c] + 1.1) / 2.2 * 255 + 0.5));
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], GetParam().expected[i][c], 0) << "pixel " << i << " channel " << c;
  }
}

scene::Camera of(scene::CameraKind kind) {
  scene::Camera c;
  c.kind = kind;
  return c;
}
scene::Camera small_fisheye() {
  scene::Camera c = of(scene::CameraKind::fisheye);
  c.right = {.5, 0, 0}, c.up = {0, .5, 0}, c.angle = 180;
  return c;
}
scene::Camera narrow_spherical() {
  scene::Camera c = of(scene::CameraKind::spherical);
  c.horizontal_angle = 200, c.vertical_angle = 100;
  return c;
}
using K = scene::CameraKind;
INSTANTIATE_TEST_SUITE_P(
    P1, CameraProbe,
    testing::Values(
        CameraCase{"perspective", {}, {{{70, 170, 219}, {159, 159, 235}, {104, 132, 241}, {185, 85, 219}}}},
        CameraCase{"fisheye", of(K::fisheye), {{{0, 0, 0}, {177, 177, 220}, {90, 135, 237}, {0, 0, 0}}}},
        CameraCase{
            "small_fisheye", small_fisheye(), {{{56, 197, 187}, {165, 178, 225}, {99, 135, 240}, {199, 58, 187}}}},
        CameraCase{
            "ultra_wide", of(K::ultra_wide_angle), {{{54, 184, 197}, {166, 166, 230}, {99, 133, 240}, {201, 71, 197}}}},
        CameraCase{"omnimax", of(K::omnimax), {{{0, 0, 0}, {187, 217, 171}, {78, 171, 223}, {0, 0, 0}}}},
        CameraCase{"panoramic", of(K::panoramic), {{{108, 242, 129}, {184, 215, 179}, {61, 141, 221}, {147, 13, 129}}}},
        CameraCase{"cylinder1", of(K::cylinder1), {{{57, 176, 206}, {165, 160, 232}, {99, 132, 240}, {198, 79, 206}}}},
        CameraCase{"cylinder2", of(K::cylinder2), {{{66, 192, 201}, {160, 177, 227}, {104, 135, 241}, {189, 63, 201}}}},
        CameraCase{"cylinder3", of(K::cylinder3), {{{50, 128, 213}, {167, 128, 237}, {99, 128, 240}, {205, 128, 213}}}},
        CameraCase{
            "cylinder4", of(K::cylinder4), {{{128, 204, 215}, {128, 179, 231}, {128, 135, 243}, {128, 51, 215}}}},
        CameraCase{"spherical", of(K::spherical), {{{125, 242, 113}, {197, 219, 141}, {32, 143, 191}, {130, 13, 113}}}},
        CameraCase{"narrow_spherical",
                   narrow_spherical(),
                   {{{47, 211, 122}, {197, 184, 201}, {68, 136, 226}, {208, 44, 122}}}}),
    [](const auto& i) { return std::string(i.param.name); });

}  // namespace
}  // namespace verisim::render
