// Integration scenes of spec 06 section 19.1, and the shadow cache, as POV-Ray 3.7.0.10 renders them.
#include <gtest/gtest.h>

#include "tests/support/shading_probe.h"
#include "tracer/image/output.h"

namespace verisim::test {
namespace {

// Integration scenes of spec 06 section 19.1: 8x6 pixels, 8 bits sRGB, rows from the top.
struct IntegrationScene {
  std::string name, scene;
  std::vector<int> expected;
};
void PrintTo(const IntegrationScene& s, std::ostream* out) { *out << s.name; }

class IntegrationScenes : public testing::TestWithParam<IntegrationScene> {};

TEST_P(IntegrationScenes, EqualPovRay) {
  const render::Framebuffer picture = render_text(GetParam().scene, 8, 6);
  const image::Quantised q = image::quantise(picture, {});
  for (std::size_t i = 0; i < GetParam().expected.size(); ++i)
    EXPECT_NEAR(q.samples[i], GetParam().expected[i], 1)
        << "column " << i / 3 % 8 << " row " << i / 24 << " channel " << i % 3;
}

INSTANTIATE_TEST_SUITE_P(
    Spec06, IntegrationScenes,
    testing::Values(
        IntegrationScene{
            "A",
            R"(#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
camera { location <0,2.2,-7> look_at <0,.8,0> right 4/3*x angle 45 }
light_source { <6,8,-6> rgb <1,.95,.85> area_light 2*x,2*y,5,5 circular orient adaptive 1 }
light_source { <-5,6,-3> rgb <.4,.5,.8> spotlight point_at <0,0,1> radius 12 falloff 24 tightness 2 fade_distance 6
fade_power 2 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.7,.8,.9>] [1 rgb <.1,.2,.6>] } } }
fog { fog_type 2 distance 25 rgbt <.6,.65,.7,.1> fog_alt .6 fog_offset .1 }
plane { y,0 pigment { checker rgb .9 rgb <.3,.1,.1> } finish { ambient .05 diffuse .7 reflection { .02,.3 } } }
sphere { <-1.3,1,0>,1 pigment { rgbf <.8,.95,.9,.9> } finish { ambient 0 diffuse .05 specular .6 roughness .01
reflection { 0,1 fresnel } conserve_energy }
  interior { ior 1.5 fade_distance 1.5 fade_power 1 fade_color <.6,.9,.8> } }
sphere { <1.2,.9,.6>,.9 pigment { rgb <.9,.6,.2> } finish { ambient .02 diffuse .3 brilliance 3 phong .7 phong_size
60 metallic reflection { .3,.7 metallic } } }
box { <-.3,0,-1.6>,<.5,.7,-1.2> pigment { rgb <.2,.5,.3> } finish { ambient .1 diffuse .6,.2 irid { .3 thickness .4 }
} rotate 20*y })",
            {212, 225, 239, 212, 225, 239, 212, 225, 239, 212, 225, 239, 212, 225, 239, 212, 225, 239, 212, 225, 239,
             212, 225, 239, 184, 190, 196, 177, 181, 187, 95,  105, 120, 184, 189, 195, 176, 180, 186, 184, 190, 195,
             184, 190, 195, 178, 182, 188, 157, 152, 159, 137, 173, 167, 144, 155, 154, 126, 142, 135, 170, 154, 116,
             135, 120, 87,  186, 163, 114, 194, 196, 198, 139, 138, 146, 178, 227, 220, 137, 182, 186, 147, 161, 174,
             128, 132, 142, 141, 123, 92,  156, 141, 148, 206, 207, 207, 155, 134, 145, 211, 218, 230, 105, 103, 116,
             83,  119, 107, 200, 195, 186, 211, 210, 212, 157, 134, 143, 216, 218, 221, 143, 122, 132, 134, 116, 118,
             196, 198, 193, 193, 193, 186, 145, 121, 131, 136, 102, 98,  208, 208, 207, 210, 210, 208}},
        IntegrationScene{
            "B",
            R"(#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 adc_bailout .01 ambient_light rgb <1,.9,.8> }
background { rgb <.05,.05,.15> }
camera { location <0,3,-6> look_at <0,.7,0> right 4/3*x angle 50 }
light_source { <4,7,-2> rgb .8 parallel point_at 0 }
light_source { <0,5,0> rgb <.9,.3,.2> cylinder point_at <0,0,0> radius 1 falloff 1.6 }
light_source { <-6,3,-6> rgb .25 shadowless }
rainbow { direction <0,-.3,1> angle 18 width 6 distance 40 color_map { [0 rgbt <.4,.1,.8,.5>] [.5 rgbt <.1,.9,.2,.5>]
[1 rgbt <1,.2,.1,.5>] } arc_angle 160 falloff_angle 90 }
plane { y,0 pigment { rgb .8 } finish { ambient .1 diffuse .7 } }
light_group {
  light_source { <-4,4,-4> rgb <.2,.9,.3> fade_distance 5 fade_power 1 }
  sphere { <-1.5,.8,0>,.8 texture { pigment { rgb <.9,.7,.5> } finish { diffuse .8 specular albedo .3 roughness .05 }
}
    texture { pigment { gradient y color_map { [0 rgbt 1] [.5 rgbft <.3,.4,.9,.3,.3>] [1 rgbt <.2,.2,.9,.1>] } scale
.5 } finish { ambient .2 diffuse .4 reflection .1 } } }
  global_lights off }
intersection { plane { -y,0 } plane { <1,1,0>,.9 } plane { <-1,1,0>,.9 } plane { -z,.8 } plane { z,1.2 } pigment {
rgbt <1,1,1,.95> } finish { diffuse .02 reflection { .05,.6 } }
  interior { ior 1.45 dispersion 1.08 dispersion_samples 5 } translate <1.2,0,.2> }
disc { <0,2.2,.5>,<.2,1,.3>,.8 texture { checker texture { pigment { rgbf <1,.6,.2,.8> } } texture { pigment { rgb .3
} finish { diffuse .3,.5 } } scale .4 } })",
            {182, 181, 179, 190, 186, 154, 174, 152, 204, 182, 181, 179, 182, 181, 179, 174, 152, 203, 190, 186, 154,
             182, 181, 179, 185, 183, 182, 181, 185, 181, 185, 183, 182, 185, 183, 182, 184, 183, 182, 184, 183, 182,
             180, 185, 181, 184, 182, 181, 187, 186, 185, 111, 184, 147, 85,  109, 101, 187, 185, 184, 186, 185, 184,
             184, 183, 188, 186, 184, 183, 185, 184, 183, 189, 188, 187, 125, 160, 117, 123, 104, 94,  244, 200, 188,
             237, 196, 192, 189, 188, 186, 190, 189, 187, 186, 185, 184, 191, 189, 188, 190, 189, 187, 208, 195, 191,
             255, 213, 204, 255, 213, 204, 207, 193, 190, 188, 186, 185, 187, 186, 185, 191, 190, 189, 191, 189, 188,
             190, 189, 188, 190, 188, 187, 189, 188, 187, 189, 187, 186, 188, 187, 186, 188, 187, 185}}),
    [](const testing::TestParamInfo<IntegrationScene>& s) { return s.param.name; });

