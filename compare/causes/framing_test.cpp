// Cameras that have moved: near things move more than far ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/causes/diagnose.h"
#include "compare/metrics/test_pictures.h"

namespace verisim::compare {
namespace {

constexpr int kWallsWidth = 96, kWallsHeight = 72;
constexpr double kFocal = 72;  // pixels: the distance of a picture with the camera's direction of 1 and right of 4/3

double depth_at(double x) { return x < kWallsWidth / 2.0 ? 4 : 8; }

// Two walls side by side, by a camera that stands so far to the right and so high.
Picture walls(double right, double high) {
  return picture_of(kWallsWidth, kWallsHeight, [=](int x, int y, int c) {
    const double move = kFocal / depth_at(x), u = x + right * move, v = y - high * move;
    return std::round(110 + 50 * std::sin(u / 3.1 + c) * std::cos(v / 4.3) + 30 * std::sin(v / 7.7 + u / 11));
  });
}

PixelTags tags_of_walls() {
  PixelTags tags;
  tags.width = kWallsWidth, tags.height = kWallsHeight;
  tags.tags = {
      {"camera", "location <0, 0, 0>, direction <0, 0, 1>, right <1.3333333, 0, 0>, up <0, 1, 0>"},
      {"object", "plane (s.pov:2)"},
  };
  tags.sets = {{0, 1}};
  tags.set_of.assign(kWallsWidth * kWallsHeight, 0);
  for (int i = 0; i < kWallsWidth * kWallsHeight; ++i) {
    const auto depth = static_cast<float>(depth_at(i % kWallsWidth));
    for (const float v : {0.0f, 0.0f, depth}) tags.surfaces.point.push_back(v);
    for (const float v : {0.0f, 0.0f, -1.0f}) tags.surfaces.normal.push_back(v);
  }
  return tags;
}

TEST(Framing, ACameraThatHasMovedIsToldByParallax) {
  const PixelTags tags = tags_of_walls();
  for (const auto& [right, high] : {std::pair(0.1, 0.0), std::pair(-0.1, 0.05)}) {
    const std::vector<Suspicion> all = diagnose(walls(0, 0), walls(right, high), nullptr, &tags);
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all[0].what, "camera moved") << all[0].what << ": " << all[0].detail;
    double aside = 0, above = 0;
    char side[6] = "", way[7] = "";
    ASSERT_EQ(std::sscanf(all[0].detail.c_str(), "it stands %lf further to the %5s and %lf %6s than", &aside, side,
                          &above, way),
              4);
    EXPECT_NEAR(std::string(side) == "right" ? aside : -aside, right, 0.005);
    EXPECT_NEAR(std::string(way) == "higher" ? above : -above, high, 0.005);
  }
}

TEST(Framing, WhatMovesAllAlikeIsAShift) {
  const PixelTags tags = tags_of_walls();
  const Picture wide = picture_of(kWallsWidth, kWallsHeight, [](int x, int y, int c) {
    return std::round(110 + 50 * std::sin((x + 1.2) / 3.1 + c) * std::cos(y / 4.3));
  });
  const Picture plain = picture_of(kWallsWidth, kWallsHeight, [](int x, int y, int c) {
    return std::round(110 + 50 * std::sin(x / 3.1 + c) * std::cos(y / 4.3));
  });
  const std::vector<Suspicion> all = diagnose(plain, wide, nullptr, &tags);
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].what, "shift") << all[0].detail;
}

}  // namespace
}  // namespace verisim::compare
