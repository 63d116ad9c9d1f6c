// What a light adds to a pixel is what the pixel has less without that light: in fog and behind media, too.
#include "cli/describe/contributions.h"

#include <gtest/gtest.h>

#include "parser/parse.h"
#include "tracer/render/explain.h"

namespace verisim::cli {
namespace {

constexpr int kSize = 8;

struct Told {
  std::vector<Color> colors;
  std::vector<compare::PixelTags::Part> parts;
};
Told told(const std::string& text) {
  parser::ParseOptions options;
  options.width = options.height = kSize;
  const parser::ParseResult parsed = parser::parse_text(text, "scene.pov", options);
  Told out;
  if (!parsed.scene) {
    ADD_FAILURE() << (parsed.errors.empty() ? "no scene" : parsed.errors[0].message);
    return out;
  }
  render::Options render;
  render.width = render.height = kSize, render.threads = 1;
  render::Explainer explainer(*parsed.scene, render);
  Contributions witness("air");
  for (int i = 0; i < kSize * kSize; ++i) {
    out.colors.push_back(explainer.pixel(i % kSize, i / kSize, witness));
    witness.take();
  }
  out.parts = witness.parts();
  return out;
}

class LightInAir : public testing::TestWithParam<const char*> {};

TEST_P(LightInAir, IsWhatThePictureHasLessWithoutIt) {
  const std::string scene = std::string(R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, 0.5, 0> } light_source { <-5, 8, -6> rgb 0.5 }
sphere { 0, 1.5 pigment { rgb 1 } finish { phong 0.5 reflection 0.2 } } plane { y, -1 pigment { rgb <1, 0.5, 0.2> } }
)") + GetParam();
  const Told with = told(scene + "light_source { <5, 8, -6> rgb <1, 0.8, 0.6> }"), without = told(scene);
  const auto light = std::find_if(with.parts.begin(), with.parts.end(), [](const compare::PixelTags::Part& part) {
    return part.kind == "light" && part.name.find("at <5, 8, -6>") != std::string::npos;
  });
  ASSERT_NE(light, with.parts.end());
  int lit = 0;
  for (std::size_t i = 0; i < with.colors.size(); ++i) {
    const Rgb less = with.colors[i].rgb() - without.colors[i].rgb();
    lit += less.max_abs() > 0.01f;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(light->light[3 * i + k], (k == 0 ? less.r : k == 1 ? less.g : less.b), 1e-5) << i;
  }
  EXPECT_GT(lit, 10);
}

INSTANTIATE_TEST_SUITE_P(
    Air, LightInAir,
    testing::Values("", "fog { distance 6 rgb 0.5 }",
                    "sphere { <0, 0.5, -3>, 1.4 pigment { rgbt 1 } hollow interior { media { absorption 0.4 } } }"));

}  // namespace
}  // namespace verisim::cli