// A CSG object with an opaque texture of its own filters twice once it is remembered (spec 08 D): 0.5 of the light
// passes the right half of the slab, which the left half has made known.
TEST(ShadowCache, RememberedCsgFiltersTwice) {
  const auto floor_at = [](const std::string& object, bool replay) {
    render::Options options;
    options.replay = replay;
    const std::string scene = std::string("#version 3.7;") + kPrelude + R"(
camera { orthographic location 50*y direction -y right 2*x up z } plane { y,0 texture { Wht } } light_source { 1000*y
rgb 1 parallel point_at 0 }
#declare A = box { <-2,1,-2>,<0,2,2> no_image } #declare B = box { <0,1,-2>,<2,2,2> pigment { rgbt <1,1,1,.5> }
no_image }
)" + object;
    const render::Framebuffer frame = render_text(scene, 2, 1, options);
    EXPECT_EQ(lin16(frame, 0, 0)[0], 0);
    return lin16(frame, 1, 0)[0];
  };
  const std::string opaque = "pigment { rgb 1 }";
  for (const bool replay : {false, true}) {
    EXPECT_NEAR(floor_at("merge { object { A } object { B } " + opaque + " no_image }", replay), 65535 / 8, 2);
    EXPECT_NEAR(floor_at("merge { object { A " + opaque + " } object { B } no_image }", replay), 65535 / 4, 2);
    EXPECT_NEAR(floor_at("union { object { A } object { B } " + opaque + " no_image }", replay), 65535 / 4, 2);
    EXPECT_NEAR(
        floor_at("union { object { A } object { B } " + opaque + " clipped_by { plane { -y,0 } } no_image }", replay),
        65535 / 8, 2);
    EXPECT_NEAR(floor_at("merge { object { A } object { B } texture { checker texture { " + opaque + " } texture { " +
                             opaque + " } } no_image }",
                         replay),
                65535 / 4, 2);
  }
}

