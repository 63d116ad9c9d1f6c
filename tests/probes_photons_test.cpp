// The ways of photons against POV-Ray's: how many are stored and their energy, from its photon files (povray +WT1,
// bytes as they are).
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/probe.h"
#include "tracer/photons/photon_map.h"

namespace verisim::test {
namespace {

std::string glass(const std::string& look, const std::string& interior = "ior 1.5") {
  return "light_source{<500,550,-100>,1} object{cylinder{-y*2,y*2,1} " + look + " interior{" + interior +
         "} photons{target refraction on reflection on collect off}}";
}
std::string mirror(const std::string& look, const std::string& light = "1") {
  return "light_source{<0.01,550,-200>," + light + "} object{box{<-3,-2,0>,<3,2,.1> rotate x*10} " + look +
         " photons{target refraction off reflection on collect off}}";
}

const std::string kPane =
    "object{box{<-3,0,-3>,<3,.1,3> pigment{rgbf 1} photons{target refraction on reflection off collect off}}}";

struct Way {
  std::string name;
  int level;             // max_trace_level
  std::string settings;  // more of photons { }
  std::string objects;
  std::size_t count;  // of photons in POV-Ray's file
  Rgb energy;         // all of them
};
void PrintTo(const Way& w, std::ostream* out) { *out << w.name; }
class PhotonWays : public testing::TestWithParam<Way> {};

TEST_P(PhotonWays, EndWherePovRaysDo) {
  const Way& w = GetParam();
  const std::filesystem::path file = "ways_" + w.name + ".ph";  // scenes write below the current folder
  std::filesystem::remove(file);
  const std::string settings = w.settings.empty() ? "adc_bailout 1e-6" : w.settings;
  render_text(
      "#version 3.7; global_settings{assumed_gamma 1 max_trace_level 5 photons{spacing 0.2 autostop 0 jitter 0 "
      "max_trace_level " +
          std::to_string(w.level) + " save_file \"" + file.string() + "\" " + settings +
          "}} camera{location <-0.5,2.5,-7> look_at <-.5,.5,0> right x*4/3}" + "plane{y,-1.9999 pigment{rgb .5}}" +
          w.objects,
      4, 4);
  global::PhotonMap surface, media;
  if (std::filesystem::exists(file)) global::load_photons(file, surface, media);  // none is written when there are none
  std::filesystem::remove(file);
  EXPECT_EQ(surface.size(), w.count);
  Rgb sum;
  for (const global::Photon& photon : surface.photons()) sum += photon.color();
  EXPECT_NEAR(sum.r, w.energy.r, 1e-4f * w.energy.r);
  EXPECT_NEAR(sum.g, w.energy.g, 1e-4f * w.energy.g);
  EXPECT_NEAR(sum.b, w.energy.b, 1e-4f * w.energy.b);
}

INSTANTIATE_TEST_SUITE_P(
    Measured, PhotonWays,
    testing::Values(
        Way{"TotalReflectionIsNotFiltered",
            3,
            "",
            glass(R"(pigment{rgbf<.9,.5,.7,.7>})"),
            184,
            {3.7128, 1.6575, 2.6055}},
        Way{"WhatDoesNotCountInAnAverageIsBlack",
            3,
            "",
            glass("texture{average texture_map{[0 pigment{rgbf .5}][1 pigment{rgbf<.9,.5,.7,.7>}]}}"),
            658,
            {3.7128, 1.6575, 2.6055}},
        Way{"TotalReflectionIsTheOnlyOne",
            6,
            "",
            glass(R"(pigment{rgbf<.9,.5,.7,.7>} finish{reflection .3 conserve_energy})"),
            534,
            {4.6263, 3.0733, 3.8031}},
        Way{"MirrorsWithinFadedGlassFade",
            6,
            "",
            glass("pigment{rgbf<1,1,1,.9>} finish{reflection .2}",
                  "ior 1.5 fade_distance 2 fade_power 1001 fade_color rgb<.35,.65,.85>"),
            534,
            {5.3818, 6.5627, 7.6615}},
        Way{"TotalReflectionWeighsLess",
            3,
            "adc_bailout .5",
            glass(R"(pigment{rgbf<1,1,1,.7>})"),
            39,
            {1.0941, 1.0941, 1.0941}},
        Way{"EndsWhereLittleGreyGetsThrough",
            2,
            "adc_bailout .42",
            glass(R"(pigment{rgbf<.9,.5,.2,.7>})"),
            0,
            {0, 0, 0}},
        Way{"GoesOnWhereMoreDoes",
            2,
            "adc_bailout .40",
            glass(R"(pigment{rgbf<.9,.5,.2,.7>})"),
            39,
            {0.98462, 0.54663, 0.21814}},
        Way{"WeighsItsLargestChannel",
            3,
            "adc_bailout .5",
            glass(R"(texture{pigment{rgbf<.9,.5,.2,.9>}} interior_texture{pigment{rgbf .9}})"),
            184,
            {5.3629, 2.9763, 1.1794}},
        Way{"LightWithinTheSphereOfItsTarget",
            5,
            "",
            "light_source{<0.3,1.2,-0.4>,1} object{box{<-3,-.1,-3>,<3,.1,3> pigment{rgbt<.8,.9,1,.8>} "
            "interior{ior 1.3} photons{target refraction on reflection on collect off}}}",
            184,
            {88.0137, 88.0137, 88.0137}},
        Way{"FromWithinTheFalloffAlone",  // the radius is 30
            5,
            "",
            "light_source{<0,5,0>,1 spotlight falloff 15 point_at 0} " + kPane,
            132,
            {10.8906, 10.8906, 10.8906}},
        Way{"OfADimLightAsOfABrightOne",
            5,
            "",
            "light_source{<0,5,0>,.01 spotlight radius 0 falloff 25 tightness 190 point_at 0} " + kPane,
            224,
            {0.0163955, 0.0163955, 0.0163955}},
        Way{"LayersCountTwice",
            2,
            "",
            glass(
                R"(texture{pigment{rgbf<.9,.5,.7,.7>}} texture{pigment{rgbf<.9,.9,.7,.7>}}
texture{pigment{rgbf<.8,.9,1,.9>}})"),
            39,
            {0.105, 0.09343, 0.1207}},
        Way{"LayersUnderADarkOneDoNothing",
            2,
            "adc_bailout .3",
            mirror(
                R"(texture{pigment{rgb 0} finish{reflection 1}} texture{pigment{rgbf<1,.2,.2,.6>} finish{reflection
.9}})"),
            309,
            {11.182, 11.182, 11.182}},
        Way{"SharesOfTexturesDoNotWeigh",
            2,
            "adc_bailout .3",
            mirror(
                R"(texture{average texture_map{[1 pigment{rgb 0} finish{reflection rgb<.8,.5,.2>}][3 pigment{rgb 0}
finish{reflection .6}]}})"),
            618,
            {8.077, 7.1373, 6.2098}},
        Way{"TheExponentIsOfWhatArrives",
            2,
            "",
            mirror(R"(pigment{rgb 0} finish{reflection rgb<.8,.5,.2> reflection_exponent 2})", "rgb<.5,.3,.2>"),
            309,
            {7.0353, 3.3948, 1.0939}},
        Way{"MirrorsWeighTwice",
            2,
            "adc_bailout .57",
            mirror(R"(pigment{rgb<.9,.5,.1>} finish{reflection{.8 metallic}})"),
            309,
            {9.0199, 5.2665, 1.5088}}),
    [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace verisim::test
