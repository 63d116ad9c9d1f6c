// Region, clock and file-name probes of spec 02: P11, P12, P13.
#include <gtest/gtest.h>

#include <cmath>

#include "cli/settings/animation.h"
#include "cli/settings/reading/ini.h"
#include "cli/settings/output_name.h"
#include "cli/settings/region.h"

namespace verisim::cli {
namespace {

Options options(std::initializer_list<const char*> words) {
  Options result;
  for (const char* word : words) apply_argument(result, word);
  return result;
}

std::string names(std::initializer_list<const char*> words, const char* scene = "sc.pov") {
  const Options given = options(words);
  const Animation plan = animation(given);
  std::string result;
  for (std::size_t i = 0; i < plan.count(); ++i)
    result += (i ? " " : "") + output_name(given, scene, plan, plan.frame(i)).path.string();
  return result;
}

TEST(OutputName, FollowsTheProbesOfP12) {
  EXPECT_EQ(names({"+KFF3"}), "sc1.png sc2.png sc3.png");
  EXPECT_EQ(names({"+KFI98", "+KFF101"}), "sc098.png sc099.png sc100.png sc101.png");
  EXPECT_EQ(names({"+KFF9", "+KC", "+EF1", "+Ofoo.png"}), "foo01.png");
  EXPECT_EQ(names({"+Ofoo.tga"}), "foo.tga.png");
  EXPECT_EQ(names({"+Ofoo.PNG"}), "foo.PNG.png");
  EXPECT_EQ(names({"+Ofoo."}), "foo.png");
  EXPECT_EQ(names({"+Osub/"}), "sub/sc.png");
  EXPECT_EQ(names({"+Osub/.png"}), "sub/sc.png");
  EXPECT_EQ(names({"+O.png"}), "sc.png");
  EXPECT_EQ(names({"+Oout.d/x.y"}), "out.d/x.y.png");
}

TEST(OutputName, LiesBesideTheSceneUnlessNamed) {
  EXPECT_EQ(names({}, "sub/sc2.pov"), "sub/sc2.png");
  EXPECT_EQ(names({}, "a.b.pov"), "a.b.png");
  EXPECT_EQ(names({"+Ofoo"}, "sub/sc2.pov"), "foo.png");
  EXPECT_EQ(names({"+O.png"}, "sub/sc2.pov"), "sc2.png");
  EXPECT_EQ(names({"+FJ"}, "sub/sc2.pov"), "sub/sc2.jpg");
}

TEST(OutputName, StandardStreams) {
  const Animation still = animation({});
  EXPECT_TRUE(output_name(options({"+O-"}), "sc.pov", still, {}).standard_output);
  EXPECT_TRUE(output_name(options({"+Ostdout"}), "sc.pov", still, {}).standard_output);
  EXPECT_TRUE(output_name(options({"+Ostderr"}), "sc.pov", still, {}).standard_error);
}

TEST(OutputName, ExactNamesKeepTheirExtension) {
  Options given = options({"+KFF12"});
  given.exact_output = "out/foo.exr";
  EXPECT_EQ(output_name(given, "sc.pov", animation(given), {7, 0}).path, "out/foo07.exr");
}

TEST(Animation, ClocksFollowTheProbesOfP11) {
  Animation plan = animation(options({"+KFF3"}));
  ASSERT_EQ(plan.count(), 3u);
  EXPECT_EQ(plan.frame(0).clock, 0);
  EXPECT_EQ(plan.frame(1).clock, 0.5);
  EXPECT_EQ(plan.frame(2).clock, 1);
  EXPECT_EQ(plan.clock_delta, 0.5);

  plan = animation(options({"+KFI1", "+KFF3", "+KF10", "+KC"}));
  ASSERT_EQ(plan.count(), 3u);
  EXPECT_NEAR(plan.frame(1).clock, 3.333333253860474, 1e-14);
  EXPECT_NEAR(plan.frame(2).clock, 6.666666507720947, 1e-14);
  EXPECT_NEAR(plan.clock_delta, 3.33333, 1e-5);
  EXPECT_EQ(plan.final_frame, 4);

  plan = animation(options({"+KFI1", "+KFF10", "+SF0.3", "+EF0.4"}));
  ASSERT_EQ(plan.count(), 2u);
  EXPECT_EQ(plan.frame(0).number, 3);
  EXPECT_NEAR(plan.frame(0).clock, 0.222222223877907, 1e-15);
  EXPECT_NEAR(plan.frame(1).clock, 0.333333343267441, 1e-15);

  plan = animation(options({"+K0.123456789012345"}));
  EXPECT_FALSE(plan.on);
  EXPECT_TRUE(plan.clock_on);
  EXPECT_NEAR(plan.frame(0).clock, 0.123456791043282, 1e-15);

  plan = animation(options({"+KFI2", "+KFF8", "+STP3"}));
  ASSERT_EQ(plan.count(), 3u);
  EXPECT_EQ(plan.frame(1).number, 5);
  EXPECT_EQ(plan.frame(1).clock, 0.5);

  plan = animation(options({"+KFI5", "+KFF5"}));
  EXPECT_TRUE(std::isnan(plan.frame(0).clock));
  EXPECT_TRUE(std::isinf(plan.clock_delta));
  EXPECT_FALSE(animation(options({"+KFI1", "+KFF1"})).on);
  EXPECT_FALSE(animation(options({})).clock_on);
}

struct RegionCase {
  std::vector<const char*> words;
  int first_column, last_column, first_row, last_row;
};

TEST(Region, FollowsTheProbesOfP13) {
  const std::vector<RegionCase> cases{{{"+SC0.25", "+EC0.75"}, 2, 6, 0, 7},
                                      {{"+SC3.7", "+EC6.7"}, 2, 5, 0, 7},
                                      {{"+SC1", "+EC1"}, 0, 9, 0, 7},
                                      {{"+SC2", "+EC2"}, 1, 1, 0, 7},
                                      {{"+SR0.99"}, 0, 9, 7, 7},
                                      {{"+W200", "+H120", "+SC0.57", "+SR0.35"}, 113, 199, 41, 119},
                                      {{"+W100", "+H200", "+EC0.59", "+ER0.295"}, 0, 57, 0, 57}};
  for (const RegionCase& test : cases) {
    Options given = options({"+W10", "+H8"});
    for (const char* word : test.words) apply_argument(given, word);
    const Region got = region(given);
    EXPECT_EQ(got.first_column, test.first_column) << test.words[0];
    EXPECT_EQ(got.last_column, test.last_column) << test.words[0];
    EXPECT_EQ(got.first_row, test.first_row) << test.words[0];
    EXPECT_EQ(got.last_row, test.last_row) << test.words[0];
  }
  for (const char* bad : {"+EC0.05", "+EC0", "+EC11", "+SC11", "+SC-2"})
    EXPECT_THROW(region(options({"+W10", "+H8", bad})), OptionError) << bad;
  EXPECT_TRUE(region(options({"+W10", "+H8", "+SC6", "+EC3"})).empty());
}

}  // namespace
}  // namespace verisim::cli
