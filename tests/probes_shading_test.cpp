// Every probe of spec 06 section 19: small scenes with the colours POV-Ray 3.7.0.10 gave, 16 bits linear, tolerance 2
// codes (`-A +WT1 +FN16 File_Gamma=1`). Scenes that draw random numbers are rendered with --replay.
#include <gtest/gtest.h>

#include "tests/support/probe.h"
#include "tracer/image/output.h"

namespace verisim::test {
namespace {

constexpr const char* kPrelude = R"(
global_settings { assumed_gamma 1.0 }
#macro CamZ(P) camera { orthographic location P direction z right 0.01*x up 0.01*y } #end
#macro CamDown() camera { orthographic location 50*y direction -y right 0.01*x up 0.01*z } #end
#macro CamTilt(A) camera { orthographic
  location <-10*sin(radians(A)), 0, -10*cos(radians(A))>
  direction <sin(radians(A)), 0, cos(radians(A))> right 0.01*x up 0.01*y } #end
#macro Em(K) finish { ambient 0 diffuse 0 emission K } #end
#macro SkyX() sky_sphere { pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 2 translate -x } } #end
#declare Clr = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Wht = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
)";

struct ShadingProbe {
  std::string id, what, option;  // option: a POV-Ray switch or a #version line
  std::string scene;
  std::vector<std::vector<int>>
      pixels;  // of row 0; one number: all channels; a fourth: alpha, with colours premultiplied
};
void PrintTo(const ShadingProbe& p, std::ostream* out) { *out << p.id << ": " << p.what; }

class ShadingProbes : public testing::TestWithParam<ShadingProbe> {};

