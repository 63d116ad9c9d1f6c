// What looks alike is compiled once.
#include <gtest/gtest.h>

#include "tracer/textures/evaluation/pigment.h"
#include "tracer/textures/texture.h"

namespace verisim::textures {
namespace {

scene::TexturePtr solid(const Color& color, const scene::Finish& finish = {}, scene::NormalPtr normal = nullptr) {
  auto pigment = std::make_shared<scene::Pigment>();
  pigment->pattern.kind = scene::PatternKind::plain;
  pigment->color = color;
  auto texture = std::make_shared<scene::Texture>();
  texture->layers.push_back({pigment, std::move(normal), finish});
  return texture;
}

TEST(Compiler, EqualSolidTexturesAreOne) {
  Compiler compiler{Settings{}};
  scene::Finish shiny;
  shiny.phong = 0.7f;
  const CompiledTexture* const red = compiler.texture(solid({1, 0, 0}, shiny));
  EXPECT_EQ(compiler.texture(solid({1, 0, 0}, shiny)), red);
  ASSERT_EQ(red->layers.size(), 1u);
  EXPECT_EQ(red->layers[0].finish.phong, 0.7f);
  EXPECT_EQ(red->layers[0].pigment->color, Color(1, 0, 0));
}

TEST(Compiler, WhatDiffersInAnythingIsAnother) {
  Compiler compiler{Settings{}};
  const CompiledTexture* const red = compiler.texture(solid({1, 0, 0}));
  EXPECT_NE(compiler.texture(solid({0.999f, 0, 0})), red);
  EXPECT_NE(compiler.texture(solid({1, 0, 0, 0.1f})), red);
  EXPECT_NE(compiler.texture(solid({1, 0, 0, 0, 0.1f})), red);
  EXPECT_NE(compiler.texture(solid({1, -0.0f, 0})), red) << "bits count";
  for (float scene::Finish::*part : {&scene::Finish::diffuse, &scene::Finish::brilliance, &scene::Finish::crand,
                                     &scene::Finish::metallic, &scene::Finish::irid, &scene::Finish::roughness}) {
    scene::Finish finish;
    finish.*part = 0.123f;
    EXPECT_NE(compiler.texture(solid({1, 0, 0}, finish)), red);
  }
  scene::Finish mirror;
  mirror.reflection.minimum = Rgb(0.1f);
  EXPECT_NE(compiler.texture(solid({1, 0, 0}, mirror)), red);
  auto bumps = std::make_shared<scene::Normal>();
  bumps->pattern.kind = scene::PatternKind::bumps;
  EXPECT_NE(compiler.texture(solid({1, 0, 0}, {}, bumps)), red);
  EXPECT_EQ(compiler.texture(solid({1, 0, 0})), red);
}

TEST(Compiler, LayersAndPatternsStayApart) {
  Compiler compiler{Settings{}};
  auto layered = std::make_shared<scene::Texture>(*solid({1, 0, 0}));
  layered->layers.push_back(solid({0, 1, 0, 0, 1})->layers[0]);
  const CompiledTexture* const two = compiler.texture(layered);
  EXPECT_EQ(two->layers.size(), 2u);
  EXPECT_NE(compiler.texture(solid({1, 0, 0})), two);
  EXPECT_EQ(compiler.texture(solid({1, 0, 0}))->layers[0].pigment, two->layers[1].pigment) << "top first";
}

}  // namespace
}  // namespace verisim::textures
