// Kernels of every instruction set give what the formulas of single rays give.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "tracer/math/scaled.h"
#include "tracer/effects/scene_effects.h"
#include "tracer/render/sampling/pixel_sampler.h"
#include "tracer/shading/finish.h"
#include "tracer/lights/light_falloff.h"
#include "tracer/shading/direct/shadow_batch.h"
#include "tracer/shading/wavefront/wavefront.h"
#include "tracer/shapes/test_support.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::shading {
namespace {

class WavefrontKernel : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    kernels = wavefront_kernels(GetParam());
    if (!kernels) GTEST_SKIP() << "this machine cannot run it";
  }
  Vec3 unit() {
    std::normal_distribution<double> d;
    return normalize(Vec3(d(random), d(random), d(random)));
  }
  const WavefrontKernels* kernels = nullptr;
  std::mt19937 random{1};
  std::unique_ptr<WavefrontPacket> packet = std::make_unique<WavefrontPacket>();
};

TEST_P(WavefrontKernel, DirectionsAreThoseOfTheCamera) {
  scene::Camera camera;
  camera.direction = {0.1, 0.2, 1.3}, camera.right = {1.33, 0, 0.1}, camera.up = {0, 1, 0.01};
  const render::CameraRays rays(camera, 641, 479);
  Vec2 places[32];
  for (int i = 0; i < 32; ++i) places[i] = Vec2(613 + i - 0.37 * (i % 3), 17 + 0.25 * i);
  kernels->directions({641, 479, camera.direction, camera.right, camera.up}, places, 28, *packet);
  for (int i = 0; i < 28; ++i) {
    const Vec3 d = rays.at(places[i].x, places[i].y)->ray.direction;
    EXPECT_EQ(packet->rays.direction.at(i), d * (1 / length(d))) << i;
  }
}

TEST_P(WavefrontKernel, LightsAndHighlightsAreThoseOfTheFormulas) {
  std::uniform_real_distribution<double> number(0, 1);
  int uncertain = 0, checked = 0;
  for (int round = 0; round < 2000; ++round) {
    scene::Finish finish[WavefrontPacket::kMax];
    for (int i = 0; i < WavefrontPacket::kMax; ++i) {
      scene::Finish& f = finish[i];
      const bool phong = i % 3 == 0;
      (phong ? f.phong : f.specular) = static_cast<float>(number(random));
      f.phong_size = static_cast<float>(std::exp(7 * number(random)));
      f.roughness = i % 7 == 0 ? 0 : static_cast<float>(std::exp(-9 * number(random)));
      const Vec3 n = unit();
      Vec3 view = unit();
      if (dot(n, view) > 0) view = -view;
      packet->normal.set(i, n), packet->view.set(i, view), packet->to_light.origin.set(i, unit());
      packet->diffuse[i] = 0.7f, packet->shines[i] = 1, packet->phong[i] = phong;
      for (float* channel : {packet->intensity.r, packet->intensity.g, packet->intensity.b})
        channel[i] = static_cast<float>(number(random));
      const Highlight highlight = phong ? phong_highlight(f) : blinn_highlight(f);
      packet->amount[i] = highlight.amount, packet->exponent[i] = highlight.exponent;
      packet->dark_to[i] = highlight.dark_to;
    }
    const Vec3 position = unit() * 10;
    light_falloff_kernels(GetParam())->aim(position, WavefrontPacket::kMax, packet->to_light, packet->distance);
    kernels->face(WavefrontPacket::kMax, *packet);
    kernels->evaluate_lobes(true, true, WavefrontPacket::kMax, *packet);
    for (int i = 0; i < WavefrontPacket::kMax; ++i) {
      const Vec3 n = packet->normal.at(i), view = packet->view.at(i), to = position - packet->to_light.origin.at(i),
                 l = to * (1 / length(to));
      ASSERT_EQ(packet->to_light.direction.at(i), l);
      ASSERT_EQ(packet->distance[i], length(to));
      ASSERT_EQ(packet->cosine[i], dot(n, l));
      ASSERT_EQ(packet->scattered[i], 0.7f * std::fabs(dot(n, l)));
      const double strength = highlight_strength(finish[i], n, view, l);  // each has one
      uncertain += packet->uncertain[i] != 0;
      if (packet->uncertain[i]) continue;
      ++checked;
      for (const float light : {packet->intensity.r[i], packet->intensity.g[i], packet->intensity.b[i]})
        ASSERT_EQ(static_cast<float>(packet->strength[i] * light), static_cast<float>(strength * light))
            << "exponent " << packet->exponent[i];
    }
  }
  EXPECT_LT(uncertain, checked / 200);  // three channels
}

