// Colours to the last of 16 bits, as `povray -A +WT1 +FN16 File_Gamma=1 +W320 +H240` wrote them: pixels that differ
// where what fog, lights, highlights and maps of textures add is rounded in another order (spec 05 4.1, 06 4.2).
#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

struct SeenPixel {
  int x, y, r, g, b;
};
struct LastBits {
  std::string name, scene;
  std::vector<SeenPixel> seen;
};
void PrintTo(const LastBits& p, std::ostream* out) { *out << p.name; }

std::string camera(const char* at) {
  return "#version 3.7; global_settings { assumed_gamma 1 }\ncamera { location " + std::string(at) +
         " direction z right x*4/3 up y }\n";
}
std::string around(const char* fog) {
  return camera("0") +
         "sphere { 0, 30000 hollow pigment { rgb <.3,.4,.5> } finish {ambient 1 diffuse 0} scale <1,2,3> }\n" + fog;
}
std::string ball(const char* texture, const char* light = "<1000, 1000, -1500> rgb <1,.9,.8>") {
  return camera("<0,0,-3>") + "light_source { " + light + " }\nsphere { 0, 1.2 " + texture + " }";
}

class LastBitsOfColors : public testing::TestWithParam<LastBits> {};

TEST_P(LastBitsOfColors, EqualPovRay) {
  const render::Framebuffer picture = render_text(GetParam().scene, 320, 240);
  for (const SeenPixel& p : GetParam().seen) {
    const Color c = picture.at(p.x, p.y);
    const auto code = [](float v) { return static_cast<int>(v * 65535 + 0.5f); };
    EXPECT_EQ(std::vector({code(c.r), code(c.g), code(c.b)}), std::vector({p.r, p.g, p.b})) << p.x << ", " << p.y;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Probes, LastBitsOfColors,
    testing::Values(
        LastBits{"fog",
                 around("fog { distance 30000 rgb <.7,.8,.9> }"),
                 {{75, 0, 42818, 49372, 55925}, {59, 93, 42416, 48969, 55523}, {59, 146, 42416, 48969, 55523}}},
        LastBits{"ground fog",
                 camera("<0,1,0>") +
                     "sphere { 0, 30000 hollow pigment { rgb <.3,.4,.5> } finish {ambient 1 diffuse 0} scale "
                     "<1,2,3>*.002 } fog { fog_type 2 distance 50 rgb <.7,.8,.9> fog_offset .1 fog_alt 2 }",
                 {{70, 6, 22380, 28934, 35487}, {19, 15, 22730, 29283, 35837}, {30, 30, 23082, 29636, 36189}}},
        LastBits{"two fogs",
                 around("fog { distance 30000 rgb <.7,.8,.9> } fog { distance 50000 rgb <.3,.1,.2> }"),
                 {{30, 2, 52574, 49713, 59915}, {105, 72, 57828, 53761, 65005}, {105, 167, 57828, 53761, 65005}}},
        LastBits{"diffuse light",
                 ball("pigment { rgb <.3,.4,.5> } finish { ambient .1 diffuse .6 }"),
                 {{163, 19, 11894, 14535, 16515}, {148, 72, 11439, 13988, 15907}, {260, 116, 11894, 14535, 16515}}},
        LastBits{"highlights",
                 ball("pigment { rgb <.3,.4,.5> } finish { ambient .1 diffuse .5 phong .7 phong_size 20 }"),
                 {{225, 46, 11735, 14344, 16301}, {168, 74, 17937, 19540, 20578}, {172, 147, 8531, 10499, 12030}}},
        LastBits{"specular",
                 ball("pigment { rgb <.3,.4,.5> } finish { ambient 0 diffuse 0 specular .7 roughness .05 }"),
                 {{159, 53, 6649, 5984, 5319}, {202, 64, 22809, 20529, 18248}, {215, 77, 22809, 20529, 18248}}},
        LastBits{"area_light",
                 ball("pigment { rgb <.3,.4,.5> } finish { ambient 0 diffuse .6 }",
                      "<1000, 1000, -1500> rgb <1,.9,.8> area_light x*300,y*300,3,3"),
                 {{166, 22, 10252, 12303, 13670}, {235, 68, 11699, 14039, 15598}, {165, 112, 9031, 10837, 12041}}},
        LastBits{"brilliance",
                 ball("pigment { rgb <.3,.4,.5> } finish { ambient .1 diffuse .5 brilliance 3 }"),
                 {{129, 28, 5650, 7042, 8188}, {187, 37, 10429, 12778, 14561}, {242, 92, 10429, 12778, 14561}}},
        LastBits{"fading light",
                 ball("pigment { rgb <.3,.4,.5> } finish { ambient 0 diffuse .6 }",
                      "<10, 10, -15> rgb <1,.9,.8> fade_distance 7 fade_power 2"),
                 {{190, 47, 2567, 3080, 3423}, {232, 89, 2567, 3080, 3423}}},
        LastBits{"texture_map",
                 ball("texture { gradient x texture_map { [0 pigment { rgb <.1,.2,.3> } finish { ambient .9 diffuse 0 }"
                      " ] [1 pigment { rgb <.8,.9,.7> } finish { ambient .9 diffuse 0 }] } scale 3 }"),
                 {{114, 26, 40912, 46810, 37702}, {156, 81, 46817, 52715, 41076}, {132, 158, 44256, 50155, 39614}}}));

}  // namespace
}  // namespace verisim::test
