#include "tracer/scene/pattern_kinds.h"

#include <gtest/gtest.h>

namespace verisim::scene {
namespace {

struct Whole {
  Vec3 direction{0, 0, 0};
  double low = 0, high = 0;
  int size[2] = {0, 0};
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("direction", direction), visit("range", low, high), visit("size", size[0], size[1]);
  }
};
struct Forgetful {
  double low = 0, high = 0;
  template <class V>
  constexpr void fields(V&& visit) const {
    visit("low", low);
  }
};
static_assert(names_all_fields<Whole>());
static_assert(!names_all_fields<Forgetful>());
static_assert(std::is_same_v<DistinctVariant<std::variant<int>, double, int, double>, std::variant<int, double>>);

TEST(PatternKinds, HaveTheirNamesListsAndDefaults) {
  EXPECT_STREQ(pattern_name(PatternKind::granite), "granite");
  EXPECT_STREQ(pattern_name(PatternKind::magnet_julia), "magnet julia");
  EXPECT_EQ(info(PatternKind::checker).list, 2);
  EXPECT_TRUE(info(PatternKind::checker).is(PatternInfo::kNoFrequency));
  EXPECT_FALSE(info(PatternKind::bozo).is(PatternInfo::kNoFrequency | PatternInfo::kNoValue));
  EXPECT_TRUE(std::holds_alternative<NoParams>(default_params(PatternKind::bozo)));
  EXPECT_EQ(std::get<BrickParams>(default_params(PatternKind::brick)).mortar, 0.5f);
  EXPECT_TRUE(std::holds_alternative<FractalParams>(default_params(PatternKind::magnet_mandel)));
}

TEST(PatternKinds, AreOnlyCalledByOneName) {
  for (std::size_t a = 0; a < kPatternInfo.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) EXPECT_STRNE(kPatternInfo[a].name, kPatternInfo[b].name);
}

}  // namespace
}  // namespace verisim::scene
