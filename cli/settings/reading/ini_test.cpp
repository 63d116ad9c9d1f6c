// INI files and arguments: spec 02 sections 9.2 to 9.4.
#include "cli/settings/reading/ini.h"

#include <gtest/gtest.h>

#include <fstream>

namespace verisim::cli {
namespace {

namespace fs = std::filesystem;

Options from_text(std::string_view text, std::string_view section = "") {
  Options options;
  apply_ini_text(options, text, section, "test.ini");
  return options;
}

class InFolder : public testing::Test {
 protected:
  void SetUp() override {
    previous_ = fs::current_path();
    folder_ = fs::path(testing::TempDir()) / ("ini_test_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    fs::current_path(folder_);
  }
  void TearDown() override {
    fs::current_path(previous_);
    fs::remove_all(folder_);
  }
  static void file(const fs::path& path, const std::string& text) {
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  fs::path previous_, folder_;
};

TEST(Ini, ReadsKeysInAnyCaseWithSpacesAndComments) {
  const Options o =
      from_text("; a comment\nWIDTH = 10 ; more\n  height=20 # more\n\nAntialias=on\nOutput_File_Name=\"a b.png\"\n");
  EXPECT_EQ(o.width, 10);
  EXPECT_EQ(o.height, 20);
  EXPECT_TRUE(o.antialias);
  EXPECT_EQ(o.output_file, "a b.png");
}

TEST(Ini, OnlyTheFirstSettingOfALineCounts) {
  const Options o = from_text("Width=10 Height=11\n");
  EXPECT_EQ(o.width, 10);
  EXPECT_EQ(o.height, 120);
}

TEST(Ini, LinesMayHoldSwitches) {
  const Options o = from_text("+W30 +H40 -A\nscene.pov\nlib/\n");
  EXPECT_EQ(o.width, 30);
  EXPECT_EQ(o.height, 40);
  EXPECT_EQ(o.input_file, "scene.pov");
  EXPECT_EQ(o.library_paths, std::vector<std::string>{"lib"});
}

TEST(Ini, CommasRepeatTheKey) {
  EXPECT_EQ(from_text("Library_Path=lib1,lib2\n").library_paths, (std::vector<std::string>{"lib1", "lib2"}));
}

TEST(Ini, SectionsApplyByNameAfterTheHead) {
  const char* text = "Width=1\n[Small]\nWidth=2\nHeight=5\n[big]\nWidth=3\n[small]\nHeight=6\n";
  EXPECT_EQ(from_text(text).width, 1);
  EXPECT_EQ(from_text(text, "SMALL").width, 2);
  EXPECT_EQ(from_text(text, "small").height, 6);
  EXPECT_EQ(from_text(text, "big").width, 3);
  EXPECT_EQ(from_text(text, "none").width, 1);
}

TEST(Ini, CommandsAreTakenRaw) {
  EXPECT_EQ(from_text("Post_Frame_Command = convert %o 'x y' # ; z\n").post_frame.command, "convert %o 'x y' # ; z");
}

TEST(Ini, ValuesWithSpacesGoToTheEndOfTheLine) {
  const Options o = from_text("Output_File_Name=my file\n");
  EXPECT_EQ(o.output_file, "my file");
  EXPECT_EQ(o.notes.size(), 1u);
}

TEST(Ini, StringDeclarationsKeepTheirQuotes) {
  EXPECT_EQ(from_text("Declare='NAME=\"some text\"'\n").declarations.at(0).second, "\"some text\"");
  EXPECT_EQ(from_text("Declare=x=1.5\n").declarations.at(0).second, "1.5");
}

TEST(Ini, RemovedKeysAreNotedAndIgnored) {
  EXPECT_EQ(from_text("Buffer_Output=on\nHistogram_Name=x\n").notes.size(), 2u);
}

TEST(Ini, ErrorsNameFileAndLine) {
  for (const char* text : {"Width=10\nFoo=1\n", "Width=10\nsome text\n", "Width=10\nWidth=x\n", "Width=10\n[open\n",
                           "Width=10\nOutput_File_Name=\"x\n"}) {
    try {
      from_text(text);
      ADD_FAILURE() << text;
    } catch (const OptionError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("test.ini:2: ", 0), 0u) << error.what();
    }
  }
}

TEST(Ini, AnyBytesEndInSettingsOrAnError) {
  for (int seed = 0; seed < 500; ++seed) {
    std::string text;
    for (int i = 0; i < 60; ++i) text += "=\"'+-[];#, \n\tAWx0."[(seed * 7919 + i * i * 31 + i * seed) % 18];
    try {
      from_text(text);
    } catch (const OptionError&) {
    }
  }
}

TEST_F(InFolder, FilesAreFoundInLibraryPathsAndWithExtensions) {
  file("lib/quick.ini", "Width=77\n[s]\nHeight=88\n");
  Options o;
  EXPECT_THROW(apply_argument(o, "quick"), OptionError);
  apply_argument(o, "+Llib");
  apply_argument(o, "quick[S]");
  EXPECT_EQ(o.width, 77);
  EXPECT_EQ(o.height, 88);
}

TEST_F(InFolder, FilesThatIncludeThemselvesEnd) {
  file("loop.ini", "Include_Ini=loop.ini\n");
  Options o;
  EXPECT_THROW(apply_argument(o, "loop.ini"), OptionError);
}

TEST_F(InFolder, AFolderIsNoIniFile) {
  fs::create_directories("dir.ini");
  Options o;
  EXPECT_THROW(apply_argument(o, "dir.ini"), OptionError);
}

TEST(Arguments, OneMayHoldSeveralOptions) {
  Options o;
  apply_argument(o, "+Isc.pov +W8 Height=9");
  EXPECT_EQ(o.input_file, "sc.pov");
  EXPECT_EQ(o.width, 8);
  EXPECT_EQ(o.height, 9);
}

TEST(Arguments, QuotesKeepSpaces) {
  Options o;
  apply_argument(o, "+O\"a b\"");
  apply_argument(o, "+I'c d.pov'");
  EXPECT_EQ(o.output_file, "a b");
  EXPECT_EQ(o.input_file, "c d.pov");
}

}  // namespace
}  // namespace verisim::cli
