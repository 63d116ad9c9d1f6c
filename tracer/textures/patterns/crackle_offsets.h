// The 81 cells that POV-Ray looks at around a point's own, nearest rings first: all of {-2..2}^3 with at most one
// component of magnitude 2 (spec 05 section 7).
#pragma once

#include <array>
#include <cstdint>

namespace verisim::textures {

struct CellOffset {
  std::int8_t x, y, z;
};

constexpr std::array<CellOffset, 81> make_crackle_offsets() {
  std::array<CellOffset, 81> result{};
  int n = 0;
  for (int ring = 0; ring <= 6; ++ring)
    for (int x = -2; x <= 2; ++x)
      for (int y = -2; y <= 2; ++y)
        for (int z = -2; z <= 2; ++z) {
          const int twos = (x * x == 4) + (y * y == 4) + (z * z == 4);
          if (twos <= 1 && x * x + y * y + z * z == ring)
            result[n++] = {static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), static_cast<std::int8_t>(z)};
        }
  return result;
}
constexpr std::array<CellOffset, 81> kCrackleOffsets = make_crackle_offsets();
static_assert(kCrackleOffsets[0].x == 0 && kCrackleOffsets[0].y == 0 && kCrackleOffsets[0].z == 0 &&
              (kCrackleOffsets[80].x != 0 || kCrackleOffsets[80].y != 0));

}  // namespace verisim::textures
