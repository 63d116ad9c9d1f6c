// What a command may still touch once it is in the sandbox: plain lists of paths, made before anything is restricted.
#pragma once

#include <filesystem>
#include <vector>

namespace verisim::cli {

struct Policy {
  std::vector<std::filesystem::path> read;         // files, and folders with all below them
  std::vector<std::filesystem::path> write;        // folders in which files may be made and replaced
  std::vector<std::filesystem::path> write_files;  // what is written through: devices, pipes
  bool server = false;                             // goes on answering on sockets that listen already
};

// Libraries that are loaded later (image plug-ins and what they need), and what the C library looks up.
std::vector<std::filesystem::path> system_files();

// Grants the writing of `file`: in its folder behind all links, or in place where it is not a regular file.
void grant_output(Policy& policy, const std::filesystem::path& file);

}  // namespace verisim::cli
