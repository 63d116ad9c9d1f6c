#include "tests/wide/harness.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "parser/source/diagnostic.h"
#include "tracer/simd/instruction_sets.h"

namespace verisim::test {
namespace {

constexpr const char* kJournalFile = "VERISIM_TEST_JOURNAL";  // where a test that was started by a test writes to

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The journal of the running test with this instruction set.
std::string journal_with(const std::string& set) {
  const auto& info = *testing::UnitTest::GetInstance()->current_test_info();
  const auto base = std::filesystem::temp_directory_path() / ("verisim_" + std::to_string(::getpid()) + '_' + set);
  const std::string journal = base.string() + ".journal", output = base.string() + ".output",
                    program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "VERISIM_INSTRUCTION_SET=" + set + ' ' + kJournalFile + "='" + journal + "' '" + program +
                              "' --gtest_filter=" + info.test_suite_name() + '.' + info.name() + " > '" + output + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << set << ":\n" << text_of(output);
  const std::string text = text_of(journal);
  std::filesystem::remove(journal), std::filesystem::remove(output);
  return text;
}

}  // namespace

SdlTables::SdlTables(const std::string& file) {
  std::ifstream in(VERISIM_SOURCE_DIR "/tests/wide/" + file);
  std::vector<SdlLine>* table = nullptr;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("== ")) {
      table = &tables_[line.substr(3)];
    } else if (!table) {
      prelude_ += line + '\n';
    } else if (line.starts_with(' ')) {
      table->back().sdl += line;
    } else if (!line.empty() && !line.starts_with("//")) {
      const std::size_t bar = line.find(" |");
      table->push_back({line.substr(0, bar), bar < line.size() ? line.substr(std::min(bar + 3, line.size())) : line});
    }
  }
}

scene::Scene SdlTables::scene(const std::string& sdl, const parser::ParseOptions& options) const {
  parser::ParseResult result = parser::parse_text(prelude_ + sdl, "line.pov", options);
  if (!result.errors.empty() || !result.scene) throw std::runtime_error(parser::format(result.errors.front()));
  return std::move(*result.scene);
}

std::string Journal::text() const {
  std::ostringstream out;
  for (const auto& [label, hash] : entries_) out << label << ": " << std::hex << hash << '\n';
  return out.str();
}

void with_each_instruction_set(const std::function<void(Journal&)>& body) {
  Journal journal;
  body(journal);
  if (testing::Test::HasFailure()) return;
  ASSERT_FALSE(journal.text().empty());
  if (const char* file = std::getenv(kJournalFile)) {
    std::ofstream(file) << journal.text();
    return;
  }
  constexpr const char* kNames[] = {"baseline", "sse4", "avx2"};
  for (int set = 0; set < simd::best_instruction_set(); ++set)
    EXPECT_EQ(journal_with(kNames[set]), journal.text()) << kNames[set];
}

TEST(EachInstructionSet, WhatDiffersIsTold) {
  testing::TestPartResultArray failures;
  {
    const testing::ScopedFakeTestPartResultReporter hear(&failures);
    with_each_instruction_set([](Journal& journal) {
      journal.begin("the same"), journal.add(1.5);
      journal.begin("another"), journal.add(static_cast<int>(simd::best_instruction_set()));
    });
  }
  EXPECT_EQ(failures.size(), std::getenv(kJournalFile) ? 0 : static_cast<int>(simd::best_instruction_set()));
}

TEST(SdlTables, HaveNamedLinesThatMayBeContinued) {
  const SdlTables tables("rays.sdl");
  EXPECT_EQ(tables["variants"][3].name, "inverse");
  EXPECT_EQ(tables["variants"][3].sdl, "rotate 90*y inverse");
  EXPECT_EQ(tables["objects"].back().name, "clipped parts");
  EXPECT_TRUE(tables["objects"].back().sdl.ends_with("M() }"));
  EXPECT_EQ(SdlTables("points.sdl")["normals"][0].sdl, "bumps");
  EXPECT_EQ(SdlTables("points.sdl")["normal modifiers"][0].sdl, "");
  EXPECT_THROW(tables["planets"], std::out_of_range);
  EXPECT_THROW(tables.scene("sphere {"), std::runtime_error);
}

}  // namespace verisim::test
