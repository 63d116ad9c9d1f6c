// The probes of spec 02 section 13 that need a scene: cameras, focal blur, alpha, quality, trace level, start interiors
// (P2, P3, P5, P6, P8, P15 to P19). Values are POV-Ray 3.7.0.10's with -A and, unless noted, File_Gamma=1.
#include <gtest/gtest.h>

#include "tests/support/probe.h"
#include "tracer/image/output.h"

namespace verisim::test {
namespace {

const std::string kLinear = "#version 3.7; global_settings { assumed_gamma 1 }\n";

image::Quantised codes(const render::Framebuffer& picture, int bits, bool alpha, bool srgb) {
  image::OutputOptions options;
  options.bits = bits, options.alpha = alpha, options.file_srgb = srgb;
  return image::quantise(picture, options);
}

std::vector<int> pixel(const image::Quantised& q, int x, int y) {
  const auto* p = &q.samples[static_cast<std::size_t>(q.channels) * (static_cast<std::size_t>(y) * q.width + x)];
  return {p, p + q.channels};
}

using Codes = std::vector<int>;

// P2: where camera rays hit a plane that shows its own coordinates.
struct HitProbe {
  std::string name, version, camera;
  Vec2 top_left, bottom_right;
};
void PrintTo(const HitProbe& p, std::ostream* out) { *out << p.name; }
class HitProbes : public testing::TestWithParam<HitProbe> {};

TEST_P(HitProbes, HitPositions) {
  const HitProbe& p = GetParam();
  const auto picture = render_text("#version " + p.version + R"(; global_settings { assumed_gamma 1 }
    plane { z,10 hollow pigment { average pigment_map { [1 function { (x+16)/32 } color_map { [0 rgb 0] [1 rgb
<2,0,0>] }]
                                                        [1 function { (y+16)/32 } color_map { [0 rgb 0] [1 rgb
<0,2,0>] }] } }
            finish { ambient 1 diffuse 0 } } )" +
                                       p.camera,
                                   8, 6);
  const auto near = [](const Color& c, const Vec2& expected) {
    EXPECT_NEAR(c.r * 32 - 16, expected.x, 0.0004);
    EXPECT_NEAR(c.g * 32 - 16, expected.y, 0.0004);
  };
  near(picture.at(0, 0), p.top_left);
  near(picture.at(7, 5), p.bottom_right);
}

HitProbe mirrored_hit(const std::string& name, const std::string& camera, double x, double y) {
  return {name, "3.7", camera, {x, y}, {-x, -y}};
}

INSTANTIATE_TEST_SUITE_P(
    P2, HitProbes,
    testing::Values(
        mirrored_hit("ortho", "camera { orthographic }", -0.5818, 0.4167),
        mirrored_hit("ortho_location", "camera { orthographic location <0,0,-5> }", -3.4911, 2.4999),
        mirrored_hit("ortho_look", "camera { orthographic location <0,0,-5> look_at 0 }", -2.9094, 2.0833),
        mirrored_hit("ortho_right_up", "camera { orthographic location <0,0,-5> look_at 0 right x*4 up y*3 }", -1.7501,
                     1.2499),
        mirrored_hit("ortho_right", "camera { orthographic location <0,0,-5> look_at 0 right x*4 }", -1.7501, 0.4167),
        mirrored_hit("ortho_angle", "camera { orthographic location <0,0,-5> look_at 0 angle 60 }", -2.5258, 1.8087),
        mirrored_hit("ortho_all", "camera { orthographic location <0,0,-5> look_at 0 right x*4 up y*3 angle 60 }",
                     -2.5258, 1.8041),
        mirrored_hit("ortho_direction", "camera { orthographic location <0,0,-5> look_at 0 direction 2*z }", -1.4546,
                     1.0417),
        mirrored_hit("ortho_bare_angle", "camera { orthographic angle location <0,0,-5> look_at 0 right x*4 up y*3 }",
                     -8.7500, 6.2499),
        mirrored_hit("ortho_blur",
                     "camera { orthographic location <0,0,-5> look_at 0 aperture .0001 blur_samples 4 focal_point 0 }",
                     0, 0),
        HitProbe{"translated",
                 "3.7",
                 "camera { perspective translate x location <0,0,-5> look_at 0 }",
                 {-7.7282, 6.2499},
                 {9.7281, -6.2499}},
        HitProbe{"translated_31",
                 "3.1",
                 "camera { perspective translate x location <0,0,-5> look_at 0 }",
                 {-8.7280, 6.2499},
                 {8.7280, -6.2499}},
        mirrored_hit("default_camera", "#default { camera { location <0,0,-5> } } camera { angle 60 }", -7.5778,
                     5.4263),
        mirrored_hit("no_camera", "#default { camera { location <0,0,-5> } }", -5.8187, 4.1668)),
    [](const testing::TestParamInfo<HitProbe>& p) { return p.param.name; });

const std::string kDirectionSky = R"(sky_sphere { pigment { average pigment_map {
  [1 function{(x+1.1)/2.2} color_map{[0 rgb 0][1 rgb <3,0,0>]}]
  [1 function{(y+1.1)/2.2} color_map{[0 rgb 0][1 rgb <0,3,0>]}]
  [1 function{(z+1.1)/2.2} color_map{[0 rgb 0][1 rgb <0,0,3>]}] } } }
)";

