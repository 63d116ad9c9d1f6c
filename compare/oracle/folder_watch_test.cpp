#include "compare/oracle/folder_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "compare/oracle/working_copy.h"

namespace verisim::compare {
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
namespace {

TEST(FolderWatch, SaysWhichFilesChanged) {
  const TemporaryFolder root;
  fs::create_directories(root.path() / "maps/small");
  fs::create_directories(root.path() / ".hidden");
  std::ofstream(root.path() / "old.txt") << "1";
  std::ofstream(root.path() / "gone.txt") << "1";
  FolderWatch watch(root.path(), true);
  ASSERT_TRUE(watch.changes());
  std::ofstream(root.path() / "new.txt") << "1";
  std::ofstream(root.path() / "old.txt", std::ios::app) << "2";
  std::ofstream(root.path() / "maps/small/deep.txt") << "1";
  std::ofstream(root.path() / ".hidden/x") << "1";
  fs::remove(root.path() / "gone.txt");
  std::ifstream(root.path() / "old.txt").get();  // only read
  EXPECT_THAT(*watch.changes(), ElementsAre("gone.txt", "maps/small/deep.txt", "new.txt", "old.txt"));
  EXPECT_THAT(*watch.changes(), IsEmpty());
  fs::rename(root.path() / "new.txt", root.path() / "newer.txt");
  EXPECT_THAT(*watch.changes(), ElementsAre("new.txt", "newer.txt"));
}

TEST(FolderWatch, SaysWhenItDoesNotKnow) {
  EXPECT_FALSE(FolderWatch().changes());
  EXPECT_FALSE(FolderWatch("/no/such/folder", true).changes());
  const TemporaryFolder root;
  FolderWatch watch(root.path(), true);
  fs::create_directory(root.path() / "folder");  // what is in it would go unseen
  EXPECT_FALSE(watch.changes());
  EXPECT_FALSE(watch.changes());
}

}  // namespace
}  // namespace verisim::compare
