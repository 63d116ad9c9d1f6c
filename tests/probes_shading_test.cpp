// The probes of spec 06 section 19 on finishes, reflection, interiors and shadows.
#include "tests/support/shading_probe.h"

namespace verisim::test {
namespace {

class ShadingProbes : public testing::TestWithParam<ShadingProbe> {};

TEST_P(ShadingProbes, EqualPovRay) { expect_the_colours_of(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Spec06, ShadingProbes,
    testing::Values(
        ShadingProbe{"F1",
                     "defaults: ambient 0.1, diffuse 0.6",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish {  } } light_source { -5*z rgb 1 })",
                     {{45875, 22937, 11469}}},
        ShadingProbe{
            "F2",
            "ambient*ambient_light + emission",
            "",
            R"(global_settings { ambient_light rgb <.5,1,2> } CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> }
finish { ambient rgb <.2,.3,.4> emission rgb <.1,0,0> diffuse 0 } })",
            {{13107, 9830, 13107}}},
        ShadingProbe{
            "F3",
            "brilliance, light at 60 deg",
            "",
            R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse .7 brilliance 2.5 }
} light_source { <5*sqrt(3),0,-5> rgb 1 })",
            {{8110, 4055, 2027}}},
        ShadingProbe{"F4",
                     "brilliance with albedo",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse albedo .7
brilliance 2.5 } } light_source { <5*sqrt(3),0,-5> rgb 1 })",
                     {{14192, 7096, 3548}}},
        ShadingProbe{"F5",
                     "diffuse back value; highlights suppressed",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse .7,.4 phong 1
specular 1 } } light_source { <5,0,5> rgb 1 })",
                     {{18536, 9268, 4634}}},
        ShadingProbe{"F6",
                     "phong, 20 deg",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 phong .8 } }
light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                     {{4355}}},
        ShadingProbe{"F7",
                     "specular, 20 deg, default roughness",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 specular .8 } }
