#include "tracer/image/shared_files.h"

#include <fstream>

#include <gtest/gtest.h>

namespace verisim::image {
namespace {

namespace fs = std::filesystem;

class FileState : public testing::Test {
 protected:
  FileState() { fs::create_directories(folder_), write("one", "text"); }
  ~FileState() override { fs::remove_all(folder_); }
  fs::path at(const char* name) const { return folder_ / name; }
  std::string state_of(const char* name) const { return file_state(at(name).c_str()); }
  void write(const char* name, const char* text) const { std::ofstream(at(name)) << text; }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) / "verisim_file_state";
};

TEST_F(FileState, IsTheSameByEveryNameOfAFile) {
  fs::create_symlink("one", at("link"));
  fs::create_hard_link(at("one"), at("other name"));
  const std::string state = state_of("one");
  EXPECT_FALSE(state.empty());
  EXPECT_EQ(state_of("link"), state);
  EXPECT_EQ(state_of("other name"), state);
}

TEST_F(FileState, IsAnotherForWhatIsWrittenLaterOrInItsPlace) {
  const std::string state = state_of("one");
  write("one", "longer text");
  const std::string longer = state_of("one");
  EXPECT_NE(longer, state);
  write("two", "longer text");
  fs::last_write_time(at("two"), fs::last_write_time(at("one")));
  fs::rename(at("two"), at("one"));
  EXPECT_NE(state_of("one"), longer);
}

TEST_F(FileState, IsEmptyForWhatIsNoFile) {
  EXPECT_TRUE(state_of("missing").empty());
  EXPECT_TRUE(state_of("").empty());
  EXPECT_TRUE(file_state("/dev/null").empty());
}

}  // namespace
}  // namespace verisim::image
