// The media probes of spec 07 section 11: scene fragments with the values POV-Ray 3.7.0.10 gave (+WT1, 16 bits,
// linear).
#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

constexpr const char* kHead =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { orthographic location <0.003,0.002,-5> right x*0.001 up y*0.001 direction z }\n";

struct MediaProbe {
  std::string name, body;
  std::vector<double> expected;  // 0..1; one value stands for three equal ones
};

void PrintTo(const MediaProbe& p, std::ostream* out) { *out << p.name; }

std::string box(const std::string& media) {
  return "box { <-1,-1,-1>,<1,1,1> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { media { " +
         media + " } } }\n";
}

const std::string kLight = "light_source { <0,0,-100> rgb 1 }\n";
const std::string kRamp = " density { gradient z color_map { [0 rgb 0][1 rgb 1] } scale 2 translate -z } ";
const std::string kRamp2 = " density { gradient z color_map { [0 rgb 0][1 rgb 1] } poly_wave 2 scale 2 translate -z } ";
const std::string kRamp3 = " density { gradient z color_map { [0 rgb 0][1 rgb 1] } poly_wave 3 scale 2 translate -z } ";
const std::string kClear = " pigment { rgbt 1 } finish { ambient 0 diffuse 0 } ";
const std::string kWall = "plane { -z,-3 pigment { rgb 0 } finish { ambient 0 } }\n";

std::string light_at(const std::string& place) { return "light_source { " + place + " rgb 1 }\n"; }

std::vector<MediaProbe> constant_media() {
  const std::string ea = "emission 0.1 absorption 0.5 ";
  return {
      {"emission", box("emission 0.1"), {0.200000}},
      {"emission_absorption", box(ea), {0.137255}},
      {"samples_2", box(ea + "samples 2"), {0.160647}},
      {"samples_1", box(ea + "samples 1"), {0.160647}},
      {"samples_30", box(ea + "samples 30"), {0.130419}},
      {"method_2_samples_1", box(ea + "method 2 samples 1"), {0.121309}},
      {"method_2_samples_4", box(ea + "method 2 samples 4"), {0.126101}},
      {"method_2_intervals_4", box(ea + "method 2 intervals 4 samples 1"), {0.121309}},
      {"method_2_intervals_4_lit", box(ea + "method 2 intervals 4 samples 1") + kLight, {0.126101}},
      {"intervals_4", box(ea + "intervals 4"), {0.137255}},
      {"intervals_4_lit", box(ea + "intervals 4") + kLight, {0.129076}},
      {"ramp", box("emission 0.5" + kRamp), {0.428565}},
      {"ramp_aa_level_1", box("emission 0.5 aa_level 1" + kRamp), {0.428565}},
      {"ramp_samples_2", box("emission 0.5 samples 2" + kRamp), {0.333333}},
      {"ramp_method_2", box("emission 0.5 method 2 samples 4" + kRamp), {0.500008}},
      {"poly", box("emission 0.4 absorption 0.3" + kRamp3), {0.122621}},
      {"poly_samples_2", box("emission 0.4 absorption 0.3 samples 2" + kRamp3), {0.060700}},
      {"poly_fine", box("emission 0.4 absorption 0.3 samples 2 aa_level 6 aa_threshold 0.01" + kRamp3), {0.059220}},
      {"poly_colours",
       box("emission <0.4,0.1,0.2> absorption 0.3 samples 5 aa_level 2 aa_threshold 0.02 intervals 2" + kRamp3),
       {0.140551, 0.035142, 0.070283}},
  };
}

