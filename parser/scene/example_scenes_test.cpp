// The scenes of the package povray-examples and the include files of povray-includes: accepted and refused as
// POV-Ray 3.7.0.10 does.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "parser/parse.h"

namespace verisim::parser {
namespace {

namespace fs = std::filesystem;

const fs::path kExamples = "/usr/share/doc/povray/examples";
const fs::path kLibrary = "/usr/share/povray-3.7";

// POV-Ray ends with an error on these: they need switches of an INI file, a missing font or another version.
const std::set<std::string> kRefusedExamples = {
    "advanced/cliche/cliche.pov", "incdemo/sort.pov",           "portfolio/__empty.pov",   "portfolio/allnormals.pov",
    "portfolio/allpatterns.pov",  "portfolio/c_colors.pov",     "portfolio/f_finish.pov",  "portfolio/m_textures.pov",
    "portfolio/o_2shapes.pov",    "portfolio/o_shapes_old.pov", "portfolio/p_skies.pov",   "portfolio/p_textures.pov",
    "portfolio/p_woods.pov",      "portfolio/t_1stones.pov",    "portfolio/t_2stones.pov", "portfolio/t_metals.pov",
    "portfolio/t_stars.pov",      "portfolio/t_textures.pov",   "portfolio/t_woods.pov",
};

// These need definitions of others first.
const std::set<std::string> kRefusedIncludes = {"shapes2.inc",  "shapesq.inc", "skies.inc",   "stdcam.inc",
                                                "stoneold.inc", "stones.inc",  "stones1.inc", "stones2.inc"};

ParseOptions options() {
  ParseOptions result;
  result.library_paths = {kLibrary, kLibrary / "ini", kLibrary / "include"};
  result.limits.max_steps = 1000000000;
  return result;
}

// Scenes name their files relative to their own folder.
class InFolder {
 public:
  explicit InFolder(const fs::path& folder) : before_(fs::current_path()) { fs::current_path(folder); }
  ~InFolder() { fs::current_path(before_); }
  InFolder(const InFolder&) = delete;
  InFolder& operator=(const InFolder&) = delete;

 private:
  fs::path before_;
};

TEST(ExampleScenes, AreAcceptedAndRefusedAsPovRayDoes) {
  if (!fs::exists(kExamples / "advanced") || !fs::exists(kLibrary / "include"))
    GTEST_SKIP() << "povray-examples or povray-includes is not installed";
  // Some scenes write files beside themselves: work on a copy.
  const fs::path copy = fs::temp_directory_path() / ("verisim_examples_" + std::to_string(getpid()));
  for (const auto& entry : fs::directory_iterator(kExamples)) {
    if (entry.is_directory() && entry.path().filename() != "previews") {
      fs::create_directories(copy / entry.path().filename());
      fs::copy(entry.path(), copy / entry.path().filename(),
               fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    }
  }
  int accepted = 0;
  for (const auto& entry : fs::recursive_directory_iterator(copy)) {
    if (entry.path().extension() != ".pov") continue;
    const std::string name = entry.path().lexically_relative(copy).string();
    const InFolder folder(entry.path().parent_path());
    const ParseResult result = parse_file(entry.path().filename(), options());
    if (kRefusedExamples.count(name)) {
      EXPECT_FALSE(result.errors.empty()) << name;
      continue;
    }
    ++accepted;
    if (result.errors.empty()) continue;
    const Diagnostic& first = result.errors.front();
    if (first.message.find("image module") != std::string::npos)
      continue;  // JPEG; the module stands beside the program, not beside this test
    ADD_FAILURE() << name << ": " << first.file << ":" << first.line << ": " << first.message << "\n"
                  << first.source_line;
  }
  EXPECT_GE(accepted, 370);
  fs::remove_all(copy);
}

TEST(StandardIncludes, AreAccepted) {
  if (!fs::exists(kLibrary / "include")) GTEST_SKIP() << "povray-includes is not installed";
  for (const auto& entry : fs::directory_iterator(kLibrary / "include")) {
    if (entry.path().extension() != ".inc") continue;
    const std::string name = entry.path().filename().string();
    const ParseResult result =
        parse_text("#version 3.7; global_settings{assumed_gamma 1}\n#include \"" + name + "\"", "test.pov", options());
    if (kRefusedIncludes.count(name)) {
      EXPECT_FALSE(result.errors.empty()) << name;
    } else if (!result.errors.empty()) {
      ADD_FAILURE() << name << ": " << result.errors.front().line << ": " << result.errors.front().message;
    }
  }
}

}  // namespace
}  // namespace verisim::parser
