#include "parser/lexer/names.h"

#include <algorithm>
#include <cstring>

namespace verisim::parser {
namespace {

// Multiply-and-fold over eight bytes at a time; identifiers are short.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t h = 0x9e3779b97f4a7c15ull ^ text.size();
  const char* p = text.data();
  std::size_t n = text.size();
  const auto mix = [&h](std::uint64_t word) {
    h = (h ^ word) * 0xff51afd7ed558ccdull;
    h ^= h >> 32;
  };
  for (; n >= 8; n -= 8, p += 8) {
    std::uint64_t word;
    std::memcpy(&word, p, 8);
    mix(word);
  }
  if (n) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < n; ++i) word = (word << 8) | static_cast<unsigned char>(p[i]);
    mix(word);
  }
  return h;
}

constexpr std::size_t kChunkBytes = 1 << 16;

}  // namespace

Names::Names() {
  entries_.reserve(2048);
  entries_.emplace_back();
  table_.resize(4096);
  for (const WordEntry& w : all_words()) entries_[intern(w.text)].word = w.word;
}

std::uint32_t Names::find(std::string_view text) const {
  const std::uint64_t h = hash_of(text);
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = h & mask; table_[i]; i = (i + 1) & mask) {
    const Name& e = entries_[table_[i]];
    if (e.hash == h && e.text == text) return table_[i];
  }
  return 0;
}

std::uint32_t Names::intern(std::string_view text) {
  const std::uint64_t h = hash_of(text);
  const std::size_t mask = table_.size() - 1;
  std::size_t i = h & mask;
  for (; table_[i]; i = (i + 1) & mask) {
    const Name& e = entries_[table_[i]];
    if (e.hash == h && e.text == text) return table_[i];
  }
  const auto id = static_cast<std::uint32_t>(entries_.size());
  entries_.push_back({store(text), h, Word::none, nullptr});
  table_[i] = id;
  if (entries_.size() * 2 > table_.size()) grow();
  return id;
}

std::string_view Names::store(std::string_view text) {
  if (text.size() > chunk_free_) {
    const std::size_t bytes = std::max(text.size(), kChunkBytes);
    chunks_.push_back(std::make_unique_for_overwrite<char[]>(bytes));
    chunk_ = chunks_.back().get();
    chunk_free_ = bytes;
  }
  std::memcpy(chunk_, text.data(), text.size());
  const std::string_view stored{chunk_, text.size()};
  chunk_ += text.size();
  chunk_free_ -= text.size();
  return stored;
}

void Names::grow() {
  table_.assign(table_.size() * 4, 0);
  const std::size_t mask = table_.size() - 1;
  for (std::uint32_t id = 1; id < entries_.size(); ++id) {
    std::size_t i = entries_[id].hash & mask;
    while (table_[i]) i = (i + 1) & mask;
    table_[i] = id;
  }
}

}  // namespace verisim::parser
