// Rays to the samples of an area light that go together find what each finds alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string_view>

#include "tests/support/probe.h"

namespace verisim {
namespace {

struct Grid {
  const char* sizes;
  const char* options;
};
void PrintTo(const Grid& grid, std::ostream* out) { *out << grid.sizes << ' ' << grid.options; }

class AreaLight : public testing::TestWithParam<Grid> {};

// A clear ball around the light, which nobody sees, changes nothing but that rays must be asked one by one what they
// meet.
TEST_P(AreaLight, CastsTheSameShadowsThroughAClearBall) {
  const auto picture = [](const char* ball, render::Statistics& counted, const render::Options& options = {}) {
    return test::render_text(fmt::format(R"(
      #version 3.7; global_settings {{ assumed_gamma 1 }}
      camera {{ location <0, 4, -6> look_at <0, 0.5, 0> }}
      light_source {{ <2, 6, -1>, rgb <1, 0.8, 0.6> area_light <2, 0, 0>, <0, 0.3, 2>, {} {} }}
      {}
      plane {{ y, 0 pigment {{ rgb 1 }} }}
      union {{
        box {{ <-1, 0, -1>, <0, 1, 0> }} cylinder {{ <1, 0, 1>, <1, 2, 1>, 0.3 }} sphere {{ <0.5, 0.5, -1>, 0.4 }}
torus {{ 0.8, 0.15 translate <-1, 1.5, 1> }}
        difference {{ sphere {{ <1.8, 1, -0.5>, 0.6 }} box {{ <1.5, 0.8, -2>, <2, 1.2, 2> }} }}
        pigment {{ rgb 0.7 }}
      }})",
                                         GetParam().sizes, GetParam().options, ball),
                             64, 48, options, &counted);
  };
  render::Statistics rays_together, rays_alone;
  const render::Framebuffer together = picture("", rays_together),
                            alone =
                                picture("sphere { <2, 6, -1>, 3.5 pigment { rgbt 1 } hollow no_image no_reflection }",
                                        rays_alone);
  int half_lit = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      ASSERT_TRUE(together.at(x, y) == alone.at(x, y)) << x << ' ' << y;
      half_lit += together.at(x, y).r > 0.15f && together.at(x, y).r < 0.3f;
    }
  }
  EXPECT_EQ(rays_together.shadow_rays, rays_alone.shadow_rays) << "none is asked twice";
  if (std::string_view(GetParam().options).find("jitter") == std::string_view::npos) {
    // One sample after another, each quarter summed.
    render::Options in_turn;
    in_turn.replay = true;
    render::Statistics rays_in_turn;
    const render::Framebuffer quartered = picture("", rays_in_turn, in_turn);
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x) ASSERT_TRUE(together.at(x, y) == quartered.at(x, y)) << x << ' ' << y;
  }
  EXPECT_GT(half_lit, 50) << "there should be penumbras";
}

INSTANTIATE_TEST_SUITE_P(Grids, AreaLight,
                         testing::Values(Grid{"5, 5", "adaptive 1"}, Grid{"5, 5", "adaptive 1 jitter"},
                                         Grid{"4, 7", "adaptive 0 jitter"}, Grid{"4, 7", ""},
                                         Grid{"17, 9", "adaptive 2"}, Grid{"1, 9", "adaptive 1 jitter"},
                                         Grid{"3, 3", "adaptive 40"}, Grid{"9, 6", "adaptive 40"},
                                         Grid{"9, 6", "adaptive 40 jitter"},
                                         Grid{"6, 6", "circular orient adaptive 1 jitter"},
                                         Grid{"5, 5", "adaptive 1 fade_distance 4 fade_power 2"},
                                         Grid{"4, 4", "adaptive 1 spotlight radius 20 falloff 50 point_at <0, 0, 0>"}));

}  // namespace
}  // namespace verisim
