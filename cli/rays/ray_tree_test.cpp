// What is told of a pixel adds up to its colour, and is drawn where it happens.
#include "cli/rays/ray_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <ostream>

#include "cli/rays/ray_drawing.h"
#include "parser/parse.h"
#include "tracer/render/explain.h"

namespace verisim::cli {
namespace {

using Json = nlohmann::json;

constexpr const char* kStart = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, 0.5, 0> } light_source { <5, 8, -6> rgb 1 }
)";

constexpr int kWidth = 16, kHeight = 12;

std::vector<Json> trees(const std::string& text) {
  parser::ParseOptions options;
  options.width = kWidth, options.height = kHeight;
  const parser::ParseResult parsed = parser::parse_text(kStart + text, "scene.pov", options);
  if (!parsed.scene) {
    ADD_FAILURE() << (parsed.errors.empty() ? "no scene" : parsed.errors[0].message);
    return {};
  }
  render::Options render;
  render.width = kWidth, render.height = kHeight, render.threads = 1;
  render::Explainer explainer(*parsed.scene, render);
  std::vector<Json> all;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      RayTree tree;
      explainer.pixel(x, y, tree);
      all.push_back(tree.json()["rays"]);
    }
  return all;
}

// Every ray of the trees; true when one of them has a term of this name.
bool adds_up(const Json& rays, const std::string& term) {
  bool found = false;
  for (const Json& ray : rays) {
    if (ray["kind"] == "cut off") continue;
    for (int c = 0; c < 3; ++c) {
      double sum = 0, size = 0;
      for (const Json& part : ray["sum"]) {
        sum += part["adds"][c].get<double>(), size += std::fabs(part["adds"][c].get<double>());
        const std::string what = part["what"];
        found = found || what.starts_with(term);
        EXPECT_NE(what, "not told apart") << ray.dump(1);
      }
      EXPECT_NEAR(sum, ray["color"][c].get<double>(), 1e-6 + 1e-5 * size) << ray.dump(1);
    }
    if (adds_up(ray["rays"], term)) found = true;
  }
  return found;
}

struct Case {
  const char *term, *scene;
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.term; }
};
class Sum : public testing::TestWithParam<Case> {};

TEST_P(Sum, IsTheColourOfEveryRay) {
  bool found = false;
  for (const Json& rays : trees(GetParam().scene)) found = adds_up(rays, GetParam().term) || found;
  EXPECT_TRUE(found) << "no ray has it";
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Sum,
    testing::Values(
        Case{"own light", "sphere { 0, 1.5 pigment { rgb 1 } finish { ambient 0.3 } }"},
        Case{"diffuse", "sphere { 0, 1.5 pigment { rgb 1 } }"},
        Case{"highlight", "sphere { 0, 1.5 pigment { rgb <1, 0.5, 0> } finish { phong 0.8 specular 0.5 metallic } }"},
        Case{"reflected",
             "plane { y, 0 pigment { rgb 1 } finish { reflection { 0.2, 0.8 exponent 0.7 metallic } } } background { "
             "rgb 1 }"},
        Case{"refracted",
             "sphere { 0, 1.5 pigment { rgbf <1, 0.8, 0.6, 0.9> } interior { ior 1.4 fade_distance 1 fade_power 2 } "
             "finish { reflection { 0, 1 fresnel } conserve_energy } } plane { z, 5 pigment { checker rgb 1 rgb 0 } }"},
        Case{"refracted",
             "sphere { 0, 1.5 pigment { rgbt 0.9 } interior { ior 1.4 dispersion 1.05 } } background { rgb 1 }"},
        Case{"transmitted",
             "box { -1, 1 texture { pigment { checker rgbt <1, 0, 0, 0.5> rgbt <0, 1, 0, 0.7> } } texture { pigment { "
             "rgbt <0, 0, 1, 0.5> } finish { specular 0.5 } } } background { rgb 1 }"},
        Case{"own light",
             "sphere { 0, 1.5 texture { gradient y texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb x } finish { "
             "ambient 1 }] } } }"},
        Case{"diffuse",
             "blob { threshold 0.5 sphere { -x, 1.5, 1 texture { pigment { rgb x } } } sphere { x, 1.5, 1 texture { "
             "pigment { rgb y } } } }"},
        Case{"fog and media",
             "fog { distance 5 rgbt <0.5, 0.6, 0.7, 0.2> } sphere { 0, 1.5 pigment { rgb 1 } finish { reflection 0.5 } "
             "}"},
        Case{"fog and media",
             "sphere { 0, 1.5 pigment { rgbt 1 } hollow interior { media { emission 0.3 absorption 0.1 } } } plane { "
             "z, 5 hollow pigment { rgb 1 } }"},
        Case{"sky", "sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb z] } } }"},
        Case{"radiosity",
             "global_settings { radiosity { count 20 } } sphere { 0, 1.5 pigment { rgb 1 } } plane { y, -1 pigment { "
             "rgb x } }"},
        Case{"photons",
             "global_settings { photons { count 2000 } } sphere { <0, 2, 0>, 0.7 pigment { rgbf 1 } interior { ior 1.5 "
             "} photons { target refraction on } } plane { y, -1 pigment { rgb 1 } }"}));

