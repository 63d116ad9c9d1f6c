#include "compare/regression/review.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "compare/metrics/test_pictures.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using testing::HasSubstr;
namespace {

class ReviewTest : public testing::Test {
 protected:
  ReviewTest() {
    compare::Run run;
    for (const char* name : {"changed", "same", "broken"}) {
      SceneResult& scene = run.scenes.emplace_back();
      scene.request.name = name;
      scene.native_picture = folder_.path() / (std::string(name) + ".native.png");
      scene.status = Status::exact;
    }
    run.scenes[0].status = Status::differ, run.scenes[0].reason = "mae 1.0000 > 0.02";
    run.scenes[2].status = Status::error, run.scenes[2].reason = "crashed", run.scenes[2].native_picture.clear();
    for (const char* name : {"changed", "same"}) draw(name, 10);
    fs::create_directories(baseline());
    std::ofstream(baseline() / "baseline.json") << "{\"scenes\": {}}";
    save_run(run, folder_.path(), baseline());
  }
  fs::path baseline() const { return folder_.path() / "baseline"; }
  void draw(const std::string& name, int grey) {
    image::write_picture(constant_picture(8, 6, grey, grey, grey), folder_.path() / (name + ".native.png"));
  }
  std::string refused(const std::string& scene, const std::string& decision) {
    try {
      Review(folder_.path()).decide(scene, decision, "");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
};

TEST_F(ReviewTest, StoresWhatWasAcceptedAndNothingElse) {
  Review review(folder_.path());
  EXPECT_EQ(review.left().undecided, 2);
  review.decide("changed", "accepted", "brighter on purpose");
  EXPECT_FALSE(fs::exists(baseline() / "changed.png"));
  Review again(folder_.path());  // decisions are kept
  EXPECT_EQ(again.left().not_stored, 1);
  EXPECT_EQ(again.store().size(), 1u);
  EXPECT_TRUE(fs::exists(baseline() / "changed.png"));
  EXPECT_FALSE(fs::exists(baseline() / "same.png"));
  EXPECT_TRUE(again.store().empty());
  EXPECT_EQ(Review(folder_.path()).state()["decisions"]["changed"]["note"], "brighter on purpose");
}

TEST_F(ReviewTest, ADecisionHoldsForOnePicture) {
  Review(folder_.path()).decide("changed", "accepted", "");
  draw("changed", 20);
  EXPECT_EQ(Review(folder_.path()).left().undecided, 2);
}

TEST_F(ReviewTest, WhatCannotBeDecidedIsRefused) {
  EXPECT_THAT(refused("same", "accepted"), HasSubstr("did not change"));
  EXPECT_THAT(refused("broken", "accepted"), HasSubstr("no picture to accept: crashed"));
  EXPECT_THAT(refused("nothing", "accepted"), HasSubstr("no scene"));
  EXPECT_THAT(refused("changed", "perhaps"), HasSubstr("accepted, refused or open"));
  EXPECT_EQ(refused("broken", "refused"), "");
}

TEST_F(ReviewTest, AFolderWithoutStoredPicturesIsNotWrittenTo) {
  fs::remove(baseline() / "baseline.json");
  Review review(folder_.path());
  review.decide("changed", "accepted", "");
  EXPECT_THROW(review.store(), std::runtime_error);
  EXPECT_EQ(Review(folder_.path(), baseline()).store().size(), 1u);
}

TEST_F(ReviewTest, TheSummaryHasPictures) {
  Review review(folder_.path());
  review.decide("changed", "refused", "a | b");
  review.write_markdown(folder_.path() / "out.md");
  std::ifstream in(folder_.path() / "out.md");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_THAT(text, HasSubstr("refused: a \\| b"));
  EXPECT_THAT(text, HasSubstr("![](<out_pictures/changed.png>)"));
  EXPECT_EQ(image::read_picture(folder_.path() / "out_pictures/changed.png").width, 8);
}

}  // namespace
}  // namespace verisim::compare
