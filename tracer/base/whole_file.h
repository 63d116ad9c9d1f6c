// A file that fits in memory, read in one go.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace verisim {

// All bytes of a file; nothing where it cannot be opened or read. How large it may be the caller decides before.
std::optional<std::string> whole_file(const std::filesystem::path& path);
// The same; throws std::runtime_error naming the file in place of giving nothing.
std::string required_file(const std::filesystem::path& path);

}  // namespace verisim