// P1: statements whose evaluation the parser does (the camera types themselves are tested beside the code).
TEST(P1, CameraStatements) {
  const std::pair<const char*, std::vector<Codes>> rows[] = {
      {"", {{70, 170, 219}, {159, 159, 235}, {104, 132, 241}, {185, 85, 219}}},
      {"location <1,2,-5> look_at <0,1,0>", {{52, 151, 212}, {136, 138, 243}, {82, 110, 233}, {167, 69, 219}}},
      {"location <1,2,-5> look_at <0,1,0> angle 40", {{70, 133, 228}, {123, 123, 243}, {92, 108, 236}, {144, 81, 232}}},
      {"right -1.33*x location <1,2,-5> look_at <0,1,0>",
       {{164, 151, 235}, {75, 138, 230}, {129, 110, 242}, {55, 69, 197}}},
      {"sky z up z right 1.5*x location <1,-5,2> look_at <0,1,0>",
       {{50, 213, 138}, {144, 242, 124}, {84, 230, 97}, {177, 208, 61}}}};
  const int at[4][2] = {{0, 0}, {11, 2}, {5, 5}, {15, 11}};
  for (const auto& [camera, expected] : rows) {
    const auto q = codes(render_text(kLinear + kDirectionSky + "camera { " + camera + " }", 16, 12), 8, false, false);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(pixel(q, at[i][0], at[i][1]), expected[i]) << camera << " pixel " << i;
  }
}

TEST(P3, CameraNormalBendsTheRaysOfSomeColumns) {
  const std::string normal =
      "camera { normal { gradient x 1 slope_map { [0 <0,0>] [.5 <0,0>] [.5 <0,1>] [1 <0,1>] } scale .5 } }";
  for (int quality : {0, 9}) {
    render::Options options;
    options.quality = quality;
    const auto plain = render_text(kLinear + kDirectionSky, 16, 12, options),
               bent = render_text(kLinear + kDirectionSky + normal, 16, 12, options);
    for (int x = 0; x < 16; ++x)
      for (int y = 0; y < 12; ++y) EXPECT_EQ(plain.at(x, y) != bent.at(x, y), x % 8 >= 4) << x << ',' << y;
  }
}

TEST(P5, FocalBlur) {
  const std::pair<const char*, Codes> rows[] = {
      {"focal_point <0,0,3> aperture .5 blur_samples 4", {13036, 14195, 15107, 16528, 17525, 19053}},
      {"focal_point <0,0,3> aperture .5 blur_samples 7", {12947, 14092, 15217, 16533, 17562, 19044}},
      {"focal_point <0,0,3> aperture .5 blur_samples 19", {12953, 14093, 15212, 16536, 17572, 19061}},
      {"focal_point <0,0,3> aperture .5 blur_samples 50", {12956, 14094, 15210, 16538, 17577, 19070}},
      {"focal_point <0,0,3> aperture .5 blur_samples 10,30", {12940, 14150, 15352, 16459, 17747, 19008}},
      {"focal_point <0,0,3> aperture .5 blur_samples 30 confidence .5 variance .01",
       {12953, 14093, 15212, 16537, 17573, 19063}},
      {"aperture .5 blur_samples 30", {13015, 14107, 15285, 16482, 17845, 24293}},
      {"focal_point <0,0,3> aperture .5 blur_samples 30 bokeh { pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } "
       "} }",
       {12930, 14081, 15278, 16521, 17542, 19104}}};
  for (const auto& [blur, expected] : rows) {
    const auto picture = render_text(kLinear + "camera { location <0,0,-2> direction z right x*1.5 up y " + blur + R"( }
      plane { z,1 pigment { function { select(x*x+y*y-0.5,0.9,0.3+0.1*x) } color_map { [0 rgb 0] [1 rgb <1,.8,.6>] }
} finish { ambient 1 diffuse 0 } })",
                                     24, 16);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(lin16(picture, 6 + i, 3)[0], expected[i], 1.1) << blur << " column " << 6 + i;
  }
}