TEST_P(ShadingProbes, EqualPovRay) {
  const ShadingProbe& p = GetParam();
  render::Options options;
  options.replay = true;
  options.output_alpha = p.option == "+UA";
  if (p.option.starts_with("+Q")) options.quality = std::stoi(p.option.substr(2));
  if (p.option == "+SC2") options.first_column = 1;
  const std::string version = p.option.starts_with("#version") ? p.option : "#version 3.7;";
  const int width = static_cast<int>(p.pixels.size());
  const render::Framebuffer picture = render_text(version + kPrelude + p.scene, width, 1, options);
  for (int x = 0; x < width; ++x) {
    const std::vector<double> got = lin16(picture, x, 0);
    const std::vector<int>& expected = p.pixels[x];
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(got[c], expected.size() == 1 ? expected[0] : expected[c], 2.0) << "pixel " << x << " channel " << c;
    if (expected.size() == 4) {
      EXPECT_NEAR((1 - picture.at(x, 0).t) * 65535, expected[3], 2.0) << "alpha";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Spec06, ShadingProbes,
    testing::
        Values(
            ShadingProbe{
                "F1",
                "defaults: ambient 0.1, diffuse 0.6",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish {  } } light_source { -5*z rgb 1 })",
                {{45875, 22937, 11469}}},
            ShadingProbe{
                "F2",
                "ambient*ambient_light + emission",
                "",
                R"(global_settings { ambient_light rgb <.5,1,2> } CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient rgb <.2,.3,.4> emission rgb <.1,0,0> diffuse 0 } })",
                {{13107, 9830, 13107}}},
            ShadingProbe{
                "F3",
                "brilliance, light at 60 deg",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse .7 brilliance 2.5 } } light_source { <5*sqrt(3),0,-5> rgb 1 })",
                {{8110, 4055, 2027}}},
            ShadingProbe{
                "F4",
                "brilliance with albedo",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse albedo .7 brilliance 2.5 } } light_source { <5*sqrt(3),0,-5> rgb 1 })",
                {{14192, 7096, 3548}}},
            ShadingProbe{
                "F5",
                "diffuse back value; highlights suppressed",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse .7,.4 phong 1 specular 1 } } light_source { <5,0,5> rgb 1 })",
                {{18536, 9268, 4634}}},
            ShadingProbe{
                "F6",
                "phong, 20 deg",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 phong .8 } } light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                {{4355}}},
            ShadingProbe{
                "F7",
                "specular, 20 deg, default roughness",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 specular .8 } } light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                {{38600}}},
            ShadingProbe{
                "F8",
                "specular albedo, roughness .02, 20 deg",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse 0 specular albedo .05 roughness .02 } } light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                {{9907}}},
            ShadingProbe{
                "F9",
                "specular metallic .8, 70 deg",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 specular .9 roughness .1 metallic .8 } } light_source { <5*tan(radians(70)),0,-5> rgb 1 })",
                {{8023, 5176, 3752}}},
            ShadingProbe{
                "F10",
                "phong metallic .8, 20 deg",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 phong .9 phong_size 2 metallic .8 } } light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                {{52082, 31384, 21035}}},
            ShadingProbe{
                "F11",
                "transparent surface: opacity scales diffuse, not phong",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgbft <.8,.4,.2,.3,.25> } finish { ambient 0 diffuse .6 phong .2 } } light_source { -5*z rgb 1 })",
                {{27263, 20185, 16646}}},
            ShadingProbe{
                "F12",
                "same, legacy #version 3.6",
                "#version 3.6",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgbft <.8,.4,.2,.3,.25> } finish { ambient 0 diffuse .6 phong .2 } } light_source { -5*z rgb 1 })",
                {{29150, 21128, 17118}}},
            ShadingProbe{
                "F13",
                "irid on direct light",
                "",
                R"(CamZ(-10*z) plane { -z,0 pigment { rgb 1 } finish { ambient .05 diffuse .5 phong .2 phong_size 1 irid { .35 thickness .6 } } } light_source { <5*sqrt(3),0,-5> rgb 1 })",
                {{24428, 25246, 31891}}},
            ShadingProbe{
                "F14",
                "two layers over a background",
                "",
                R"(CamZ(-10*z) background { rgb <.9,.6,.3> } disc { 0,z,3 texture { pigment { rgbft <.1,.5,.9,.5,.2> } Em(.4) } texture { pigment { rgbft <.8,.5,.2,.3,.4> } Em(.5) } })",
                {{17805, 16810, 11100}}},
            ShadingProbe{
                "R1",
                "variable reflection, 60 deg",
                "",
                R"(CamTilt(60) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection { rgb <.1,.2,.3>, rgb <.9,.8,.7> falloff 2.5 } } })",
                {{14239, 12035, 7288}}},
            ShadingProbe{
                "R2",
                "fresnel reflection, 60 deg",
                "",
                R"(CamTilt(60) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection { .2, .8 fresnel on } } interior { ior 1.5 } })",
                {{14953, 9968, 4984}}},
            ShadingProbe{
                "R3",
                "metallic reflection, 80 deg",
                "",
                R"(CamTilt(80) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb <.8,.5,.2> } finish { ambient 0 diffuse 0 reflection { .5 metallic .7 } } })",
                {{26440, 14576, 5763}}},
            ShadingProbe{
                "R4",
                "reflection exponent 2",
                "",
                R"(CamTilt(30) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection { .5 exponent 2 } } })",
                {{31086, 25382, 17948}}},
            ShadingProbe{
                "R5",
                "lower layer reflection is not filtered",
                "",
                R"(CamZ(-10*z) background { rgb <.9,.6,.3> } plane { -z,0 texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection .3 } } texture { pigment { rgbt <1,1,1,.5> } finish { ambient 0 diffuse 0 reflection .2 } } })",
                {{29491, 19661, 9830}}},
            ShadingProbe{
                "R6",
                "two parallel mirrors, default max_trace_level 5",
                "",
                R"(CamZ(0) plane { -z,-1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission .3 reflection .5 } } plane { z,-1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission .3 reflection .5 } })",
                {{38092}}},
            ShadingProbe{
                "R7",
                "same, max_trace_level 20: ADC stops after 8",
                "",
                R"(global_settings { max_trace_level 20 } CamZ(0) plane { -z,-1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission .3 reflection .5 } } plane { z,-1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission .3 reflection .5 } })",
                {{39167}}},
            ShadingProbe{
                "R8",
                "straight-through rays do not consume levels (12 discs)",
                "",
                R"(CamZ(0) background { rgb 1 } #for(I,1,12) disc { I*z,z,10 pigment { rgbt <1,1,1,.9> } Em(.01) } #end)",
                {{18979}}},
            ShadingProbe{
                "R9",
                "irid on reflection, 40 deg",
                "",
                R"(CamTilt(40) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection 1 irid { .35 thickness .2 } } })",
                {{39897, 27667, 15220}}},
            ShadingProbe{
                "I1",
                "fade_power 2, depth 1",
                "",
                R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,2> texture { Clr } interior { fade_distance .5 fade_power 2 fade_color <.9,.5,.1> } })",
                {{54263, 23593, 5505}}},
            ShadingProbe{
                "I2",
                "fade_power 1000 (exponential)",
                "",
                R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,2> texture { Clr } interior { fade_distance .5 fade_power 1000 fade_color <.9,.5,.1> } })",
                {{48290, 14465, 3250}}},
            ShadingProbe{
                "I3",
                "fade_distance without fade_power (camera ray)",
                "",
                R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,2> texture { Clr } interior { fade_distance .5 fade_color <.9,.5,.1> } })",
                {{56032, 29491, 10813}}},
            ShadingProbe{
                "I4",
                "bubble inside: only the last segment attenuates",
                "",
                R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,7> texture { Clr } interior { fade_distance 2 fade_power 1 } } box { <-1,-1,3>,<1,1,4> texture { Clr } })",
                {{23593, 15728, 7864}}},
            ShadingProbe{"I5",
                         "sphere ior 1.5 seen at offset .6875 (SkyX gives (dir.x+1)/2)",
                         "",
                         R"(CamZ(<.6875,0,-10>) SkyX() sphere { 0,1 texture { Clr } interior { ior 1.5 } })",
                         {{15255}}},
            ShadingProbe{
                "I6",
                "nested slab: (A (B B) A), tilted inner exit",
                "",
                R"(CamTilt(20) SkyX() intersection { plane { -z,3 } plane { z,0 } texture { Clr } interior { ior 1.5 } } intersection { plane { -z,2 } plane { <.3,0,1>,-1 } texture { Clr } interior { ior 1.2 } })",
                {{46799}}},
            ShadingProbe{
                "I7",
                "overlap (A (B A) B): A exit is not refracted",
                "",
                R"(CamTilt(20) SkyX() intersection { plane { -z,3 } plane { <.3,0,1>,0 } texture { Clr } interior { ior 1.5 } } intersection { plane { -z,1 } plane { z,2 } texture { Clr } interior { ior 1.2 } })",
                {{43975}}},
            ShadingProbe{
                "I8",
                "union children share one interior (entry+exit)",
                "",
                R"(CamTilt(20) SkyX() union { disc { 0,z,100 } disc { 2*z,z,100 } texture { Clr } interior { ior 1.5 } })",
                {{43975}}},
            ShadingProbe{
                "I9",
                "same discs, separate interiors (never leaves)",
                "",
                R"(CamTilt(20) SkyX() disc { 0,z,100 texture { Clr } interior { ior 1.5 } } disc { 2*z,z,100 texture { Clr } interior { ior 1.5 } })",
                {{40239}}},
            ShadingProbe{
                "I10",
                "camera inside two nested spheres, outer declared first",
                "",
                R"(CamZ(.5*x) SkyX() sphere { 0,2 texture { Clr } interior { ior 1.5 } } sphere { 0,1 texture { Clr } interior { ior 1.2 } })",
                {{33054}}},
            ShadingProbe{
                "I11",
                "same, inner declared first",
                "",
                R"(CamZ(.5*x) SkyX() sphere { 0,1 texture { Clr } interior { ior 1.2 } } sphere { 0,2 texture { Clr } interior { ior 1.5 } })",
                {{28464}}},
            ShadingProbe{
                "I12",
                "white through a dispersive slab",
                "",
                R"(CamZ(-10*z) background { rgb 1 } box { <-3,-3,1>,<3,3,2> texture { Clr } interior { ior 1.5 dispersion 1.1 } })",
                {{65129, 65535, 65286}}},
            ShadingProbe{
                "I13",
                "dispersive prism, 7 samples",
                "",
                R"(CamZ(-10*z) SkyX() intersection { plane { -z,0 } plane { <.5,0,1>,1 } plane { -x,5 } plane { x,5 } texture { Clr } interior { ior 1.5 dispersion 1.2 dispersion_samples 7 } })",
                {{25068, 24383, 22580}}},
            ShadingProbe{
                "I14", "total internal reflection: TIR face transmit .5 does not filter, its reflection is skipped", "", R"(CamZ(-10*z) background { rgb .3 } intersection { plane { -z,0 texture { Clr } } plane { <1,0,1>,1 texture { pigment { rgbt <1,1,1,.5> } finish { ambient 0 diffuse 0 emission .2 reflection .5 } } } plane { -x,5 texture { Clr } } interior { ior 1.5 } })", {{26214}}},
            ShadingProbe{
                "I15",
                "slab, fresnel + conserve_energy, two-sided",
                "",
                R"(CamZ(-10*z) box { <-5,-5,0>,<5,5,1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } conserve_energy } interior { ior 1.5 } } plane { -z,-5 pigment { rgb 1 } Em(.8) } plane { z,-20 pigment { rgb 1 } Em(.2) })",
                {{49325}}},
            ShadingProbe{
                "I16",
                "conserve_energy, constant reflection",
                "",
                R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } background { rgb 0 } disc { z,z,3 pigment { rgbt <1,1,1,.8> } finish { ambient 0 diffuse 0 emission .5 reflection <.1,.2,.3> conserve_energy } })",
                {{49020, 31719, 17563}}},
            ShadingProbe{
                "S1",
                "shadow: filter + transmit, two surfaces",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } box { <-1,1,-1>,<1,2,1> no_image pigment { rgbft <.8,.5,.2,.3,.4> } })",
                {{26843, 19824, 13867}}},
            ShadingProbe{
                "S2",
                "shadow: layered disc",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc { y,y,1 no_image texture { pigment { rgbft <.8,.5,.2,.3,.4> } } texture { pigment { rgbft <.1,.5,.9,.5,.2> } } })",
                {{10486, 16220, 19595}}},
            ShadingProbe{
                "S3",
                "slab thinner than 0.001: one surface only",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } box { <-1,1,-1>,<1,1.0005,1> no_image pigment { rgbft <.8,.5,.2,.3,.4> } })",
                {{41942, 36044, 30146}}},
            ShadingProbe{
                "S4",
                "shadow with fade (thickness 1, fade_distance .5)",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } box { <-1,1,-1>,<1,2,1> no_image pigment { rgbt 1 } interior { fade_distance .5 fade_power 2 fade_color <.9,.5,.1> } })",
                {{60292, 39321, 18350}}},
            ShadingProbe{
                "S5",
                "faked caustics, disc tilted 45 deg",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc { y,vnormalize(<1,1,0>),3 no_image pigment { rgbt .3 } interior { caustics .1 } })",
                {{23794}}},
            ShadingProbe{
                "S6",
                "texture_map 70/30 shadow",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc { 2*y,y,3 no_image texture { gradient z texture_map { [0 pigment { rgbf 1 }] [1 pigment { rgb <.2,.4,.6> }] } translate -.3*z } })",
                {{45875}}},
            ShadingProbe{
                "S7",
                "pigment blend 70/30 shadow (filter of blended colour)",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc { 2*y,y,3 no_image texture { pigment { gradient z color_map { [0 rgbf 1] [1 rgb <.2,.4,.6>] } } translate -.3*z } })",
                {{34865, 37617, 40370}}},
            ShadingProbe{
                "L1",
                "point light, fade 4/2, at x=2",
                "",
                R"(camera { orthographic location <2,50,0> direction -y right .01*x up .01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 fade_distance 4 fade_power 2 })",
                {{35527}}},
            ShadingProbe{
                "L2",
                "spotlight defaults, x=4.8125",
                "",
                R"(camera { orthographic location <4.8125,50,0> direction -y right .01*x up .01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 spotlight point_at 0 })",
                {{22436}}},
            ShadingProbe{
                "L3",
                "spotlight 20/50 tightness 10, x=3.0625",
                "",
                R"(camera { orthographic location <3.0625,50,0> direction -y right .01*x up .01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 spotlight point_at 0 radius 20 falloff 50 tightness 10 })",
                {{17008}}},
            ShadingProbe{
                "L4",
                "cylinder 1/4 tightness .5, x=1.96875",
                "",
                R"(camera { orthographic location <1.96875,50,0> direction -y right .01*x up .01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 cylinder point_at 0 radius 1 falloff 4 tightness .5 })",
                {{35237}}},
            ShadingProbe{
                "L5",
                "parallel + fade: projected distance, x=-7.5",
                "",
                R"(camera { orthographic location <-7.5,50,0> direction -y right .01*x up .01*z } plane { y,0 texture { Wht } } light_source { <3,4,0> rgb 1 parallel point_at 0 fade_distance 4 fade_power 2 })",
                {{15790}}},
            ShadingProbe{
                "L6",
                "parallel light lights points behind it, unshadowed",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { -4*y rgb 1 parallel point_at -5*y } box { <-1,2,-1>,<1,2.5,1> no_image })",
                {{65535}}},
            ShadingProbe{
                "L7",
                "area light 3x3, centre sample blocked (weight 1/4)",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 6*y rgb 1 area_light 8*x,8*z,3,3 } box { -.05,.05 translate .97*6*y no_image })",
                {{49151}}},
            ShadingProbe{
                "L8",
                "area light 7x1: sample 3 has double weight",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 6*y rgb 1 area_light 8*x,8*z,7,1 } box { -.05,.05 translate .97*6*y no_image })",
                {{49151}}},
            ShadingProbe{
                "L9",
                "nested in-line light_group: inner objects lose the outer light",
                "",
                R"(CamZ(-10*z) light_group { light_group { light_source { -1e6*z rgb <.5,0,0> } plane { -z,0 texture { Wht } } } light_source { -1e6*z rgb <0,.25,0> } } light_source { -1e6*z rgb <0,0,.125> })",
                {{32768, 0, 0}}},
            ShadingProbe{
                "L10",
                "nested through an identifier: inherits",
                "",
                R"(CamZ(-10*z) #declare G = light_group { light_source { -1e6*z rgb <.5,0,0> } plane { -z,0 texture { Wht } } } light_group { light_source { -1e6*z rgb <0,.25,0> } light_group { G } } light_source { -1e6*z rgb <0,0,.125> })",
                {{32768, 16384, 0}}},
            ShadingProbe{
                "A1",
                "fog type 1, filter and transmit",
                "",
                R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8 rgbft <.2,.5,.8,.5,.1> })",
                {{25034, 31014, 33836}}},
            ShadingProbe{
                "A2",
                "ground fog, horizontal at y=2",
                "",
                R"(CamZ(2*y) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { fog_type 2 distance 8 rgb <.2,.5,.8> fog_alt .7 fog_offset 1 })",
                {{50458, 38103, 25748}}},
            ShadingProbe{
                "A3",
                "ground fog to infinity, 5 deg up from y=2",
                "",
                R"(camera { orthographic location 2*y direction <0,sin(radians(5)),cos(radians(5))> right .01*x up .01*<0,cos(radians(5)),-sin(radians(5))> } background { rgb 1 } fog { fog_type 2 distance 8 rgb <.2,.5,.8> fog_alt .7 fog_offset 1 })",
                {{41505, 50516, 59527}}},
            ShadingProbe{
                "A4",
                "two fogs",
                "",
                R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8 rgb <.2,.5,.8> } fog { distance 20 rgb <.9,.1,.1> })",
                {{43725, 33069, 34011}}},
            ShadingProbe{
                "A5",
                "fog turbulence",
                "",
                R"(CamZ(<.3,.2,0>) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8 rgb <.2,.5,.8> turbulence <1,.5,.2> turb_depth .7 octaves 3 omega .7 lambda 1.5 })",
                {{42001, 36895, 31789}}},
            ShadingProbe{
                "A6",
                "fog, camera inside solid clear box up to z=4",
                "",
                R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } box { -20,<20,20,4> texture { Clr } } fog { distance 8 rgb <.2,.5,.8> })",
                {{53591, 38551, 23511}}},
            ShadingProbe{
                "A7",
                "fog on shadow ray with media_attenuation",
                "",
                R"(CamZ(4*z) plane { -z,-5 texture { Wht } } light_source { -5*z rgb 1 media_attenuation on } fog { distance 8 rgbf <.9,.5,0,.5> })",
                {{21885, 13171, 4142}}},
            ShadingProbe{"A8",
                         "sky_sphere two layers",
                         "",
                         R"(CamZ(0) sky_sphere { pigment { rgb <.9,.6,.3> } pigment { rgbft <.2,.5,.8,.3,.4> } })",
                         {{31064, 31457, 28311}}},
            ShadingProbe{"A9",
                         "same, #version 3.6",
                         "#version 3.6",
                         R"(CamZ(0) sky_sphere { pigment { rgb <.9,.6,.3> } pigment { rgbft <.2,.5,.8,.3,.4> } })",
                         {{45219, 37355, 29491}}},
            ShadingProbe{"A10",
                         "background transmit without alpha output",
                         "",
                         R"(CamZ(0) background { rgbt <.9,.6,.3,.4> })",
                         {{35389, 23593, 11796}}},
            ShadingProbe{"A11",
                         "same with +UA (RGBA, alpha last)",
                         "+UA",
                         R"(CamZ(0) background { rgbt <.9,.6,.3,.4> })",
                         {{35389, 23592, 11796, 39321}}},
            ShadingProbe{
                "A12",
                "rainbow at 3 deg inside centre, azimuth 45 deg (arc 120, falloff 60)",
                "",
                R"(#declare Anti = vnormalize(<0,-.2,1>); #declare Rt = vnormalize(vcross(y,Anti)); #declare Up = vnormalize(vcross(Anti,Rt));
#declare Dir = cos(radians(37))*Anti + sin(radians(37))*(cos(radians(45))*Up + sin(radians(45))*Rt);
camera { orthographic location 0 direction Dir right .001*x up .001*y } background { rgb <.9,.6,.3> }
rainbow { angle 40 width 10 direction <0,-.2,1> distance 1e6 arc_angle 120 falloff_angle 60 color_map { [0 rgb <0,.5,1>] [1 rgb <1,.5,0>] } })",
                {{36044}}},
            ShadingProbe{
                "Q1",
                "quality 5 (no refraction, no reflection, quick colours)",
                "+Q5",
                R"(CamZ(-10*z) background { rgb <.1,.2,.3> } plane { -z,-1 pigment { rgb <.9,.6,.3> } finish { ambient .1 diffuse .5 } } disc { 0,z,3 pigment { rgbt <1,1,1,.5> quick_color rgbt <.2,.4,.6,.25> } finish { ambient .2 diffuse .1 reflection .3 } } light_source { -1e6*z rgb 1 })",
                {{2949, 5898, 8847}}},
            ShadingProbe{
                "Q2",
                "same, quality 6",
                "+Q6",
                R"(CamZ(-10*z) background { rgb <.1,.2,.3> } plane { -z,-1 pigment { rgb <.9,.6,.3> } finish { ambient .1 diffuse .5 } } disc { 0,z,3 pigment { rgbt <1,1,1,.5> quick_color rgbt <.2,.4,.6,.25> } finish { ambient .2 diffuse .1 reflection .3 } } light_source { -1e6*z rgb 1 })",
                {{20152, 16711, 13271}}},
            ShadingProbe{
                "Q3",
                "same, quality 8",
                "+Q8",
                R"(CamZ(-10*z) background { rgb <.1,.2,.3> } plane { -z,-1 pigment { rgb <.9,.6,.3> } finish { ambient .1 diffuse .5 } } disc { 0,z,3 pigment { rgbt <1,1,1,.5> quick_color rgbt <.2,.4,.6,.25> } finish { ambient .2 diffuse .1 reflection .3 } } light_source { -1e6*z rgb 1 })",
                {{22118, 20644, 19169}}},
            ShadingProbe{
                "N1",
                "8x1 image: crand, one thread",
                "",
                R"(camera { orthographic location -10*z direction z right 8*x up y } plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse .6 crand .5 } } light_source { -1e9*z rgb 1 })",
                {{39321}, {24033}, {31160}, {7672}, {18464}, {11016}, {25109}, {38059}}},
            ShadingProbe{
                "N2",
                "16x1 image: rainbow jitter, one thread (red = 2u-1 clipped)",
                "",
                R"(camera { orthographic location 0 direction z right 16*x up y } rainbow { angle 10 width 20 distance 1e-6 direction z up y jitter 1 color_map { [0 rgb 0] [1 rgb 1] } })",
                {{0},
                 {53187},
                 {43910},
                 {0},
                 {61455},
                 {54181},
                 {0},
                 {17348},
                 {0},
                 {0},
                 {6189},
                 {0},
                 {0},
                 {6145},
                 {64602},
                 {59965}}},
            ShadingProbe{
                "N3",
                "8x1 image: jittered 4x4 area light, half-plane blocker, one thread",
                "",
                R"(camera { orthographic location 50*y direction -y right 8*x up z } plane { y,0 texture { Wht } } box { <-100,3,-100>,<0,3.0001,100> no_image } light_source { 6*y rgb 1 area_light 4*x,4*z,4,4 jitter })",
                {{0}, {0}, {15895}, {32654}, {44900}, {47684}, {60494}, {56608}}},
            ShadingProbe{
                "N4",
                "8x1 image: adaptive 1 9x9",
                "",
                R"(camera { orthographic location 50*y direction -y right 8*x up z } plane { y,0 texture { Wht } } box { <-100,3,-100>,<0,3.0001,100> no_image } light_source { 6*y rgb 1 area_light 4*x,4*z,9,9 adaptive 1 })",
                {{0}, {0}, {3974}, {20409}, {36736}, {51657}, {60494}, {56608}}},
            ShadingProbe{
                "N5",
                "8x1 image: area_illumination 3x2, fade 4/2",
                "",
                R"(camera { orthographic location 50*y direction -y right 16*x up 2*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 area_light 8*x,4*z,3,2 area_illumination fade_distance 4 fade_power 2 })",
                {{15320}, {20698}, {24944}, {27132}, {27132}, {24944}, {20698}, {15320}}},
            ShadingProbe{
                "N6",
                "8x1 image: circular orient 5x5",
                "",
                R"(camera { orthographic location 50*y direction -y right 8*x up z } plane { y,0 texture { Wht } } box { <-100,3,-100>,<0,3.0001,100> no_image } light_source { 6*y rgb 1 area_light 4*x,4*z,5,5 circular orient })",
                {{0}, {0}, {7947}, {24491}, {40818}, {55631}, {60494}, {56608}}},
            ShadingProbe{
                "I17",
                "fresnel at exit surface, not nested",
                "",
                R"(global_settings { max_trace_level 20 } CamZ(-10*z) intersection { plane { -z,0 texture { Clr } } plane { z,1 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } } } interior { ior 1.5 } } plane { z,-20 pigment { rgb 1 } Em(1) })",
                {{2621}}},
            ShadingProbe{"I18",
                         "same inside a clear box of ior 1: fresnel reflection vanishes",
                         "",
                         R"(global_settings { max_trace_level 20 } CamZ(-10*z) intersection { plane { -z,0 texture { Clr } } plane { z,1 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } } } interior { ior 1.5 } } plane { z,-20 pigment { rgb 1 } Em(1) } box { <-5,-5,-3>,<5,5,5> texture { Clr } })",
                         {{0}}},
            ShadingProbe{
                "I19",
                "finish ior overrides interior ior and resets dispersion",
                "",
                R"(CamTilt(20) SkyX() disc { 0,z,100 pigment { rgbt 1 } finish { ambient 0 diffuse 0 ior 1.5 } interior { ior 1.2 dispersion 1.3 } })",
                {{40239}}},
            ShadingProbe{
                "S8",
                "caustics in finish is not multiplied by 45 (compare S5)",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc { y,vnormalize(<1,1,0>),3 no_image pigment { rgbt .3 } finish { caustics .1 } })",
                {{38651}}},
            ShadingProbe{
                "S10",
                "same with only column 2 rendered (+SC2): pixel 1 is lit",
                "+SC2",
                R"(camera { orthographic location 50*y direction -y right 2*x up z } plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc { <0,.01025,0>,vnormalize(<.0195,1,0>),3 no_image })",
                {{0}, {65535}}},
            ShadingProbe{
                "L11",
                "shadowless after spotlight removes the cone (and shadows)",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } light_source { 6*y rgb 1 spotlight point_at 100*x radius 5 falloff 10 shadowless })",
                {{65535}}},
            ShadingProbe{
                "L12",
                "shadowless before spotlight is lost",
                "",
                R"(CamDown() plane { y,0 texture { Wht } } box { <-1,1,-1>,<1,2,1> no_image } light_source { 6*y rgb 1 shadowless spotlight point_at 0 })",
                {{0}}},
            ShadingProbe{
                "L13",
                "projected_through; occluder between object and light ignored",
                "",
                R"(CamZ(-z) plane { -z,0 texture { Wht } } light_source { -10*z rgb .8 projected_through { disc { -5*z,z,1 } } } box { <-1,-1,-8>,<1,1,-7> })",
                {{52428}}},
            ShadingProbe{"L14",
                         "area_illumination on a non-area light disables the facing test",
                         "",
                         R"(CamZ(-10*z) plane { -z,0 texture { Wht } } light_source { 5*z rgb .7 area_illumination })",
                         {{45875}}},
            ShadingProbe{
                "O1",
                "union child no_image in a clipped union is visible to primary rays",
                "",
                R"(CamZ(-z) background { rgb .1 } union { sphere { 0,.5 pigment { rgb <1,0,0> } Em(1) no_image } sphere { 9*x,.5 } clipped_by { sphere { 0,50 } } })",
                {{65535, 0, 0}}},
            ShadingProbe{
                "O2",
                "merge child no_shadow still casts a shadow",
                "",
                R"(CamZ(-z) plane { -z,0 texture { Wht } } light_source { -10*z rgb 1 } merge { sphere { -3*z,.5 no_shadow } sphere { x*9,1 } })",
                {{0}}},
            ShadingProbe{
                "O3",
                "fog in a union whose children disagree on hollow: last child wins",
                "",
                R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8 rgb <.2,.5,.8> } union { box { <-1,-1,1>,<1,1,2> } box { <-1,-1,3>,<1,1,4> hollow } texture { Clr } })",
                {{37662, 36275, 34889}}},
            ShadingProbe{
                "O4",
                "reversed order",
                "",
                R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8 rgb <.2,.5,.8> } union { box { <-1,-1,1>,<1,1,2> hollow } box { <-1,-1,3>,<1,1,4> } texture { Clr } })",
                {{44636, 37272, 29907}}}),
    [](const testing::TestParamInfo<ShadingProbe>& s) { return s.param.id; });

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
light_source { <-5,6,-3> rgb <.4,.5,.8> spotlight point_at <0,0,1> radius 12 falloff 24 tightness 2 fade_distance 6 fade_power 2 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.7,.8,.9>] [1 rgb <.1,.2,.6>] } } }
fog { fog_type 2 distance 25 rgbt <.6,.65,.7,.1> fog_alt .6 fog_offset .1 }
plane { y,0 pigment { checker rgb .9 rgb <.3,.1,.1> } finish { ambient .05 diffuse .7 reflection { .02,.3 } } }
sphere { <-1.3,1,0>,1 pigment { rgbf <.8,.95,.9,.9> } finish { ambient 0 diffuse .05 specular .6 roughness .01 reflection { 0,1 fresnel } conserve_energy }
  interior { ior 1.5 fade_distance 1.5 fade_power 1 fade_color <.6,.9,.8> } }
