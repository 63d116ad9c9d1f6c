// Patterns and pigments on every instruction set, bit by bit.
#include "tracer/textures/evaluation.h"

#include <gtest/gtest.h>

#include <random>

namespace verisim::textures {
namespace {

using enum scene::PatternKind;

// Patterns of all kinds that evaluation.inc knows and some that it does not, with all waves, transformations, turbulence and maps of several lengths.
std::vector<scene::PigmentPtr> pigments() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<scene::PigmentPtr> all;
  for (const scene::PatternKind kind : {bozo, bumps, spotted, agate, granite, marble, wood, wrinkles, dents, onion, radial, leopard}) {
    for (int variant = 0; variant < 12; ++variant) {
      scene::Pigment d;
      d.pattern.kind = kind;
      if (kind == agate) d.pattern.params = scene::AgateParams{};
      d.pattern.noise_generator = variant % 4;
      d.pattern.wave = static_cast<scene::Wave>(variant % 6);
      if (variant % 3 == 1) d.pattern.frequency = 2.5f, d.pattern.phase = 0.3f;
      if (variant % 2 == 1) d.pattern.prepend(Transform::translation(Vec3(3 * unit(random), unit(random), -unit(random))));
      if (variant % 4 >= 2) {
        scene::Turbulence turbulence;
        turbulence.amount = Vec3(0.5, 0.3, 0.7);
        turbulence.octaves = 1 + variant % 10;
        d.pattern.turbulence = turbulence;
      }
      scene::ColorMap map;
      const int entries = 2 + 3 * (variant % 5);
      for (int i = 0; i < entries; ++i)
        map.push_back({static_cast<float>(i) / static_cast<float>(entries), Color(static_cast<float>(unit(random)), 0.2f, static_cast<float>(unit(random)), 0, static_cast<float>(unit(random)))});
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
      evaluation_kernels(kBaseline).evaluate(pigment, p, nullptr, first);
      const PatternValue value = evaluation_kernels(kBaseline).value_of(*pigment.pattern, p, nullptr);
      for (int set = 1; set <= best_instruction_set(); ++set) {
        const EvaluationKernels& kernels = evaluation_kernels(static_cast<InstructionSet>(set));
        const PatternValue other = kernels.value_of(*pigment.pattern, p, nullptr);
        ASSERT_EQ(other.point, value.point) << "instruction set " << set;
        ASSERT_EQ(other.value, value.value) << "instruction set " << set << ", pattern " << static_cast<int>(pigment.pattern->kind);
        Color color;
        kernels.evaluate(pigment, p, nullptr, color);
        ASSERT_EQ(color, first) << "instruction set " << set;
      }
    }
  }
}

}  // namespace
}  // namespace verisim::textures
