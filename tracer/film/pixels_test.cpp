#include "tracer/film/pixels.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace verisim::render {
namespace {

constexpr std::size_t kMany = std::size_t{4} << 20;  // 64 MB

std::size_t megabytes_of_process() {
  std::ifstream statm("/proc/self/statm");
  std::size_t all = 0, resident = 0;
  statm >> all >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) >> 20;
}
Color color_of(std::size_t i) { return {static_cast<float>(i), 1, 2, 0, 0.5f}; }

TEST(Pixels, ThoseInAFileTakeMemoryOnlyWhileTheyAreWorkedAt) {
  Pixels pixels;
  if (!pixels.assign_in_file(kMany, testing::TempDir())) GTEST_SKIP() << "no files without names there";
  ASSERT_TRUE(pixels.in_file());
  ASSERT_EQ(pixels.size(), kMany);
  EXPECT_EQ(pixels[kMany - 1], Color());
  const std::size_t before = megabytes_of_process();
  for (std::size_t i = 0; i < kMany; ++i) pixels[i] = color_of(i);
  EXPECT_GT(megabytes_of_process(), before + 50);
  pixels.done_with(kMany);
  EXPECT_LT(megabytes_of_process(), before + 10);
  for (std::size_t i = 0; i < kMany; ++i) ASSERT_EQ(pixels[i], color_of(i)) << i;
}

TEST(Pixels, WhereNoFileCanBeTheyStayAsTheyAre) {
  Pixels pixels;
  pixels.assign(3, Color(1, 2, 3));
  EXPECT_FALSE(pixels.assign_in_file(8, "/nowhere/at/all"));
  EXPECT_FALSE(pixels.in_file());
  ASSERT_EQ(pixels.size(), 3u);
  EXPECT_EQ(pixels[2], Color(1, 2, 3));
}

TEST(Pixels, CopiesAreInMemory) {
  Pixels pixels;
  if (!pixels.assign_in_file(100, testing::TempDir())) GTEST_SKIP() << "no files without names there";
  pixels[7] = color_of(7);
  Pixels copy = pixels;
  EXPECT_FALSE(copy.in_file());
  ASSERT_EQ(copy.size(), 100u);
  EXPECT_EQ(copy[7], color_of(7));
  copy.assign(5, Color(1, 1, 1));
  EXPECT_EQ(pixels.size(), 100u);
  const Pixels moved = std::move(pixels);
  EXPECT_TRUE(moved.in_file());
  EXPECT_EQ(moved[7], color_of(7));
}

}  // namespace
}  // namespace verisim::render
