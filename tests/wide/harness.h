// What is computed many at a time is compared with what is computed alone, with every instruction set of this machine.
// It is SDL in files beside the tests: what all scenes begin with, then tables, each below `== its name`. A line of a
// table is `name | SDL`, or SDL alone, which then is the name, too; lines that are indented continue it.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "parser/parse.h"
#include "tracer/math/vec.h"

namespace verisim::test {

struct SdlLine {
  std::string name, sdl;
};

class SdlTables {
 public:
  // `file`: its name in tests/wide.
  explicit SdlTables(const std::string& file);
  const std::vector<SdlLine>& operator[](const std::string& table) const { return tables_.at(table); }
  // What they begin with, and `sdl`. Throws what is wrong with it.
  scene::Scene scene(const std::string& sdl, const parser::ParseOptions& options = {}) const;

 private:
  std::string prelude_;
  std::map<std::string, std::vector<SdlLine>> tables_;
};

// What one run found, in few bits: to be the same with every instruction set.
class Journal {
 public:
  // What follows belongs to this.
  void begin(const std::string& label) { entries_.emplace_back(label, 0xcbf29ce484222325u); }
  // Which NaN it is may differ.
  void add(double value) { add_bits(std::isnan(value) ? 0x7ff8000000000000u : std::bit_cast<std::uint64_t>(value)); }
  void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
  // A line for each label.
  std::string text() const;

 private:
  void add_bits(std::uint64_t bits) {
    std::uint64_t& hash = entries_.back().second;
    hash = (hash ^ bits) * 0x100000001b3u, hash ^= hash >> 29;
  }
  std::vector<std::pair<std::string, std::uint64_t>> entries_;
};

// Runs `body`, and for each narrower instruction set this very test once more in a process of its own, where kernels
// are chosen anew; their journals are to be the same. Failures within `body` count wherever they happen.
void with_each_instruction_set(const std::function<void(Journal&)>& body);

// The same bits; of two numbers that are none it does not matter which.
inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}
inline bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

}  // namespace verisim::test
