// How other programs and old scenes write SDL: versions 1 to 3.6, line ends of DOS and Mac, Latin-1, and in the manner
// of Jmol, PyMOL, VMD, RasMol, L3P, Moray, vapory ... The files are our own; their names say what povray 3.7.0.10 does
// with them, and NAME.txt what it prints with #debug.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "parser/parse.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;

TEST(Differential, Idioms) {
  const fs::path includes = "/usr/share/povray-3.7/include";
  if (!fs::exists(includes)) GTEST_SKIP() << "the standard include files are missing (package povray-includes)";
  parser::ParseOptions options;
  options.library_paths = {includes};
  std::string debug;
  options.debug = [&debug](const std::string& text) { debug += text; };
  const fs::path work = fs::temp_directory_path() / ("verisim_idioms_" + std::to_string(::getpid()));
  fs::create_directories(work);
  const fs::path before = fs::current_path();
  fs::current_path(work);  // one of them writes a file
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(VERISIM_SOURCE_DIR) / "tests/differential/idioms")) {
    if (entry.path().extension() != ".pov") continue;
    debug.clear();
    const parser::ParseResult result = parser::parse_file(entry.path(), options);
    const bool accepted = entry.path().filename().string().starts_with("accepted");
    EXPECT_EQ(result.errors.empty(), accepted)
        << entry.path() << (result.errors.empty() ? "" : "\n" + parser::format(result.errors.front()));
    if (std::ifstream expected(fs::path(entry.path()).replace_extension(".txt")); expected) {
      EXPECT_EQ(debug, std::string(std::istreambuf_iterator<char>(expected), {})) << entry.path();
    }
    ++count;
  }
  fs::current_path(before);
  fs::remove_all(work);
  EXPECT_GT(count, 60);
}

}  // namespace
}  // namespace verisim
