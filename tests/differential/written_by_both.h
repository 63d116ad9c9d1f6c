// What POV-Ray and verisim write into a file when they run the same scene.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "parser/parse.h"
#include "tracer/base/whole_file.h"

namespace verisim {

inline bool has_povray() { return std::system("command -v povray > /dev/null 2>&1") == 0; }

struct WrittenByBoth {
  std::string povray, verisim;
};

// Of a scene that writes out.txt; a failure of the test where one of them does not run it. What they leave is removed
// where both do.
inline void run_by_both(const std::string& scene, const std::string& name, WrittenByBoth& written) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("verisim_" + name + "_" + std::to_string(::getpid()));
  fs::create_directories(folder / "povray");
  fs::create_directories(folder / "verisim");
  std::ofstream(folder / "scene.pov") << scene;
  const std::string command = "cd '" + (folder / "povray").string() + "' && HOME='" + folder.string() +
                              "' timeout 120 povray +I../scene.pov -D -F +W1 +H1 -A -GA +WT1 > log.txt 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << "POV-Ray rejects the scene: see " << folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder / "verisim");
  const parser::ParseResult result = parser::parse_file(folder / "scene.pov", {});
  fs::current_path(before);
  ASSERT_TRUE(result.errors.empty()) << parser::format(result.errors.front());
  written = {whole_file(folder / "povray" / "out.txt").value_or(""),
             whole_file(folder / "verisim" / "out.txt").value_or("")};
  fs::remove_all(folder);
}

}  // namespace verisim
