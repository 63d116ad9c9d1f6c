#include "compare/report/why.h"

#include <gtest/gtest.h>

namespace verisim::compare {
namespace {

std::string of(const std::string& reason, Status status = Status::differ) {
  SceneResult scene;
  scene.status = status, scene.reason = reason;
  return why(scene);
}

TEST(Why, NamesTheFigureAndTheLimit) {
  EXPECT_EQ(of("within_1_pct 87.906 < 99.5"),
            "87.906 % of the pixels are within one code value of the reference; 99.5 % must be.");
  EXPECT_EQ(
      of("wrong pixels lie together around 10, 20: solid_2_pixels 9 > 2"),
      "Wrong pixels lie together around 10, 20: 9 pixels of patches are wrong by more than two code values; 2 may "
      "be.");
  EXPECT_EQ(of("blurred mad 3.210 > 1.100 in the means of 4 runs"),
            "Blurred mad is 3.210; the limit is 1.100 in the means of 4 runs");
}

TEST(Why, LeavesOtherReasonsAsTheyAre) {
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("isosurface (scene.pov:3)", Status::unsupported), "isosurface (scene.pov:3)");
  EXPECT_EQ(of("the program ended with 1 < 2", Status::error), "the program ended with 1 < 2");
}

}  // namespace
}  // namespace verisim::compare
