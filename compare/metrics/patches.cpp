#include "compare/metrics/patches.h"

#include <vector>

#include "compare/metrics/rounding.h"
#include "tracer/base/parallel.h"

namespace verisim::compare {
namespace {

constexpr int kCell = 8, kBlock = 2 * kCell;

Rgb finite_difference(const Values& a, const Values& b, int x, int y) {
  return a.finite(x, y) && b.finite(x, y) ? difference(a, b, x, y) : Rgb{};
}

std::vector<Rgb> row_of(const Values& a, const Values& b, int y) {
  std::vector<Rgb> out;
  out.reserve(static_cast<std::size_t>(a.width()));
  for (int x = 0; x < a.width(); ++x) out.push_back(finite_difference(a, b, x, y));
  return out;
}

double median_of_nine(std::array<double, 9> v) {
  std::nth_element(v.begin(), v.begin() + 4, v.end());
  return v[4];
}

Patches solid_row(const Values& a, const Values& b, int y) {
  Patches out;
  if (y < 1 || y + 1 >= a.height()) return out;
  const std::array<std::vector<Rgb>, 3> rows{row_of(a, b, y - 1), row_of(a, b, y), row_of(a, b, y + 1)};
  for (std::size_t x = 1; x + 1 < rows[0].size(); ++x) {
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 9> window;
      int zeros = 0;
      for (std::size_t i = 0; i < 9; ++i) window[i] = rows[i / 3][x - 1 + i % 3][c], zeros += window[i] == 0;
      if (zeros < 5) largest = std::max(largest, std::fabs(median_of_nine(window)));
    }
    out.solid_2_pixels += largest > 2 + kRounding, out.solid_4_pixels += largest > 4 + kRounding;
    if (largest > out.solid_max) out.solid_max = largest, out.solid_x = static_cast<int>(x), out.solid_y = y;
  }
  return out;
}

}  // namespace

Rgb told_difference(const Values& a, const Values& b, int x, int y) {
  if (!a.finite(x, y) || !b.finite(x, y)) return {};
  if ((a.bits() > 8) == (b.bits() > 8)) return difference(a, b, x, y);
  const Rgb p = a.rgb(x, y), q = b.rgb(x, y);
  return {std::round(q[0]) - std::round(p[0]), std::round(q[1]) - std::round(p[1]),
          std::round(q[2]) - std::round(p[2])};
}

namespace {

// Sums of clipped differences over the cells of one row of them.
std::vector<Rgb> cell_sums(const Values& a, const Values& b, int y0) {
  std::vector<Rgb> sums(static_cast<std::size_t>((a.width() + kCell - 1) / kCell));
  for (int y = y0; y < std::min(y0 + kCell, a.height()); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const Rgb d = told_difference(a, b, x, y);
      for (std::size_t c = 0; c < 3; ++c) sums[static_cast<std::size_t>(x / kCell)][c] += std::clamp(d[c], -1.0, 1.0);
    }
  return sums;
}

// Blocks whose upper half is the row of cells at y0. What reaches over the picture's edge counts as equal, unless the
// whole picture is smaller than a block.
Patches drift_row(const Values& a, const Values& b, int y0) {
  Patches out;
  const std::vector<Rgb> upper = cell_sums(a, b, y0), lower = cell_sums(a, b, y0 + kCell);
  const double pixels = static_cast<double>(std::min(kBlock, a.width())) * std::min(kBlock, a.height());
  for (std::size_t i = 0; i < upper.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double right = i + 1 < upper.size() ? upper[i + 1][c] + lower[i + 1][c] : 0;
      const double drift = std::fabs(upper[i][c] + lower[i][c] + right) / pixels;
      if (drift > out.drift_max)
        out.drift_max = drift, out.drift_x = std::min(static_cast<int>(i + 1) * kCell, a.width() - 1),
        out.drift_y = std::min(y0 + kCell, a.height() - 1);
    }
  return out;
}

}  // namespace

void Patches::add(const Patches& other) {
  solid_2_pixels += other.solid_2_pixels, solid_4_pixels += other.solid_4_pixels;
  if (other.solid_max > solid_max) solid_max = other.solid_max, solid_x = other.solid_x, solid_y = other.solid_y;
  if (other.drift_max > drift_max) drift_max = other.drift_max, drift_x = other.drift_x, drift_y = other.drift_y;
}

Patches patches(const Values& reference, const Values& test, int begin, int end) {
  std::vector<Patches> rows(static_cast<std::size_t>((end - begin + kCell - 1) / kCell));
  parallel_for(rows.size(), 1, [&](std::size_t i) {
    const int first = begin + kCell * static_cast<int>(i);
    for (int y = first; y < std::min(first + kCell, end); ++y) rows[i].add(solid_row(reference, test, y));
    rows[i].add(drift_row(reference, test, first));
  });
  Patches out;
  for (const Patches& row : rows) out.add(row);
  return out;
}

}  // namespace verisim::compare
