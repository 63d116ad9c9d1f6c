// What is computed many at a time is compared with what is computed alone, with every instruction set of this machine.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "tracer/math/vec.h"

namespace verisim::test {

// What one run found, in few bits: to be the same with every instruction set.
class Journal {
 public:
  // What follows belongs to this.
  void begin(const std::string& label) { entries_.push_back({label, 0xcbf29ce484222325u}); }
  template <class T>
  void add(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      // Which NaN it is may differ.
      add_bits(std::isnan(value) ? 0x7ff8000000000000u : std::bit_cast<std::uint64_t>(static_cast<double>(value)));
    } else {
      add_bits(static_cast<std::uint64_t>(value));
    }
  }
  void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
  // A line for each label.
  std::string text() const;

 private:
  void add_bits(std::uint64_t bits) {
    std::uint64_t& hash = entries_.back().hash;
    hash = (hash ^ bits) * 0x100000001b3u, hash ^= hash >> 29;
  }
  struct Entry {
    std::string label;
    std::uint64_t hash;
  };
  std::vector<Entry> entries_;
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
