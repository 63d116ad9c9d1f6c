// The radiosity probes of spec 07 section 11, rendered with --replay: values POV-Ray 3.7.0.10 gave with +WT1.
#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

render::Options replay() {
  render::Options options;
  options.replay = true;
  return options;
}

std::string patch(const std::string& settings, const std::string& finish, const std::string& more = "",
                  const std::string& version = "3.7") {
  return "#version " + version + "; global_settings { assumed_gamma 1 radiosity { " + settings +
         " } }\n"
         "camera { orthographic location <0,1,0> right x*0.02 up z*0.02 direction -y }\n"
         "background { rgb <0.8,0.4,0.2> } plane { y,0 pigment { rgb 0.5 } finish { " +
         finish + " } }\n" + more;
}

struct PatchProbe {
  std::string name, scene;
  std::vector<double> expected;
};
void PrintTo(const PatchProbe& p, std::ostream* out) { *out << p.name; }

class RadiosityPatch : public testing::TestWithParam<PatchProbe> {};

TEST_P(RadiosityPatch, EqualsPovRay) {
  const auto pixel = lin16(render_text(GetParam().scene, 1, 1, replay()), 0, 0);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], 65535.0 * GetParam().expected[c], 2.0) << "channel " << c;
}

INSTANTIATE_TEST_SUITE_P(
    P_R2, RadiosityPatch,
    testing::Values(
        PatchProbe{"defaults", patch("", "diffuse 1"), {0.400000, 0.200000, 0.099992}},
        PatchProbe{"brightness", patch("brightness 2", "diffuse 1"), {0.800000, 0.400000, 0.200000}},
        PatchProbe{"half_grey", patch("gray_threshold 0.5", "diffuse 1"), {0.323995, 0.224002, 0.173999}},
        PatchProbe{"grey", patch("gray_threshold 1", "diffuse 1"), {0.248005, 0.248005, 0.248005}},
        PatchProbe{"max_sample", patch("max_sample 0.4", "diffuse 1"), {0.200000, 0.099992, 0.050004}},
        PatchProbe{"brilliance", patch("", "diffuse 0.6 brilliance 3 ambient 0.3"), {0.239994, 0.119997, 0.059998}},
        PatchProbe{"albedo", patch("", "diffuse albedo 0.6 brilliance 3 ambient 0.3"), {0.239994, 0.119997, 0.059998}},
        PatchProbe{"emission", patch("", "diffuse 0.6 ambient 0.3 emission 0.1"), {0.289998, 0.170001, 0.110002}},
        PatchProbe{"old_ambient",
                   patch("", "diffuse 0.6 ambient 0.3 emission 0.1", "", "3.6"),
                   {0.439994, 0.319997, 0.259998}},
        PatchProbe{"below_bailout", patch("", "diffuse 0.0077"), {0, 0, 0}},
        PatchProbe{"above_bailout", patch("", "diffuse 0.0079"), {0.003159, 0.001587, 0.000793}},
        PatchProbe{"two_sided", patch("", "diffuse 0.2,0.6"), {0.319997, 0.160006, 0.080003}},
        PatchProbe{"fog", patch("", "diffuse 1", "fog { distance 1 rgb <0,0,1> }"), {0.147158, 0.073579, 0.668910}},
        PatchProbe{"fog_media", patch("media on", "diffuse 1", "fog { distance 1 rgb <0,0,1> }"), {0, 0, 0.816068}},
        PatchProbe{"dark", patch("brightness 0.02", "diffuse 1"), {0, 0, 0}}),
    [](const auto& parameter) { return parameter.param.name; });

std::string importance(const std::string& count, const std::string& object, const std::string& more = "") {
  return patch("pretrace_start 1 pretrace_end 1 count " + count, "diffuse 1",
               "sphere { <0,3,0>,2 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission <1,0,0> } no_image " +
                   object + " }" + more);
}

INSTANTIATE_TEST_SUITE_P(
    P_R3, RadiosityPatch,
    testing::Values(
        PatchProbe{"all", importance("100", "radiosity { importance 1 }"), {0.446006, 0.108003, 0.0540015}},
        PatchProbe{"fifth", importance("100", "radiosity { importance 0.2 }"), {0.448081, 0.103853, 0.0519265}},
        PatchProbe{"hundredth", importance("100", "radiosity { importance 0.01 }"), {0.400000, 0.200000, 0.1}},
        PatchProbe{"fine_half", importance("1600", "radiosity { importance 0.5 }"), {0.444678, 0.110674, 0.055337}},
        PatchProbe{"hidden", importance("100", "no_radiosity"), {0.400000, 0.200000, 0.1}}),
    [](const auto& parameter) { return parameter.param.name; });

struct Pixel {
  int x, y;
  std::vector<double> value;
};

void expect_pixels(const std::string& scene, int width, int height, const std::vector<Pixel>& pixels) {
  const auto picture = render_text(scene, width, height, replay());
  for (const Pixel& p : pixels) {
    const auto found = lin16(picture, p.x, p.y);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], p.value[p.value.size() == 1 ? 0 : c], 2.0) << p.x << "," << p.y << " channel " << c;
  }
}

