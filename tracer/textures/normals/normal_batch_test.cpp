// Normals of rows against those of single points, bit by bit.
#include <gtest/gtest.h>

#include <random>

#include "tracer/textures/normals/normal.h"
#include "tracer/textures/normals/normal_kernels.h"

namespace verisim::textures {
namespace normal_batch_test {

using enum scene::PatternKind;

std::vector<scene::NormalPtr> descriptions() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.2, 2);
  std::vector<scene::NormalPtr> all;
  for (const scene::PatternKind kind :
       {bumps, dents, wrinkles, granite, bozo, crackle, leopard, ripples, waves, quilted, slope}) {
    for (int variant = 0; variant < 8; ++variant) {
      scene::Normal d;
      d.pattern.kind = kind;
      if (kind == crackle) d.pattern.params = scene::CrackleParams{};
      if (kind == quilted) d.pattern.params = scene::QuiltedParams{};
      if (kind == slope) d.pattern.params = scene::SlopeParams{.direction = Vec3(0, 1, 0)};
      d.amount = 0.7f;
      d.no_bump_scale = variant % 2 == 1;
      if (variant % 4 >= 2)
        d.pattern.prepend(Transform::scaling(Vec3(unit(random), unit(random), unit(random)))
                              .then(Transform::rotation(Vec3(20, -30, 40))));
      if (variant >= 4)
        d.slope_map = std::make_shared<const scene::BlendMap<scene::SlopeEntry>>(
            scene::BlendMap<scene::SlopeEntry>{{0.1f, {0, 1}}, {0.5f, {1, 0}}, {0.8f, {0.3f, -1}}});
      if (variant == 3) d.pattern.turbulence = scene::Turbulence{.amount = Vec3(0.4, 0.5, 0.6)};
      all.push_back(std::make_shared<const scene::Normal>(d));
    }
  }
  return all;
}

TEST(NormalBatch, GivesTheBitsOfPoints) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  const auto any_vector = [&] { return Vec3(coordinate(random), coordinate(random), coordinate(random)); };
  Compiler compiler{Settings{}};
  for (const scene::NormalPtr& description : descriptions()) {
    const CompiledNormal& normal = *compiler.normal(description);
    for (int round = 0; round < 8; ++round) {
      const int count = 1 + (round * 13) % PointBatch::kMax;
      const Vec3 from = any_vector(), along = any_vector() * std::pow(10.0, -round % 4);
      PointBatch points;
      SurfacePoint together[PointBatch::kMax], single[PointBatch::kMax];
      SurfacePoint* surfaces[PointBatch::kMax];
      for (int i = 0; i < count; ++i) {
        points.set(i, from + static_cast<double>(i) * along);
        together[i].point = points.at(i);
        together[i].normal = i % 3 == 0 ? Vec3(0, 1, 0) : normalize(any_vector());
        together[i].ray_direction = normalize(any_vector());
        single[i] = together[i];
        surfaces[i] = &together[i];
      }
      points.fill_up(count);
      Vec3 normals[PointBatch::kMax];
      perturb(normal, count, points, surfaces, normals);
      for (int i = 0; i < count; ++i) {
        ASSERT_EQ(normals[i], perturb(normal, points.at(i), single[i]))
            << "pattern " << static_cast<int>(description->pattern.kind) << ", point " << i << " of " << count;
        ASSERT_EQ(together[i].normal, single[i].normal);
      }
    }
  }
}

TEST(NormalKernels, GiveTheBitsOfTheScalarFormOnEveryInstructionSet) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  scene::Normal d;
  d.pattern.kind = bumps;
  d.pattern.prepend(Transform::scaling(Vec3(0.3, 2, 1.5)));
  d.pattern.prepend(Transform::rotation(Vec3(10, 20, 30)));
  Compiler compiler{Settings{}};
  const CompiledPattern& pattern = *compiler.normal(std::make_shared<const scene::Normal>(d))->pattern;
  for (int set = 0; set <= simd::best_instruction_set(); ++set) {
    const NormalKernels& kernels = *normal_kernels(set);
    for (const bool no_bump_scale : {false, true}) {
      PointBatch start, inner;
      for (int i = 0; i < 16; ++i) {
        const Vec3 n(coordinate(random), coordinate(random), coordinate(random));
        start.set(i, i % 2 ? n : normalize(n));
      }
      inner = start;
      kernels.into_frame(pattern, no_bump_scale, 13, inner);
      PointBatch outer = inner;
      kernels.out_of_frame(pattern, no_bump_scale, 13, outer);
      for (int i = 0; i < 13; ++i) {
        ASSERT_EQ(inner.at(i), normal_into_frame(pattern, no_bump_scale, start.at(i))) << "instruction set " << set;
        ASSERT_EQ(outer.at(i), normal_out_of_frame(pattern, no_bump_scale, inner.at(i))) << "instruction set " << set;
      }
    }
  }
}

}  // namespace normal_batch_test
}  // namespace verisim::textures
