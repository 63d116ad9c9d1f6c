#include "tests/wide/each_instruction_set.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tracer/simd/instruction_sets.h"

namespace verisim::test {
namespace {

constexpr const char* kJournalFile = "VERISIM_TEST_JOURNAL";  // where a test that was started by a test writes to

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The journal of the running test with this instruction set.
std::string journal_with(const char* set, const std::string& test) {
  const auto base = std::filesystem::temp_directory_path() / ("verisim_" + std::to_string(::getpid()) + '_' + set);
  const std::string journal = base.string() + ".journal", output = base.string() + ".output";
  const std::string filter = "--gtest_filter=" + test;
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("VERISIM_INSTRUCTION_SET", set, 1), ::setenv(kJournalFile, journal.c_str(), 1);
    if (!std::freopen(output.c_str(), "w", stdout)) ::_exit(1);
    ::execl("/proc/self/exe", "/proc/self/exe", filter.c_str(), nullptr);
    ::_exit(1);
  }
  int status = 1;
  if (child > 0) ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << set << ":\n" << text_of(output);
  const std::string text = text_of(journal);
  std::filesystem::remove(journal), std::filesystem::remove(output);
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::string Journal::text() const {
  std::ostringstream out;
  for (const Entry& e : entries_) out << e.label << ": " << std::hex << e.hash << '\n';
  return out.str();
}

void with_each_instruction_set(const std::function<void(Journal&)>& body) {
  Journal journal;
  body(journal);
  if (testing::Test::HasFailure()) return;
  if (const char* file = std::getenv(kJournalFile)) {
    std::ofstream(file) << journal.text();
    return;
  }
  const std::vector<std::string> best = lines_of(journal.text());
  ASSERT_FALSE(best.empty());
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string test = std::string(info->test_suite_name()) + '.' + info->name();
  constexpr const char* kNames[] = {"baseline", "sse4", "avx2"};
  for (int set = 0; set < simd::best_instruction_set(); ++set) {
    const std::vector<std::string> other = lines_of(journal_with(kNames[set], test));
    ASSERT_EQ(other.size(), best.size()) << kNames[set];
    for (std::size_t i = 0; i < best.size(); ++i) EXPECT_EQ(other[i], best[i]) << kNames[set];
  }
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

}  // namespace verisim::test