sphere { <1.2,.9,.6>,.9 pigment { rgb <.9,.6,.2> } finish { ambient .02 diffuse .3 brilliance 3 phong .7 phong_size 60 metallic reflection { .3,.7 metallic } } }
box { <-.3,0,-1.6>,<.5,.7,-1.2> pigment { rgb <.2,.5,.3> } finish { ambient .1 diffuse .6,.2 irid { .3 thickness .4 } } rotate 20*y })",
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
rainbow { direction <0,-.3,1> angle 18 width 6 distance 40 color_map { [0 rgbt <.4,.1,.8,.5>] [.5 rgbt <.1,.9,.2,.5>] [1 rgbt <1,.2,.1,.5>] } arc_angle 160 falloff_angle 90 }
plane { y,0 pigment { rgb .8 } finish { ambient .1 diffuse .7 } }
light_group {
  light_source { <-4,4,-4> rgb <.2,.9,.3> fade_distance 5 fade_power 1 }
  sphere { <-1.5,.8,0>,.8 texture { pigment { rgb <.9,.7,.5> } finish { diffuse .8 specular albedo .3 roughness .05 } }
    texture { pigment { gradient y color_map { [0 rgbt 1] [.5 rgbft <.3,.4,.9,.3,.3>] [1 rgbt <.2,.2,.9,.1>] } scale .5 } finish { ambient .2 diffuse .4 reflection .1 } } }
  global_lights off }
