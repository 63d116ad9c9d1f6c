// Patterns and pigments on every instruction set, bit by bit.
#include "tracer/textures/evaluation/evaluation.h"

#include <gtest/gtest.h>

#include <random>

#include "tracer/functions/function.h"

namespace verisim::textures {
namespace evaluation_test {

using enum scene::PatternKind;

// Patterns of all kinds that evaluation.inc knows and some that it does not, with all waves, transformations,
// turbulence and maps of several lengths.
std::vector<scene::PigmentPtr> pigments() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<scene::PigmentPtr> all;
  for (const scene::PatternKind kind : {bozo, bumps, spotted, agate, granite, marble, wood, wrinkles, dents, onion,
                                        radial, leopard, crackle, spherical, checker}) {
    for (int variant = 0; variant < 12; ++variant) {
      scene::Pigment d;
      d.pattern.kind = kind;
      if (kind == agate) d.pattern.params = scene::AgateParams{};
      if (kind == crackle)
        d.pattern.params = scene::CrackleParams{.form = Vec3(-1, 1, 0.3 * (variant % 2)),
                                                .metric = 1.0f + static_cast<float>(variant % 3),
                                                .solid = variant == 5};
      d.pattern.noise_generator = variant % 4;
      d.pattern.wave = static_cast<scene::Wave>(variant % 6);
      if (variant % 3 == 1) d.pattern.frequency = 2.5f, d.pattern.phase = 0.3f;
      if (variant % 2 == 1)
        d.pattern.prepend(Transform::translation(Vec3(3 * unit(random), unit(random), -unit(random))));
      if (variant % 4 >= 2) {
        scene::Turbulence turbulence;
        turbulence.amount = Vec3(0.5, 0.3, 0.7);
        turbulence.octaves = 1 + variant % 10;
        d.pattern.turbulence = turbulence;
      }
      scene::ColorMap map;
      const int entries = 2 + 3 * (variant % 5);
      for (int i = 0; i < entries; ++i)
        map.push_back({static_cast<float>(i) / static_cast<float>(entries),
                       Color(static_cast<float>(unit(random)), 0.2f, static_cast<float>(unit(random)), 0,
                             static_cast<float>(unit(random)))});
      d.color_map = std::make_shared<const scene::ColorMap>(map);
      all.push_back(std::make_shared<const scene::Pigment>(d));
    }
  }
  return all;
}

TEST(Evaluation, GivesTheSameBitsOnEveryInstructionSet) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Compiler compiler{Settings{}};
  for (const scene::PigmentPtr& description : pigments()) {
    const CompiledPigment& pigment = *compiler.pigment(description);
    for (int i = 0; i < 300; ++i) {
      const double size = std::pow(10.0, i % 7 - 2);
      const Vec3 p(size * coordinate(random), size * coordinate(random), size * coordinate(random));
      Color first;
      evaluation_kernels(simd::kBaseline).evaluate(pigment, p, nullptr, first);
      const PatternValue value = evaluation_kernels(simd::kBaseline).value_of(*pigment.pattern, p, nullptr);
      for (int set = 1; set <= simd::best_instruction_set(); ++set) {
        const EvaluationKernels& kernels = evaluation_kernels(static_cast<simd::InstructionSet>(set));
        const PatternValue other = kernels.value_of(*pigment.pattern, p, nullptr);
        ASSERT_EQ(other.point, value.point) << "instruction set " << set;
        ASSERT_EQ(other.value, value.value)
            << "instruction set " << set << ", pattern " << static_cast<int>(pigment.pattern->kind);
        Color color;
        kernels.evaluate(pigment, p, nullptr, color);
        ASSERT_EQ(color, first) << "instruction set " << set;
      }
    }
  }
}

// Points as they lie in a picture: rows of neighbours, close together or far apart, some of them beyond all lattices.
void fill(PointBatch& batch, int count, double step, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-9, 9);
  const Vec3 from(coordinate(random), coordinate(random), coordinate(random));
  const Vec3 along(step * coordinate(random), step * coordinate(random), step * coordinate(random));
  for (int i = 0; i < count; ++i) batch.set(i, from + static_cast<double>(i) * along);
  batch.fill_up(count);
}