std::vector<MediaProbe> scattering_media() {
  std::vector<MediaProbe> probes;
  const auto phase = [&](const std::string& name, const std::string& scattering, const std::string& light,
                         double value) {
    probes.push_back(
        {name,
         box("scattering { " + scattering + " extinction 0 } method 2 intervals 1 samples 1") + light_at(light),
         {value}});
  };
  const std::string behind = "<0.003,0.002,-3>", side = "<3,0.002,0>";
  phase("isotropic_behind", "1, 0.1", behind, 0.200000), phase("isotropic_side", "1, 0.1", side, 0.200000);
  phase("hazy_behind", "2, 0.1", behind, 0.115328), phase("hazy_side", "2, 0.1", side, 0.119387);
  phase("murky_behind", "3, 0.02", behind, 0.019821), phase("murky_side", "3, 0.02", side, 0.019821);
  phase("rayleigh_behind", "4, 0.1", behind, 0.319753), phase("rayleigh_side", "4, 0.1", side, 0.159869);
  phase("henyey_behind", "5, 0.1 eccentricity 0.5", behind, 0.044450),
      phase("henyey_side", "5, 0.1 eccentricity 0.5", side, 0.107332);
  phase("henyey_back", "5, 0.1 eccentricity -0.5", "<0.003,0.002,3>", 0.044450);
  probes.push_back({"mixture",
                    "box { <-1,-1,-1>,<1,1,1> hollow" + kClear +
                        "interior { media { scattering { 4, 0.1 extinction 0 } method 2 intervals 1 samples 1 } media "
                        "{ emission 0.05 method 2 intervals 1 "
                        "samples 1 } } }" +
                        light_at(side),
                    {0.279942}});
  const std::string one = "scattering { 1, 0.1 } method 2 intervals 1 samples 1";
  probes.push_back({"attenuated_light", box(one) + light_at(side), {0.163790}});
  probes.push_back({"no_interaction", box(one) + "light_source { <3,0.002,0> rgb 1 media_interaction off }", {0}});
  probes.push_back({"shadowless", box(one) + "light_source { <3,0.002,0> rgb 1 shadowless }", {0}});
  probes.push_back({"half_extinction",
                    box("scattering { 1, 0.1 extinction 0.5 } method 2 intervals 1 samples 1") + light_at(side),
                    {0.180987}});
  probes.push_back({"light_inside", box(one) + light_at("<0.5,0.002,0>"), {0.180972}});
  probes.push_back(
      {"container_no_shadow",
       "box { <-1,-1,-1>,<1,1,1> hollow no_shadow" + kClear + "interior { media { " + one + " } } }" + light_at(side),
       {0.180972}});
  probes.push_back({"filtering_container",
                    "box { <-1,-1,-1>,<1,1,1> hollow pigment { rgbf <1,0.5,0.25,0.8> } finish { ambient 0 diffuse 0 } "
                    "interior { media { " +
                        one + " } } }" + light_at(side),
                    {0.104829, 0.026200, 0.006546}});
  return probes;
}

std::vector<MediaProbe> containers() {
  const auto clear_box = [&](const std::string& corners, const std::string& media, bool hollow) {
    return "box { " + corners + (hollow ? " hollow" : "") + kClear +
           (media.empty() ? "" : "interior { media { " + media + " } } ") + "}\n";
  };
  const std::string outer = "<-1,-1,-1>,<1,1,1>", inner = "<-.5,-.5,-.5>,<.5,.5,.5>";
  return {
      {"nested",
       clear_box(outer, "emission 0.1", true) + clear_box(inner, "emission <0,0.2,0>", true),
       {0.2, 0.4, 0.2}},
      {"inner_not_hollow",
       clear_box(outer, "emission 0.1", true) + clear_box(inner, "emission <0,0.2,0>", false),
       {0.100008}},
      {"outer_not_hollow", clear_box(outer, "emission 0.1", false) + clear_box(inner, "emission <0,0.2,0>", true), {0}},
      {"camera_inside", clear_box("<-9,-9,-9>,<9,9,9>", "emission 0.01", true), {0.140002}},
      {"camera_inside_not_hollow", clear_box("<-9,-9,-9>,<9,9,9>", "emission 0.01", false), {0}},
      {"atmosphere", "media { emission 0.01 }" + kWall, {0.080003}},
      {"atmosphere_in_box", "media { emission 0.01 }" + kWall + clear_box("-9,2", "", false), {0.009995}},
      {"atmosphere_between", "media { emission 0.01 }" + kWall + clear_box(outer, "", false), {0.059998}},
      {"atmosphere_hollow", "media { emission 0.01 }" + kWall + clear_box(outer, "", true), {0.080003}},
      {"two_atmospheres", "media { emission 0.01 } media { emission 0.02 }" + kWall, {0.239994}},
      {"atmosphere_to_infinity", "media { emission 1e-11 }", {0.200000}},
      {"absorbed_background", "media { absorption 0.1 } background { rgb 1 }", {0}},
  };
}

