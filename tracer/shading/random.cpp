#include "tracer/shading/random.h"

#include <random>
#include <vector>

namespace verisim::shading {

std::span<const double> mersenne_table() {
  static const std::vector<double> table = [] {
    std::vector<double> t(32768);
    std::mt19937 generator;
    for (double& u : t) u = generator() / 4294967296.0;
    return t;
  }();
  return table;
}

// A draw first advances, then reads: the first number used is element 1 (spec 07 section 1).
double RandomSource::table(std::uint32_t& index) {
  static const std::span<const double> numbers = mersenne_table();
  index = (index + 1) % 32768;
  return numbers[index];
}

}  // namespace verisim::shading