// The lens lies on both sides of a plane that is not hollow: after a ray from within it none of the same place sees
// fog.
TEST(P5, FocalBlurBesideThingsThatAreNotHollow) {
  const auto picture =
      render_text(kLinear +
                      "camera { location 0.1*x direction z*1000 focal_point <0.1,0,1e6> aperture 1 blur_samples 4 }"
                      "fog { distance 1e-3 rgb 1 } plane { x, 0 } sphere { <9,9,-9>, 1 }",
                  32, 24);
  const float expected[] = {0, 0, .5, .5, .5, 0, 0, 0, 0, 1, 0, .5, 0, 1, 0, .5, .5, 1, 0, 0, 0, .5, .5, 0, 0, 0, .5};
  for (int x = 0; x < 27; ++x) EXPECT_NEAR(picture.at(x, 0).r, expected[x], 1e-5) << x;
}

TEST(P6, FisheyeAlpha) {
  render::Options options;
  options.output_alpha = true;
  const std::string scene = kLinear + "background { rgb 1 } camera { fisheye right x up y angle 90 }";
  const auto plain = codes(render_text(scene, 8, 8, options), 8, true, false);
  EXPECT_EQ(pixel(plain, 0, 0), (Codes{0, 0, 0, 0}));
  EXPECT_EQ(pixel(plain, 4, 4), (Codes{255, 255, 255, 255}));
  options.antialias = true, options.antialias_threshold = 0.1f, options.jitter = false;
  const auto smooth = codes(render_text(scene, 8, 8, options), 8, true, false);
  const int alpha[8] = {0, 26, 179, 255, 255, 179, 26, 0};
  for (int x = 0; x < 8; ++x)
    EXPECT_EQ(pixel(smooth, x, 0), (alpha[x] ? Codes{255, 255, 255, alpha[x]} : Codes{0, 0, 0, 0})) << x;
  EXPECT_EQ(pixel(smooth, 1, 1)[3], 230);
  options.antialias = false;
  const auto blurred = render_text(
      kLinear +
          "background { rgb 1 } camera { fisheye right x up y angle 90 aperture .1 blur_samples 4 focal_point z }",
      8, 8, options);
  EXPECT_EQ(pixel(codes(blurred, 8, true, false), 0, 0), (Codes{0, 0, 0, 255}));
}

struct AlphaProbe {
  const char *scene, *version;
  Codes corner, centre, corner_alpha, centre_alpha;
};

