#include "tracer/base/whole_file.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>

namespace verisim {
namespace {

TEST(WholeFile, HasEveryByteAndIsNothingWhereThereIsNone) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const std::filesystem::path file = folder / ("whole_file_test_" + std::to_string(getpid()));
  const std::string bytes("a\r\n\0\xff", 5);
  std::ofstream(file, std::ios::binary) << bytes;
  EXPECT_EQ(whole_file(file), bytes);
  std::ofstream(file, std::ios::binary | std::ios::trunc).flush();
  EXPECT_EQ(required_file(file), "");
  std::filesystem::remove(file);
  EXPECT_EQ(whole_file(file), std::nullopt);
  EXPECT_THROW(required_file(file), std::runtime_error);
  EXPECT_EQ(whole_file(folder), std::nullopt);
}

}  // namespace
}  // namespace verisim
