#include "compare/metrics/systematic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "compare/metrics/test_pictures.h"
#include "compare/verdict/verdict.h"

namespace verisim::compare {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 160, kHeight = 120;

Picture fine_scene() {
  Picture p = scene_like_picture(kWidth, kHeight);
  p.bits = 16;
  return p;
}

template <typename F>
Picture where(Picture p, F&& amount) {
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x)
      for (int c = 0; c < 3; ++c)
        p.samples[static_cast<std::size_t>(3 * (y * p.width + x) + c)] += static_cast<float>(amount(x, y) / 255);
  return p;
}

// A bead is seen in every third pixel of the right half, everything else is the room.
PixelTags room_with_bead() {
  PixelTags tags{kWidth, kHeight, 1, {{"object", "room (a.pov:1)"}, {"object", "bead (a.pov:7)"}}, {{0}, {1}}, {}, {}};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) tags.set_of.push_back(x > 80 && x % 3 == 0 && y % 3 == 0);
  return tags;
}
bool is_bead(int x, int y) { return x > 80 && x % 3 == 0 && y % 3 == 0; }

std::int64_t largest(const std::vector<std::vector<signed char>>& rows) {
  OneSidedGroups groups;
  for (const auto& row : rows) groups.add_row(row);
  return groups.largest().size();
}

TEST(OneSidedGroups, AreConnectedAlsoByCorners) {
  EXPECT_EQ(largest({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 3);
  EXPECT_EQ(largest({{1, 0, 1}, {1, 0, 1}, {1, 1, 1}}), 7) << "two that meet further down";
  EXPECT_EQ(largest({{1, 0, 1, 0, 1}, {0, 1, 0, 1, 0}, {0, 0, 0, 0, 0}, {1, 1, 1, 1, 0}}), 5);
  EXPECT_EQ(largest({{1, 1, 1, 1}, {0, 0, -1, -1}}), 2) << "five contacts with the other side";
  EXPECT_EQ(largest({{0, 0}, {0, 0}}), 0);
}

TEST(OneSidedGroups, AreThoseOfAFloodFill) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const int w = 23, h = 17;
    std::vector<std::vector<signed char>> rows(h, std::vector<signed char>(w));
    for (auto& row : rows)
      for (signed char& v : row) v = static_cast<signed char>(static_cast<int>(random() % 3) - 1);
    std::int64_t most = 0;
    std::vector<std::vector<bool>> seen(h, std::vector<bool>(w));
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        std::int64_t n = 0, contacts = 0;
        std::vector<std::pair<int, int>> waiting{{x, y}};
        while (!waiting.empty()) {
          const auto [i, j] = waiting.back();
          waiting.pop_back();
          if (i < 0 || j < 0 || i >= w || j >= h || seen[j][i] || !rows[j][i] || rows[j][i] != rows[y][x]) continue;
          seen[j][i] = true, ++n;
          for (int k = 0; k < 9; ++k) {
            const int p = i - 1 + k % 3, q = j - 1 + k / 3;
            contacts += p >= 0 && q >= 0 && p < w && q < h && rows[q][p] == -rows[y][x];
            waiting.emplace_back(p, q);
          }
        }
        most = std::max(most, n - contacts / 2);
      }
    EXPECT_EQ(largest(rows), most) << trial;
  }
}

TEST(Systematic, ASmallObjectThatIsALittleDarkerIsAFault) {
  const Picture a = fine_scene(), b = where(a, [](int x, int y) { return x < 5 && y < 4 ? -0.05 : 0; });
  const Verdict verdict = judge_deterministic(measure(a, b), false);
  EXPECT_EQ(verdict.status, Status::differ);
  EXPECT_THAT(verdict.reason, HasSubstr("one_sided_pixels 20 > 8"));
  EXPECT_EQ(
      judge_deterministic(measure(a, b), false, {.solid_pixels = 2, .drift_max = {}, .one_sided_pixels = 20}).status,
      Status::exact)
      << "the manifest allows it";
}

// A line of pixels that all go over to the other side of an outline: a vertex that moved by a part of a pixel.
TEST(Systematic, AnOutlineThatMovedIsAFault) {
  const Picture a = fine_scene(), b = where(a, [](int x, int y) { return x == 40 && y >= 20 && y < 40 ? -30.0 : 0; });
  EXPECT_EQ(judge_deterministic(measure(a, b), false).status, Status::differ);
}

TEST(Systematic, AnObjectInPiecesLeans) {
  const Picture a = fine_scene(), b = where(a, [](int x, int y) { return is_bead(x, y) ? -0.1 : 0; });
  EXPECT_EQ(judge_deterministic(measure(a, b), false).status, Status::exact) << "no figure of the picture shows it";
  const auto verdict = judge_objects(a, b, room_with_bead());
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->status, Status::differ);
  EXPECT_THAT(verdict->reason, HasSubstr("bead (a.pov:7)"));
  EXPECT_THAT(verdict->reason, HasSubstr("darker"));
  EXPECT_FALSE(
      judge_objects(a, b, room_with_bead(), {.solid_pixels = 2, .drift_max = {}, .one_sided_pixels = 8, .leaning = 1}))
      << "the manifest allows it";
}

// What POV-Ray and another right program differ by: last bits, and lone pixels of coincident surfaces.
TEST(Systematic, SpeckleIsNone) {
  const Picture a = fine_scene();
  std::mt19937 random(7);
  for (const double part : {0.001, 0.01, 0.04}) {
    const Picture b = where(a, [&](int, int) {
      const bool here = random() / 4294967296.0 < part;
      return here ? (random() % 2 ? 0.6 : -0.6) : (random() % 2 ? 0.004 : -0.004);
    });
    EXPECT_EQ(judge_deterministic(measure(a, b), false).status, Status::exact) << part;
    EXPECT_FALSE(judge_objects(a, b, room_with_bead())) << part;
  }
}

TEST(Systematic, NoiseToBothSidesIsNone) {
  const Picture a = fine_scene();
  std::mt19937 random(7);
  const Picture b = where(a, [&](int, int) { return random() % 2 ? 0.1 : -0.1; });
  EXPECT_EQ(judge_deterministic(measure(a, b), false).status, Status::exact);
}

TEST(Systematic, TagsOfAnotherPictureAreRefused) {
  PixelTags tags = room_with_bead();
  tags.set_of.pop_back();
  EXPECT_THROW(judge_objects(fine_scene(), fine_scene(), tags), PictureMismatch);
}

}  // namespace
}  // namespace verisim::compare