light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                     {{38600}}},
        ShadingProbe{"F8",
                     "specular albedo, roughness .02, 20 deg",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse 0 specular albedo .05
roughness .02 } } light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                     {{9907}}},
        ShadingProbe{"F9",
                     "specular metallic .8, 70 deg",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 specular .9
roughness .1 metallic .8 } } light_source { <5*tan(radians(70)),0,-5> rgb 1 })",
                     {{8023, 5176, 3752}}},
        ShadingProbe{"F10",
                     "phong metallic .8, 20 deg",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb <1,.5,.25> } finish { ambient 0 diffuse 0 phong .9
phong_size 2 metallic .8 } } light_source { <5*tan(radians(20)),0,-5> rgb 1 })",
                     {{52082, 31384, 21035}}},
        ShadingProbe{"F11",
                     "transparent surface: opacity scales diffuse, not phong",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgbft <.8,.4,.2,.3,.25> } finish { ambient 0 diffuse .6 phong
.2 } } light_source { -5*z rgb 1 })",
                     {{27263, 20185, 16646}}},
        ShadingProbe{"F12",
                     "same, legacy #version 3.6",
                     "#version 3.6",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgbft <.8,.4,.2,.3,.25> } finish { ambient 0 diffuse .6 phong
.2 } } light_source { -5*z rgb 1 })",
                     {{29150, 21128, 17118}}},
        ShadingProbe{"F13",
                     "irid on direct light",
                     "",
                     R"(CamZ(-10*z) plane { -z,0 pigment { rgb 1 } finish { ambient .05 diffuse .5 phong .2 phong_size 1
irid { .35 thickness .6 } } } light_source { <5*sqrt(3),0,-5> rgb 1 })",
                     {{24428, 25246, 31891}}},
        ShadingProbe{
            "F14",
            "two layers over a background",
            "",
            R"(CamZ(-10*z) background { rgb <.9,.6,.3> } disc { 0,z,3 texture { pigment { rgbft <.1,.5,.9,.5,.2>
} Em(.4) } texture { pigment { rgbft <.8,.5,.2,.3,.4> } Em(.5) } })",
            {{17805, 16810, 11100}}},
        ShadingProbe{"R1",
                     "variable reflection, 60 deg",
                     "",
                     R"(CamTilt(60) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0
diffuse 0 reflection { rgb <.1,.2,.3>, rgb <.9,.8,.7> falloff 2.5 } } })",
                     {{14239, 12035, 7288}}},
        ShadingProbe{"R2",
                     "fresnel reflection, 60 deg",
                     "",
                     R"(CamTilt(60) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0
diffuse 0 reflection { .2, .8 fresnel on } } interior { ior 1.5 } })",
                     {{14953, 9968, 4984}}},
        ShadingProbe{
            "R3",
            "metallic reflection, 80 deg",
            "",
            R"(CamTilt(80) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb <.8,.5,.2> } finish { ambient
0 diffuse 0 reflection { .5 metallic .7 } } })",
            {{26440, 14576, 5763}}},
        ShadingProbe{"R4",
                     "reflection exponent 2",
                     "",
                     R"(CamTilt(30) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0
diffuse 0 reflection { .5 exponent 2 } } })",
                     {{31086, 25382, 17948}}},
        ShadingProbe{"R5",
                     "lower layer reflection is not filtered",
                     "",
                     R"(CamZ(-10*z) background { rgb <.9,.6,.3> } plane { -z,0 texture { pigment { rgb 1 } finish {
ambient 0 diffuse 0 reflection .3 } } texture { pigment { rgbt <1,1,1,.5> } finish { ambient 0 diffuse 0 reflection
.2 } } })",
                     {{29491, 19661, 9830}}},
        ShadingProbe{
            "R6",
            "two parallel mirrors, default max_trace_level 5",
            "",
            R"(CamZ(0) plane { -z,-1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission .3 reflection .5 } }
plane { z,-1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission .3 reflection .5 } })",
            {{38092}}},
        ShadingProbe{
            "R7",
            "same, max_trace_level 20: ADC stops after 8",
            "",
            R"(global_settings { max_trace_level 20 } CamZ(0) plane { -z,-1 pigment { rgb 1 } finish { ambient 0
diffuse 0 emission .3 reflection .5 } } plane { z,-1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission .3
reflection .5 } })",
            {{39167}}},
        ShadingProbe{"R8",
                     "straight-through rays do not consume levels (12 discs)",
                     "",
                     R"(CamZ(0) background { rgb 1 } #for(I,1,12) disc { I*z,z,10 pigment { rgbt <1,1,1,.9> } Em(.01) }
#end)",
                     {{18979}}},
        ShadingProbe{"R9",
                     "irid on reflection, 40 deg",
                     "",
                     R"(CamTilt(40) background { rgb <.9,.6,.3> } plane { -z,0 pigment { rgb 1 } finish { ambient 0
diffuse 0 reflection 1 irid { .35 thickness .2 } } })",
                     {{39897, 27667, 15220}}},
        ShadingProbe{"I1",
                     "fade_power 2, depth 1",
                     "",
                     R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,2> texture {
Clr } interior { fade_distance .5 fade_power 2 fade_color <.9,.5,.1> } })",
                     {{54263, 23593, 5505}}},
        ShadingProbe{"I2",
                     "fade_power 1000 (exponential)",
                     "",
                     R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,2> texture {
Clr } interior { fade_distance .5 fade_power 1000 fade_color <.9,.5,.1> } })",
                     {{48290, 14465, 3250}}},
        ShadingProbe{"I3",
                     "fade_distance without fade_power (camera ray)",
                     "",
                     R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,2> texture {
Clr } interior { fade_distance .5 fade_color <.9,.5,.1> } })",
                     {{56032, 29491, 10813}}},
        ShadingProbe{"I4",
                     "bubble inside: only the last segment attenuates",
                     "",
                     R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } box { <-3,-3,1>,<3,3,7> texture {
Clr } interior { fade_distance 2 fade_power 1 } } box { <-1,-1,3>,<1,1,4> texture { Clr } })",
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
            R"(CamTilt(20) SkyX() intersection { plane { -z,3 } plane { z,0 } texture { Clr } interior { ior 1.5
} } intersection { plane { -z,2 } plane { <.3,0,1>,-1 } texture { Clr } interior { ior 1.2 } })",
            {{46799}}},
        ShadingProbe{"I7",
                     "overlap (A (B A) B): A exit is not refracted",
                     "",
                     R"(CamTilt(20) SkyX() intersection { plane { -z,3 } plane { <.3,0,1>,0 } texture { Clr } interior {
ior 1.5 } } intersection { plane { -z,1 } plane { z,2 } texture { Clr } interior { ior 1.2 } })",
                     {{43975}}},
        ShadingProbe{
            "I8",
            "union children share one interior (entry+exit)",
            "",
            R"(CamTilt(20) SkyX() union { disc { 0,z,100 } disc { 2*z,z,100 } texture { Clr } interior { ior 1.5
} })",
            {{43975}}},
        ShadingProbe{
            "I9",
            "same discs, separate interiors (never leaves)",
            "",
            R"(CamTilt(20) SkyX() disc { 0,z,100 texture { Clr } interior { ior 1.5 } } disc { 2*z,z,100 texture
{ Clr } interior { ior 1.5 } })",
            {{40239}}},
        ShadingProbe{
            "I10",
            "camera inside two nested spheres, outer declared first",
            "",
            R"(CamZ(.5*x) SkyX() sphere { 0,2 texture { Clr } interior { ior 1.5 } } sphere { 0,1 texture { Clr }
interior { ior 1.2 } })",
            {{33054}}},
        ShadingProbe{
            "I11",
            "same, inner declared first",
            "",
            R"(CamZ(.5*x) SkyX() sphere { 0,1 texture { Clr } interior { ior 1.2 } } sphere { 0,2 texture { Clr }
interior { ior 1.5 } })",
            {{28464}}},
        ShadingProbe{"I12",
                     "white through a dispersive slab",
                     "",
                     R"(CamZ(-10*z) background { rgb 1 } box { <-3,-3,1>,<3,3,2> texture { Clr } interior { ior 1.5
dispersion 1.1 } })",
                     {{65129, 65535, 65286}}},
        ShadingProbe{
            "I13",
            "dispersive prism, 7 samples",
            "",
            R"(CamZ(-10*z) SkyX() intersection { plane { -z,0 } plane { <.5,0,1>,1 } plane { -x,5 } plane { x,5 }
texture { Clr } interior { ior 1.5 dispersion 1.2 dispersion_samples 7 } })",
            {{25068, 24383, 22580}}},
        ShadingProbe{"I14",
                     "total internal reflection: TIR face transmit .5 does not filter, its reflection is skipped",
                     "",
                     R"(CamZ(-10*z) background { rgb .3 } intersection { plane { -z,0 texture { Clr } }
plane { <1,0,1>,1 texture { pigment { rgbt <1,1,1,.5> } finish { ambient 0 diffuse 0 emission .2 reflection .5 } } }
plane { -x,5 texture { Clr } } interior { ior 1.5 } })",
                     {{26214}}},
        ShadingProbe{
            "I15",
            "slab, fresnel + conserve_energy, two-sided",
            "",
            R"(CamZ(-10*z) box { <-5,-5,0>,<5,5,1> pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 1
fresnel } conserve_energy } interior { ior 1.5 } } plane { -z,-5 pigment { rgb 1 } Em(.8) } plane { z,-20 pigment {
rgb 1 } Em(.2) })",
            {{49325}}},
        ShadingProbe{"I16",
                     "conserve_energy, constant reflection",
                     "",
                     R"(CamZ(-10*z) plane { -z,-20 pigment { rgb <.9,.6,.3> } Em(1) } background { rgb 0 } disc { z,z,3
pigment { rgbt <1,1,1,.8> } finish { ambient 0 diffuse 0 emission .5 reflection <.1,.2,.3> conserve_energy } })",
                     {{49020, 31719, 17563}}},
        ShadingProbe{"S1",
                     "shadow: filter + transmit, two surfaces",
                     "",
                     R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } box {
<-1,1,-1>,<1,2,1> no_image pigment { rgbft <.8,.5,.2,.3,.4> } })",
                     {{26843, 19824, 13867}}},
        ShadingProbe{"S2",
                     "shadow: layered disc",
                     "",
                     R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc {
y,y,1 no_image texture { pigment { rgbft <.8,.5,.2,.3,.4> } } texture { pigment { rgbft <.1,.5,.9,.5,.2> } } })",
                     {{10486, 16220, 19595}}},
        ShadingProbe{"S3",
                     "slab thinner than 0.001: one surface only",
                     "",
                     R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } box {
<-1,1,-1>,<1,1.0005,1> no_image pigment { rgbft <.8,.5,.2,.3,.4> } })",
                     {{41942, 36044, 30146}}},
        ShadingProbe{"S4",
                     "shadow with fade (thickness 1, fade_distance .5)",
                     "",
                     R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } box {
<-1,1,-1>,<1,2,1> no_image pigment { rgbt 1 } interior { fade_distance .5 fade_power 2 fade_color <.9,.5,.1> } })",
                     {{60292, 39321, 18350}}},
        ShadingProbe{"S5",
                     "faked caustics, disc tilted 45 deg",
                     "",
                     R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc {
y,vnormalize(<1,1,0>),3 no_image pigment { rgbt .3 } interior { caustics .1 } })",
                     {{23794}}},
        ShadingProbe{"S6",
                     "texture_map 70/30 shadow",
                     "",
                     R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc {
2*y,y,3 no_image texture { gradient z texture_map { [0 pigment { rgbf 1 }] [1 pigment { rgb <.2,.4,.6> }] } translate
-.3*z } })",
                     {{45875}}},
        ShadingProbe{"S7",
                     "pigment blend 70/30 shadow (filter of blended colour)",
                     "",
                     R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc {
2*y,y,3 no_image texture { pigment { gradient z color_map { [0 rgbf 1] [1 rgb <.2,.4,.6>] } } translate -.3*z } })",
                     {{34865, 37617, 40370}}}),
    [](const testing::TestParamInfo<ShadingProbe>& s) { return s.param.id; });

}  // namespace
}  // namespace verisim::test
