// Small scenes of spec 06 section 19 with the colours POV-Ray 3.7.0.10 gave, 16 bits linear, tolerance 2 codes
// (`-A +WT1 +FN16 File_Gamma=1`). Scenes that draw random numbers are rendered with --replay.
#pragma once

#include <gtest/gtest.h>

#include "tests/support/probe.h"

namespace verisim::test {

inline constexpr const char* kPrelude = R"(
global_settings { assumed_gamma 1.0 }
#macro CamZ(P) camera { orthographic location P direction z right 0.01*x up 0.01*y } #end
#macro CamDown() camera { orthographic location 50*y direction -y right 0.01*x up 0.01*z } #end
#macro CamTilt(A) camera { orthographic
  location <-10*sin(radians(A)), 0, -10*cos(radians(A))>
  direction <sin(radians(A)), 0, cos(radians(A))> right 0.01*x up 0.01*y } #end
#macro Em(K) finish { ambient 0 diffuse 0 emission K } #end
#macro SkyX() sky_sphere { pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 2 translate -x } } #end
#declare Clr = texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
#declare Wht = texture { pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
)";

struct ShadingProbe {
  std::string id, what, option;  // option: a POV-Ray switch or a #version line
  std::string scene;
  std::vector<std::vector<int>>
      pixels;  // of row 0; one number: all channels; a fourth: alpha, with colours premultiplied
};
inline void PrintTo(const ShadingProbe& p, std::ostream* out) { *out << p.id << ": " << p.what; }

inline void expect_the_colours_of(const ShadingProbe& p) {
  render::Options options;
  options.replay = true;
  options.output_alpha = p.option == "+UA";
  if (p.option.starts_with("+Q")) options.quality = std::stoi(p.option.substr(2));
  if (p.option == "+SC2") options.first_column = 1;
  const std::string version = p.option.starts_with("#version") ? p.option : "#version 3.7;";
  const int width = static_cast<int>(p.pixels.size());
  const render::Framebuffer picture = render_text(version + kPrelude + p.scene, width, 1, options);
  for (int x = 0; x < width; ++x) {
    const std::vector<double> got = lin16(picture, x, 0);
    const std::vector<int>& expected = p.pixels[x];
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(got[c], expected.size() == 1 ? expected[0] : expected[c], 2.0) << "pixel " << x << " channel " << c;
    if (expected.size() == 4) {
      EXPECT_NEAR((1 - picture.at(x, 0).t) * 65535, expected[3], 2.0) << "alpha";
    }
  }
}

}  // namespace verisim::test
