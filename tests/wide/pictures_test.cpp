// Rays that are traced and shaded together get the bits of rays that go one by one.
#include <gtest/gtest.h>

#include <random>

#include "tests/wide/each_instruction_set.h"
#include "tests/wide/sdl_tables.h"
#include "tracer/render/prepared_scene.h"
#include "tracer/shading/explain.h"

namespace verisim::test {
namespace {

using shading::RandomSource, shading::Wavefront;

constexpr int kPictureWidth = 48, kPictureHeight = 36;

// One way to trace a scene's rays; each has a cache of radiosity of its own.
struct TracedWay {
  explicit TracedWay(const scene::Scene& scene, shading::Observer* observer = nullptr, bool replay = false)
      : prepared(scene, options_of()),
        camera(prepared.camera(options_of())),
        tracer(prepared.data(), RandomSource(replay, 0)),
        sampler((prepared.run_prepasses(camera, options_of(), 1), camera), tracer) {
    tracer.coherent().set_camera(camera.coherence);
    tracer.set_observer(observer);
    render::begin_block(prepared.effects(), tracer, options_of(), 0);
  }
  static const render::Options& options_of() {
    static const render::Options options = [] {
      render::Options o;
      o.width = kPictureWidth, o.height = kPictureHeight, o.threads = 1;
      return o;
    }();
    return options;
  }
  render::PreparedScene prepared;
  render::CameraModel camera;
  shading::Tracer tracer;
  render::PixelSampler sampler;
};

void expect_the_same_rays(const render::Statistics& a, const render::Statistics& b) {
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.camera_rays, b.camera_rays);
  EXPECT_EQ(a.shadow_rays, b.shadow_rays);
  EXPECT_EQ(a.reflected_rays, b.reflected_rays);
  EXPECT_EQ(a.refracted_rays, b.refracted_rays);
  EXPECT_EQ(a.transmitted_rays, b.transmitted_rays);
}

// Rows of pixels and places anywhere; `watched` does everything one by one, `alone` what hangs on one camera ray: both
// in a scene that shows the same, the former perhaps with --replay.
void expect_the_same(const scene::Scene& scene, const scene::Scene& other, bool replay, Journal& journal) {
  shading::Observer watching;
  TracedWay watched(other, &watching, replay), together(scene), alone(other);
  const auto compare = [&](const Vec2& place, const Color& color) {
    const Color each = watched.sampler(place.x, place.y);
    ASSERT_TRUE(color == each) << place;
    ASSERT_TRUE(alone.sampler(place.x, place.y) == each) << place << " alone";
    journal.add(each.r), journal.add(each.g), journal.add(each.b), journal.add(each.t);
  };
  std::vector<Color> colors(3 * Wavefront::kMax);
  for (int y = 0; y < kPictureHeight; ++y) {
    together.sampler.row(0, y, kPictureWidth, colors.data());
    for (int x = 0; x < kPictureWidth; ++x)
      ASSERT_NO_FATAL_FAILURE(compare(Vec2(x, y), colors[static_cast<std::size_t>(x)]));
  }
  std::mt19937 random{5};
  std::uniform_real_distribution<double> beside(-1.4, 1.4), across(0, kPictureWidth - 1), down(0, kPictureHeight - 1);
  for (int count = 1; count < 3 * Wavefront::kMax; count += 17) {
    const Vec2 near{across(random), down(random)};
    std::vector<Vec2> places;
    for (int i = 0; i < count; ++i)
      places.push_back(count % 3 == 0 ? Vec2{across(random), down(random)}
                                      : near + Vec2{beside(random), beside(random)});
    together.sampler.points(places.data(), count, colors.data());
    for (std::size_t i = 0; i < places.size(); ++i) ASSERT_NO_FATAL_FAILURE(compare(places[i], colors[i]));
  }
  expect_the_same_rays(together.tracer.statistics(), watched.tracer.statistics());
  expect_the_same_rays(alone.tracer.statistics(), watched.tracer.statistics());
  // They do go together.
  EXPECT_GT(together.tracer.statistics().wavefront_rays, together.tracer.statistics().camera_rays * 3 / 4);
  EXPECT_EQ(watched.tracer.statistics().wavefront_rays, 0u);
}

TEST(WidePictures, AreThoseOfRaysThatGoOneByOne) {
  with_each_instruction_set([](Journal& journal) {
    parser::ParseOptions options;
    options.width = kPictureWidth, options.height = kPictureHeight;
    const SdlTables tables("pictures.sdl");
    const auto expect = [&](const std::string& name, const std::string& sdl, const std::string& more = "",
                            bool replay = false) {
      SCOPED_TRACE(name);
      journal.begin(name);
      expect_the_same(tables.scene(sdl, options), tables.scene(sdl + more, options), replay, journal);
    };
    for (const auto& [name, sdl] : tables["pictures"]) expect(name, sdl);
    // A clear ball around an area light changes nothing but that rays are asked one by one what they meet; --replay has
    // one sample of the light after another, each quarter summed.
    for (const auto& [name, sdl] : tables["lights"])
      if (sdl.starts_with("area_light"))
        expect(name, "Penumbras() light_source { <2,6,-1>, <1,.8,.6> " + sdl + " }", "ClearBall()",
               sdl.find("jitter") == std::string::npos);
  });
}

}  // namespace
}  // namespace verisim::test
