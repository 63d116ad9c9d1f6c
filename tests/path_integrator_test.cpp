// The path integrator against scenes whose answer is known in closed form: furnaces, form factors, exponential
// attenuation.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "tests/support/probe.h"

namespace verisim::test {
namespace {

render::Options paths(int samples) {
  render::Options options;
  options.path_samples = samples;
  return options;
}

const std::string kHeader = "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 20 }\n";
// Looks straight down at the origin from 0.5 above it.
const std::string kDown = "camera { orthographic location <0,0.5,0> right x*0.001 up z*0.001 direction -y }\n";

Rgb mean(const render::Framebuffer& picture) {
  double sum[3] = {};
  for (const render::PixelColor& c : picture.pixels) sum[0] += c.r, sum[1] += c.g, sum[2] += c.b;
  const auto n = static_cast<double>(picture.pixels.size());
  return {static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n), static_cast<float>(sum[2] / n)};
}

struct Known {
  std::string name, scene;
  double expected;
  int samples = 4096;
};
void PrintTo(const Known& k, std::ostream* out) { *out << k.name; }

class PathIntegrator : public testing::TestWithParam<Known> {};

TEST_P(PathIntegrator, EqualsTheClosedForm) {
  const Known& known = GetParam();
  const Rgb value = mean(render_text(kHeader + known.scene, 8, 8, paths(known.samples)));
  EXPECT_NEAR(value.g, known.expected, 0.005 * known.expected);
}

const std::string kFloor = kDown + "plane { y,0 pigment { rgb 1 } finish { ambient 0 diffuse 0.8 } }\n";
const std::string kShine = "pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 }";

// A furnace: every surface emits e and reflects the share r, so that e / (1 - r) is seen everywhere.
INSTANTIATE_TEST_SUITE_P(Furnace, PathIntegrator,
                         testing::Values(Known{"box",
                                               "camera { location <0,1,-0.9> look_at <0,1,0> } box { <-1,0,-1>,<1,2,1> "
                                               "pigment { rgb 1 } finish { diffuse 0.7 ambient 0 emission 0.1 } }",
                                               0.1 / 0.3},
                                         Known{"bright_sphere",
                                               "camera { location 0.3*x look_at y } sphere { 0,1 pigment { rgb 1 } "
                                               "finish { diffuse 0.9 ambient 0 emission 0.05 } }",
                                               0.5},
                                         Known{"brilliance",
                                               "camera { location 0 look_at y } sphere { 0,1 pigment { rgb 1 } finish "
                                               "{ diffuse albedo 0.5 brilliance 3 ambient 0 emission 0.1 } }",
                                               0.1 / (1 - 0.5)},
                                         Known{"box_with_ball",
                                               "camera { location <0,1,-0.9> look_at <0,1,0> } union { box { "
                                               "<-1,0,-1>,<1,2,1> } sphere { <0.3,0.5,0.2>,0.4 } pigment { rgb 1 } "
                                               "finish { diffuse 0.6 ambient 0 emission 0.1 } }",
                                               0.25}),
                         [](const auto& p) { return p.param.name; });

// Form factors of a small patch of floor (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-13,
// B-32, B-4).
INSTANTIATE_TEST_SUITE_P(
    FormFactor, PathIntegrator,
    testing::Values(
        Known{"disc_above", kFloor + "disc { 2*y,y,1 " + kShine + " }", 0.8 / 5},
        Known{"sphere_above", kFloor + "sphere { 3*y,1 " + kShine + " }", 0.8 / 9},
        Known{"sphere_aside", kFloor + "sphere { <4,3,0>,1 " + kShine + " }", 0.8 * 0.6 / 25},
        Known{"sphere_not_aimed_at", kFloor + "intersection { sphere { 3*y,1 } sphere { 3*y,2 } " + kShine + " }",
              0.8 / 9, 65536},
        Known{"box_turned", kFloor + "box { <-1,0,-1>,<1,0.001,1> rotate y*30 translate 2*y " + kShine + " }",
              0.8 * 4 * (2 / 3.14159265358979) * (0.5 / std::sqrt(1.25)) * std::atan(0.5 / std::sqrt(1.25)) / 2 * 1.0},
        Known{"triangles",
              kFloor + "union { triangle { <-1,2,-1>,<1,2,-1>,<1,2,1> } triangle { <-1,2,-1>,<1,2,1>,<-1,2,1> } " +
                  kShine + " }",
              0.8 * 4 * (2 / 3.14159265358979) * (0.5 / std::sqrt(1.25)) * std::atan(0.5 / std::sqrt(1.25)) / 2},
        Known{"under_clear_sheet",
              kFloor + "disc { 2*y,y,1 " + kShine +
                  " } box { <-9,1,-9>,<9,1.1,9> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }",
              0.8 / 5},
        Known{"sky", kFloor + "background { rgb 0.5 }", 0.4}),
    [](const auto& p) { return p.param.name; });

const std::string kThrough = "camera { orthographic location <0.003,0.002,-5> right x*0.001 up y*0.001 direction z }\n";
const std::string kClearHollow = " hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 } ";
const std::string kShiningWall = "plane { -z,-3 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }\n";

INSTANTIATE_TEST_SUITE_P(
    Media, PathIntegrator,
    testing::Values(
        Known{"absorption",
              kThrough + kShiningWall + "box { -1,1" + kClearHollow + "interior { media { absorption 0.5 } } }",
              std::exp(-1.0)},
        Known{"emission",
              kThrough + "plane { -z,-3 pigment { rgb 0 } finish { ambient 0 } } box { -1,1" + kClearHollow +
                  "interior { media { emission 0.1 absorption 0.5 } } }",
              0.2 * (1 - std::exp(-1.0))},
        Known{"ramp",
              kThrough + kShiningWall + "box { -1,1" + kClearHollow +
                  "interior { media { absorption 0.5 density { gradient z color_map { [0 rgb 0] [1 rgb 1] } scale 2 "
                  "translate -z } } } }",
              std::exp(-0.5)},
        // A wall all around, as bright everywhere: scattering changes nothing.
        Known{"white_furnace",
              "camera { location 0 look_at z } sphere { 0,5 " + kShine + " } sphere { 0,2" + kClearHollow +
                  "interior { media { scattering { 1,1 } } } }",
              1},
        Known{"white_furnace_forward",
              "camera { location 0 look_at z } sphere { 0,5 " + kShine + " } sphere { 0,2" + kClearHollow +
                  "interior { media { scattering { 5,1 eccentricity 0.6 } } } }",
              1},
        Known{"white_furnace_haze",
              "camera { location 0 look_at z } sphere { 0,5 " + kShine + " } sphere { 0,2" + kClearHollow +
                  "interior { media { scattering { 2,1 } } } }",
              1},
        // POV-Ray's light sources light a medium without extinction by S k I over the length (spec 07, P-M5).
        Known{"single_scattering",
              kThrough +
                  "light_source { <0.003,0.002,-3> rgb 1 } plane { -z,-3 pigment { rgb 0 } finish { ambient 0 } } box "
                  "{ -1,1" +
                  kClearHollow + "interior { media { scattering { 1,0.1 extinction 0 } } } }",
              0.2}),
    [](const auto& p) { return p.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Clear, PathIntegrator,
    testing::Values(
        // Glass that loses nothing cannot be seen in a uniform environment, and neither can a perfect mirror.
        Known{"glass",
              "camera { location -3*z look_at 0 angle 30 } background { rgb 0.5 } sphere { 0,1 pigment { rgbt 1 } "
              "interior { ior 1.5 } "
              "finish { ambient 0 diffuse 0 reflection { 0,1 fresnel } conserve_energy } }",
              0.5},
        Known{"mirror",
              "camera { location -3*z look_at 0 angle 30 } background { rgb 0.5 } sphere { 0,1 pigment { rgb 1 } "
              "finish { ambient 0 diffuse 0 reflection 1 } }",
              0.5},
        // Light sources are POV-Ray's: intensity times cosine.
        Known{"point_light", kFloor + "light_source { <0,0.4,0.3> rgb 1 shadowless }", 0.8 * 0.8, 16},
        // A highlight's lobe has the albedo 2 k / (n + 1) about any direction that keeps it above the surface.
        Known{"phong_in_furnace",
              kDown + "plane { y,0 pigment { rgb 0 } finish { ambient 0 diffuse 0 phong 0.5 phong_size 40 } } "
                      "background { rgb 1 }",
              0.5 * 2 / 41.0}),
    [](const auto& p) { return p.param.name; });

const char* const kPathScene =
    "camera { location <0,1,-3> look_at <0,0.5,0> } light_source { <2,3,-2> rgb 1 area_light x,z,3,3 } background { "
    "rgb 0.2 } plane { y,0 pigment { rgb 0.7 } }"
    "sphere { <0,0.5,0>,0.5 pigment { rgbt 1 } interior { ior 1.4 dispersion 1.05 media { scattering { 1,0.3 } } } "
    "hollow finish { reflection { 0,1 fresnel } conserve_energy } }"
    "box { <-2,2,-1>,<-1,2.1,0> pigment { rgb 1 } finish { emission 3 } }";

TEST(PathIntegrator, IsTheSameForAnyNumberOfThreads) {
  render::Options options = paths(4);
  options.block_size = 8;
  options.threads = 1;
  const auto one = render_text(kHeader + kPathScene, 48, 36, options);
  for (const int threads : {2, 5}) {
    options.threads = threads;
    const auto many = render_text(kHeader + kPathScene, 48, 36, options);
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
      ASSERT_EQ(one.pixels[i].r, many.pixels[i].r) << threads << " threads, pixel " << i;
      ASSERT_EQ(one.pixels[i].b, many.pixels[i].b) << threads << " threads, pixel " << i;
    }
  }
  options.seed = 1;
  EXPECT_NE(render_text(kHeader + kPathScene, 48, 36, options).at(24, 30).r, one.at(24, 30).r);
}

TEST(PathIntegrator, CanBeCancelled) {
  std::atomic<bool> cancel{false};
  render::Options options = paths(1 << 20);  // would take minutes
  options.threads = 2;
  options.block_size = 4;
  options.cancel = &cancel;
  int calls = 0;
  options.progress = [&](double) {
    ++calls;
    cancel = true;
  };
  options.block_done = {};
  options.path_samples = 4096;
  const auto picture = render_text(kHeader + kPathScene, 64, 64, options);
  EXPECT_GE(calls, 1);
  EXPECT_LT(std::count(picture.done.begin(), picture.done.end(), 1), 64 * 64);
}

TEST(PathIntegrator, RefusesByNameWhatHasNoMeaning) {
  const auto message = [](const std::string& scene) {
    try {
      render_text(kHeader + scene, 4, 4, paths(1));
    } catch (const render::Unsupported& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(message("global_settings { subsurface { } } sphere { 0,1 pigment { rgb 1 } finish { subsurface { "
                    "translucency 1 } } }")
                .find("subsurface"),
            std::string::npos);
  EXPECT_NE(
      message("sphere { 0,1 pigment { rgb 1 } finish { reflection { 0.5 exponent 2 } } }").find("reflection exponent"),
      std::string::npos);
}

}  // namespace
}  // namespace verisim::test