intersection { plane { -y,0 } plane { <1,1,0>,.9 } plane { <-1,1,0>,.9 } plane { -z,.8 } plane { z,1.2 } pigment { rgbt <1,1,1,.95> } finish { diffuse .02 reflection { .05,.6 } }
  interior { ior 1.45 dispersion 1.08 dispersion_samples 5 } translate <1.2,0,.2> }
disc { <0,2.2,.5>,<.2,1,.3>,.8 texture { checker texture { pigment { rgbf <1,.6,.2,.8> } } texture { pigment { rgb .3 } finish { diffuse .3,.5 } } scale .4 } })",
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
camera { orthographic location 50*y direction -y right 2*x up z } plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 }
#declare A = box { <-2,1,-2>,<0,2,2> no_image } #declare B = box { <0,1,-2>,<2,2,2> pigment { rgbt <1,1,1,.5> } no_image }
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
camera { orthographic location 50*y direction -y right 2*x up z } plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 }
intersection { disc { <-.5,2,0>,y,.3 } box { <-2,1,-2>,<2,3,2> } pigment { rgb 1 } no_image })",
                                                2, 1, options);
  EXPECT_EQ(lin16(frame, 0, 0)[0], 0);
  EXPECT_NEAR(lin16(frame, 1, 0)[0], 65535, 2);
}

// POV-Ray's shadow cache makes an opaque occluder count from 1e-4 on if it blocked the light of the pixel before (S9,
// spec 06 9.2); by default it counts whatever was before, but not for lights of groups, which have no cache.
TEST(ShadowCache, OccluderInTheContactZoneShadows) {
  const std::string scene = std::string("#version 3.7;") + kPrelude + R"(
camera { orthographic location 50*y direction -y right 2*x up z } plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 }
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

}  // namespace
}  // namespace verisim::test
