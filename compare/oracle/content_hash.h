// SHA-256 of files and texts: the key of the oracle's cache.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace verisim::compare {

class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  // Length-prefixed: ("ab", "c") and ("a", "bc") differ.
  void add(std::string_view text);
  // The file's content; a file that cannot be read counts as missing, which is a content of its own.
  void add_file(const std::filesystem::path& path);
  std::string hex();  // ends the hash

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace verisim::compare
