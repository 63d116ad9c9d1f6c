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
  void write(const char* name, const char* text) const { std::ofstream(at(name)) << text; }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) / "verisim_file_state";
};

TEST_F(FileState, IsTheSameByEveryNameOfAFile) {
  fs::create_symlink("one", at("link"));
  fs::create_hard_link(at("one"), at("other name"));
  const std::string state = file_state(at("one"));
  EXPECT_FALSE(state.empty());
  EXPECT_EQ(file_state(at("link")), state);
  EXPECT_EQ(file_state(at("other name")), state);
}

TEST_F(FileState, IsAnotherForWhatIsWrittenLaterOrInItsPlace) {
  const std::string state = file_state(at("one"));
  write("one", "longer text");
  const std::string longer = file_state(at("one"));
  EXPECT_NE(longer, state);
  write("two", "longer text");
  fs::last_write_time(at("two"), fs::last_write_time(at("one")));
  fs::rename(at("two"), at("one"));
  EXPECT_NE(file_state(at("one")), longer);
}

TEST_F(FileState, IsEmptyForWhatIsNoFile) {
  EXPECT_TRUE(file_state(at("missing")).empty());
  EXPECT_TRUE(file_state(at("")).empty());
  EXPECT_TRUE(file_state("/dev/null").empty());
}

}  // namespace
}  // namespace verisim::image
