// The kept corpus of the fuzzers, and our own scenes with random mistakes, through the same entry points.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/entry_points.h"
#include "tests/fuzz/files.h"

namespace verisim {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> texts_below(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const fs::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return texts;
}

const fs::path kCorpus = fs::path(VERISIM_SOURCE_DIR) / "tests/fuzz/corpus";

TEST(FuzzCorpus, Lexer) {
  const auto texts = texts_below(kCorpus);
  ASSERT_GT(texts.size(), 10u);
  for (const std::string& text : texts) fuzz::lexer(text);
}

TEST(FuzzCorpus, Scene) {
  for (const fs::path& folder : {kCorpus / "scene", fs::path(VERISIM_SOURCE_DIR) / "scenes/shapes",
                                 fs::path(VERISIM_SOURCE_DIR) / "scenes/global"})
    for (const std::string& text : texts_below(folder)) fuzz::scene(text);
}

TEST(FuzzCorpus, Function) {
  const auto texts = texts_below(kCorpus / "function");
  ASSERT_GT(texts.size(), 5u);
  for (const std::string& text : texts) fuzz::function(text);
}

// Files of every kind, with bytes lost and changed.
TEST(FuzzCorpus, Files) {
  std::mt19937 random(20260102);
  for (const fuzz::FileTarget& target : fuzz::kFileTargets) {
    const auto texts = texts_below(kCorpus / target.name);
    EXPECT_FALSE(texts.empty()) << target.name;
    for (const std::string& text : texts) {
      target.run(text);
      for (int round = 0; round < 30 && !text.empty(); ++round) {
        std::string changed = text.substr(0, round % 3 == 0 ? random() % text.size() : text.size());
        for (int mistakes = 1 + round % 4; mistakes > 0 && !changed.empty(); --mistakes)
          changed[random() % changed.size()] = static_cast<char>(random());
        target.run(changed);
      }
    }
  }
}

// Words lost, doubled, exchanged and replaced by others of the scene: near enough to SDL to get deep into every block.
TEST(FuzzCorpus, ScenesWithMistakes) {
  std::mt19937 random(20260101);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (const std::string& text : texts_below(kCorpus / "scene")) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text) {
      const bool letter = std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
      if (!letter && !word.empty()) words.push_back(std::exchange(word, {}));
      if (letter)
        word += c;
      else
        words.emplace_back(1, c);
    }
    if (words.size() < 4 || words.size() > 5000) continue;
    for (int round = 0; round < 40; ++round) {
      std::vector<std::string> changed = words;
      for (std::size_t mistakes = 1 + below(4); mistakes > 0; --mistakes) {
        const std::size_t at = below(changed.size());
        switch (below(4)) {
          case 0:
            changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(at));
            break;
          case 1:
            changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(at), words[below(words.size())]);
            break;
          case 2:
            changed[at] = words[below(words.size())];
            break;
          default:
            std::swap(changed[at], changed[below(changed.size())]);
        }
        if (changed.size() < 4) break;
      }
      std::string joined;
      for (const std::string& w : changed) joined += w;
      fuzz::scene(joined);
    }
  }
}

}  // namespace
}  // namespace verisim