std::vector<MediaProbe> shadows() {
  const std::string white = "plane { -z,-3 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n";
  const auto lit = [&](const std::string& switches) {
    return "light_source { <0.003,0.002,-3> rgb 1 " + switches + " }\n";
  };
  return {
      {"atmosphere_off", "media { absorption 0.1 }" + white + lit("media_attenuation off"), {0.449332}},
      {"atmosphere_on", "media { absorption 0.1 }" + white + lit("media_attenuation on"), {0.246601}},
      {"atmosphere_no_interaction",
       "media { absorption 0.1 }" + white + lit("media_attenuation on media_interaction off"),
       {0.449332}},
      {"fog_on", "fog { distance 20 rgb 0.5 }" + white + lit("media_attenuation on"), {0.661433}},
      {"fog_off", "fog { distance 20 rgb 0.5 }" + white + lit("media_attenuation off"), {0.835157}},
      {"fog_over_media",
       "media { absorption 0.1 } fog { distance 20 rgb <0,0,1> } plane { -z,-3 pigment { rgb 1 } finish { ambient 1 "
       "diffuse 0 } }",
       {0.301198, 0.301198, 0.630869}},
  };
}

std::vector<MediaProbe> spotlights() {
  const std::string spot =
      "light_source { <0.003,3.002,0.1> rgb 1 spotlight point_at <0.003,0,0.1> radius 10 falloff 10 tightness 0 }\n";
  const std::string spot2 =
      "light_source { <0.003,3.002,0.8> rgb 1 spotlight point_at <0.003,0,0.8> radius 3 falloff 3 tightness 0 }\n";
  const std::string m = "scattering { 1, 1 extinction 0 } ", two = "method 2 samples 1 ";
  return {
      {"intervals_10", box(m + two + "intervals 10" + kRamp2) + spot, {0.344320}},
      {"intervals_4", box(m + two + "intervals 4" + kRamp2) + spot, {0.338537}},
      {"intervals_1", box(m + two + "intervals 1" + kRamp2) + spot, {0.320027}},
      {"ratio", box(m + two + "intervals 10 ratio 0.5" + kRamp2) + spot, {0.343160}},
      {"two_spotlights", box(m + two + "intervals 10" + kRamp2) + spot + spot2, {0.598901}},
      // Soft edges (measured, 34093/65535): at a hard edge the first sample of a piece is lit or not by the last bit.
      {"method_3",
       box(m + kRamp2) + "light_source { <0.003,3.002,0.1> rgb 1 spotlight point_at <0.003,0,0.1> radius 10 falloff "
                         "10.5 tightness 0 }\n"
                         "light_source { <0.003,3.002,0.8> rgb 1 spotlight point_at <0.003,0,0.8> radius 3 falloff 3.2 "
                         "tightness 0 }\n",
       {0.520226}},
  };
}

class MediaProbes : public testing::TestWithParam<MediaProbe> {};

TEST_P(MediaProbes, EqualPovRay) {
  const MediaProbe& probe = GetParam();
  const auto pixel = lin16(render_text(kHead + probe.body, 1, 1), 0, 0);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(pixel[c], 65535.0 * probe.expected[probe.expected.size() == 1 ? 0 : c], 2.0) << "channel " << c;
  }
}

