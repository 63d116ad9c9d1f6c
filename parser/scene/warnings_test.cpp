// Warnings that POV-Ray gives about statements it accepts; the texts are ours where they say the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "parser/parse.h"

namespace verisim::parser {
namespace {

std::vector<std::string> warnings(const std::string& scene) {
  std::vector<std::string> found;
  ParseOptions options;
  options.message = [&](const Diagnostic& d) { found.push_back(d.message); };
  parse_text(scene, "test.pov", options);
  return found;
}

std::vector<std::string> of_statement(const std::string& statement) {
  return warnings("#version 3.7; global_settings { assumed_gamma 1 }\n" + statement + "\nsphere { 5, 1 }");
}

using Texts = std::vector<std::string>;

TEST(Warnings, UselessBounds) {
  const std::string parts = "sphere { 0, 1 } box { 0, 1 }", bound = "bounded_by { sphere { 0, 2 } }";
  EXPECT_EQ(of_statement("union { " + parts + bound + "}"), Texts{"CSG union unnecessarily bounded."});
  EXPECT_EQ(of_statement("union { plane { y, 0 }" + parts + bound + "}"), Texts{});
  EXPECT_EQ(of_statement("union { " + parts + bound + "split_union off }"), Texts{});
  EXPECT_EQ(of_statement("merge { " + parts + bound + "}"), Texts{});
  EXPECT_EQ(of_statement("#declare U = union { " + parts + bound + "}"), Texts{});
  EXPECT_EQ(of_statement("torus { 1, .2 " + bound + "}"), Texts{"Unnecessary bounding object removed."});
  EXPECT_EQ(of_statement("union { sphere { 0, 1 } torus { 1, .2 " + bound + "} }"),
            Texts{"Unnecessary bounding object removed."});
  EXPECT_EQ(of_statement("intersection { sphere { 0, 1 } torus { 1, .2 " + bound + "} }"), Texts{});
  EXPECT_EQ(of_statement("union { sphere { 0, 1 } torus { 1, .2 " + bound + "} inverse }"), Texts{});
  EXPECT_EQ(of_statement("union { sphere { 0, 1 } torus { 1, .2 " + bound + "} clipped_by { plane { y, 0 } } }"),
            Texts{});
  // Only the outermost one of the frame.
  EXPECT_EQ(of_statement("union { sphere { 0, 1 " + bound + "} box { 0, 1 } " + bound + "}"),
            Texts{"CSG union unnecessarily bounded."});
  EXPECT_EQ(of_statement("union { sphere { 0, 1 " + bound + "} plane { y, 0 } " + bound + "}"), Texts{});
}

// Bounds of what has no automatic box are of use: mixed terms, and cones and hyperboloids of one sheet without clips.
TEST(Warnings, BoundsOfQuadrics) {
  const auto quadric = [](const std::string& terms, const std::string& modifiers) {
    return "quadric { " + terms + " bounded_by { sphere { 0, 3 } } " + modifiers + "}";
  };
  const Texts useless{"Unnecessary bounding object removed."};
  const std::string hyperboloid = "<1,-1,1>,<0,0,0>,<0,0,0>,-1", cone = "<1,1,-1>,<0,0,0>,<0,0,0>,0",
                    mixed = "<1,2,1>,<1,2,0>,<0,0,0>,-1", cylinder = "<1,0,1>,<0,0,0>,<0,0,0>,-1",
                    clip = "clipped_by { plane { y, 1 } }";
  for (const std::string& kept : {hyperboloid, cone, mixed}) {
    EXPECT_EQ(of_statement(quadric(kept, "")), Texts{}) << kept;
    EXPECT_EQ(of_statement(quadric(kept, "rotate 30")), Texts{}) << kept;
    EXPECT_EQ(of_statement(quadric(kept, "rotate 30 " + clip)), Texts{}) << kept;
  }
  for (const std::string& removed : {cylinder, std::string("<1,1,-1>,<0,0,0>,<0,0,0>,1"),
                                     std::string("<0,0,0>,<0,0,0>,<0,1,0>,0"), std::string("<1,1,1>,0,0,-1")})
    EXPECT_EQ(of_statement(quadric(removed, "")), useless) << removed;
  EXPECT_EQ(of_statement(quadric(cylinder, "rotate 30")), useless);
  EXPECT_EQ(of_statement(quadric(hyperboloid, clip)), useless);
  EXPECT_EQ(of_statement(quadric(hyperboloid, clip + " rotate 30")), useless);
  EXPECT_EQ(of_statement(quadric(mixed, clip)), Texts{});
  // A clip that is the bound is none.
  EXPECT_EQ(of_statement(quadric(hyperboloid, "clipped_by { bounded_by } rotate 30")), Texts{});
  EXPECT_EQ(of_statement("quadric { " + hyperboloid + " clipped_by { sphere { 0, 3 } } bounded_by { clipped_by } }"),
            useless);
}

// A text is a union of letters.
TEST(Warnings, UselessBoundsOfText) {
  const auto text = [](const std::string& modifiers) { return "text { internal 1 \"xy\" 0.5, 0 " + modifiers + "}"; };
  const std::string bound = "bounded_by { sphere { 0, 20 } }";
  const Texts useless{"CSG union unnecessarily bounded."};
  EXPECT_EQ(of_statement(text("")), Texts{});
  EXPECT_EQ(of_statement(text(bound)), useless);
  EXPECT_EQ(of_statement("union { " + text(bound) + " sphere { 0, 1 } }"), useless);
  EXPECT_EQ(of_statement("object { " + text("") + bound + "}"), useless);
  EXPECT_EQ(of_statement(text(bound + " inverse ")), Texts{});
  EXPECT_EQ(of_statement(text(bound + " split_union off ")), Texts{});
  EXPECT_EQ(of_statement(text(bound + " clipped_by { plane { y, 0 } }")), Texts{});
  EXPECT_EQ(of_statement("difference { " + text(bound) + " sphere { 0, 1 } }"), Texts{});
}

// Once a scene each.
TEST(Warnings, ExperimentalFeatures) {
  EXPECT_EQ(
      of_statement(
          "#for (I, 1, 3) sphere { 0, 1 finish { diffuse .5, .2 } } #end sphere { 0, 1 finish { diffuse .5, .2 } }"),
      Texts{"Diffuse reflection on the back is an experimental feature of POV-Ray."});
  EXPECT_EQ(of_statement("sphere { 0, 1 pigment { slope { y altitude y } } normal { slope { y altitude y } } }"),
            Texts{"A slope pattern with altitude is an experimental feature of POV-Ray."});
  EXPECT_EQ(of_statement("#declare F = finish { subsurface { translucency 1 } } #declare G = finish { subsurface { "
                         "translucency 2 } }"),
            Texts{"subsurface is an experimental feature of POV-Ray."});
  EXPECT_EQ(of_statement("#declare S = spline { 0, x 1, y } #declare T = spline { S 2, z }"),
            Texts{"Splines are an experimental feature of POV-Ray."});
  EXPECT_EQ(of_statement("sphere { 0, 1 pigment { slope y } finish { diffuse .5, 0 } }"), Texts{});
}

// Before 1.5 a texture may hold the items of its pigment, normal and finish.
TEST(Warnings, StrayItemsOfOldTextures) {
  const auto of_old_texture = [](const std::string& items) {
    Texts found = warnings("#version 1.0;\nsphere { 0, 1 texture { " + items + " } }\n");
    return Texts(found.begin(), found.end() - 2);  // about the gamma and the version
  };
  const auto belongs = [](const std::string& item, const std::string& block) {
    return "Found '" + item + "' that should be in a " + block + " statement.";
  };
  EXPECT_EQ(
      of_old_texture("marble turbulence .5 color_map { [0 1 color red 1 color blue 1] } phong 1 bumps .3 scale 3"),
      (Texts{belongs("marble", "pigment"), belongs("color_map", "pigment"), belongs("phong", "finish"),
             belongs("bumps", "normal")}));
  EXPECT_EQ(of_old_texture("color red 1 frequency 3 waves .2"),
            (Texts{belongs("color", "pigment"), belongs("frequency", "normal"), belongs("waves", "normal")}));
  EXPECT_EQ(of_old_texture("pigment { marble } normal { bumps } finish { phong 1 }"), Texts{});
}

// What was the way of writing it up to 1.5.
TEST(Warnings, OldFormsInOldScenes) {
  const auto of_version = [](const std::string& version, const std::string& scene) {
    Texts found = warnings("#version " + version + ";\n" + scene);
    std::erase_if(found, [](const std::string& text) {
      return text.find("assumed_gamma") != std::string::npos || text.find("language version") != std::string::npos;
    });
    return found;
  };
  const std::string quick = "sphere { 0, 1 color rgb 1 }", fog = "fog { color rgb 1 40 } sphere { 0, 1 }",
                    crand = "sphere { 0, 1 texture { .05 pigment { color red 1 } } }",
                    copy = "#declare S = sphere { 0, 1 } union { S }";
  const Texts warned_of_copy = {"Found 'object identifier' that should be in an object statement."};
  for (const std::string& scene : {quick, fog, crand}) EXPECT_EQ(of_version("1.0", scene), Texts{}) << scene;
  EXPECT_EQ(of_version("1.0", copy), warned_of_copy);
  EXPECT_EQ(of_version("1.5", quick), Texts{"Quick color belongs in texture. Color ignored."});
  for (const std::string& scene : {fog, crand, copy}) EXPECT_EQ(of_version("1.5", scene), Texts{}) << scene;
  EXPECT_EQ(of_version("2.0", fog), Texts{"Should use keyword 'distance' in a fog statement."});
  EXPECT_EQ(of_version("2.0", crand), Texts{"Should use crand keyword in finish statement."});
}

TEST(Warnings, CameraThatLooksAlongItsSky) {
  const auto warned = [](const std::string& version) {
    const Texts found =
        warnings("#version " + version + "; camera { location -6*y look_at 0 } sphere { 0, 1 pigment { rgb 1 } }");
    return std::ranges::any_of(found, [](const std::string& text) { return text.starts_with("Camera location"); });
  };
  EXPECT_FALSE(warned("3.1"));
  EXPECT_TRUE(warned("3.5"));
}

TEST(Warnings, TraceLevelsBelowOneAreTakenForOne) {
  EXPECT_EQ(of_statement("global_settings { max_trace_level 0 }"), Texts{});
  EXPECT_EQ(of_statement("global_settings { max_trace_level 300 }").size(), 1u);
}

TEST(Warnings, OpenPrisms) {
  EXPECT_EQ(of_statement("prism { 0, 1, 3, <0, 0>, <1, 0>, <0, 1> }"), Texts{"Linear prism not closed. Closing it."});
  EXPECT_EQ(of_statement("prism { 0, 1, 8, <0,0>, <1,0>, <0,1>, <0,0>, <.1,.1>, <.2,.1>, <.1,.2>, <.1,.1> }"), Texts{});
  EXPECT_EQ(of_statement("prism { bezier_spline 0, 1, 4, <0,0>, <1,0>, <0,1>, <.2,.2> }"),
            Texts{"Prism not closed. Ignoring it."});
}

TEST(Warnings, ZeroPower) {
  EXPECT_EQ(of_statement("#declare F = function(a) { a*pow(a - 1, 0) + 1 };"),
            Texts{"Zero power optimised to constant 1.0!"});
  EXPECT_EQ(of_statement("#declare F = function(a) { pow(a, (0)) };"), Texts{});
}

TEST(Warnings, DeprecatedNamesAreUndefinedWithAWarning) {
  EXPECT_EQ(of_statement("#declare deprecated \"old\" X = 1; #undef X"), Texts{"old"});
}

TEST(Warnings, EveryFinishItemOutsideOfAFinish) {
  const Texts found = warnings("#version 1.0; sphere { 0 1 texture { color red 1 phong 1 ambient .5 } }");
  ASSERT_GE(found.size(), 3u);
  EXPECT_NE(found[1].find("'phong'"), std::string::npos);
  EXPECT_NE(found[2].find("'ambient'"), std::string::npos);
}

// POV-Ray's, of flags in one statement and of such as reach the children of CSG (spec 07 3.2).
TEST(Warnings, OfPhotonFlagsThatTurnEachOtherOff) {
  const auto turned_off = [](const std::string& object) {
    std::string all;
    for (const std::string& text : of_statement(object))
      if (const auto at = text.find("Turning off "); at != std::string::npos) all += text.substr(at + 12);
    return all;
  };
  const auto box = [](const std::string& flags) { return "box { -1, 1 photons { " + flags + " } }"; };
  const auto in_union = [&box](const std::string& inner, const std::string& outer) {
    return "union { " + box(inner) + " sphere { 3, 1 } photons { " + outer + " } }";
  };
  EXPECT_EQ(turned_off(box("target refraction off pass_through")), "");
  EXPECT_EQ(turned_off(box("target refraction on pass_through")), "refraction.");
  EXPECT_EQ(turned_off(box("pass_through refraction off target")), "");
  EXPECT_EQ(turned_off(box("pass_through refraction on target")), "pass_through.");
  EXPECT_EQ(turned_off(box("pass_through target refraction on")), "refraction.pass_through.");
  EXPECT_EQ(turned_off(in_union("target", "pass_through")), "refraction.");
  EXPECT_EQ(turned_off(in_union("target refraction off", "pass_through")), "");
  EXPECT_EQ(turned_off(in_union("refraction on", "pass_through")), "");
  EXPECT_EQ(turned_off(in_union("pass_through refraction on", "target")), "pass_through.");
  EXPECT_EQ(turned_off(in_union("pass_through", "refraction off target")), "refraction.");
  EXPECT_EQ(turned_off(in_union("target", "refraction on pass_through")), "refraction.pass_through.");
}

}  // namespace
}  // namespace verisim::parser