TEST(P8, AlphaOfBackgroundsAndObjects) {
  const AlphaProbe rows[] = {
      {"#declare P = pigment { rgbt <.8,.4,.2,.5> }",
       "3.7",
       {0, 0, 0},
       {153, 77, 38},
       {0, 0, 0, 0},
       {204, 102, 51, 191}},
      {"#declare P = pigment { rgbf <.8,.4,.2,.5> }",
       "3.7",
       {0, 0, 0},
       {143, 61, 28},
       {0, 0, 0, 0},
       {152, 65, 30, 239}},
      {"background { rgbt <.2,.4,.6,.5> } #declare P = pigment { rgb <.8,.4,.2> }",
       "3.7",
       {26, 51, 77},
       {204, 102, 51},
       {51, 102, 153, 128},
       {204, 102, 51, 255}},
      {"background { rgbf <.2,.4,.6,.5> } #declare P = pigment { rgb <.8,.4,.2> }",
       "3.7",
       {51, 102, 153},
       {204, 102, 51},
       {31, 62, 93, 209},
       {204, 102, 51, 255}},
      {"sky_sphere { pigment { rgbt <.2,.4,.6,.5> } } #declare P = pigment { rgbt <.8,.4,.2,.5> }",
       "3.7",
       {26, 51, 77},
       {159, 89, 57},
       {51, 102, 153, 128},
       {182, 102, 66, 223}},
      {"#declare P = pigment { rgbt <3,3,.2,.5> }",
       "3.7",
       {0, 0, 0},
       {255, 255, 38},
       {0, 0, 0, 0},
       {255, 255, 38, 255}},
      {"#declare P = pigment { rgbt <6,0,0,.9> }", "3.7", {0, 0, 0}, {255, 0, 0}, {0, 0, 0, 0}, {255, 0, 0, 86}},
      {"#declare P = pigment { rgbf <.8,.4,.2,.5> }",
       "3.6",
       {0, 0, 0},
       {171, 73, 34},
       {0, 0, 0, 0},
       {183, 78, 36, 239}}};
  for (const AlphaProbe& row : rows) {
    const std::string scene = std::string("#version ") + row.version + "; global_settings { assumed_gamma 1 } " +
                              row.scene +
                              " camera { orthographic location <0,0,-5> right 2*x up 2*y } sphere { 0,.5 pigment { P } "
                              "finish { ambient 1 diffuse 0 } }";
    const auto opaque = codes(render_text(scene, 4, 4), 8, false, false);
    EXPECT_EQ(pixel(opaque, 0, 0), row.corner) << row.scene;
    EXPECT_EQ(pixel(opaque, 1, 1), row.centre) << row.scene;
    render::Options options;
    options.output_alpha = true;
    const auto clear = codes(render_text(scene, 4, 4, options), 8, true, false);
    EXPECT_EQ(pixel(clear, 0, 0), row.corner_alpha) << row.scene;
    EXPECT_EQ(pixel(clear, 1, 1), row.centre_alpha) << row.scene;
  }
}

// P15: one number per quality level 0..9 and channel.
TEST(P15, QualityLevels) {
  const std::string camera = kLinear + "camera { location <0,0,-5> look_at 0 } ";
  const auto centre = [&](const std::string& scene, int quality) {
    render::Options options;
    options.quality = quality;
    return pixel(codes(render_text(camera + scene, 9, 7, options), 8, false, false), 4, 3);
  };
  for (int q = 0; q <= 9; ++q) {
    EXPECT_EQ(centre("sphere { 0,1 pigment { rgb .5 } finish { ambient 0 } }", q)[0], q < 2 ? 128 : 0) << q;
    EXPECT_EQ(
        centre("sphere { 0,1 pigment { rgb <1,0,0> quick_color rgb <0,1,0> } finish { ambient 1 diffuse 0 } }", q),
        (q < 6 ? Codes{0, 255, 0} : Codes{255, 0, 0}))
        << q;
    EXPECT_EQ(centre("sphere { 0,1 pigment { rgbt <1,0,0,1> } finish { ambient 1 diffuse 0 } } plane { -z,-5 pigment { "
                     "rgb <0,1,0> } finish { ambient 1 diffuse 0 } }",
                     q),
              (q < 2   ? Codes{255, 0, 0}
               : q < 6 ? Codes{0, 0, 0}
                       : Codes{0, 255, 0}))
        << q;
    EXPECT_EQ(
        centre("fog { distance 5 rgb <0,1,0> } sphere { 0,1 pigment { rgb 0 } finish { ambient 0 diffuse 0 } }", q)[1],
        q < 9 ? 0 : 140)
        << q;
  }
}

TEST(P16, TraceLevelAndBailout) {
  const std::string scene = R"(camera { location <0,0,-.5> look_at z }
    #declare T = texture { pigment { rgb .1 } finish { ambient 1 diffuse 0 reflection .9 } } plane { z,1 texture { T
} } plane { -z,1 texture { T } })";
  const std::pair<const char*, double> rows[] = {{"", .409506},
                                                 {"max_trace_level 1", .100008},
                                                 {"max_trace_level 2", .190005},
                                                 {"max_trace_level 20", .878416},
                                                 {"max_trace_level 200", .996246},
                                                 {"max_trace_level 200 adc_bailout 0", 1.0},
                                                 {"max_trace_level 200 adc_bailout .5", .521706}};
  for (const auto& [settings, expected] : rows)
    EXPECT_NEAR(lin16(render_text(kLinear + "global_settings { " + settings + " } " + scene, 3, 3), 1, 1)[0],
                expected * 65535, 2)
        << settings;
}

