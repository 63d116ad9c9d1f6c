// The JSON of `check --dump`: stable members that other programs rely on (docs/dump.md).
#include "cli/describe/dump.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "parser/parse.h"

namespace verisim::cli {
namespace {

using Json = SceneDump::Json;

Json dump_of(const std::string& text) {
  const parser::ParseResult result =
      parser::parse_text("#version 3.7;\nglobal_settings { assumed_gamma 1 }\n" + text, "scene.pov", {});
  EXPECT_TRUE(result.scene.has_value());
  return result.scene ? SceneDump().scene(*result.scene) : Json();
}

TEST(SceneDump, NamesItsFormatAndTheSceneAroundTheObjects) {
  const Json dump = dump_of(
      "camera { orthographic location <1,2,3> } background { rgb <.5,0,1> } fog { distance 7 color rgbt <1,1,1,.5> }");
  EXPECT_EQ(dump["format"], "verisim scene");
  EXPECT_EQ(dump["format_version"], 1);
  EXPECT_EQ(dump["version"], 3.7);
  EXPECT_EQ(dump["camera"]["type"], "orthographic");
  EXPECT_EQ(dump["camera"]["location"], Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(dump["background"], Json({0.5, 0.0, 1.0, 0.0, 0.0}));
  EXPECT_EQ(dump["fog"][0]["distance"], 7.0);
  EXPECT_EQ(dump["global_settings"]["max_trace_level"], 5);
  EXPECT_EQ(dump["sky_sphere"], nullptr);
}

TEST(SceneDump, WritesObjectsInTheWordsOfSdl) {
  const Json dump = dump_of(
      "sphere { <1,2,3>, 4 translate x hollow no_shadow }\nbox { 0, 1 rotate 90*z }\nlight_source { <1,2,3> rgb .5 "
      "spotlight radius 20 }");
  const Json& sphere = dump["objects"][0];
  EXPECT_EQ(sphere["type"], "sphere");
  EXPECT_EQ(sphere["place"]["line"], 3);
  EXPECT_EQ(sphere["center"], Json({2.0, 2.0, 3.0}));
  EXPECT_EQ(sphere["radius"], 4.0);
  EXPECT_EQ(sphere["matrix"], nullptr);
  EXPECT_EQ(sphere["flags"], Json({"hollow", "no_shadow"}));
  EXPECT_EQ(dump["objects"][1]["matrix"].size(), 12u);
  EXPECT_EQ(dump["objects"][2]["kind"], "spotlight");
  EXPECT_EQ(dump["objects"][2]["radius"], 20.0);
}

TEST(SceneDump, ListsSharedTexturesOnce) {
  const Json dump = dump_of(
      "#declare T = texture { pigment { rgb x } finish { phong 1 } }\nunion { sphere { 0, 1 } box { 0, 1 } texture { T "
      "} } sphere { 0, 1 texture { T } }");
  EXPECT_EQ(dump["textures"].size(), 1u);
  EXPECT_EQ(dump["objects"][0]["children"][1]["texture"], dump["objects"][1]["texture"]);
  const Json& layer = dump["textures"][0]["layers"][0];
  EXPECT_EQ(layer["pigment"], Json({{"type", "plain"}, {"color", {1.0, 0.0, 0.0, 0.0, 0.0}}}));
  EXPECT_EQ(layer["finish"]["phong"], 1.0);
}

TEST(SceneDump, WritesPatternsWithTheirMapsAndWarps) {
  const Json dump = dump_of(
      "sphere { 0, 1 pigment { crackle metric 1 color_map { [.5 rgb 1] } frequency 2 turbulence .1 warp { repeat x } "
      "scale 2 } normal { bumps .5 } }");
  const Json& pigment = dump["textures"][0]["layers"][0]["pigment"];
  EXPECT_EQ(pigment["type"], "crackle");
  EXPECT_EQ(pigment["parameters"]["metric"], 1.0);
  EXPECT_EQ(pigment["color_map"], Json::array({Json::array({0.5, {1.0, 1.0, 1.0, 0.0, 0.0}})}));
  EXPECT_EQ(pigment["frequency"], 2.0);
  EXPECT_EQ(pigment["warps"].size(), 2u);
  EXPECT_EQ(dump["textures"][0]["layers"][0]["normal"]["type"], "bumps");
}

TEST(SceneDump, NamesTheNumbersOfShapesAndTheParametersOfPatterns) {
  const Json dump = dump_of(
      "torus { 1, .25 pigment { brick mortar .25 } } cone { 0, 1, y, 0 open pigment { mandel 7 exterior 2, 3 } }\n"
      "superellipsoid { <.5, .25> pigment { bozo } } light_source { 0 rgb 1 shadowless }");
  const auto pigment = [&](std::size_t texture) { return dump["textures"][texture]["layers"][0]["pigment"]; };
  const auto parameters = [&](std::size_t texture) { return pigment(texture)["parameters"]; };
  EXPECT_EQ(dump["objects"][0]["radii"], Json({1.0, 0.25}));
  EXPECT_EQ(parameters(0), Json({{"brick_size", {8.0, 3.0, 4.5}}, {"mortar", 0.25}}));
  EXPECT_EQ(dump["objects"][1]["type"], "cone");
  EXPECT_EQ(dump["objects"][1]["radii"], Json({1.0, 0.0}));
  EXPECT_EQ(dump["objects"][1]["open"], true);
  EXPECT_EQ(parameters(1)["iterations"], 7);
  EXPECT_EQ(parameters(1)["exterior"], Json({2, 3.0}));
  EXPECT_EQ(dump["objects"][2]["exponents"], Json({0.5, 0.25}));
  EXPECT_FALSE(pigment(2).contains("parameters"));
  EXPECT_EQ(dump["objects"][3]["kind"], "shadowless");
}

// Every kind of statement passes through without an exception.
TEST(SceneDump, TakesEveryShape) {
  const Json dump = dump_of(
      "blob { threshold .6 sphere { 0,1,1 } } isosurface { function { x } contained_by { sphere { 0,2 } } } "
      "julia_fractal { 0 } lathe { 3,<0,0>,<1,1>,<0,2> }\n"
      "sor { 4,<0,0>,<1,1>,<1,2>,<0,3> } prism { 0,1,4,<0,0>,<1,0>,<1,1>,<0,0> } height_field { function 4,4 { x } } "
      "torus { 1,.2 } superellipsoid { 1 } plane { y,0 }\n"
      "mesh2 { vertex_vectors { 3,<0,0,0>,<1,0,0>,<0,1,0> } face_indices { 1,<0,1,2> } } quadric { 1,0,0,-1 } poly { "
      "2,<1,0,0,0,1,0,0,1,0,-1> } disc { 0,y,1 } cone { 0,1,y,0 }\n"
      "light_group { light_source { 0 rgb 1 } sphere { 0,1 } } polygon { 4,0,x,x+y,y } triangle { 0,x,y } "
      "smooth_triangle { 0,y,x,y,z,y } ovus { 1,.5 } sphere_sweep { linear_spline 2,0,1,x,1 }\n"
      "parametric { function{u} function{v} function{0} <0,0>,<1,1> } difference { sphere { 0,1 } box { 0,1 } "
      "clipped_by { plane { y,0 } } interior { ior 1.5 media { scattering { 1,1 } } } }");
  EXPECT_EQ(dump["objects"].size(), 23u);
  EXPECT_EQ(dump["objects"].back()["clipped_by"].size(), 1u);
  EXPECT_EQ(dump["interiors"][dump["objects"].back()["interior"].get<std::size_t>()]["ior"], 1.5);
}

}  // namespace
}  // namespace verisim::cli
