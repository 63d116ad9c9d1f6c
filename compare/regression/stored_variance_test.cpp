#include "compare/regression/stored_variance.h"

#include <gtest/gtest.h>

#include <random>

#include "compare/metrics/test_pictures.h"
#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace {

Picture noisy(unsigned seed, double brighter = 1) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0, 6);
  Picture p = constant_picture(96, 64, 0, 0, 0);
  for (std::size_t i = 0; i < p.samples.size(); i += 3) {
    const double v = brighter * (60 + static_cast<double>(i % 288) / 3) + (i % 288 < 96 ? 0 : noise(generator));
    for (std::size_t c = 0; c < 3; ++c) p.samples[i + c] = static_cast<float>(std::round(v) / 255);
  }
  return p;
}

StoredVariance stored_of(unsigned first, int runs, const std::filesystem::path& folder) {
  std::vector<Picture> pictures;
  for (int i = 0; i < runs; ++i) pictures.push_back(noisy(first + static_cast<unsigned>(i)));
  write_stored_variance(pictures, folder / "scene.png");
  return *read_stored_variance(folder / "scene.png");
}

TEST(StoredVariance, OneMoreRunPassesAndABrighterOneDoesNot) {
  const TemporaryFolder folder;
  int alarms = 0, found = 0, one_percent = 0;
  for (unsigned trial = 0; trial < 50; ++trial) {
    const StoredVariance stored = stored_of(100 * trial, 4, folder.path());
    EXPECT_EQ(stored.runs, 4);
    alarms += z_test(stored, noisy(100 * trial + 50)).rejected;
    found += z_test(stored, noisy(100 * trial + 50, 1.05)).rejected;
    one_percent += z_test(stored, noisy(100 * trial + 50, 1.02)).rejected;
  }
  EXPECT_EQ(alarms, 0);
  EXPECT_GE(found, 49);
  RecordProperty("two_percent_found_of_50", one_percent);
}

TEST(StoredVariance, AMissingObjectIsFoundWhereItIs) {
  const TemporaryFolder folder;
  const StoredVariance stored = stored_of(7, 6, folder.path());
  Picture render = noisy(99);
  for (int y = 20; y < 40; ++y)
    for (int x = 40; x < 60; ++x)
      for (int c = 0; c < 3; ++c) render.samples[static_cast<std::size_t>((y * 96 + x) * 3 + c)] = 0;
  const ZTest test = z_test(stored, render);
  EXPECT_TRUE(test.rejected);
  EXPECT_LT(test.p[30 * 96 + 50], 1e-3);
  EXPECT_GT(test.p[5 * 96 + 5], 1e-3);
}

}  // namespace
}  // namespace verisim::compare