TEST(RayDrawing, TheRaysLieWhereTheyAre) {
  const std::vector<Json> all = trees("sphere { 0, 1.5 pigment { rgb 1 } finish { reflection 0.5 } }");
  const Json& rays = all[kWidth * kHeight / 2 + kWidth / 2];
  const std::vector<Vec3> points = points_of(rays);
  ASSERT_EQ(points.size(), 4u);  // from the eye to the sphere, from there to the sky
  EXPECT_NEAR(length(points[1]), 1.5, 1e-9);
  for (const double azimuth : {0.0, 90.0, 200.0})
    for (const double elevation : {-90.0, 0.0, 25.0, 90.0}) {
      const Viewpoint view = viewpoint_of(points, azimuth, elevation, 400, 300);
      EXPECT_NEAR(dot(view.right, view.up), 0, 1e-12);
      EXPECT_NEAR(length(view.up), 1, 1e-12);
      for (const Vec3& p : points) {
        const Vec2 at = view.project(p, 400);
        EXPECT_TRUE(at.x > 0 && at.x < 400 && at.y > 0 && at.y < 300) << azimuth << " " << elevation;
        EXPECT_GT(dot(p - view.center, view.forward), view.near);
      }
    }
  const Viewpoint front = viewpoint_of(points, 0, 0, 400, 300);
  EXPECT_NEAR(length(front.forward - Vec3(0, 0, 1)), 0, 1e-12);  // along +z, x to the right
  EXPECT_NEAR(length(front.right - Vec3(1, 0, 0)), 0, 1e-12);
  const std::string svg = ray_svg(rays, front, {400, 300, "", true});
  EXPECT_NE(svg.find("class=\"ray camera\""), std::string::npos);
  EXPECT_NE(svg.find("class=\"ray reflected\""), std::string::npos);
  EXPECT_NE(svg.find("class=\"ray lit\""), std::string::npos);
}

// Each ray of a tree and each way to a light that counts is one line of its kind.
void count(const Json& rays, std::map<std::string, int>& kinds) {
  for (const Json& ray : rays) {
    if (ray["kind"] == "cut off") continue;
    ++kinds[ray["kind"]];
    if (!ray["layers"].empty())
      for (const Json& light : ray["layers"][0]["lights"])
        if (light["state"] == "lit" || light["state"] == "shadow") ++kinds[light["state"]];
    count(ray["rays"], kinds);
  }
}

TEST(RayDrawing, TheLecturesTreesAreDrawnWhole) {
  struct Place {
    const char* scene;
    int x, y, width, height;
  };
  for (const Place& p : {Place{"orthographic_casting", 0, 0, 1, 5}, Place{"orthographic_casting", 0, 1, 1, 5},
                         Place{"orthographic_casting", 0, 2, 1, 5}, Place{"orthographic_casting", 0, 3, 1, 5},
                         Place{"orthographic_casting", 0, 4, 1, 5}, Place{"three_levels", 2, 2, 8, 4},
                         Place{"three_levels", 5, 2, 8, 4}, Place{"glass_ball", 190, 200, 480, 360}}) {
    parser::ParseOptions options;
    options.width = p.width, options.height = p.height;
    const parser::ParseResult parsed =
        parser::parse_file(std::string(VERISIM_SOURCE_DIR "/scenes/lecture/") + p.scene + ".pov", options);
    ASSERT_TRUE(parsed.scene) << p.scene;
    render::Options render;
    render.width = p.width, render.height = p.height, render.threads = 1;
    RayTree tree;
    render::Explainer(*parsed.scene, render).pixel(p.x, p.y, tree);
    const Json rays = tree.json()["rays"];
    std::map<std::string, int> kinds;
    count(rays, kinds);
    const std::string svg = ray_svg(rays, viewpoint_of(points_of(rays), 30, 25, 480, 360), {480, 360, "", true});
    for (const auto& [kind, number] : kinds) {
      int drawn = 0;
      const std::string element = "<line class=\"ray " + kind + "\"";
      for (std::size_t at = svg.find(element); at != std::string::npos; at = svg.find(element, at + 1)) ++drawn;
      EXPECT_EQ(drawn, number) << p.scene << ": " << kind;
    }
    EXPECT_GE(kinds["camera"], 1);
  }
}

}  // namespace
}  // namespace verisim::cli
