#include "tracer/noise/noise_tables.h"

#include <algorithm>
#include <iterator>
#include <random>
#include <utility>

namespace verisim::textures {
namespace {

// R of spec 05 section 5.1.
constexpr double kValueTable[267] = {
#include "tracer/noise/noise_value_table.inc"
};

void shuffle_hash(NoiseTables& t) {
  for (int i = 0; i < 4096; ++i) t.hash[i] = static_cast<std::uint16_t>(i);
  LinearCongruential generator(0);
  for (int i = 4095; i >= 0; --i) std::swap(t.hash[i], t.hash[generator.draw() % 4096]);
}

void fill_gradients(NoiseTables& t) {
  LinearCongruential generator(1);
  for (auto& row : t.gradient_rows) {
    Vec3 g;
    double squared;
    do {
      const auto coordinate = [&] { return (generator.draw() % 4096 - 2048) / 2048.0; };
      g.x = coordinate();
      g.y = coordinate();
      g.z = coordinate();
      squared = dot(g, g);
    } while (squared > 1 || squared < 1e-5);
    const double inverse_length = 1 / std::sqrt(squared);
    row[0] = 0;
    row[1] = g.x * inverse_length;
    row[2] = g.y * inverse_length;
    row[3] = g.z * inverse_length;
  }
  // One cell too many takes part in the shuffle, as in POV-Ray: 0 occurs twice and one value is lost.
  std::uint16_t cells[2049];
  for (int i = 0; i < 2048; ++i) cells[i] = static_cast<std::uint16_t>(i);
  cells[2048] = 0;
  for (int i = 2048; i >= 2; i -= 2) std::swap(cells[i], cells[generator.draw() % 2048]);
  for (int i = 0; i < 2048; ++i) t.permutation[i] = cells[i];
}

}  // namespace

NoiseTables::NoiseTables() {
  shuffle_hash(*this);
  std::copy(std::begin(kValueTable), std::end(kValueTable), values);
  values[std::size(kValueTable)] = 0;
  for (std::size_t i = 0; i < std::size(vectors); ++i)
    for (std::size_t k = 0; k < 4; ++k) vectors[i][k] = k < 3 ? values[i + 4 * k] : 0;
  std::mt19937 twister;  // seed 5489
  for (int i = 0; i < 32768; ++i) random[i] = static_cast<std::uint32_t>(twister());
  for (int i = 0; i < 4; ++i) random[32768 + i] = random[i];
  fill_gradients(*this);
}

}  // namespace verisim::textures
