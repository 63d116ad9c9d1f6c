// Scenes reduced with a script in the place of POV-Ray and a function in the place of our renderer.
#include "compare/reduce/reduce.h"

#include "compare/regression/run_test_support.h"

namespace verisim::compare {
namespace {

// POV-Ray draws a torus brighter, refuses a lathe, crashes on a prism; we refuse a blob and crash on a text.
class Reduce : public RunTest {
 protected:
  Reduce() {
    script(root() / "pov",
           "if [ \"$1\" = --version ]; then echo 'POV-Ray 3.7.test'; exit 0; fi\n"
           "for a in \"$@\"; do case \"$a\" in +I*) in=\"${a#+I}\";; +O*) out=\"${a#+O}\";; esac; done\n"
           "if grep -q lathe $in; then echo \"File '$in' line 9: Parse Error: no lathe\" >&2; exit 1; fi\n"
           "if grep -q prism $in; then kill -SEGV $$; fi\n"
           "if grep -q torus $in; then cp " +
               (pictures() / "bright.png").string() + " $out; else cp " + (pictures() / "plain.png").string() +
               " $out; fi\n");
    options_of_.native = [this](const NativeRequest& request) { return ours(request); };
    options_of_.oracle = options_.oracle;
  }
  NativeResult ours(const NativeRequest& request) {
    ++native_runs_;
    std::ifstream in(request.scene);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    NativeResult out;
    if (text.find("text") != std::string::npos) {
      out.ending = NativeResult::Ending::by_signal, out.message = "killed by signal 11";
    } else if (text.find("blob") != std::string::npos) {
      out.message = request.scene.string() + ":7:1: error: no blob 'A'";
    } else if (text.find("polygon") != std::string::npos) {
      out.message = request.scene.string() + ":7:1: error: no polygon";
    } else {
      fs::copy_file(pictures() / "plain.png", request.output);
      out.outcome = NativeResult::Outcome::rendered;
    }
    return out;
  }
  Reduction reduced(const std::string& text) {
    scene("a.pov", text);
    return reduce_scene(suite().scenes[0], options_of_);
  }