const auto kName = [](const testing::TestParamInfo<MediaProbe>& parameter) { return parameter.param.name; };
INSTANTIATE_TEST_SUITE_P(Constant, MediaProbes, testing::ValuesIn(constant_media()), kName);
INSTANTIATE_TEST_SUITE_P(Scattering, MediaProbes, testing::ValuesIn(scattering_media()), kName);
INSTANTIATE_TEST_SUITE_P(Containers, MediaProbes, testing::ValuesIn(containers()), kName);
INSTANTIATE_TEST_SUITE_P(Shadows, MediaProbes, testing::ValuesIn(shadows()), kName);
INSTANTIATE_TEST_SUITE_P(Spotlights, MediaProbes, testing::ValuesIn(spotlights()), kName);

// Extra samples and method 1 draw random numbers: exact only where the draws are POV-Ray's.
std::vector<MediaProbe> random_media() {
  const std::string ea = "emission 0.1 absorption 0.5 method 1 ";
  return {
      {"method_1_samples_1", box(ea + "intervals 1 samples 1"), {0.174655}},
      {"method_1_samples_4", box(ea + "intervals 1 samples 4"), {0.129610}},
      {"method_1_intervals_4", box(ea + "intervals 4 samples 1") + kLight, {0.126879}},
      {"ramp_method_1", box("emission 0.5 method 1 intervals 1 samples 1" + kRamp), {0.135470}},
      {"ramp_method_2_jitter", box("emission 0.5 method 2 samples 1 jitter 1" + kRamp), {0.635477}},
      {"ramp_method_3_jitter", box("emission 0.5 method 3 samples 2 aa_level 1 jitter 1" + kRamp), {0.548775}},
      {"extra_1_20", box("emission 0.4 method 1 intervals 1 samples 1,20" + kRamp), {0.108385}},
      {"extra_2_20", box("emission 0.4 method 1 intervals 1 samples 2,20" + kRamp), {0.383169}},
      {"extra_3_20", box("emission 0.4 method 1 intervals 1 samples 3,20 variance 0.001" + kRamp), {0.474983}},
      {"extra_method_2", box("emission 0.4 method 2 samples 3,9 variance 0.001 confidence 0.95" + kRamp), {0.381460}},
  };
}

class MediaReplayProbes : public testing::TestWithParam<MediaProbe> {};

TEST_P(MediaReplayProbes, EqualPovRay) {
  const MediaProbe& probe = GetParam();
  render::Options options;
  options.replay = true;
  const auto pixel = lin16(render_text(kHead + probe.body, 1, 1, options), 0, 0);
  EXPECT_NEAR(pixel[0], 65535.0 * probe.expected[0], 2.0);
}

INSTANTIATE_TEST_SUITE_P(Random, MediaReplayProbes, testing::ValuesIn(random_media()), kName);

// Six intervals of a segment that grows from pixel to pixel: now and then the rounding of the last start adds one, and
// all later pixels draw other numbers.
TEST(MediaReplay, DividesSegmentsAsPovRayDoes) {
  constexpr int kWidth = 20;
  const std::vector<double> expected = {22810, 21889, 24011, 23443, 22519, 23775, 23247, 23673, 23670, 23027,
                                        22894, 24322, 23774, 23613, 23906, 25472, 24556, 24446, 25597, 25084};
  render::Options options;
  options.replay = true;
  const auto picture = render_text(
      "#version 3.7; global_settings { assumed_gamma 1 } camera { orthographic location <-0.25,0.002,-5> right x*0.5 "
      "up y*0.005 direction z }"
      "intersection { plane { -z,1 } plane { <-0.3,0,1>,0.9 } box { -3,3 } hollow pigment { rgbt 1 } finish { ambient "
      "0 diffuse 0 } interior { media {"
      "emission 0.4 method 1 intervals 6 samples 1 density { gradient z color_map { [0 rgb 0][1 rgb 1] } scale 4 "
      "translate -2*z } } } }",
      kWidth, 1, options);
  for (int x = 0; x < kWidth; ++x)
    EXPECT_NEAR(lin16(picture, x, 0)[0], expected[static_cast<std::size_t>(x)], 2.0) << x;
}

}  // namespace
}  // namespace verisim::test
