// The children of a copied object are made when somebody asks for them (tracer/scene/children.h): the copy means the
// same as the object written out.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/describe/dump.h"
#include "parser/parse.h"

namespace verisim::cli {
namespace {

using Json = SceneDump::Json;

void remove_places(Json& json) {
  if (json.is_object()) json.erase("place");
  if (json.is_structured())
    for (Json& member : json) remove_places(member);
}

Json meaning_of(const std::string& text) {
  parser::ParseOptions options;
  std::string messages;
  options.message = [&](const parser::Diagnostic& d) { messages += d.message + "\n"; };
  options.debug = [&](const std::string& line) { messages += line; };
  const parser::ParseResult result =
      parser::parse_text("#version 3.7; global_settings { assumed_gamma 1 }\n" + text, "scene.pov", options);
  if (!result.scene) return messages;
  Json dump = SceneDump().scene(*result.scene);
  remove_places(dump);
  dump["messages"] = messages;
  return dump;
}

const std::vector<std::string> kObjects = {
    "union { sphere { x, 1 } cylinder { 0, 2*y, .3 } box { -1, 1 pigment { rgb x } } }",
    "difference { sphere { 0, 1 } box { 0, 2 texture { pigment { bozo } normal { bumps } } } plane { y, -.5 } "
    "cutaway_textures pigment { rgb y } }",
    "intersection { quadric { 1, 0, 0, -1 } plane { z, 1 } plane { -z, 1 } sphere { 0, 3 inverse } }",
    "merge { union { sphere { 0, 1 no_shadow } torus { 2, .3 no_shadow } } union { box { 0, 1 no_shadow } } }",
    "union { union { sphere { 0, 1 interior { ior 1.5 media { scattering { 1, 1 } density { spherical } } } } sphere { "
    "x, 1 hollow } } light_source { y rgb 1 looks_like { union { "
    "sphere { 0, .1 } box { 0, .1 } } } } }",
    "union { box { 0, 1 clipped_by { union { sphere { 0, 1 } sphere { x, 1 } } } } difference { sphere { 0, 2 } box { "
    "0, 1 } bounded_by { box { -2, 2 } } } }",
    "union { light_group { light_source { 5 rgb 1 } sphere { 0, 1 } global_lights off } box { 0, 1 } }",
    "light_group { light_source { 5 rgb 1 } union { sphere { 0, 1 } box { 0, 1 } } }",
    "union { sphere { 0, 1 texture { pigment { rgb 1 } finish { phong 1 } } } cone { 0, 1, y, 0 uv_mapping pigment { "
    "checker } } blob { threshold .5 sphere { 0, 1, 1 pigment { granite } } } }",
};
const std::vector<std::string> kModifiers = {
    "",
    "rotate 30*y translate <1, 2, 3>",
    "scale <1, 2, 3> rotate <10, 20, 30> translate x scale 2 rotate 5*z translate -y",
    "translate x texture { pigment { marble } finish { ambient 1 } } rotate 45*x",
    "matrix <1, .5, 0, 0, 1, 0, 0, 0, 1, 2, 3, 4> hollow rotate 90*y",
    "inverse translate z",
    "rotate 10*x double_illuminate inverse scale 3",
    "interior { ior 2 media { emission 1 density { onion } } } scale 2",
    "no_shadow clipped_by { sphere { 0, 2 } } translate 5*x",
    "bounded_by { sphere { 0, 5 } } scale .1",
    "photons { target reflection on } radiosity { importance .5 } no_image transform { rotate 20*z inverse }",
};

TEST(Copies, MeanWhatTheyAreCopiesOf) {
  for (const std::string& object : kObjects)
    for (const std::string& modifiers : kModifiers) {
      if (object.starts_with("light_group") && modifiers.find_first_of("{") != std::string::npos) continue;
      const std::string kind = object.starts_with("light_group") ? "light_group" : "object";
      const Json written = meaning_of(kind + " { " + object + modifiers + " }"),
                 copied = meaning_of("#declare D = " + object + " " + kind + " { D " + modifiers + " }");
      if (kind == "object") {
        EXPECT_EQ(written, copied) << object << "\n" << modifiers;
      }
      EXPECT_EQ(copied, meaning_of("#declare D = " + object + " #declare E = " + kind + " { D } " + kind + " { E " +
                                   modifiers + " }"))
          << object << "\n"
          << modifiers;
    }
}

// In the middle of a chain of copies, in other objects, and asked for before the end.
TEST(Copies, OfCopies) {
  const std::string object = "union { sphere { x, 1 pigment { rgb x } } cylinder { 0, 2*y, .3 } }",
                    declare = "#declare D = " + object + " ";
  const std::string first = object.substr(0, object.size() - 1) + " rotate 30*y scale <1, 2, 1> }",
                    second = "object { " + first + " translate z }";
  const std::string e = "#declare E = object { D rotate 30*y scale <1, 2, 1> } ";
  EXPECT_EQ(meaning_of(second), meaning_of(declare + e + "object { E translate z }"));
  EXPECT_EQ(meaning_of(second), meaning_of(declare + e + "#undef D object { E translate z }"));
  EXPECT_EQ(
      meaning_of("difference { box { -5, 5 } " + second + " rotate x pigment { agate } }"),
      meaning_of(declare + e + "difference { box { -5, 5 } object { E translate z } rotate x pigment { agate } }"));
  EXPECT_EQ(meaning_of("sphere { 0, 9 clipped_by { " + object + " scale 2 } }"),
            meaning_of("#declare D = " + object + " sphere { 0, 9 clipped_by { object { D } scale 2 } }"));
  const std::string asks =
      "#debug vstr(3, max_extent(D), \",\", 0, 9) #debug vstr(3, trace(D, <0, .2, -9>, z), \",\", 0, 9) #debug "
      "str(inside(D, y), 0, 0) ";
  EXPECT_EQ(meaning_of("#declare D = " + second + asks + "object { D }"),
            meaning_of(declare + e + "#declare D = object { E translate z } " + asks + "object { D }"));
  EXPECT_EQ(meaning_of("#declare L = " + first + " plane { y, 0 pigment { object { L rgb 0, rgb 1 } } }"),
            meaning_of(declare + "#declare L = object { D rotate 30*y scale <1, 2, 1> } plane { y, 0 pigment { object "
                                 "{ L rgb 0, rgb 1 } } }"));
}

TEST(Copies, TakeTheDefaultTextureOfTheirStatement) {
  const std::string object = "union { sphere { x, 1 pigment { rgb x } } box { 0, 1 } }",
                    later = "#default { pigment { rgb z } } ";
  EXPECT_EQ(meaning_of("#default { pigment { rgb y } } " + object + later),
            meaning_of("#declare D = " + object + " #default { pigment { rgb y } } object { D } " + later));
}

}  // namespace
}  // namespace verisim::cli