TEST_P(WavefrontKernel, WhatArrivesIsAskedForWhereItCounts) {
  std::uniform_real_distribution<double> number(-1, 1);
  int asked_for = 0, lit = 0;
  for (int round = 0; round < 500; ++round) {
    const Rgb light(static_cast<float>(std::fabs(number(random))), 0.5f,
                    round % 5 == 0 ? 0 : static_cast<float>(number(random)));
    const bool highlights = round % 2 == 0;
    for (int i = 0; i < WavefrontPacket::kMax; ++i) {
      packet->cosine[i] = i % 5 == 0 ? 0 : number(random);
      packet->front[i] = number(random), packet->behind[i] = number(random);
      packet->two_sided[i] = i % 3 == 0, packet->lit_behind[i] = i % 4 == 0, packet->dull[i] = i % 11 == 0;
      packet->attenuation[i] = i % 7 == 0 ? 1e-12 : std::fabs(number(random));
    }
    const int count = 1 + round % WavefrontPacket::kMax;
    bool any = false;
    const bool received = kernels->receive(light, highlights, count, *packet);
    for (int i = 0; i < count; ++i) {
      const bool back = packet->cosine[i] < kEpsilon && packet->two_sided[i] == 0;
      const Rgb color = scaled(light, packet->attenuation[i]);
      const bool expected = !(back && packet->lit_behind[i] == 0) && packet->dull[i] == 0 &&
                            !(color.max_abs() < static_cast<float>(kEpsilon));
      ASSERT_EQ(packet->active[i], expected) << i;
      any |= expected;
      asked_for += expected;
      ASSERT_EQ(packet->diffuse[i], back ? packet->behind[i] : packet->front[i]);
      ASSERT_EQ(packet->shines[i], highlights && !back);
      ASSERT_EQ(Rgb(packet->intensity.r[i], packet->intensity.g[i], packet->intensity.b[i]), color);
      if (i % 6 == 1) packet->intensity.r[i] = packet->intensity.g[i] = packet->intensity.b[i] = 0;  // in a shadow
    }
    ASSERT_EQ(received, any);
    any = false;
    const bool illuminated = kernels->illuminate(count, *packet);
    for (int i = 0; i < count; ++i) {
      const bool expected = packet->active[i] != 0 && i % 6 != 1;
      ASSERT_EQ(packet->lit[i], expected ? 1.0f : 0.0f);
      any |= expected;
      lit += expected;
    }
    ASSERT_EQ(illuminated, any);
  }
  EXPECT_GT(asked_for, lit);
  EXPECT_GT(lit, 1000);
}

TEST_P(WavefrontKernel, NumbersThatAreNoneAreLeftToTheFormulas) {
  for (int i = 0; i < WavefrontPacket::kMax; ++i) {
    packet->normal.set(i, Vec3(0, 1, 0)), packet->view.set(i, Vec3(0, -1, 0)),
        packet->to_light.direction.set(i, Vec3(std::nan("")));
    packet->amount[i] = packet->shines[i] = packet->exponent[i] = 1;
  }
  EXPECT_TRUE(kernels->evaluate_lobes(false, true, WavefrontPacket::kMax, *packet));
  EXPECT_NE(packet->uncertain[0], 0);
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, WavefrontKernel, testing::Range(0, static_cast<int>(simd::kInstructionSets)));

}  // namespace
}  // namespace verisim::shading