std::vector<scene::PigmentPtr> nested_pigments() {
  const std::vector<scene::PigmentPtr> leaves = pigments();
  std::vector<scene::PigmentPtr> all;
  for (std::size_t i = 0; i + 4 < leaves.size(); i += 7) {
    for (const bool average : {false, true}) {
      scene::Pigment d;
      d.pattern.kind = average ? scene::PatternKind::average : i % 2 ? bozo : gradient;
      if (d.pattern.kind == gradient) d.pattern.params = scene::GradientParams{{1, 0.2, 0}};
      d.pattern.prepend(Transform::scaling(Vec3(0.4, 0.5, 0.6)));
      scene::BlendMap<scene::PigmentPtr> map;
      for (std::size_t k = 0; k < 4; ++k) map.push_back({0.1f + 0.25f * static_cast<float>(k), leaves[i + k]});
      map.push_back({0.9f, leaves[i]});
      d.pigment_map = std::make_shared<const scene::BlendMap<scene::PigmentPtr>>(map);
      all.push_back(std::make_shared<const scene::Pigment>(d));
    }
  }
  return all;
}

// Maps that begin with several entries of one colour, and patterns that hang on some coordinates only: rows need not
// know everything about them.
std::vector<scene::PigmentPtr> pigments_of_few_colors() {
  std::vector<scene::PigmentPtr> all;
  for (const scene::PatternKind kind : {granite, wrinkles, marble, gradient, planar, bozo, spherical, crackle}) {
    for (int variant = 0; variant < 24; ++variant) {
      scene::Pigment d;
      d.pattern.kind = kind;
      const double y = variant % 2, z = variant % 3 == 0 ? 0 : 1;
      if (kind == gradient) d.pattern.params = scene::GradientParams{{y == 0 && z == 0 ? 1.0 : 0.0, y, z}};
      d.pattern.noise_generator = variant % 4;
      if (variant % 8 == 7) d.pattern.phase = 0.2f;
      if (variant % 3 != 0) {
        scene::TurbulenceWarp turbulence;
        turbulence.amount = Vec3(0.5, 0.3, 0.7);
        turbulence.octaves = 1 + variant % 10;
        d.pattern.prepend(turbulence);
      }
      if (variant % 6 == 5) d.pattern.prepend(Transform::rotation(Vec3(10, 20, 30)));
      const Color dark(0.1f, 0.2f, 0.3f), light(1, 0.5f, 0.25f);
      const float end = 0.2f + 0.1f * static_cast<float>(variant % 7);
      const bool all_dark = variant == 23;
      d.color_map = std::make_shared<const scene::ColorMap>(
          scene::ColorMap{{0, dark}, {end / 2, dark}, {end, dark}, {0.9f, all_dark ? dark : light}, {1, dark}});
      all.push_back(std::make_shared<const scene::Pigment>(d));
    }
  }
  return all;
}

// Patterns that ask pigments and functions, these within each other, too, deeper than batches go.
std::vector<scene::PigmentPtr> pigments_of_others() {
  const std::vector<scene::PigmentPtr> leaves = pigments();
  std::vector<scene::PigmentPtr> all;
  for (std::size_t i = 0; i < leaves.size(); i += 5) {
    scene::PigmentPtr inner = leaves[i];
    for (int depth = 0; depth < (i % 15 == 0 ? 12 : 2); ++depth) {
      scene::Pigment d;
      const bool asks_function = (i + static_cast<std::size_t>(depth)) % 2 == 0;
      d.pattern.kind = asks_function ? function : pigment_pattern;
      if (asks_function)
        d.pattern.params = scene::FunctionParams{pigment_function(inner, Settings{})};
      else
        d.pattern.params = scene::PigmentPatternParams{inner};
      if (depth == 0) d.pattern.frequency = 3, d.pattern.wave = static_cast<scene::Wave>(i % 6);
      d.pattern.prepend(Transform::scaling(Vec3(0.9, 1.2, 0.8)));
      d.color_map =
          std::make_shared<const scene::ColorMap>(scene::ColorMap{{0, Color(0.1f, 0.3f, 0)}, {1, Color(1, 0.9f, 2)}});
      inner = std::make_shared<const scene::Pigment>(d);
    }
    all.push_back(inner);
  }
  return all;
}