// The disc cuts through all of the box of 4, but the object's box is the disc's: light that misses that is not asked
// about the cut, remembered or not (spec 08 D).
TEST(ShadowCache, RememberedObjectIsAskedWithinItsBox) {
  render::Options options;
  options.replay = true;
  const render::Framebuffer frame = render_text(std::string("#version 3.7;") + kPrelude + R"(
camera { orthographic location 50*y direction -y right 2*x up z } plane { y,0 texture { Wht } } light_source { 1000*y
rgb 1 parallel point_at 0 }
intersection { disc { <-.5,2,0>,y,.3 } box { <-2,1,-2>,<2,3,2> } pigment { rgb 1 } no_image })",
                                                2, 1, options);
  EXPECT_EQ(lin16(frame, 0, 0)[0], 0);
  EXPECT_NEAR(lin16(frame, 1, 0)[0], 65535, 2);
}

// POV-Ray's shadow cache makes an opaque occluder count from 1e-4 on if it blocked the light of the pixel before (S9,
// spec 06 9.2); by default it counts whatever was before, but not for lights of groups, which have no cache.
TEST(ShadowCache, OccluderInTheContactZoneShadows) {
  const std::string scene = std::string("#version 3.7;") + kPrelude + R"(
camera { orthographic location 50*y direction -y right 2*x up z } plane { y,0 texture { Wht } } light_source { 1000*y
rgb 1 parallel point_at 0 }
disc { <0,.01025,0>,vnormalize(<.0195,1,0>),3 no_image })";
  const render::Framebuffer plain = render_text(scene, 2, 1);
  EXPECT_EQ(lin16(plain, 0, 0)[0], 0);
  EXPECT_EQ(lin16(plain, 1, 0)[0], 0);
  std::string grouped = scene;
  grouped.insert(grouped.find("plane {"), "light_group { ");
  const render::Framebuffer group = render_text(grouped + "}", 2, 1);
  EXPECT_EQ(lin16(group, 0, 0)[0], 0);
  EXPECT_NEAR(lin16(group, 1, 0)[0], 65535, 2);
  render::Options options;
  options.replay = true;
  const render::Framebuffer replayed = render_text(scene, 2, 1, options);
  EXPECT_EQ(lin16(replayed, 0, 0)[0], 0);
  EXPECT_EQ(lin16(replayed, 1, 0)[0], 0);
}

// The remembered disc counts as far as the light, but ends 0.001 before what the light is projected through: it rises
// through 2.9985 in the middle by 0.001 from there to either side (spec 08 D).
TEST(ShadowCache, OccluderNearTheLightShadows) {
  const auto shadowed = [](const std::string& light) {
    render::Options options;
    options.replay = true;
    const std::string scene = std::string("#version 3.7;") + kPrelude + R"(
camera { orthographic location 50*y direction -y right 4*x up z } plane { y,0 texture { Wht } }
disc { <0,2.9985,0>,vnormalize(<-.001,1,0>),9 no_image }
light_source { )" + light + " }";
    const render::Framebuffer frame = render_text(scene, 64, 1, options);
    int dark = 0;
    for (int x = 0; x < 64; ++x) dark += lin16(frame, x, 0)[0] == 0;
    return dark;
  };
  EXPECT_EQ(shadowed("3*y rgb 1 parallel point_at 0"), 56);
  EXPECT_EQ(shadowed("1000*y rgb 1 parallel point_at 0 projected_through { plane { y,3 } }"), 40);
}

// A ray that has met the red sphere before it comes to the box of the green one does not ask that, though it is nearer
// (spec 08 A). Numbers of pixels are POV-Ray's.
TEST(Bounds, WhatReachesOutOfItsBoxIsAskedInItsTurn) {
  for (const bool replay : {false, true}) {
    render::Options options;
    options.replay = replay;
    const render::Framebuffer frame = render_text(std::string("#version 3.7;") + kPrelude + R"(
camera { fisheye location -5*z angle 30 }
intersection { sphere { 0, 1 } plane { -z, 2 } bounded_by { sphere { .9*z, .9 } }
pigment { rgb y } finish { emission 1 ambient 0 diffuse 0 } }
sphere { 0, .5 pigment { rgb x } finish { emission 1 ambient 0 diffuse 0 } } sphere { 20*y,1 } sphere { 30*y,1 })",
                                                  16, 12, options);
    int red = 0, green = 0;
    for (int i = 0; i < 16 * 12; ++i) {
      const auto color = lin16(frame, i % 16, i / 16);
      red += color[0] > 0, green += color[1] > 0;
    }
    EXPECT_EQ(red, 16);
    EXPECT_EQ(green, 16);
  }
}