TEST(P17, DefaultWavelengthsOfIridescence) {
  const std::string scene = R"(camera { location <0,0,-3> look_at 0 } light_source { <3,4,-9> 1 }
    sphere { 0,1 pigment { rgb .5 } finish { ambient 0 irid { .8 thickness 3 turbulence 0 } } })";
  EXPECT_EQ(pixel(codes(render_text(kLinear + scene, 16, 12), 16, false, true), 7, 5), (Codes{43027, 20495, 17086}));
  EXPECT_EQ(pixel(codes(render_text(kLinear + "global_settings { irid_wavelength rgb <.25,.18,.14> }" + scene, 16, 12),
                        16, false, true),
                  7, 5),
            (Codes{46332, 20056, 29566}));
}

TEST(P18, InteriorsAroundTheCamera) {
  const std::string fog = kLinear + "camera { location 0 direction z } fog { distance 5 rgb <0,1,0> } ";
  const std::string wall = "plane { -z,-5 pigment { rgb <1,0,0> } finish { ambient 1 diffuse 0 } } ";
  const std::string clear = " pigment { rgbt 1 } finish { ambient 0 diffuse 0 } ";
  const auto centre = [](const std::string& scene) {
    return pixel(codes(render_text(scene, 3, 3), 8, false, false), 1, 1);
  };
  EXPECT_EQ(centre(fog + wall), (Codes{94, 161, 0}));
  EXPECT_EQ(centre(fog + wall + "sphere { 0,20" + clear + "}"), (Codes{255, 0, 0}));
  EXPECT_EQ(centre(fog + wall + "sphere { 0,2" + clear + "}"), (Codes{140, 115, 0}));
  EXPECT_EQ(centre(fog + wall + "sphere { 0,2" + clear + "hollow }"), (Codes{94, 161, 0}));
  EXPECT_EQ(centre(fog + "plane { z,5 pigment { rgb <1,0,0> } finish { ambient 1 diffuse 0 } }"), (Codes{255, 0, 0}));
  EXPECT_EQ(centre(fog + "plane { z,5 pigment { rgb <1,0,0> } finish { ambient 1 diffuse 0 } hollow }"),
            (Codes{94, 161, 0}));
  EXPECT_EQ(centre(kLinear +
                   "camera { location 0 direction z } plane { -z,-5 pigment { rgb 1 } finish { ambient 1 diffuse 0 } } "
                   "sphere { 0,2" +
                   clear + "interior { fade_distance 1 fade_power 1001 fade_color rgb <.5,.25,.125> } }"),
            (Codes{94, 57, 44}));
  const auto q = codes(
      render_text(
          kLinear + "camera { orthographic location 0 direction z right 4*x up 4*y } fog { distance 5 rgb <0,1,0> } " +
              wall + "box { <-1,-9,-9>,<9,9,9>" + clear + "}",
          4, 2),
      8, false, false);
  for (int x = 0; x < 4; ++x) EXPECT_EQ(pixel(q, x, 0), x == 0 ? (Codes{94, 161, 0}) : (Codes{255, 0, 0})) << x;
}

// The pixels do not depend on the number of threads, nor on which run it was; a region equals the same part of the
// whole picture when blocks coincide.
TEST(Determinism, ThreadsAndRegions) {
  const std::string scene =
      kLinear +
      R"(camera { location <0,2,-6> look_at 0 } plane { y,-1 pigment { checker rgb 1 rgb .2 } finish { crand .2
reflection .2 } }
    sphere { 0,1 pigment { rgbf <1,.8,.6,.7> } interior { ior 1.4 } } light_source { <5,8,-6> rgb 1 area_light
3*x,3*z,4,4 jitter })";
  render::Options options;
  options.antialias = true, options.threads = 1, options.block_size = 16;
  const auto one = render_text(scene, 64, 48, options);
  options.threads = 4;
  const auto four = render_text(scene, 64, 48, options);
  EXPECT_EQ(one.pixels, four.pixels);
  options.first_column = 16, options.first_row = 16, options.last_column = 47, options.last_row = 31;
  const auto part = render_text(scene, 64, 48, options);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      EXPECT_EQ(part.at(x, y), x >= 16 && x < 48 && y >= 16 && y < 32 ? one.at(x, y) : render::PixelColor())
          << x << ',' << y;
  options.seed = 1;
  EXPECT_NE(render_text(scene, 64, 48, options).at(20, 20), one.at(20, 20));
}

}  // namespace
}  // namespace verisim::test
