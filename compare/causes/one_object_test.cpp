// What speaks for one object rather than for the whole picture, with one side's tags.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/causes/diagnose.h"
#include "compare/metrics/test_pictures.h"
#include "compare/metrics/values.h"

namespace verisim::compare {
namespace {

using testing::HasSubstr;

constexpr int kColumns = 96, kRows = 72;

bool in_disc(int x, int y) { return std::hypot(x - 45, y - 35) < 16; }

// A flat background, and a disc on it that shows a pattern.
Picture pattern_on_disc(const std::function<double(int, int, int)>& pattern) {
  return picture_of(kColumns, kRows,
                    [&](int x, int y, int c) { return std::round(in_disc(x, y) ? pattern(x, y, c) : 20.0 + 10 * c); });
}
double waves(int x, int y, int c) { return 120 + 60 * std::sin(x / 4.0) * std::cos(y / 5.0) + 15 * c; }

PixelTags tags_of_disc(const std::vector<PixelTags::Tag>& tags) {
  PixelTags out;
  out.width = kColumns, out.height = kRows, out.tags = tags, out.sets = {{}, {}};
  for (std::size_t i = 0; i < tags.size(); ++i) out.sets[1].push_back(static_cast<int>(i));
  for (int i = 0; i < kColumns * kRows; ++i) out.set_of.push_back(in_disc(i % kColumns, i / kColumns));
  return out;
}
const PixelTags::Tag kObject{"object", "sphere (s.pov:2)"},
    kCopy{"copy", "sphere (s.pov:2) at <0, 0, 0>, size <1, 1, 1>"};

Suspicion first_of(const Picture& reference, const Picture& test, const PixelTags& tags) {
  const std::vector<Suspicion> all = diagnose(reference, test, nullptr, &tags);
  return all.empty() ? Suspicion{"nothing", "", 0} : all[0];
}

TEST(OneObject, ItsChannelsAreSwappedNotThePictures) {
  const auto swapped = [](int x, int y, int c) { return waves(x, y, 2 - c); };
  const Suspicion s = first_of(pattern_on_disc(waves), pattern_on_disc(swapped), tags_of_disc({kObject, kCopy}));
  EXPECT_EQ(s.what, "swapped channels");
  EXPECT_THAT(s.detail, HasSubstr("sphere (s.pov:2)"));
}

TEST(OneObject, ItsPatternIsElsewhereNotThePicture) {
  const auto moved = [](int x, int y, int c) { return waves(x - 3, y, c); };
  const Suspicion s = first_of(pattern_on_disc(waves), pattern_on_disc(moved), tags_of_disc({kObject, kCopy}));
  EXPECT_NE(s.what, "shift") << s.detail;
  EXPECT_THAT(s.detail, HasSubstr("sphere (s.pov:2)"));
}

// Where it is not, there is nothing to be lit: its light is no suspect.
TEST(OneObject, IsToldRatherThanItsLight) {
  const auto other = [](int x, int y, int c) { return waves(y, x, c); };
  const PixelTags tags = tags_of_disc({kObject, kCopy, {"light", "lit by the light at <1, 2, 3>"}});
  const Suspicion s = first_of(pattern_on_disc(waves), pattern_on_disc(other), tags);
  EXPECT_THAT(s.detail, HasSubstr("sphere (s.pov:2)")) << s.what;
}

// It is gone: neither has the picture shrunk to a point, nor is it all darker, nor are its squares of one colour.
TEST(OneObject, ThatIsGoneIsNoFaultOfThePicture) {
  const Picture none = pattern_on_disc([](int, int, int c) { return 20.0 + 10 * c; });
  PixelTags tags = tags_of_disc({{"passed object", "sor (s.pov:7)"}});
  const std::vector<Suspicion> all = diagnose(pattern_on_disc(waves), none, nullptr, &tags);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].what, "object missing") << all[0].detail;
  for (const Suspicion& s : all)
    EXPECT_THAT(s.what, testing::Not(testing::AnyOf("zoom", "stretched", "contrast", "pixelation", "vignetting")))
        << s.detail;
}

TEST(OneObject, ItsShadowIsToldWithIt) {
  PixelTags tags = tags_of_disc({{"caster", "lathe (s.pov:4)"}, {"light", "in the shadow of the light at <1, 2, 3>"}});
  const auto half = [](int x, int y, int c) { return 0.5 * waves(x, y, c) + 9 * std::sin(x * y); };
  const Suspicion s = first_of(pattern_on_disc(waves), pattern_on_disc(half), tags);
  EXPECT_EQ(s.what, "shadows");
  EXPECT_THAT(s.detail, HasSubstr("lathe (s.pov:4)"));
}

// The reference is without one of two lights in a small part of what they light.
TEST(OneObject, AShadowThatOnlyTheReferenceHas) {
  PixelTags tags = tags_of_disc({kObject});
  for (int& set : tags.set_of) set = 1;  // all the same
  PixelTags::Part one{"light", "light at <1, 2, 3>", {}}, two{"light", "light at <3, 2, 1>", {}};
  for (int i = 0; i < kColumns * kRows; ++i)
    for (int c = 0; c < 3; ++c)
      one.light.push_back(0.1f + 0.002f * static_cast<float>(i % kColumns)),
          two.light.push_back(0.3f - 0.001f * static_cast<float>(i / kColumns + 9 * c));
  tags.parts = {one, two};
  const auto picture = [&](bool shadow) {
    return picture_of(kColumns, kRows, [&](int x, int y, int c) {
      const auto i = static_cast<std::size_t>(3 * (y * kColumns + x) + c);
      return std::round(255 * linear_to_srgb(one.light[i] + (shadow && in_disc(x, y) ? 0 : two.light[i])));
    });
  };
  const Suspicion s = first_of(picture(true), picture(false), tags);
  EXPECT_EQ(s.what, "shadows") << s.detail;
  EXPECT_THAT(s.detail, HasSubstr("only the reference has one of the light at <3, 2, 1>"));
}

}  // namespace
}  // namespace verisim::compare
