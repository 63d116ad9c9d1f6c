// What holds for all scenes of this process, whatever options they are parsed with. Set once, before the first of them,
// by who renders scenes of strangers (cli/sandbox); libraries leave it alone.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

namespace verisim::parser {

struct Confinement {
  std::atomic<bool> writes_named_only{false};  // only below ParseOptions::allow_write, not in the scene's folder
  // Bytes that scenes may write and say, and have: #write, #debug, #warning and all other warnings, and a block of the
  // disk for each file that is opened; 0: no limit.
  std::atomic<std::uint64_t> output_limit{0}, output{0};

  // Counts what is about to be written; false: it is too much.
  bool may_write(std::uint64_t bytes) {
    output += bytes;
    return output_limit == 0 || output <= output_limit;
  }
  std::string refusal() const {
    return "The scene writes more than --max-output-bytes " + std::to_string(output_limit) + " allows.";
  }
};
inline Confinement confinement;

}  // namespace verisim::parser
