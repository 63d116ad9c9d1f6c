// The kept corpus of the fuzzers, and our own scenes with random mistakes, through the same entry points.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/sdl_mutator.h"
#include "tests/fuzz/targets.h"

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

// Values are copied and written by recursion.
TEST(FuzzCorpus, MessagesAsDeepAsTheyAreLong) {
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  fuzz::lsp(R"({"jsonrpc":"2.0","id":)" + deep + R"(,"method":"textDocument/hover","params":)" + deep + "}");
}

// Blocks and words lost, doubled, exchanged and replaced: near enough to SDL to get deep into every block.
TEST(FuzzCorpus, ScenesWithMistakes) {
  const auto texts = texts_below(kCorpus / "scene");
  for (const std::string& text : texts)
    for (std::uint32_t round = 0; round < 40; ++round)
      fuzz::scene(fuzz::mutate_scene(text, texts[round % texts.size()], round));
}

TEST(FuzzCorpus, Render) {
  const auto texts = texts_below(kCorpus / "render");
  ASSERT_FALSE(texts.empty());
  for (const std::string& text : texts)
    for (std::uint32_t round = 0; round < 10; ++round)
      fuzz::render(round ? fuzz::mutate_scene(text, texts[round % texts.size()], round) : text);
}

}  // namespace
}  // namespace verisim