// What has no weight in an average is shaded and draws numbers: each pixel takes the second of two (spec 05 11.1).
TEST(Average, ShadesWhatDoesNotCount) {
  render::Options options;
  options.replay = true;
  const auto row = [&](const std::string& texture, int width) {
    return render_text(std::string("#version 3.7;") + kPrelude + R"(
camera { orthographic location 50*y direction -y right 2*x up z } light_source { 1000*y rgb 1 parallel point_at 0 }
plane { y,0 texture { )" + texture +
                           " } }",
                       width, 1, options);
  };
  const std::string grains = "pigment { rgb 0.5 } finish { ambient 0 diffuse 1 crand 0.2 }";
  const render::Framebuffer alone = row(grains, 8),
                            averaged = row("average texture_map { [0 " + grains + "] [1 " + grains + "] }", 4);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(lin16(averaged, x, 0)[0], lin16(alone, 2 * x + 1, 0)[0]) << x;
}

// Its second hit, the first that is not clipped away, seems to be nearer than it is: nearer than the sphere before it
// and than all that the clip leaves of its box (spec 08 M).
TEST(JuliaFractal, IsSeenBeforeWhatIsNearer) {
  const render::Framebuffer frame = render_text(R"(#version 3.7;
camera { orthographic location <-6,8,-5> direction <0.514874,-0.694366,0.502752> right 1e-5*x up 1e-5*y }
#default { finish { ambient 1 diffuse 0 } }
sphere { <-0.5,0.2,0.5>,0.5 pigment { rgb x } }
sphere { <0,1,0>,0.1 pigment { rgb z } }
julia_fractal { <0,0,-0.8,0> max_iteration 8 translate y scale 4 clipped_by { plane { y,0.5 } } pigment { rgb y } }
)",
                                                1, 1);
  EXPECT_EQ(lin16(frame, 0, 0)[0], 0);
  EXPECT_EQ(lin16(frame, 0, 0)[1], 65535);
}

// Scaled without being normalised again, a normal along y is no unit vector, and POV-Ray takes it to look down: the
// plane is lit from behind (spec 05 12.6).
TEST(BumpMap, TurnsOverWhatIsNotNormalised) {
  const auto brightness = [](const std::string& modifiers) {
    return lin16(render_text("#version 3.7; camera { orthographic location 5*y direction -y right x up z } "
                             "light_source { 9*y rgb 1 parallel point_at 0 } plane { y,0 pigment { rgb 1 } finish { "
                             "ambient 0 diffuse 1 } normal { bump_map { function 4,4 { 0.5 } } " +
                                 modifiers + " } }",
                             1, 1),
                 0, 0)[0];
  };
  EXPECT_NEAR(brightness("scale 2"), 65535, 2);
  EXPECT_NEAR(brightness("no_bump_scale"), 65535, 2);
  EXPECT_EQ(brightness("scale 2 no_bump_scale"), 0);
}

// At hits of the field itself the last bit decides, and with it CSG of two in one place (spec 08 F).
TEST(HeightField, InsidesAtItsOwnSurface) {
  const render::Framebuffer frame = render_text(R"(#version 3.7;
#declare Field = height_field { function 20,20 { 0.5+0.3*sin(x*9)*cos(y*7) } }
background { rgb <inside(Field, <0.41491710384827335, 0.45703891700246135, 0.8160291431913418>),
                  inside(Field, <0.2813170170974004, 0.6467555355493046, 0.02740108883981829>),
                  inside(Field, <0.9837965174051426, 0.6216424941474474, 0.1956843175395182>)> }
)",
                                                1, 1);
  EXPECT_EQ(lin16(frame, 0, 0)[0], 0);
  EXPECT_EQ(lin16(frame, 0, 0)[1], 0);
  EXPECT_EQ(lin16(frame, 0, 0)[2], 65535);
}

}  // namespace
}  // namespace verisim::test
