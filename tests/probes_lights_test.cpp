// The probes of spec 06 section 19 on lights, fog and the sky, and all that were added later.
#include "tests/support/shading_probe.h"

namespace verisim::test {
namespace {

class LightProbes : public testing::TestWithParam<ShadingProbe> {};

TEST_P(LightProbes, EqualPovRay) { expect_the_colours_of(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Spec06, LightProbes,
    testing::Values(ShadingProbe{"L1",
                                 "point light, fade 4/2, at x=2",
                                 "",
                                 R"(camera { orthographic location <2,50,0> direction -y right .01*x
up .01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 fade_distance 4 fade_power 2 })",
                                 {{35527}}},
                    ShadingProbe{"L2",
                                 "spotlight defaults, x=4.8125",
                                 "",
                                 R"(camera { orthographic location <4.8125,50,0> direction -y right .01*x up
.01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 spotlight point_at 0 })",
                                 {{22436}}},
                    ShadingProbe{"L3",
                                 "spotlight 20/50 tightness 10, x=3.0625",
                                 "",
                                 R"(camera { orthographic location <3.0625,50,0> direction -y right .01*x up
.01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 spotlight point_at 0 radius 20 falloff 50 tightness 10
})",
                                 {{17008}}},
                    ShadingProbe{"L4",
                                 "cylinder 1/4 tightness .5, x=1.96875",
                                 "",
                                 R"(camera { orthographic location <1.96875,50,0> direction -y right .01*x up
.01*z } plane { y,0 texture { Wht } } light_source { 6*y rgb 1 cylinder point_at 0 radius 1 falloff 4 tightness .5 })",
                                 {{35237}}},
                    ShadingProbe{"L5",
                                 "parallel + fade: projected distance, x=-7.5",
                                 "",
                                 R"(camera { orthographic location <-7.5,50,0> direction -y right .01*x up
.01*z } plane { y,0 texture { Wht } } light_source { <3,4,0> rgb 1 parallel point_at 0 fade_distance 4 fade_power 2 })",
                                 {{15790}}},
                    ShadingProbe{"L6",
                                 "parallel light lights points behind it, unshadowed",
                                 "",
                                 R"(CamDown() plane { y,0 texture { Wht } } light_source { -4*y rgb 1 parallel
point_at -5*y } box { <-1,2,-1>,<1,2.5,1> no_image })",
                                 {{65535}}},
                    ShadingProbe{"L7",
                                 "area light 3x3, centre sample blocked (weight 1/4)",
                                 "",
                                 R"(CamDown() plane { y,0 texture { Wht } } light_source { 6*y rgb 1
area_light 8*x,8*z,3,3 } box { -.05,.05 translate .97*6*y no_image })",
                                 {{49151}}},
                    ShadingProbe{"L8",
                                 "area light 7x1: sample 3 has double weight",
                                 "",
                                 R"(CamDown() plane { y,0 texture { Wht } } light_source { 6*y rgb 1
area_light 8*x,8*z,7,1 } box { -.05,.05 translate .97*6*y no_image })",
                                 {{49151}}},
                    ShadingProbe{"L9",
                                 "nested in-line light_group: inner objects lose the outer light",
                                 "",
                                 R"(CamZ(-10*z) light_group { light_group { light_source { -1e6*z rgb <.5,0,0>
} plane { -z,0 texture { Wht } } } light_source { -1e6*z rgb <0,.25,0> } } light_source { -1e6*z rgb <0,0,.125> })",
                                 {{32768, 0, 0}}},
                    ShadingProbe{"L10",
                                 "nested through an identifier: inherits",
                                 "",
                                 R"(CamZ(-10*z) #declare G = light_group { light_source { -1e6*z rgb <.5,0,0>
} plane { -z,0 texture { Wht } } } light_group { light_source { -1e6*z rgb <0,.25,0> } light_group { G } }
light_source { -1e6*z rgb <0,0,.125> })",
                                 {{32768, 16384, 0}}},
                    ShadingProbe{"A1",
                                 "fog type 1, filter and transmit",
                                 "",
                                 R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8
rgbft <.2,.5,.8,.5,.1> })",
                                 {{25034, 31014, 33836}}},
                    ShadingProbe{"A2",
                                 "ground fog, horizontal at y=2",
                                 "",
                                 R"(CamZ(2*y) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { fog_type
2 distance 8 rgb <.2,.5,.8> fog_alt .7 fog_offset 1 })",
                                 {{50458, 38103, 25748}}},
                    ShadingProbe{"A3",
                                 "ground fog to infinity, 5 deg up from y=2",
                                 "",
                                 R"(camera { orthographic location 2*y direction
<0,sin(radians(5)),cos(radians(5))> right .01*x up .01*<0,cos(radians(5)),-sin(radians(5))> } background { rgb 1 }
fog { fog_type 2 distance 8 rgb <.2,.5,.8> fog_alt .7 fog_offset 1 })",
                                 {{41505, 50516, 59527}}},
                    ShadingProbe{"A4",
                                 "two fogs",
                                 "",
                                 R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8
rgb <.2,.5,.8> } fog { distance 20 rgb <.9,.1,.1> })",
                                 {{43725, 33069, 34011}}},
                    ShadingProbe{"A5",
                                 "fog turbulence",
                                 "",
                                 R"(CamZ(<.3,.2,0>) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog {
distance 8 rgb <.2,.5,.8> turbulence <1,.5,.2> turb_depth .7 octaves 3 omega .7 lambda 1.5 })",
                                 {{42001, 36895, 31789}}},
                    ShadingProbe{"A6",
                                 "fog, camera inside solid clear box up to z=4",
                                 "",
                                 R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } box {
-20,<20,20,4> texture { Clr } } fog { distance 8 rgb <.2,.5,.8> })",
                                 {{53591, 38551, 23511}}},
                    ShadingProbe{"A7",
                                 "fog on shadow ray with media_attenuation",
                                 "",
                                 R"(CamZ(4*z) plane { -z,-5 texture { Wht } } light_source { -5*z rgb 1
media_attenuation on } fog { distance 8 rgbf <.9,.5,0,.5> })",
                                 {{21885, 13171, 4142}}},
                    ShadingProbe{"A8",
                                 "sky_sphere two layers",
                                 "",
                                 R"(CamZ(0) sky_sphere { pigment { rgb <.9,.6,.3> } pigment { rgbft
<.2,.5,.8,.3,.4> } })",
                                 {{31064, 31457, 28311}}},
                    ShadingProbe{"A9",
                                 "same, #version 3.6",
                                 "#version 3.6",
                                 R"(CamZ(0) sky_sphere { pigment { rgb <.9,.6,.3> } pigment { rgbft
<.2,.5,.8,.3,.4> } })",
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
                    ShadingProbe{"A12",
                                 "rainbow at 3 deg inside centre, azimuth 45 deg (arc 120, falloff 60)",
                                 "",
                                 R"(#declare Anti = vnormalize(<0,-.2,1>); #declare Rt =
vnormalize(vcross(y,Anti)); #declare Up = vnormalize(vcross(Anti,Rt));
#declare Dir = cos(radians(37))*Anti + sin(radians(37))*(cos(radians(45))*Up + sin(radians(45))*Rt);
camera { orthographic location 0 direction Dir right .001*x up .001*y } background { rgb <.9,.6,.3> }
rainbow { angle 40 width 10 direction <0,-.2,1> distance 1e6 arc_angle 120 falloff_angle 60 color_map { [0 rgb
<0,.5,1>] [1 rgb <1,.5,0>] } })",
                                 {{36044}}},
                    ShadingProbe{"Q1",
                                 "quality 5 (no refraction, no reflection, quick colours)",
                                 "+Q5",
                                 R"(CamZ(-10*z) background { rgb <.1,.2,.3> } plane { -z,-1 pigment { rgb
<.9,.6,.3> } finish { ambient .1 diffuse .5 } } disc { 0,z,3 pigment { rgbt <1,1,1,.5> quick_color rgbt
<.2,.4,.6,.25> } finish { ambient .2 diffuse .1 reflection .3 } } light_source { -1e6*z rgb 1 })",
                                 {{2949, 5898, 8847}}},
                    ShadingProbe{"Q2",
                                 "same, quality 6",
                                 "+Q6",
                                 R"(CamZ(-10*z) background { rgb <.1,.2,.3> } plane { -z,-1 pigment { rgb
<.9,.6,.3> } finish { ambient .1 diffuse .5 } } disc { 0,z,3 pigment { rgbt <1,1,1,.5> quick_color rgbt
<.2,.4,.6,.25> } finish { ambient .2 diffuse .1 reflection .3 } } light_source { -1e6*z rgb 1 })",
                                 {{20152, 16711, 13271}}},
                    ShadingProbe{"Q3",
                                 "same, quality 8",
                                 "+Q8",
                                 R"(CamZ(-10*z) background { rgb <.1,.2,.3> } plane { -z,-1 pigment { rgb
<.9,.6,.3> } finish { ambient .1 diffuse .5 } } disc { 0,z,3 pigment { rgbt <1,1,1,.5> quick_color rgbt
<.2,.4,.6,.25> } finish { ambient .2 diffuse .1 reflection .3 } } light_source { -1e6*z rgb 1 })",
                                 {{22118, 20644, 19169}}},
                    ShadingProbe{"N1",
                                 "8x1 image: crand, one thread",
                                 "",
                                 R"(camera { orthographic
location -10*z direction z right 8*x up y } plane { -z,0 pigment { rgb 1 } finish { ambient 0 diffuse .6 crand .5 } }
light_source { -1e9*z rgb 1 })",
                                 {{39321}, {24033}, {31160}, {7672}, {18464}, {11016}, {25109}, {38059}}},
                    ShadingProbe{"N2",
                                 "16x1 image: rainbow jitter, one thread (red = 2u-1 clipped)",
                                 "",
                                 R"(camera { orthographic location 0 direction z right 16*x up y } rainbow {
angle 10 width 20 distance 1e-6 direction z up y jitter 1 color_map { [0 rgb 0] [1 rgb 1] } })",
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
                    ShadingProbe{"N3",
                                 "8x1 image: jittered 4x4 area light, half-plane blocker, one thread",
                                 "",
                                 R"(camera { orthographic location 50*y direction -y right 8*x up z } plane {
y,0 texture { Wht } } box { <-100,3,-100>,<0,3.0001,100> no_image } light_source { 6*y rgb 1 area_light 4*x,4*z,4,4
jitter })",
                                 {{0}, {0}, {15895}, {32654}, {44900}, {47684}, {60494}, {56608}}},
                    ShadingProbe{"N4",
                                 "8x1 image: adaptive 1 9x9",
                                 "",
                                 R"(camera { orthographic location 50*y direction -y right 8*x up z } plane {
y,0 texture { Wht } } box { <-100,3,-100>,<0,3.0001,100> no_image } light_source { 6*y rgb 1 area_light 4*x,4*z,9,9
adaptive 1 })",
                                 {{0}, {0}, {3974}, {20409}, {36736}, {51657}, {60494}, {56608}}},
                    ShadingProbe{"N5",
                                 "8x1 image: area_illumination 3x2, fade 4/2",
                                 "",
                                 R"(camera { orthographic location 50*y direction -y right 16*x up 2*z } plane
{ y,0 texture { Wht } } light_source { 6*y rgb 1 area_light 8*x,4*z,3,2 area_illumination fade_distance 4 fade_power
2 })",
                                 {{15320}, {20698}, {24944}, {27132}, {27132}, {24944}, {20698}, {15320}}},
                    ShadingProbe{"N6",
                                 "8x1 image: circular orient 5x5",
                                 "",
                                 R"(camera { orthographic location 50*y direction -y right 8*x up z } plane {
y,0 texture { Wht } } box { <-100,3,-100>,<0,3.0001,100> no_image } light_source { 6*y rgb 1 area_light 4*x,4*z,5,5
circular orient })",
                                 {{0}, {0}, {7947}, {24491}, {40818}, {55631}, {60494}, {56608}}},
                    ShadingProbe{"I17",
                                 "fresnel at exit surface, not nested",
                                 "",
                                 R"(global_settings { max_trace_level 20 } CamZ(-10*z) intersection { plane {
-z,0 texture { Clr } } plane { z,1 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } } }
interior { ior 1.5 } } plane { z,-20 pigment { rgb 1 } Em(1) })",
                                 {{2621}}},
                    ShadingProbe{"I18",
                                 "same inside a clear box of ior 1: fresnel reflection vanishes",
                                 "",
                                 R"(global_settings { max_trace_level 20 } CamZ(-10*z) intersection { plane {
-z,0 texture { Clr } } plane { z,1 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 fresnel } } }
interior { ior 1.5 } } plane { z,-20 pigment { rgb 1 } Em(1) } box { <-5,-5,-3>,<5,5,5> texture { Clr } })",
                                 {{0}}},
                    ShadingProbe{"I19",
                                 "finish ior overrides interior ior and resets dispersion",
                                 "",
                                 R"(CamTilt(20) SkyX() disc { 0,z,100 pigment { rgbt 1 } finish { ambient 0
diffuse 0 ior 1.5 } interior { ior 1.2 dispersion 1.3 } })",
                                 {{40239}}},
                    ShadingProbe{"S8",
                                 "caustics in finish is not multiplied by 45 (compare S5)",
                                 "",
                                 R"(CamDown() plane { y,0 texture { Wht } } light_source { 1000*y rgb 1
parallel point_at 0 } disc { y,vnormalize(<1,1,0>),3 no_image pigment { rgbt .3 } finish { caustics .1 } })",
                                 {{38651}}},
                    ShadingProbe{"S10",
                                 "same with only column 2 rendered (+SC2): pixel 1 is lit",
                                 "+SC2",
                                 R"(camera { orthographic location 50*y direction -y right 2*x up z } plane {
y,0 texture { Wht } } light_source { 1000*y rgb 1 parallel point_at 0 } disc { <0,.01025,0>,vnormalize(<.0195,1,0>),3
no_image })",
                                 {{0}, {65535}}},
                    ShadingProbe{"L11",
                                 "shadowless after spotlight removes the cone (and shadows)",
                                 "",
                                 R"(CamDown() plane { y,0 texture { Wht } } light_source { 6*y rgb 1 spotlight
point_at 100*x radius 5 falloff 10 shadowless })",
                                 {{65535}}},
                    ShadingProbe{"L12",
                                 "shadowless before spotlight is lost",
                                 "",
                                 R"(CamDown() plane { y,0 texture { Wht } } box { <-1,1,-1>,<1,2,1> no_image }
light_source { 6*y rgb 1 shadowless spotlight point_at 0 })",
                                 {{0}}},
                    ShadingProbe{"L13",
                                 "projected_through; occluder between object and light ignored",
                                 "",
                                 R"(CamZ(-z) plane { -z,0 texture { Wht } } light_source { -10*z rgb .8
projected_through { disc { -5*z,z,1 } } } box { <-1,-1,-8>,<1,1,-7> })",
                                 {{52428}}},
                    ShadingProbe{"L14",
                                 "area_illumination on a non-area light disables the facing test",
                                 "",
                                 R"(CamZ(-10*z) plane { -z,0 texture { Wht } } light_source { 5*z rgb .7
area_illumination })",
                                 {{45875}}},
                    ShadingProbe{"O1",
                                 "union child no_image in a clipped union is visible to primary rays",
                                 "",
                                 R"(CamZ(-z) background { rgb .1 } union { sphere { 0,.5 pigment { rgb <1,0,0>
} Em(1) no_image } sphere { 9*x,.5 } clipped_by { sphere { 0,50 } } })",
                                 {{65535, 0, 0}}},
                    ShadingProbe{"O2",
                                 "merge child no_shadow still casts a shadow",
                                 "",
                                 R"(CamZ(-z) plane { -z,0 texture { Wht } } light_source { -10*z rgb 1 } merge
{ sphere { -3*z,.5 no_shadow } sphere { x*9,1 } })",
                                 {{0}}},
                    ShadingProbe{"O3",
                                 "fog in a union whose children disagree on hollow: last child wins",
                                 "",
                                 R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8
rgb <.2,.5,.8> } union { box { <-1,-1,1>,<1,1,2> } box { <-1,-1,3>,<1,1,4> hollow } texture { Clr } })",
                                 {{37662, 36275, 34889}}},
                    ShadingProbe{"O4",
                                 "reversed order",
                                 "",
                                 R"(CamZ(0) plane { -z,-5 pigment { rgb <.9,.6,.3> } Em(1) } fog { distance 8
rgb <.2,.5,.8> } union { box { <-1,-1,1>,<1,1,2> hollow } box { <-1,-1,3>,<1,1,4> } texture { Clr } })",
                                 {{44636, 37272, 29907}}}),
    [](const testing::TestParamInfo<ShadingProbe>& s) { return s.param.id; });

}  // namespace
}  // namespace verisim::test
