// uv_mapping asked for where there is no surface (spec 05 11.3): whoever asks first ends the render, be it the picture,
// a photon or a sample of radiosity. Each form as POV-Ray has it.
#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

struct Question {
  std::string name, text;
  bool ends_in_error;
};
void PrintTo(const Question& q, std::ostream* out) { *out << q.name; }
class MissingSurface : public testing::TestWithParam<Question> {};

TEST_P(MissingSurface, EndsTheRenderThatAsks) {
  const std::string text =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0, 1, -4> look_at 0 } "
      "light_source { <3, 8, -4> 1 } " +
      GetParam().text;
  if (GetParam().ends_in_error)
    EXPECT_THROW(render_text(text, 32, 24), std::runtime_error);
  else
    EXPECT_NO_THROW(render_text(text, 32, 24));
}

const std::string kChecks = "uv_mapping checker rgb x rgb y";
const std::string kMapped = "#declare N = normal { wood normal_map { [0 bumps] [1 dents] } } ";
const std::string kFunction = "#declare F = function { pigment { " + kChecks + " } } ";
const std::string kSky = "sky_sphere { pigment { " + kChecks + " } } ";
const std::string kFog = "media { absorption 1 density { uv_mapping gradient x } }";

INSTANTIATE_TEST_SUITE_P(
    Forms, MissingSurface,
    testing::Values(
        Question{"sky", kSky, true}, Question{"sky_of_one_color", "sky_sphere { pigment { uv_mapping rgb x } }", true},
        Question{"average", "sky_sphere { pigment { average pigment_map { [1 " + kChecks + "] [1 rgb z] } } }", true},
        Question{"map", "sky_sphere { pigment { gradient y pigment_map { [0 " + kChecks + "] [1 rgb z] } } }", true},
        Question{"sky_in_a_mirror",
                 kSky + "plane { z, 8 no_reflection pigment { rgb 1 } } sphere { 0, 1 finish { reflection 1 } }", true},
        Question{"media", "box { -1, 1 pigment { rgbt 1 } hollow interior { " + kFog + " } }", true},
        Question{"pigment_of_a_function", kFunction + "sphere { 0, 1 pigment { function { F(x, y, z).red } } }", true},
        Question{"normal_of_a_function",
                 kFunction + "sphere { 0, 1 pigment { rgb 1 } normal { function { F(x, y, z).red } 1 } }", true},
        Question{"isosurface",
                 kFunction + "isosurface { function { x*x + y*y + z*z - F(x, y, z).red } max_gradient 5 "
                             "contained_by { box { -1.5, 1.5 } } pigment { rgb 1 } }",
                 true},
        Question{"radiosity_alone",
                 "global_settings { radiosity { count 10 } } " + kSky +
                     "plane { z, 8 pigment { rgb 1 } } sphere { 0, 1 pigment { rgb 1 } }",
                 true},
        Question{"photons_alone",
                 "global_settings { photons { spacing 0.2 } } camera { location <0, 1, -4> look_at 100*y } "
                 "box { -1, 1 pigment { rgbt 1 } hollow interior { ior 1.4 " +
                     kFog + " } photons { target refraction on } } plane { y, -1 pigment { rgb 1 } }",
                 true},
        // Not without a surface, but without a type that its map belongs to.
        Question{"facets_with_a_map", kMapped + "sphere { 0, 1 pigment { rgb 1 } normal { N facets } }", true},
        Question{"facets_in_a_map",
                 kMapped + "sphere { 0, 1 pigment { rgb 1 } normal { checker normal { N facets } normal { bumps } } }",
                 true},
        Question{"facets_behind_the_camera", kMapped + "sphere { -9*z, 1 pigment { rgb 1 } normal { N facets } }",
                 false},
        Question{"hidden_sky", kSky + "plane { z, 5 pigment { rgb 1 } }", false},
        Question{"entry_of_a_map_that_nothing_reaches",
                 "sky_sphere { pigment { gradient y pigment_map { [0 rgb x] [1 rgb z] [1 " + kChecks + "] } } }",
                 false},
        Question{"pattern_on_a_surface",
                 "sphere { 0, 1 pigment { pigment_pattern { " + kChecks + " } color_map { [0 rgb x] [1 rgb y] } } }",
                 false},
        Question{"light_through",
                 "light_source { 5*y 1 projected_through { sphere { 0, 1 pigment { " + kChecks +
                     " } } } } sphere { 0, 1 pigment { rgb 1 } }",
                 false}),
    [](const testing::TestParamInfo<Question>& q) { return q.param.name; });

}  // namespace
}  // namespace verisim::test
