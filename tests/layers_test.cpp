// What --layers says of a scene whose depths, normals, colours and numbers are known.
#include "tracer/render/layers.h"

#include <gtest/gtest.h>

#include "parser/parse.h"

namespace verisim {
namespace {

constexpr int kSize = 9;  // odd: the middle pixel's ray is the axis

render::Layers layers_of(const std::string& objects, bool antialias = false, int threads = 1) {
  const std::string text =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,0,-5> direction z right x up y "
      "}\nlight_source { <3,4,-9> rgb 1 }\n" +
      objects;
  const parser::ParseResult parsed = parser::parse_text(text, "layers.pov", {});
  render::Layers layers;
  layers.depth = layers.normal = layers.albedo = layers.id = true;
  if (!parsed.scene) {
    ADD_FAILURE() << (parsed.errors.empty() ? "" : parsed.errors[0].message);
    render::resize_layers(layers, kSize, kSize);
    return layers;
  }
  render::Options options;
  options.width = options.height = kSize;
  options.threads = threads;
  options.antialias = antialias;
  options.layers = &layers;
  render::Framebuffer picture;
  render::render(*parsed.scene, options, picture);
  return layers;
}
constexpr std::size_t kMiddle = (kSize / 2) * kSize + kSize / 2, kCorner = 0;

TEST(Layers, TellDepthNormalColourAndNumber) {
  const render::Layers layers =
      layers_of("plane { y, -9 pigment { rgb 1 } } sphere { 0, 1 pigment { rgb <.8,.4,.2> } }");
  EXPECT_FLOAT_EQ(layers.depths[kMiddle], 4);
  EXPECT_NEAR(layers.normals[kMiddle].z, -1, 1e-9);
  EXPECT_FLOAT_EQ(layers.albedos[kMiddle].g, 0.4f);
  EXPECT_EQ(layers.ids[kMiddle], 2u);
  EXPECT_EQ(layers.depths[kCorner], render::kFarDepth);
  EXPECT_EQ(layers.ids[kCorner], 0u);
  EXPECT_EQ(layers.normals[kCorner], Vec3(0, 0, 0));
}

TEST(Layers, ColoursOfSeeThroughLayersAndMapsAreMixedAsTheyAreSeen) {
  const render::Layers layered =
      layers_of("sphere { 0, 1 texture { pigment { rgb <1,0,0> } } texture { pigment { rgbt <0,0,1,.75> } } }");
  EXPECT_NEAR(layered.albedos[kMiddle].b, 0.25, 1e-6);
  EXPECT_NEAR(layered.albedos[kMiddle].r, 0.75, 1e-6);
  const render::Layers mixed = layers_of(
      "sphere { 0, 1 texture { gradient x texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } translate .25*x "
      "} }");
  EXPECT_NEAR(mixed.albedos[kMiddle].r, 0.25, 1e-6);
}

TEST(Layers, NormalsArePerturbedAndTurnedTowardsTheViewer) {
  const std::string bumps = "normal { gradient x 1 slope_map { [0 <0,1>] [1 <1,1>] } }";
  const render::Layers bumped = layers_of("plane { -z, 0 pigment { rgb 1 } " + bumps + " }"),
                       inside = layers_of("sphere { 0, 20 pigment { rgb 1 } }");
  EXPECT_GT(std::fabs(bumped.normals[kMiddle].x), 0.1);
  EXPECT_NEAR(length(bumped.normals[kMiddle]), 1, 1e-9);
  EXPECT_NEAR(inside.normals[kMiddle].z, -1, 1e-9);
}

TEST(Layers, AntialiasingAveragesColoursButNeverDepthsOrNumbers) {
  const std::string half = "box { <-9,0.02,0>, <9,9,1> pigment { rgb 1 } }";
  const render::Layers layers = layers_of(half, true);
  EXPECT_GT(layers.albedos[kMiddle].r, 0.2f);
  EXPECT_LT(layers.albedos[kMiddle].r, 0.8f);
  for (const float depth : layers.depths) EXPECT_TRUE(depth == render::kFarDepth || depth < 10);
  for (const std::uint32_t id : layers.ids) EXPECT_LE(id, 1u);
}

TEST(Layers, ThreadsDoNotChangeThem) {
  const std::string scene =
      "sphere { <.3,0,0>, 1 pigment { bozo scale .1 } normal { bumps } } plane { y, -1 pigment { checker rgb 1, rgb 0 "
      "} }";
  const render::Layers one = layers_of(scene, true, 1), many = layers_of(scene, true, 3);
  EXPECT_EQ(one.depths, many.depths);
  EXPECT_EQ(one.ids, many.ids);
  for (std::size_t i = 0; i < one.normals.size(); ++i) EXPECT_EQ(one.normals[i], many.normals[i]);
}

}  // namespace
}  // namespace verisim
