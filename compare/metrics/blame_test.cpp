#include "compare/metrics/blame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/compare.h"
#include "compare/metrics/test_pictures.h"

namespace verisim::compare {
namespace {

// A floor, and a ball on the right half whose left part is lit by one more light.
PixelTags half_and_half(int width, int height) {
  PixelTags t;
  t.width = width, t.height = height;
  t.tags = {{"object", "floor"}, {"object", "ball"}, {"light", "lamp"}};
  t.sets = {{0}, {1}, {1, 2}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) t.set_of.push_back(x < width / 2 ? 0 : x < 3 * width / 4 ? 2 : 1);
  return t;
}

Picture with_error(const Picture& p, int from, int to, double error) {
  Picture out = p;
  for (int y = 0; y < p.height; ++y)
    for (int x = from; x < to; ++x)
      for (int c = 0; c < 3; ++c)
        out.samples[static_cast<std::size_t>((y * p.width + x) * 3 + c)] += static_cast<float>(error / 255);
  return out;
}

TEST(Blame, NamesTheTagThatFitsTheWrongPixels) {
  const Picture a = constant_picture(40, 20, 100, 100, 100);
  const Blame b = blame(a, with_error(a, 20, 30, 12), half_and_half(40, 20));
  EXPECT_EQ(b.bad, 200u);
  EXPECT_EQ(b.good, 600u);
  ASSERT_EQ(b.common.size(), 2u);
  EXPECT_EQ(b.common[0].name, "lamp");
  EXPECT_NEAR(b.common[0].correlation, 1, 1e-12);
  EXPECT_EQ(b.common[1].name, "ball");
  EXPECT_NEAR(b.common[1].bad_pct, 100, 1e-12);
  EXPECT_NEAR(b.common[1].good_pct, 100.0 / 3, 1e-9);
  // phi of the table 200 200 / 0 400
  EXPECT_NEAR(b.common[1].correlation, 200.0 * 400 / std::sqrt(200.0 * 600 * 400 * 400), 1e-12);
}

TEST(Blame, DividesTheErrorAmongObjects) {
  const Picture a = constant_picture(40, 20, 100, 100, 100);
  const Blame b = blame(a, with_error(with_error(a, 0, 10, 6), 30, 40, 12), half_and_half(40, 20));
  ASSERT_EQ(b.objects.size(), 2u);
  EXPECT_EQ(b.objects[0].name, "ball");
  EXPECT_NEAR(b.objects[0].share, 0.8, 1e-6);
  EXPECT_NEAR(b.objects[0].rmse, 12 / std::sqrt(2), 1e-6);
  EXPECT_NEAR(b.objects[0].bias, 6, 1e-6);
  EXPECT_NEAR(b.objects[0].bad_pct, 50, 1e-9);
  EXPECT_NEAR(b.objects[0].pixels_pct, 50, 1e-9);
  EXPECT_EQ(b.objects[0].max_abs, 12);
  EXPECT_GE(b.objects[0].worst_x, 30);
}

// No pixel is wrong by a whole code value: the limit goes down.
TEST(Blame, SmallDifferencesEverywhere) {
  Picture a = constant_picture(40, 20, 100, 100, 100);
  a.bits = 16;
  const Blame b = blame(a, with_error(a, 20, 40, -0.6), half_and_half(40, 20));
  EXPECT_DOUBLE_EQ(b.limit, 0.05);
  EXPECT_EQ(b.common.at(0).name, "ball");
}

TEST(Blame, EqualPicturesHaveNoCulprit) {
  const Picture a = random_picture(40, 20, 1);
  const Blame b = blame(a, a, half_and_half(40, 20));
  EXPECT_EQ(b.bad, 0u);
  EXPECT_TRUE(b.common.empty());
  EXPECT_EQ(b.objects.size(), 2u);
}

TEST(Blame, EveryFourthPixelOfALargePicture) {
  const Picture a = constant_picture(41, 21, 100, 100, 100);
  PixelTags t;
  t.width = 41, t.height = 21, t.step = 4;
  t.tags = {{"object", "a"}, {"object", "b"}}, t.sets = {{0}, {1}};
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 11; ++x) t.set_of.push_back(x >= 5);
  const Blame b = blame(a, with_error(a, 20, 41, 9), t);
  EXPECT_EQ(b.bad + b.good, 66u);
  EXPECT_EQ(b.common.at(0).name, "b");
}

TEST(Blame, RefusesTagsOfAnotherPicture) {
  const Picture a = constant_picture(40, 20, 100, 100, 100);
  EXPECT_THROW(blame(a, a, half_and_half(20, 20)), PictureMismatch);
  PixelTags t = half_and_half(40, 20);
  t.set_of.pop_back();
  EXPECT_THROW(blame(a, a, t), PictureMismatch);
  t = half_and_half(40, 20), t.step = 0;
  EXPECT_THROW(blame(a, a, t), PictureMismatch);
  t = half_and_half(40, 20), t.set_of[0] = 99, t.sets[1] = {-1, 7};  // nonsense inside is passed over
  EXPECT_NO_THROW(blame(a, a, t));
}

TEST(PixelTags, GoThroughJson) {
  PixelTags t = half_and_half(8, 4);
  t.trees.push_back({3, 2, "camera ray\n  hits \xff"});
  t.surfaces.point = {1234.5678f, -0.00012345678f, 0}, t.surfaces.normal = {0, 1, HUGE_VALF};
  const PixelTags read = tags_from_json(tags_json(t));
  EXPECT_EQ(read.set_of, t.set_of);
  EXPECT_EQ(read.sets, t.sets);
  EXPECT_EQ(read.tags[2].name, "lamp");
  EXPECT_EQ(read.trees[0].x, 3);
  EXPECT_THAT(read.surfaces.point, testing::ElementsAre(1234.6f, -0.00012346f, 0));
  EXPECT_THAT(read.surfaces.normal, testing::ElementsAre(0, 1, 0));
  for (const char* bad : {"", "{", "[]", "{\"width\": \"x\"}",
                          "{\"width\":1,\"height\":1,\"step\":1,\"tags\":[{}],\"sets\":[],\"pixels\":[],\"trees\":[]}"})
    EXPECT_THROW(tags_from_json(bad), std::runtime_error) << bad;
}

}  // namespace
}  // namespace verisim::compare
