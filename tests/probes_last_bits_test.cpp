// Colours to the last of 16 bits, as `povray -A +WT1 +FN16 File_Gamma=1 +W320 +H240` wrote them: pixels that differ
// where what fog, lights, highlights, mirrors, media and maps of textures add is rounded in another order (spec 05 4.1,
// 06 4.2, 07 4.6).
#include <gtest/gtest.h>

#include <algorithm>

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

// A wall in front of a camera, with a light beside it.
std::string before_camera(const std::string& things) {
  return "#version 3.7; global_settings { assumed_gamma 1 ambient_light rgb <.61,.73,.87> }\n"
         "camera { location <.3,1.7,-5> look_at <0,.2,0> angle 50 }\n" +
         things;
}
std::string lit_wall(const char* texture, const char* light = "", const char* more = "") {
  return before_camera(std::string("light_source { <.4,.7,-5> rgb <.83,.71,.93> ") + light +
                       " }\nplane { z, 1 hollow pigment { rgb <.71,.43,.29> } " + texture + " }\n" + more);
}
std::string pane_of(const char* interior) {
  return before_camera(
      std::string("box { <-50,-50,-1>, <50,50,1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ") +
      interior + " } } background { rgb <.83,.77,.91> }");
}

class LastBitsOfColors : public testing::TestWithParam<LastBits> {};

TEST_P(LastBitsOfColors, EqualPovRay) {
  const render::Framebuffer picture = render_text(GetParam().scene, 320, 240);
  for (const SeenPixel& p : GetParam().seen) {
    const Color c = picture.at(p.x, p.y);
    const auto code = [](float v) { return static_cast<int>(std::min(v, 1.0f) * 65535 + 0.5f); };
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
                 {{114, 26, 40912, 46810, 37702}, {156, 81, 46817, 52715, 41076}, {132, 158, 44256, 50155, 39614}}},
        LastBits{
            "ambient light and opacity",
            lit_wall("pigment { rgbft <.57,.93,.77,.13,.41> } finish { ambient <.31,.73,.49> emission <.17,.13,.23> "
                     "diffuse .67 }"),
            {{18, 0, 14640, 30405, 28054}, {277, 102, 15374, 31430, 29165}, {157, 237, 14515, 30231, 27865}}},
        LastBits{"two lights",
                 lit_wall("finish { ambient .13 diffuse .67  }", "", "light_source { <-3,1,-4> rgb <.31,.27,.43> }"),
                 {{267, 0, 35443, 19190, 17441}, {271, 108, 35508, 19223, 17456}, {273, 239, 31677, 17230, 15612}}},
        LastBits{"two highlights",
                 lit_wall("finish { ambient .13 diffuse .67 phong .7 phong_size 3 specular .5 roughness .2 }"),
                 {{79, 2, 65535, 51257, 60418}, {202, 155, 65535, 50127, 58763}, {252, 237, 39199, 25518, 27139}}},
        LastBits{"metallic highlights",
                 lit_wall("finish { ambient .13 diffuse .67 specular .7 roughness .2 metallic .8 }"),
                 {{305, 0, 49885, 28589, 27186}, {26, 122, 42165, 24020, 22534}, {157, 239, 38530, 21853, 20312}}},
        LastBits{"fading light",
                 lit_wall("finish { ambient .13 diffuse .67  }", "fade_distance 5 fade_power 2"),
                 {{258, 21, 23531, 12953, 11230}, {91, 121, 22717, 12532, 10858}, {7, 237, 15165, 8620, 7401}}},
        LastBits{"spotlight",
                 lit_wall("finish { ambient .13 diffuse .67  }",
                          "spotlight tightness 0 radius 5 falloff 40 point_at <.2,.3,1>"),
                 {{219, 3, 27069, 14786, 12849}, {267, 142, 26165, 14318, 12435}, {130, 230, 18768, 10486, 9050}}},
        LastBits{"area illumination",
                 lit_wall("finish { ambient .13 diffuse .67  }",
                          "fade_distance 5 fade_power 2 area_light <2,0,0>, <0,0,2>, 3, 5 area_illumination"),
                 {{138, 1, 23327, 12848, 11136}, {261, 109, 23430, 12901, 11184}, {168, 239, 19047, 10631, 9178}}},
        LastBits{"mirror",
                 lit_wall("finish { ambient 0 diffuse 0 reflection { <.1,.2,.3>, <.9,.7,.6> falloff 1.3 } }", "",
                          "background { rgb <.83,.77,.91> }"),
                 {{115, 9, 5655, 10218, 17980}, {68, 103, 7048, 11025, 18552}, {306, 237, 11704, 13725, 20467}}},
        LastBits{"metallic mirror",
                 lit_wall("finish { ambient 0 diffuse 0 reflection { .6 metallic .8 } }", "",
                          "background { rgb <.83,.77,.91> }"),
                 {{245, 1, 25085, 16508, 15513}, {0, 106, 25163, 16651, 15723}, {298, 239, 25211, 16738, 15851}}},
        LastBits{"fog with filter",
                 lit_wall("finish { ambient .13 diffuse .67  }", "", "fog { distance 7 rgbft <.53,.61,.79,.2,.3> }"),
                 {{145, 3, 31114, 29216, 35442}, {54, 161, 30889, 30235, 37207}, {192, 237, 30958, 30677, 37908}}},
        LastBits{"fading glass",
                 pane_of("fade_distance 1.3 fade_power 1.3 fade_color rgb <.7,.8,.4>"),
                 {{162, 5, 43999, 44033, 36842}, {65, 90, 43639, 43811, 36054}, {94, 222, 43014, 43424, 34684}}},
        LastBits{"absorbing glass",
                 pane_of("fade_distance 1.3 fade_power 1001 fade_color rgb <.7,.8,.4>"),
                 {{22, 1, 32782, 36004, 21661}, {293, 130, 32652, 35909, 21489}, {254, 232, 30713, 34473, 19013}}},
        LastBits{"absorbing media",
                 lit_wall("finish { ambient .13 diffuse .67  }", "", "media { absorption <.031,.043,.017> }"),
                 {{195, 10, 24179, 12245, 12452}, {58, 119, 22435, 11303, 11683}, {25, 236, 18687, 9323, 9980}}},
        LastBits{"glowing media",
                 lit_wall("finish { ambient .13 diffuse .67  }", "",
                          "media { emission <.023,.019,.037> absorption <.031,.043,.017> }"),
                 {{109, 0, 32071, 18765, 26376}, {234, 122, 32692, 19113, 27073}, {111, 239, 30703, 18434, 28147}}},
        LastBits{
            "media of method 2",
            lit_wall("finish { ambient .13 diffuse .67  }", "",
                     "media { emission <.023,.019,.037> absorption <.031,.043,.017> method 2 intervals 1 samples 3 }"),
            {{138, 1, 32183, 18718, 26242}, {22, 116, 30866, 18256, 27056}, {4, 238, 29131, 17714, 28511}}},
        LastBits{
            "scattering media",
            lit_wall(
                "finish { ambient .13 diffuse .67  } }"
                "media { emission <.023,.019,.037> scattering { 4, <.031,.043,.017> } method 2 intervals 1 samples 1",
                "", "light_source { <-3,1,-4> rgb <.31,.27,.43> }"),
            {{158, 1, 56575, 42158, 42161}, {298, 124, 56862, 43852, 43728}, {289, 239, 57959, 46543, 46701}}}));

}  // namespace
}  // namespace verisim::test
