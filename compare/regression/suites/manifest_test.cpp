// Suites of folders and manifests, and what is chosen of them.
#include <fmt/format.h>

#include "compare/regression/run_test_support.h"

namespace verisim::compare {
namespace {

Filter chosen(std::vector<std::string> names, std::vector<std::string> tags) {
  Filter f;
  f.names = std::move(names), f.tags = std::move(tags);
  return f;
}

TEST_F(RunTest, SuiteOfAPlainFolder) {
  scene("b.pov", ""), scene("a/z.pov", ""), scene("a/note.txt", ""), scene(".hidden/x.pov", "");
  std::vector<std::string> names;
  for (const SceneRequest& s : suite().scenes) names.push_back(s.name);
  EXPECT_THAT(names, ElementsAre("a/z.pov", "b.pov"));
  EXPECT_THAT(load_suite({pictures()}).warnings, ElementsAre(HasSubstr("no scene")));
  EXPECT_THROW(load_suite({root() / "nothing.pov"}), std::runtime_error);
}

TEST_F(RunTest, ManifestSetsDefaultsAndScenes) {
  scene("one.pov", ""), scene("set/two.pov", ""), scene("set/three.pov", "");
  write(root() / "scenes/verisim.toml", R"(
width = 64
switches = "+A0.3 'Declare=x=1'"
tags = ["all"]
[[scene]]
file = "one.pov"
name = "first"
height = 48
class = "stochastic"
[[scene]]
file = "set/*.pov"
tags = ["set"]
switches = ["-A"]
thresholds = { max_rmse = 1.5, min_ssim_mean = 0.9 }
pixels_per_degree = 40
)");
  const Suite s = suite();
  ASSERT_EQ(s.scenes.size(), 3u);
  EXPECT_EQ(s.scenes[0].name, "first");
  EXPECT_EQ(s.scenes[0].width, 64);
  EXPECT_EQ(s.scenes[0].height, 48);
  EXPECT_THAT(s.scenes[0].switches, ElementsAre("+A0.3", "Declare=x=1"));
  EXPECT_TRUE(s.scenes[0].antialiased());
  EXPECT_EQ(s.scenes[0].scene_class, SceneClass::stochastic);
  EXPECT_EQ(s.scenes[1].name, "set/three.pov");
  EXPECT_DOUBLE_EQ(s.scenes[1].thresholds.at("max_rmse"), 1.5);
  EXPECT_DOUBLE_EQ(s.scenes[2].flip_pixels_per_degree, 40);
  const auto names = [&](const Filter& f) {
    std::vector<std::string> out;
    for (const SceneRequest& r : filter(s, f).scenes) out.push_back(r.name);
    return out;
  };
  EXPECT_THAT(names(chosen({}, {"set"})), ElementsAre("set/three.pov", "set/two.pov"));
  EXPECT_THAT(names(chosen({"*two*"}, {})), ElementsAre("set/two.pov"));
  EXPECT_THAT(names(chosen({"irs"}, {"all"})), ElementsAre("first"));
}

TEST_F(RunTest, ManifestErrorsHaveTheirPlace) {
  scene("one.pov", "");
  const auto message = [&](const std::string& text) -> std::string {
    write(root() / "scenes/verisim.toml", text);
    try {
      suite();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message("width = \n"), HasSubstr("verisim.toml:1:"));
  EXPECT_THAT(message("\nwitdh = 3\n"), testing::AllOf(HasSubstr(":2:"), HasSubstr("unknown key 'witdh'")));
  EXPECT_THAT(message("width = \"3\"\n"), HasSubstr("'width' must be a whole number"));
  EXPECT_THAT(message("width = 0\n"), HasSubstr("between 1 and"));
  EXPECT_THAT(message("class = \"random\"\n"), HasSubstr("'class' must be"));
  EXPECT_THAT(message("thresholds = {max_rsme = 1}\n"), HasSubstr("max_rsme"));
  EXPECT_THAT(message("switches = \"'open\"\n"), HasSubstr("quote"));
  EXPECT_THAT(message("[[scene]]\nname = \"x\"\n"), HasSubstr("needs 'file'"));
  EXPECT_THAT(message("[[scene]]\nfile = \"none.pov\"\n"), HasSubstr("none.pov"));
  EXPECT_THAT(message("[[scene]]\nfile = \"none*.pov\"\n"), HasSubstr("no scene is named"));
  EXPECT_THAT(message("scene = 3\n"), HasSubstr("[[scene]]"));
  EXPECT_THAT(message("[[scene]]\nfile = \"one.pov\"\npasses = [{ switches = \"-A\" }]\n"),
              HasSubstr("needs a 'matrix'"));
  EXPECT_THAT(message("[[scene]]\nfile = \"one.pov\"\npasses = [{ matrix = [[1, 2], [3, 4]] }]\n"),
              HasSubstr("three rows of three numbers"));
  EXPECT_THAT(message("width = 3\n\u00e9 = 1\n"),
              testing::AllOf(HasSubstr("verisim.toml:2:1:"), HasSubstr("saw '\u00e9'")));
  // Where toml++ 3.3 asks whether a letter is a blank.
  for (const char* letter : {"\u0499", "\u2c60", "\u3041", "\ufc30", "\ufef7"})
    EXPECT_THAT(message(std::string("width") + letter + " = 1\n"), HasSubstr("verisim.toml:1:6:")) << letter;
  EXPECT_EQ(message("width = 40\n"), "no error");
}

}  // namespace
}  // namespace verisim::compare