  ReduceOptions options_of_;
};

const std::string kRest = "sphere { 0, 1 }\nbox { 0, 1 }\nplane { y, 0 }\n";

TEST_F(Reduce, APictureThatDiffers) {
  const Reduction r = reduced(kRest + "union { torus { 1, 0.2 } sphere { 0, 1 } }\n" + kRest);
  EXPECT_EQ(r.difference.kind, Difference::Kind::picture);
  EXPECT_EQ(r.text, "torus { }\n");
  EXPECT_EQ(r.lines_before, 10u);  // a statement a line
  EXPECT_EQ(r.lines, 1u);
  EXPECT_TRUE(r.complete);
  EXPECT_THAT(in_words(r.difference), HasSubstr("768 pixels differ"));
}

TEST_F(Reduce, WhatOnlyOneDraws) {
  const Reduction r = reduced(kRest + "lathe { 3 }\n" + kRest);
  EXPECT_EQ(r.difference.kind, Difference::Kind::only_verisim);
  EXPECT_EQ(r.text, "lathe { }\n");
  EXPECT_THAT(in_words(r.difference), HasSubstr("no lathe"));
}

TEST_F(Reduce, ARefusalIsNotTakenForAnother) {
  const Reduction r = reduced("polygon { 3 }\n" + kRest + "blob { 3 }\n");
  EXPECT_EQ(r.difference.kind, Difference::Kind::only_povray);
  EXPECT_EQ(r.text, "blob { }\n");  // which is named first; without it the polygon is
}

// Boxes at 0.3 differ in one pixel; rounded to 0 they would in all.
TEST_F(Reduce, RounderNumbersDoNotShowAnotherDifference) {
  Picture one = image::read_picture(pictures() / "plain.png");
  one.samples[0] = one.samples[0] > 0.5f ? 0.2f : 0.8f;
  image::write_picture(one, pictures() / "one.png");
  script(root() / "pov",
         "if [ \"$1\" = --version ]; then echo 'POV-Ray 3.7.test'; exit 0; fi\n"
         "for a in \"$@\"; do case \"$a\" in +I*) in=\"${a#+I}\";; +O*) out=\"${a#+O}\";; esac; done\n"
         "p=plain; grep -q 'box.*0\\.3' $in && p=one; grep -q 'box { 0' $in && p=bright; grep -q 'box { 0\\.3' $in && "
         "p=one\n"
         "cp " +
             pictures().string() + "/$p.png $out\n");
  EXPECT_EQ(reduced(kRest.substr(0, kRest.find("box")) + "box { 0.3125 }\n").text, "box { 0.3 }\n");
}

TEST_F(Reduce, Crashes) {
  EXPECT_EQ(reduced(kRest + "text { 3 }\n" + kRest).text, "text { }\n");
  const Reduction r = reduced(kRest + "prism { 3 }\n" + kRest);
  EXPECT_EQ(r.difference.kind, Difference::Kind::povray_crashes);
  EXPECT_EQ(r.text, "prism { }\n");
}

// Both draw the same, and one of them warns of a lathe with three points.
TEST_F(Reduce, WhatOnlyOneWarnsOf) {
  options_of_.native = [this](const NativeRequest& request) {
    NativeResult out = ours(request);
    std::ifstream in(request.scene);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    if (text.find("cone { 3") != std::string::npos) out.console = "a.pov:3:1: warning: Three are few. [few]\n  3 | x\n";
    if (text.find("#debug") != std::string::npos) out.console += "one\n";
    return out;
  };
  const Reduction r = reduced(kRest + "union { cone { 3 } sphere { 0, 1 } }\n" + kRest);
  EXPECT_EQ(r.difference.kind, Difference::Kind::verisim_warns);
  EXPECT_EQ(r.text, "cone { 3 }\n");
  EXPECT_EQ(in_words(r.difference), "only verisim warns: Three are few.");
  EXPECT_EQ(reduced(kRest + "#debug \"one\\n\"\n").difference.kind, Difference::Kind::none);  // POV-Ray is silent
}

TEST_F(Reduce, NothingWhereBothAgree) {
  const Reduction r = reduced(kRest);
  EXPECT_EQ(r.difference.kind, Difference::Kind::none);
  EXPECT_EQ(r.tried, 0u);
}

TEST_F(Reduce, NothingWhereBothRefuse) {
  const Reduction r = reduced(kRest + "lathe { 3 }\npolygon { 3 }\n");
  EXPECT_EQ(r.difference.kind, Difference::Kind::none);
  EXPECT_THAT(r.difference.message, HasSubstr("no lathe"));
}

TEST_F(Reduce, IncludeFilesBesideTheScene) {
  scene("shapes/part.inc", kRest + "torus { 1, 0.2 }\n");
  const Reduction r = reduced("#include \"shapes/part.inc\"\n" + kRest);
  EXPECT_EQ(r.difference.kind, Difference::Kind::none);  // this POV-Ray reads no include files
  scene("b.inc", kRest);
  EXPECT_EQ(reduced("#include \"b.inc\"\ntorus { 1, 0.2 }\n").text, "torus { }\n");
}

TEST_F(Reduce, TheSceneIsLeftAsItIs) {
  const std::string text = kRest + "torus { 1, 0.2 }\n";
  reduced(text);
  std::ifstream in(root() / "scenes/a.pov");
  EXPECT_EQ(std::string((std::istreambuf_iterator<char>(in)), {}), text);
}

TEST_F(Reduce, CancelEndsItWithTheBestSoFar) {
  std::atomic<bool> cancel = false;
  options_of_.cancel = &cancel;
  int told = 0;
  options_of_.progress = [&](const ReduceProgress& p) {
    if (++told == 2) cancel = true;
    EXPECT_EQ(p.lines_before, 61u);
  };
  std::string many;
  for (int i = 0; i < 20; ++i) many += kRest;
  const Reduction r = reduced(many + "union { torus { 1, 0.25 } }\n");
  EXPECT_FALSE(r.complete);
  EXPECT_LT(r.lines, 61u);
  EXPECT_THAT(r.text, HasSubstr("torus { 1, 0.25 }"));
}

TEST_F(Reduce, TimeIsShort) {
  options_of_.native = [this](const NativeRequest& request) {
    usleep(20'000);
    return ours(request);
  };
  options_of_.seconds = 1;
  std::string many;
  for (int i = 0; i < 200; ++i) many += "union { sphere { 0, 1.5 } box { 0.25, " + std::to_string(i) + " } }\n";
  const Reduction r = reduced(many + "union { torus { 1, 0.25 } }\n" + many);
  EXPECT_LT(r.seconds, 4);
  EXPECT_THAT(r.text, HasSubstr("torus"));
}

TEST(Differences, OfPictures) {
  const Picture a = scene_like_picture(32, 24);
  EXPECT_EQ(picture_difference(a, a).kind, Difference::Kind::none);
  Picture b = a;
  const std::size_t at = (5 * 32 + 7) * static_cast<std::size_t>(a.channels);
  b.samples[at] = a.samples[at] > 0.5f ? a.samples[at] - 0.4f : a.samples[at] + 0.4f;
  const Difference d = picture_difference(a, b);
  EXPECT_EQ(d.kind, Difference::Kind::picture);
  EXPECT_EQ(d.pixels, 1u);
  EXPECT_NEAR(d.largest, 102, 1);
  EXPECT_EQ(d.x, 7);
  EXPECT_EQ(d.y, 5);
}

TEST(Differences, AFewPixelsDoNotTakeThePlaceOfMany) {
  using Kind = Difference::Kind;
  const auto of = [](std::size_t pixels, double largest) { return Difference{Kind::picture, pixels, 1, largest, {}}; };
  EXPECT_TRUE(same_difference(of(1, 40), of(1, 90)));
  EXPECT_TRUE(same_difference(of(4000, 40), of(15, 90)));
  EXPECT_FALSE(same_difference(of(4000, 40), of(14, 90)));
  EXPECT_FALSE(same_difference(of(40, 2), of(40, 200)));
  EXPECT_FALSE(same_difference(of(40, 200), Difference()));
  const auto refused = [](const char* words) { return Difference{Kind::only_verisim, 0, 1, 0, words}; };
  EXPECT_TRUE(same_difference(refused("POV-Ray: exit status 1: File 'a.pov' line 3: Parse Error: No 'x' 3"),
                              refused("POV-Ray: exit status 1: File 'b.pov' line 77: Parse Error: No 'yy' 4")));
  EXPECT_FALSE(same_difference(refused("Parse Error: No camera"), refused("Parse Error: No light")));
}

}  // namespace
}  // namespace verisim::compare
