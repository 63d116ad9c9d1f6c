#include "tracer/scene/transform_steps.h"

#include <gtest/gtest.h>

namespace verisim::scene {
namespace {

TexturePtr bozo_with_bumps() {
  auto pigment = std::make_shared<Pigment>();
  pigment->pattern.kind = PatternKind::bozo;
  auto normal = std::make_shared<Normal>();
  normal->pattern.kind = PatternKind::bumps;
  normal->pattern.prepend(Transform::scaling(Vec3(0.1, 0.2, 0.3)));
  auto texture = std::make_shared<Texture>();
  texture->layers.push_back({pigment, normal, {}});
  return texture;
}

TransformSteps some_steps() {
  TransformSteps steps;
  steps.rotate(Vec3(10, 20, 30));
  steps.translate(Vec3(0.1, -3, 7));
  steps.scale(Vec3(3, 0.7, 1.1));
  return steps;
}

TEST(TransformSteps, TexturesMoveAsStepByStep) {
  const TexturePtr texture = bozo_with_bumps();
  const TransformSteps steps = some_steps();
  TexturePtr expected = texture;
  for (std::size_t i = 0; i < steps.size(); ++i) expected = transformed(expected, steps[i].t);
  const TexturePtr moved = steps.moved(texture);
  const auto front = [](const Pattern& p) { return std::get<Transform>(p.warps.front()); };
  const TextureLayer &a = moved->layers[0], &b = expected->layers[0];
  EXPECT_EQ(front(a.pigment->pattern).m, front(b.pigment->pattern).m);
  EXPECT_EQ(front(a.pigment->pattern).inv, front(b.pigment->pattern).inv);
  EXPECT_EQ(front(a.normal->pattern).m, front(b.normal->pattern).m);
  EXPECT_EQ(front(a.normal->pattern).inv, front(b.normal->pattern).inv);
  EXPECT_EQ(a.normal->pattern.warps.size(), 1u);
  EXPECT_TRUE(texture->layers[0].pigment->pattern.warps.empty()) << "the original stays where it is";
}

TEST(TransformSteps, ObjectsThatShareATextureShareTheMovedOne) {
  const TexturePtr one = bozo_with_bumps(), two = bozo_with_bumps();
  const TransformSteps steps = some_steps();
  const TexturePtr moved = steps.moved(one);
  EXPECT_NE(steps.moved(two), moved);
  EXPECT_EQ(steps.moved(one), moved);
  for (int i = 0; i < 10; ++i) steps.moved(bozo_with_bumps());  // more than are remembered
  EXPECT_NE(steps.moved(one), nullptr);
  EXPECT_EQ(steps.moved(nullptr), nullptr);
}

TEST(Transform, ProductsAreTheSumsOfTheMatricesInOrder) {
  const Transform a = Transform::rotation(Vec3(11, 22, 33)), b = Transform::rotation(Vec3(-47, 5, 0.3));
  const Transform moved = Transform::translation(Vec3(1e-3, 1e3, 7)), ab = a.then(moved).then(b);
  EXPECT_EQ(ab.m.whole(), a.m.whole() * moved.m.whole() * b.m.whole());
  EXPECT_EQ(ab.inv.whole(), b.inv.whole() * (moved.inv.whole() * a.inv.whole()));
}

}  // namespace
}  // namespace verisim::scene