std::string sphere_scene(const std::string& radiosity, const std::string& sky, const std::string& plane,
                         const std::string& sphere) {
  return "#version 3.7; global_settings { assumed_gamma 1 radiosity { " + radiosity +
         " } }\n"
         "camera { location <0,2,-4> direction z*1.5 right x*1.3333333333333333 up y look_at <0,0,0> }\n"
         "sky_sphere { pigment { function { 0.5+0.5*x } color_map { " +
         sky +
         " } } }\n"
         "plane { y,0 " +
         plane + " } sphere { <0,0.6,0>,0.5 " + sphere + " }\n";
}

TEST(RadiosityPicture, OneLevel) {  // P-R5
  expect_pixels(sphere_scene("count 20 error_bound 0.8 recursion_limit 1 nearest_count 4", "[0 rgb 0][1 rgb 0.5]",
                             "pigment { rgb 1 } finish { diffuse 1 ambient 0 }",
                             "pigment { rgb 1 } finish { diffuse 0 ambient 0 emission 1 }"),
                64, 48, {{5, 40, {17487}}, {20, 30, {20698}}, {40, 44, {17070}}, {53, 38, {17853}}});
}

const char* const kPlane = "pigment { rgb 0.9 } finish { diffuse 0.8 ambient 0 }";
const char* const kSphere = "pigment { rgb 0.8 } finish { diffuse 0.9 ambient 0 }";

TEST(RadiosityPicture, TwoLevels) {  // P-R6
  expect_pixels(
      sphere_scene("count 20 error_bound 0.8 recursion_limit 2 nearest_count 4", "[0 rgb 0][1 rgb 1]", kPlane, kSphere),
      64, 48,
      {{5, 40, {22395}},
       {32, 10, {22696}},
       {20, 30, {20097}},
       {40, 44, {23420}},
       {29, 6, {18127}},
       {31, 22, {14474}},
       {53, 38, {23592}}});
}

TEST(RadiosityPicture, FourLevels) {  // P-R7
  expect_pixels(
      sphere_scene("count 60 error_bound 0.8 recursion_limit 4 nearest_count 4", "[0 rgb 0][1 rgb 1]", kPlane, kSphere),
      64, 48,
      {{5, 40, {23097}},
       {32, 10, {23043}},
       {20, 30, {20953}},
       {40, 44, {23525}},
       {29, 6, {19284}},
       {31, 22, {16144}},
       {53, 38, {23754}}});
}

TEST(RadiosityPicture, EverySetting) {  // P-R8
  expect_pixels(sphere_scene("count 40 error_bound 0.5 recursion_limit 4 nearest_count 7 low_error_factor 0.7 "
                             "minimum_reuse 0.01 maximum_reuse 0.3 "
                             "brightness 1.1 gray_threshold 0.2 max_sample 0.6 always_sample on",
                             "[0 rgb <0.1,0,0>][1 rgb 0.8]", kPlane, kSphere),
                64, 48,
                {{5, 40, {21527, 19445, 19445}},
                 {32, 10, {21683, 19769, 19769}},
                 {20, 30, {20153, 18104, 18104}},
                 {29, 6, {19304, 16871, 16871}},
                 {31, 22, {16846, 15414, 15414}},
                 {53, 38, {21977, 19962, 19962}}});
}

TEST(RadiosityPicture, CornellBox) {  // P-R9
  const std::string scene = R"(#version 3.7; global_settings { assumed_gamma 1 max_trace_level 20 radiosity {} }
camera { location <0,1,-3.4> direction z*1.6 right x*1.3333 up y look_at <0,1,0> }
#declare F = finish { diffuse 0.8 ambient 0 }
box { <-1,-0.01,-1> <1,0,1> pigment { rgb 0.9 } finish { F } } box { <-1,2,-1> <1,2.01,1> pigment { rgb 0.9 } finish
{ F } }
box { <-1.01,0,-1> <-1,2,1> pigment { rgb <0.8,0.1,0.1> } finish { F } } box { <1,0,-1> <1.01,2,1> pigment { rgb
<0.1,0.8,0.1> } finish { F } }
box { <-1,0,1> <1,2,1.01> pigment { rgb 0.9 } finish { F } }
box { <-0.3,0,-0.3> <0.3,1.2,0.3> rotate y*20 translate <-0.35,0,0.3> pigment { rgb 0.9 } finish { F } }
box { <-0.3,0,-0.3> <0.3,0.6,0.3> rotate y*-18 translate <0.35,0,-0.35> pigment { rgb 0.9 } finish { F } }
light_source { <0,1.9,0> rgb 0.9 fade_distance 1 fade_power 2 })";
  expect_pixels(scene, 160, 120,
                {{20, 20, {43039, 5668, 5253}},
                 {80, 20, {53095, 53865, 50027}},
                 {80, 60, {12323, 18763, 11971}},
                 {60, 90, {7419, 3374, 3167}},
                 {110, 95, {603, 2012, 500}},
                 {140, 60, {3551, 27406, 3274}}});
}

}  // namespace
}  // namespace verisim::test