TEST(Evaluation, GivesRowsTheBitsOfPoints) {
  std::mt19937 random(9);
  Compiler compiler{Settings{}};
  std::vector<scene::PigmentPtr> all = pigments();
  for (const scene::PigmentPtr& nested : nested_pigments()) all.push_back(nested);
  for (const scene::PigmentPtr& few : pigments_of_few_colors()) all.push_back(few);
  for (const scene::PigmentPtr& other : pigments_of_others()) all.push_back(other);
  for (const scene::PigmentPtr& description : all) {
    const CompiledPigment& pigment = *compiler.pigment(description);
    for (int round = 0; round < 12; ++round) {
      const int count = 1 + (round * 13) % PointBatch::kMax;
      PointBatch points;
      fill(points, count, std::pow(10.0, round % 5 - 4 + (round == 11 ? 12 : 0)), random);
      for (int set = 0; set <= simd::best_instruction_set(); ++set) {
        const EvaluationKernels& kernels = evaluation_kernels(static_cast<simd::InstructionSet>(set));
        Color colors[PointBatch::kMax];
        bool colored[PointBatch::kMax];
        kernels.evaluate_batch(pigment, count, points, nullptr, colors, colored);
        for (int i = 0; i < count; ++i) {
          Color single;
          ASSERT_EQ(colored[i], kernels.evaluate(pigment, points.at(i), nullptr, single));
          ASSERT_EQ(colors[i], single) << "instruction set " << set << ", pattern "
                                       << static_cast<int>(pigment.pattern->kind) << ", point " << i << " of " << count;
        }
        RgbBatch rgb;
        kernels.rgb_batch(pigment, count, points, rgb);
        for (int i = 0; i < count; ++i)
          ASSERT_EQ(Rgb(rgb.r[i], rgb.g[i], rgb.b[i]), colors[i].rgb())
              << "instruction set " << set << ", pattern " << static_cast<int>(pigment.pattern->kind);
      }
    }
  }
}

TEST(Evaluation, GivesTurbulenceOfManyPointsTheBitsOfOne) {
  std::mt19937 random(11);
  const Octaves octaves[] = {Octaves(6, 2, 0.5), Octaves(10, 2.17, 0.63), Octaves(1, 3, 0.1)};
  for (int round = 0; round < 60; ++round) {
    const int count = 1 + (round * 13) % PointBatch::kMax, generator = 1 + round % 3;
    PointBatch points;
    fill(points, count, std::pow(10.0, round % 5 - 4 + (round == 11 ? 12 : 0)), random);
    for (int set = 0; set <= simd::best_instruction_set(); ++set) {
      const EvaluationKernels& kernels = evaluation_kernels(static_cast<simd::InstructionSet>(set));
      alignas(64) double values[PointBatch::kMax];
      kernels.turbulence_batch(generator, count, points, octaves[round % 3], values);
      for (int i = 0; i < count; ++i)
        ASSERT_EQ(values[i], turbulence(points.at(i), octaves[round % 3], generator)) << set << ' ' << i;
    }
  }
}

TEST(Evaluation, GivesManyPointsOfFunctionsTheBitsOfOne) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> coordinate(-3, 3);
  for (const scene::PigmentPtr& description : nested_pigments()) {
    const FunctionPtr function = pigment_function(description, Settings{});
    for (const std::size_t count : {1, 2, 64, 65, 200}) {
      const std::size_t stride = count + 3;
      std::vector<double> points(3 * stride), values(5 * stride);
      for (double& x : points) x = coordinate(random);
      function->evaluate_batch(points.data(), stride, count, values.data());
      for (std::size_t k = 0; k < count; ++k) {
        const double at[3] = {points[k], points[stride + k], points[2 * stride + k]};
        double single[5];
        function->evaluate(at, single);
        for (std::size_t c = 0; c < 5; ++c) ASSERT_EQ(values[c * stride + k], single[c]) << k << " of " << count;
      }
    }
  }
}

}  // namespace evaluation_test
}  // namespace verisim::textures
