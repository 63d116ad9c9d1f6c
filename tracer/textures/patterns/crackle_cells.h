// What crackle and facets remember: for a unit cell, the random points of the cells around it that matter inside it.
#pragma once

#include <cstdint>

#include "tracer/noise/noise_tables.h"

namespace verisim::textures {

// Points in the order in which POV-Ray's 81 cells are looked at here; those that cannot be among the three nearest of
// any place in the cell are left out. Where they are, not where in the cell: differences have POV-Ray's bits. Filled up
// to a multiple of 8 with points far away.
struct alignas(64) CrackleCell {
  static constexpr int kMax = 88;
  double x[kMax], y[kMax], z[kMax];
  int count;
};

// Of metric 2, of metric 1, and of any other, for which no point is left out.
enum class CrackleMetric { squares, sums, any };

// The cell whose lower corner is (a, b, c), from the memory of the calling thread.
const CrackleCell& crackle_cell(CrackleMetric metric, std::int64_t a, std::int64_t b, std::int64_t c);

}  // namespace verisim::textures
