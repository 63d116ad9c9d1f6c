// The picture depends on the scene alone: every scene of scenes/ has the same pixels, bit for bit, on 1, 2, 3 and 8
// threads (issue 6).
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "parser/parse.h"
#include "tracer/render/render.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes_below(const fs::path& folder) {
  std::vector<fs::path> scenes;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".pov") scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

// Small blocks, so that threads share even a small picture.
std::vector<Color> pixels_of(const scene::Scene& scene, int threads) {
  render::Options options;
  options.width = 32, options.height = 24, options.block_size = 8;
  options.antialias = true, options.antialias_depth = 2;
  options.threads = threads;
  render::Framebuffer frame;
  render::render(scene, options, frame);
  return frame.pixels;
}

class ThreadIdentity : public testing::TestWithParam<const char*> {};

TEST_P(ThreadIdentity, TheSamePixelsOnAnyNumberOfThreads) {
  int rendered = 0;
  for (const fs::path& path : scenes_below(fs::path(VERISIM_SOURCE_DIR) / "scenes" / GetParam())) {
    parser::ParseOptions options;
    options.width = 32, options.height = 24;
    const auto parsed = parser::parse_file(path, options);
    if (!parsed.scene) continue;  // needs a switch, or includes that are not installed
    std::vector<Color> expected;
    try {
      expected = pixels_of(*parsed.scene, 1);
    } catch (const std::exception&) {
      continue;  // refused by name
    }
    ++rendered;
    for (const int threads : {2, 3, 8}) {
      const auto pixels = pixels_of(*parsed.scene, threads);
      ASSERT_EQ(pixels.size(), expected.size());
      EXPECT_EQ(std::memcmp(pixels.data(), expected.data(), expected.size() * sizeof(Color)), 0)
          << path << " on " << threads << " threads";
    }
  }
  EXPECT_GT(rendered, 0);
}

std::string name_of(const testing::TestParamInfo<const char*>& info) { return info.param; }

INSTANTIATE_TEST_SUITE_P(Scenes, ThreadIdentity,
                         testing::Values("analytic", "camera", "cornell_box", "global", "lecture", "light", "output",
                                         "shapes", "textures"),
                         name_of);

}  // namespace
}  // namespace verisim
